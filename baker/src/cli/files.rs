//! From paths to what is in the files, and back.

use super::exit_code::Failure;
use nearfield::Field;
use nearfield_bake::import::{self, ReadOptions};
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::output;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// The path that stands for standard input or output.
pub(super) fn is_standard_stream(path: &Path) -> bool {
    path == Path::new("-")
}

/// The wanted parts of a mesh, welded and checked.
pub(super) fn read_mesh(path: &Path, options: &ReadOptions) -> Result<CheckedMesh, Failure> {
    let soup = import::read_with(path, options).map_err(|error| Failure::Input(error.to_string()))?;
    CheckedMesh::new(soup).map_err(|error| Failure::Input(format!("{}: {error}", path.display())))
}

/// Refuses a mesh that a field was not baked from.
pub(super) fn refuse_other_mesh(
    field_path: &Path,
    field: &Field<'_>,
    mesh_path: &Path,
    mesh: &CheckedMesh,
) -> Result<(), Failure> {
    if mesh.hash() == field.header().mesh_hash {
        return Ok(());
    }
    Err(Failure::Verification(format!(
        "{} was not baked from {}: the hash of the mesh differs; name the right mesh or bake again",
        field_path.display(),
        mesh_path.display()
    )))
}

/// The bytes of a file.
pub(super) fn read_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(path).map_err(|error| Failure::Input(format!("{} cannot be read: {error}", path.display())))
}

/// The field in these bytes, everything about it checked.
pub(super) fn open_field<'a>(bytes: &'a [u8], path: &Path) -> Result<Field<'a>, Failure> {
    let invalid = |error| Failure::Field(format!("{} is not a valid field: {error}; bake it again", path.display()));
    let field = Field::open(bytes).map_err(invalid)?;
    field.validate().map_err(invalid)?;
    Ok(field)
}

/// Bytes of a point in a file of points: three little-endian `f32`.
const POINT_BYTES: usize = 12;

/// A point of a file of points.
fn point_of_bytes(bytes: &[u8; POINT_BYTES]) -> [f32; 3] {
    let (coordinates, _) = bytes.as_chunks::<4>();
    std::array::from_fn(|axis| f32::from_le_bytes(coordinates[axis]))
}

/// All points of a file of finite points.
pub(super) fn read_points(path: &Path) -> Result<Vec<[f32; 3]>, Failure> {
    let bytes = read_bytes(path)?;
    let (points, rest) = bytes.as_chunks::<POINT_BYTES>();
    if !rest.is_empty() {
        return Err(ends_within_a_point(path));
    }
    let points: Vec<[f32; 3]> = points.iter().map(point_of_bytes).collect();
    match points.iter().flatten().all(|coordinate| coordinate.is_finite()) {
        true if !points.is_empty() => Ok(points),
        true => Err(Failure::Input(format!("{} holds no points", path.display()))),
        false => Err(Failure::Input(format!("{} holds a point that is not finite", path.display()))),
    }
}

/// The failure of a file of points that is cut off.
fn ends_within_a_point(path: &Path) -> Failure {
    let path = path.display();
    Failure::Input(format!("{path} ends within a point: points are three little-endian f32, {POINT_BYTES} bytes each"))
}

/// Writes a whole file or nothing; `-` is standard output.
pub(super) fn write_bytes(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let outcome = if is_standard_stream(path) {
        let mut stdout = io::stdout().lock();
        stdout.write_all(bytes).and_then(|()| stdout.flush())
    } else {
        output::write(path, bytes)
    };
    outcome.map_err(|error| not_written(path, &error))
}

/// As [`write_bytes`], but a file that holds these bytes already stays untouched.
pub(super) fn write_bytes_if_changed(path: &Path, bytes: &[u8]) -> Result<bool, Failure> {
    if is_standard_stream(path) {
        return write_bytes(path, bytes).map(|()| true);
    }
    output::write_if_changed(path, bytes).map_err(|error| not_written(path, &error))
}

/// Refuses a place that cannot be written, or that is `input` itself, before work is spent on what should go there.
pub(super) fn check_output(path: &Path, input: &Path) -> Result<(), Failure> {
    if is_standard_stream(path) {
        return Ok(());
    }
    if same_file(path, input) {
        return Err(Failure::Usage(format!(
            "{} would overwrite what it is made from: choose another place",
            path.display()
        )));
    }
    output::check_writable(path).map_err(|error| not_written(path, &error))
}

/// Whether both paths lead to one file that exists.
fn same_file(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// The failure to write `path`.
pub(super) fn not_written(path: &Path, error: &io::Error) -> Failure {
    Failure::Output(format!("{} was not written: {error}; choose another place with -o", path.display()))
}
