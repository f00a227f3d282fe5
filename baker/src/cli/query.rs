//! `nearfield query`: distances at given points.

use super::exit_code::Failure;
use super::questions::{self, Answers, Kind};
use clap::Args;
use nearfield::Field;
use serde::Serialize;
use std::path::PathBuf;

/// Ask a field for distances
///
/// With --points, reads little-endian f32 triples (x, y, z) without a header, and writes one f32
/// distance a point, or four f32 (distance, then gradient) with --gradient. Without --points, reads
/// lines of text "x y z" from standard input and writes lines of text. Distances are in mesh units,
/// negative inside.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  echo 0 0 0 | nearfield query spot.nfd
  nearfield query spot.nfd --points points.f32 -o distances.f32
  make-points | nearfield query spot.nfd --points - -o - --gradient | use-them")]
pub(super) struct Query {
    /// The field
    field: PathBuf,

    /// Binary points; `-` is standard input
    #[arg(long, value_name = "POINTS")]
    points: Option<PathBuf>,

    /// Answer with the gradient as well
    #[arg(long)]
    gradient: bool,

    #[command(flatten)]
    answers: Answers,
}

/// Distances at points.
struct Distances {
    with_gradient: bool,
}

#[derive(Serialize)]
struct Distance {
    distance: f32,
    #[serde(skip_serializing_if = "Option::is_none")]
    gradient: Option<[f32; 3]>,
}

impl Query {
    pub(super) fn run(self) -> Result<(), Failure> {
        let kind = Distances { with_gradient: self.gradient };
        questions::answer(&kind, &self.field, self.points.as_deref(), &self.answers)
    }
}

impl Kind<3> for Distances {
    type Answer = Distance;
    const NAME: &'static str = "point";
    const SHAPE: &'static str = "x y z";

    fn answers(&self, field: &Field<'_>, points: &[[f32; 3]]) -> Vec<Distance> {
        let mut distances = vec![0.0; points.len()];
        if !self.with_gradient {
            field.distances(points, &mut distances);
            return distances.into_iter().map(|distance| Distance { distance, gradient: None }).collect();
        }
        let mut gradients = vec![[0.0; 3]; points.len()];
        field.distances_and_gradients(points, &mut distances, &mut gradients);
        let answers = distances.into_iter().zip(gradients);
        answers.map(|(distance, gradient)| Distance { distance, gradient: Some(gradient) }).collect()
    }

    fn add_floats(&self, answer: &Distance, floats: &mut Vec<f32>) {
        floats.push(answer.distance);
        floats.extend(answer.gradient.iter().flatten());
    }
}
