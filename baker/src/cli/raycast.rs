//! `nearfield raycast`: where rays meet the surface.

use super::exit_code::Failure;
use super::questions::{self, Answers, Kind};
use clap::Args;
use nearfield::{Field, RayHit, Raycast as Outcome};
use serde::Serialize;
use std::path::PathBuf;

/// Follow rays to the surface
///
/// With --rays, reads six little-endian f32 a ray (origin, direction) without a header, and writes
/// eight f32: how it ended (0 miss, 1 hit, 2 out of steps), how far along, the point and the unit
/// normal. Without --rays, reads lines of text "x y z dx dy dz" from standard input and writes lines of
/// text: "hit" and those seven numbers, "miss", or "clear" and the length that is. Mesh units;
/// directions need no unit length. A ray is followed within the box of the field.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  echo 0 0 9 0 0 -1 | nearfield raycast spot.nfd
  echo 0 0 9 0 0 -1 | nearfield raycast spot.nfd --json
  nearfield raycast spot.nfd --rays rays.f32 --length 2 -o hits.f32")]
pub(super) struct Raycast {
    /// The field
    field: PathBuf,

    /// Binary rays; `-` is standard input
    #[arg(long, value_name = "RAYS")]
    rays: Option<PathBuf>,

    /// Where rays end, mesh units from their origins
    #[arg(long, value_name = "LENGTH", value_parser = at_least_zero, default_value = "inf", allow_negative_numbers = true)]
    length: f32,

    /// How near to the surface a ray stops, mesh units
    #[arg(long, value_name = "DISTANCE", value_parser = at_least_zero, default_value = "0", allow_negative_numbers = true)]
    within: f32,

    #[command(flatten)]
    answers: Answers,
}

impl Raycast {
    pub(super) fn run(self) -> Result<(), Failure> {
        let kind = Rays { length: self.length, within: self.within };
        questions::answer(&kind, &self.field, self.rays.as_deref(), &self.answers)
    }
}

fn at_least_zero(text: &str) -> Result<f32, String> {
    match text.parse() {
        Ok(number) if number >= 0.0 => Ok(number),
        _ => Err("expected a number of at least 0".to_owned()),
    }
}

/// Rays of a length.
struct Rays {
    length: f32,
    within: f32,
}

#[derive(Serialize)]
#[serde(tag = "end", rename_all = "snake_case")]
enum End {
    Hit { distance: f32, point: [f32; 3], normal: [f32; 3], steps: u32 },
    Miss { steps: u32 },
    OutOfSteps { clear: f32 },
}

impl Kind<6> for Rays {
    type Answer = End;
    const NAME: &'static str = "ray";
    const SHAPE: &'static str = "x y z dx dy dz";

    fn answers(&self, field: &Field<'_>, rays: &[[f32; 6]]) -> Vec<End> {
        let cast = |&[x, y, z, u, v, w]: &[f32; 6]| field.raycast([x, y, z], [u, v, w], self.length, self.within);
        rays.iter()
            .map(|ray| match cast(ray) {
                Outcome::Hit(RayHit { distance, point, normal, steps }) => End::Hit { distance, point, normal, steps },
                Outcome::Miss { steps } => End::Miss { steps },
                Outcome::OutOfSteps { clear } => End::OutOfSteps { clear },
            })
            .collect()
    }

    fn add_floats(&self, end: &End, floats: &mut Vec<f32>) {
        floats.extend(match *end {
            End::Miss { .. } => [0.0; 8],
            End::Hit { distance, point: [x, y, z], normal: [u, v, w], .. } => [1.0, distance, x, y, z, u, v, w],
            End::OutOfSteps { clear } => [2.0, clear, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        });
    }

    fn line(&self, end: &End) -> String {
        match end {
            End::Miss { .. } => "miss".to_owned(),
            End::Hit { distance, point, normal, .. } => {
                format!("hit {distance} {} {}", questions::spaced(point), questions::spaced(normal))
            }
            End::OutOfSteps { clear } => format!("clear {clear}"),
        }
    }
}
