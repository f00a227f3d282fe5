//! What a bake did, and how long it took.

use crate::distance::SignDecision;
use crate::progress::Progress;
use crate::verify::Measurement;
use cpu_time::ProcessTime;
use std::time::{Duration, Instant};

/// What a bake did.
#[derive(Clone, Debug)]
pub struct Report {
    /// Where the sign came from; `None` for a function.
    pub sign: Option<SignDecision>,
    /// Leaves of each level below the root grid; none for a grid.
    pub leaves_by_level: Vec<usize>,
    /// Points at which the exact distance was sampled to build the field.
    pub samples: usize,
    /// What the finished field is worth.
    pub measurement: Measurement,
    /// Levels of detail that were asked for and would have taken too many bytes.
    pub lods_left_out: usize,
    /// The stages in order.
    pub stages: Vec<Stage>,
}

/// How long a stage took.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// Its name.
    pub name: &'static str,
    /// Time on the clock.
    pub wall: Duration,
    /// Time on all processors, of the whole process.
    pub cpu: Duration,
}

/// Times the stages of a bake and announces them.
pub struct Stopwatch<'a> {
    progress: &'a dyn Progress,
    running: Option<(&'static str, Instant, ProcessTime)>,
    stages: Vec<Stage>,
}

impl<'a> Stopwatch<'a> {
    /// Starts before the first stage.
    pub fn start(progress: &'a dyn Progress) -> Self {
        Self { progress, running: None, stages: Vec::new() }
    }

    /// Ends the stage that runs, if any, and begins the next.
    pub fn stage(&mut self, name: &'static str) {
        self.end();
        self.progress.stage(name, None);
        self.running = Some((name, Instant::now(), ProcessTime::now()));
    }

    /// Ends the last stage and gives all of them.
    pub fn stop(mut self) -> Vec<Stage> {
        self.end();
        self.stages
    }

    fn end(&mut self) {
        if let Some((name, wall, cpu)) = self.running.take() {
            self.stages.push(Stage { name, wall: wall.elapsed(), cpu: cpu.elapsed() });
        }
    }
}
