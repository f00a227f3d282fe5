//! `nearfield closest-point`: from given points down to the surface.

use super::exit_code::Failure;
use super::questions::{self, Answers, Kind};
use clap::Args;
use nearfield::Field;
use serde::Serialize;
use std::path::PathBuf;

/// Go from points down to the surface
///
/// With --points, reads little-endian f32 triples (x, y, z) without a header, and writes four f32 a
/// point: where its descent ended, and the field there, which is how far it stayed from the surface.
/// Without --points, reads lines of text "x y z" from standard input and writes lines of text. Mesh
/// units. The end is a point of the surface near the closest, not always the closest; beyond creases
/// and far from the surface it may be another.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  echo 0 0 0 | nearfield closest-point spot.nfd
  nearfield closest-point spot.nfd --points points.f32 -o ends.f32")]
pub(super) struct ClosestPoint {
    /// The field
    field: PathBuf,

    /// Binary points; `-` is standard input
    #[arg(long, value_name = "POINTS")]
    points: Option<PathBuf>,

    #[command(flatten)]
    answers: Answers,
}

impl ClosestPoint {
    pub(super) fn run(self) -> Result<(), Failure> {
        questions::answer(&Descents, &self.field, self.points.as_deref(), &self.answers)
    }
}

/// Descents from points.
struct Descents;

#[derive(Serialize)]
struct End {
    point: [f32; 3],
    residual: f32,
    steps: u32,
}

impl Kind<3> for Descents {
    type Answer = End;
    const NAME: &'static str = "point";
    const SHAPE: &'static str = "x y z";

    fn answers(&self, field: &Field<'_>, points: &[[f32; 3]]) -> Vec<End> {
        let ends = points.iter().map(|&point| field.closest_point(point));
        ends.map(|nearfield::ClosestPoint { point, residual, steps }| End { point, residual, steps }).collect()
    }

    fn add_floats(&self, end: &End, floats: &mut Vec<f32>) {
        floats.extend(end.point);
        floats.push(end.residual);
    }
}
