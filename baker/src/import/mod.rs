//! Mesh files to a [`TriangleSoup`]: one door, whatever the format.

mod format;
mod gltf;
mod obj;
mod off;
mod off_binary;
mod options;
mod ply;
mod problem;
mod stl;
#[cfg(test)]
mod tests;

pub use options::{Names, Placement, ReadOptions, Selection, Up};
pub use problem::{ImportError, Problem};

use format::Format;
use glam::DVec3;
use std::fs;
use std::path::{Path, PathBuf};

/// Triangles as a file gave them: finite positions and indices in range, nothing else is known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleSoup {
    /// Vertex positions, mesh units, mesh frame, all finite.
    pub positions: Vec<DVec3>,
    /// Three indices into `positions` a triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// The formats that [`read`] knows, as messages name them.
pub const KNOWN_FORMATS: &str = "OBJ, STL, PLY, OFF, glTF, GLB";

/// Triangles that a file may have, instances counted: the search tree takes no more.
const MAX_TRIANGLES: usize = (1 << 28) - 1;

/// Reads a mesh file whole: positions in the file's own units and frame, polygons split into fans.
///
/// # Errors
/// [`ImportError`] when the file is missing, of another format, damaged or empty. Nothing in a file
/// makes this panic, hang, or ask for memory out of proportion to its length.
pub fn read(path: impl AsRef<Path>) -> Result<TriangleSoup, ImportError> {
    read_with(path, &ReadOptions::default())
}

/// Reads the parts of a mesh file that are wanted, scaled and turned as wanted.
///
/// # Errors
/// As [`read`], and when nothing in the file has the wanted names.
pub fn read_with(path: impl AsRef<Path>, options: &ReadOptions) -> Result<TriangleSoup, ImportError> {
    let path = path.as_ref();
    read_parts(path, options).map_err(|problem| ImportError { path: path.to_owned(), problem })
}

fn read_parts(path: &Path, options: &ReadOptions) -> Result<TriangleSoup, Problem> {
    let bytes = fs::read(path).map_err(Problem::Unreadable)?;
    let format = Format::detect(path, &bytes).ok_or(Problem::UnknownFormat)?;
    let selection = &options.selection;
    let mut soup = match format {
        Format::Obj => obj::parse(&bytes, selection)?,
        Format::Gltf => gltf::parse(&bytes, &folder_of(path), selection)?,
        Format::Ply | Format::Stl | Format::Off if !selection.is_everything() => {
            return Err(Problem::Nameless { format: format.name() });
        }
        Format::Ply => ply::parse(&bytes)?,
        Format::Stl => stl::parse(&bytes)?,
        Format::Off => off::parse(&bytes)?,
    };
    if soup.triangles.len() > MAX_TRIANGLES {
        return Err(Problem::TooLarge { triangles: soup.triangles.len() });
    }
    options.placement.apply(&mut soup.positions, format == Format::Gltf)?;
    Ok(soup)
}

/// The files that [`read`] opens for a mesh: the file itself, then the external buffers of a glTF in the
/// order of its list.
///
/// # Errors
/// The file cannot be read, or is a glTF whose description is damaged. Other formats are not looked at.
pub fn inputs(path: impl AsRef<Path>) -> Result<Vec<PathBuf>, ImportError> {
    let path = path.as_ref();
    let buffers = || {
        // A pipe can be read once, and that is for the mesh.
        if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
            return Ok(Vec::new());
        }
        let bytes = fs::read(path).map_err(Problem::Unreadable)?;
        match Format::detect(path, &bytes) {
            Some(Format::Gltf) => gltf::external_buffers(&bytes, &folder_of(path)),
            _ => Ok(Vec::new()),
        }
    };
    let buffers = buffers().map_err(|problem| ImportError { path: path.to_owned(), problem })?;
    Ok([vec![path.to_owned()], buffers].concat())
}

fn folder_of(path: &Path) -> PathBuf {
    path.parent().unwrap_or(Path::new("")).to_owned()
}

/// Splits a polygon into the fan around its first corner; points and lines vanish.
fn push_fan(triangles: &mut Vec<[u32; 3]>, polygon: &[u32]) {
    if let [apex, rest @ ..] = polygon {
        triangles.extend(rest.windows(2).map(|edge| [*apex, edge[0], edge[1]]));
    }
}

/// Splits a strip into triangles wound like the first.
fn push_strip(triangles: &mut Vec<[u32; 3]>, strip: &[u32]) {
    for (number, corners) in strip.windows(3).enumerate() {
        let [a, b, c] = [corners[0], corners[1], corners[2]];
        triangles.push(if number % 2 == 0 { [a, b, c] } else { [b, a, c] });
    }
}
