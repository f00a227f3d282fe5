//! `nearfield slice`: a picture of a plane through a field.

use super::arguments::method_of;
use super::exit_code::Failure;
use super::files;
use super::mesh_arguments::MeshArguments;
use clap::{Args, ValueEnum};
use nearfield::Field;
use nearfield_bake::distance::SignedDistance;
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::picture::{self, Axis, Position, Slice};
use std::path::PathBuf;
use std::str::FromStr;

/// Draw a slice through a field
///
/// Blue is inside, warm is outside, the surface is black, grey lines join points of equal distance.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield slice spot.nfd -o spot.png
  nearfield slice spot.nfd -o feet.png --axis y --at 20% --cells
  nearfield slice spot.nfd -o plane.png --axis z --at 0.35
  nearfield slice teapot.nfd -o doubt.png --mesh teapot.obj")]
pub(super) struct SliceCommand {
    /// The field
    field: PathBuf,

    /// The PNG to write; `-` is standard output
    #[arg(short, long, value_name = "PNG")]
    output: PathBuf,

    /// Axis perpendicular to the picture
    #[arg(long, value_enum, value_name = "AXIS", default_value_t = AxisName::Z)]
    axis: AxisName,

    /// Place on that axis: a coordinate in mesh units, or a percentage of the field's box
    #[arg(long, value_name = "PLACE", value_parser = place, default_value = "50%", allow_hyphen_values = true)]
    at: Position,

    /// Pixels along the longer side
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=8192), default_value_t = 768)]
    resolution: u32,

    /// Draw the borders of the leaves
    #[arg(long)]
    cells: bool,

    /// The mesh that the field was baked from: red is where its sign is a guess
    #[arg(long, value_name = "MESH")]
    mesh: Option<PathBuf>,

    #[command(flatten)]
    reading: MeshArguments,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum AxisName {
    /// z to the right, y up
    X,
    /// x to the right, z up
    Y,
    /// x to the right, y up
    Z,
}

impl SliceCommand {
    pub(super) fn run(self) -> Result<(), Failure> {
        let bytes = files::read_bytes(&self.field)?;
        let field = files::open_field(&bytes, &self.field)?;
        files::check_output(&self.output, &self.field)?;

        let truth = self.truth(&field)?;
        let image = picture::slice(
            &field,
            &Slice {
                axis: match self.axis {
                    AxisName::X => Axis::X,
                    AxisName::Y => Axis::Y,
                    AxisName::Z => Axis::Z,
                },
                position: self.at,
                resolution: self.resolution,
                cells: self.cells,
            },
            truth.as_ref().map(|truth| truth as &dyn FieldFunction),
        );
        files::write_bytes(&self.output, &image.to_png())
    }

    fn truth(&self, field: &Field<'_>) -> Result<Option<SignedDistance>, Failure> {
        let Some(path) = &self.mesh else { return Ok(None) };
        let mesh = files::read_mesh(path, &self.reading.read_options()?)?;
        files::refuse_other_mesh(&self.field, field, path, &mesh)?;
        Ok(Some(SignedDistance::new(&mesh, method_of(field.header().sign_method, 0.0))))
    }
}

/// "35%" of the box, or a coordinate.
fn place(text: &str) -> Result<Position, String> {
    let finite = |text: &str| f64::from_str(text).ok().filter(|number| number.is_finite());
    let place = match text.strip_suffix('%') {
        Some(percentage) => finite(percentage).map(|percentage| Position::Fraction(percentage / 100.0)),
        None => finite(text).map(Position::Coordinate),
    };
    place.ok_or_else(|| "it must be a coordinate such as 0.25, or a percentage such as 50%".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_coordinates_or_percentages() {
        assert_eq!(place("50%"), Ok(Position::Fraction(0.5)));
        assert_eq!(place("-1.5"), Ok(Position::Coordinate(-1.5)));
        for wrong in ["", "%", "nan", "inf%", "middle"] {
            assert!(place(wrong).is_err(), "{wrong}");
        }
    }
}
