//! Mesh files to a [`TriangleSoup`]: one door, whatever the format.

mod obj;
mod ply;
#[cfg(test)]
mod tests;

use glam::DVec3;
use std::path::{Path, PathBuf};
use std::{fs, io};
use thiserror::Error;

/// Triangles as a file gave them: finite positions and indices in range, nothing else is known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleSoup {
    /// Vertex positions, mesh units, mesh frame, all finite.
    pub positions: Vec<DVec3>,
    /// Three indices into `positions` a triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// Why a mesh file could not be read.
#[derive(Debug, Error)]
#[error("cannot read {}: {problem}", path.display())]
pub struct ImportError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    #[source]
    pub problem: Problem,
}

/// What is wrong with a mesh file.
#[derive(Debug, Error)]
pub enum Problem {
    /// The operating system did not hand over the bytes.
    #[error("{0}; check the path and its permissions")]
    Unreadable(#[source] io::Error),
    /// Neither the content nor the extension names a format that this program knows.
    #[error("its format is none of {KNOWN_FORMATS}; convert it to one of them")]
    UnknownFormat,
    /// The file breaks the rules of its format.
    #[error("it is not valid {format}: {reason}; export it again")]
    Malformed {
        /// Name of the format.
        format: &'static str,
        /// What the parser said.
        reason: String,
    },
    /// The file ends before everything that it announces.
    #[error("it is cut short: {reason}; copy or export it again")]
    Truncated {
        /// What is missing.
        reason: String,
    },
    /// A face names a vertex that is not there.
    #[error("{place} uses vertex index {index}, but there are {vertices} vertices; export it again")]
    IndexOutOfRange {
        /// The line or the face.
        place: String,
        /// The index as the file writes it.
        index: i64,
        /// Vertices known at that place.
        vertices: usize,
    },
    /// A vertex is NaN or infinite.
    #[error("{place} is ({}, {}, {}), which is no point; repair the mesh", position.x, position.y, position.z)]
    NotFinite {
        /// The vertex.
        place: String,
        /// Its position.
        position: DVec3,
    },
    /// There is nothing to bake.
    #[error("it holds no triangles{hint}; export the surface as triangles or polygons")]
    NoTriangles {
        /// What it holds instead, as a parenthesis, or nothing.
        hint: &'static str,
    },
}

/// The formats that [`read`] knows, as messages name them.
pub const KNOWN_FORMATS: &str = "OBJ, PLY";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Obj,
    Ply,
}

impl Format {
    /// The content decides; the extension only where the content says nothing.
    fn detect(path: &Path, bytes: &[u8]) -> Option<Self> {
        if ply::is_ply(bytes) {
            return Some(Self::Ply);
        }
        let extension = path.extension().unwrap_or_default();
        if extension.eq_ignore_ascii_case("obj") {
            Some(Self::Obj)
        } else if extension.eq_ignore_ascii_case("ply") {
            Some(Self::Ply)
        } else {
            obj::looks_like_obj(bytes).then_some(Self::Obj)
        }
    }
}

/// Reads a mesh file: positions in the file's own units and frame, polygons split into fans.
///
/// # Errors
/// [`ImportError`] when the file is missing, of another format, damaged or empty. Nothing in a file
/// makes this panic, hang, or ask for memory out of proportion to its length.
pub fn read(path: impl AsRef<Path>) -> Result<TriangleSoup, ImportError> {
    let path = path.as_ref();
    read_bytes(path).map_err(|problem| ImportError { path: path.to_owned(), problem })
}

fn read_bytes(path: &Path) -> Result<TriangleSoup, Problem> {
    let bytes = fs::read(path).map_err(Problem::Unreadable)?;
    match Format::detect(path, &bytes).ok_or(Problem::UnknownFormat)? {
        Format::Obj => obj::parse(&bytes),
        Format::Ply => ply::parse(&bytes),
    }
}

/// Splits a polygon into the fan around its first corner; points and lines vanish.
fn push_fan(triangles: &mut Vec<[u32; 3]>, polygon: &[u32]) {
    if let [apex, rest @ ..] = polygon {
        triangles.extend(rest.windows(2).map(|edge| [*apex, edge[0], edge[1]]));
    }
}
