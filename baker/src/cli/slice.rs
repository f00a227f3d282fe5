//! `nearfield slice`: a picture of a plane through a field.

use super::arguments::{LevelOfDetail, method_of, not_negative};
use super::exit_code::Failure;
use super::files;
use super::mesh_arguments::MeshArguments;
use clap::{Args, ValueEnum};
use glam::DVec3;
use nearfield::Field;
use nearfield_bake::distance::SignedDistance;
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::picture::{self, Axis, Cut, Position, Slice};
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
  nearfield slice spot.nfd -o oblique.png --normal 1,2,0.5 --origin 0,0.3,0
  nearfield slice teapot.nfd -o doubt.png --mesh teapot.obj
  nearfield slice spot.nfd -o errors.png --mesh spot.ply --error-map")]
pub(super) struct SliceCommand {
    /// The field
    field: PathBuf,

    #[command(flatten)]
    lod: LevelOfDetail,

    /// The PNG to write; `-` is standard output
    #[arg(short, long, value_name = "PNG")]
    output: PathBuf,

    /// Axis perpendicular to the picture
    #[arg(long, value_enum, value_name = "AXIS", default_value_t = AxisName::Z)]
    axis: AxisName,

    /// Place on that axis: a coordinate in mesh units, or a percentage of the field's box
    #[arg(long, value_name = "PLACE", value_parser = place, default_value = "50%", allow_hyphen_values = true)]
    at: Position,

    /// Direction across an oblique plane, towards the eye; y is up in the picture, or z where it looks along y
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, conflicts_with_all = ["axis", "at"], allow_hyphen_values = true)]
    normal: Option<DVec3>,

    /// A point of the oblique plane, mesh units; by default the middle of the field's box
    #[arg(long, value_name = "X,Y,Z", value_parser = point, requires = "normal", allow_hyphen_values = true)]
    origin: Option<DVec3>,

    /// Pixels along the longer side
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=8192), default_value_t = 768)]
    resolution: u32,

    /// Draw the borders of the leaves
    #[arg(long)]
    cells: bool,

    /// The mesh that the field was baked from: red is where its sign is a guess
    #[arg(long, value_name = "MESH")]
    mesh: Option<PathBuf>,

    /// Draw the size of the error against the mesh instead of the distance, with a scale below it
    #[arg(long, requires = "mesh")]
    error_map: bool,

    /// The thickness that a sheet was baked with, mesh units
    #[arg(long, value_name = "T", value_parser = not_negative, default_value_t = 0.0)]
    thickness: f64,

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
        let field = self.lod.open(&bytes, &self.field)?;
        files::check_output(&self.output, &self.field)?;

        let truth = self.truth(&field)?;
        let truth = truth.as_ref().map(|truth| truth as &dyn FieldFunction);
        let request = Slice { cut: self.cut(), resolution: self.resolution, cells: self.cells };
        let image = match truth {
            Some(truth) if self.error_map => picture::error_map(&field, &request, truth),
            _ => picture::slice(&field, &request, truth),
        };
        files::write_bytes(&self.output, &image.to_png())
    }

    fn cut(&self) -> Cut {
        if let Some(normal) = self.normal {
            return Cut::Oblique { origin: self.origin, normal };
        }
        let axis = match self.axis {
            AxisName::X => Axis::X,
            AxisName::Y => Axis::Y,
            AxisName::Z => Axis::Z,
        };
        Cut::Across { axis, position: self.at }
    }

    fn truth(&self, field: &Field<'_>) -> Result<Option<SignedDistance>, Failure> {
        let Some(path) = &self.mesh else { return Ok(None) };
        let mesh = files::read_mesh(path, &self.reading.read_options()?)?;
        files::refuse_other_mesh(&self.field, field, path, &mesh)?;
        Ok(Some(SignedDistance::new(&mesh, method_of(field.header().sign_method, self.thickness))))
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

/// Three finite numbers with commas between them.
fn point(text: &str) -> Result<DVec3, String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    let point = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok()).map(DVec3::from_array);
    point.filter(|point| point.is_finite()).ok_or_else(|| "it must be three numbers, such as 0,0.5,-1".to_owned())
}

fn direction(text: &str) -> Result<DVec3, String> {
    let vector = point(text)?;
    vector.try_normalize().ok_or_else(|| "it must have a length".to_owned())
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

    #[test]
    fn points_are_three_numbers_and_directions_are_not_zero() {
        assert_eq!(point("1, -2.5,3e2"), Ok(DVec3::new(1.0, -2.5, 300.0)));
        assert_eq!(direction("0,-4,0"), Ok(DVec3::NEG_Y));
        for wrong in ["", "1,2", "1,2,3,4", "1,2,nan", "a,b,c"] {
            assert!(point(wrong).is_err(), "{wrong}");
        }
        assert!(direction("0,0,0").is_err());
    }
}
