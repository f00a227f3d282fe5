//! What can be wrong with a mesh file.

use super::KNOWN_FORMATS;
use glam::DVec3;
use std::io;
use std::path::PathBuf;
use thiserror::Error;

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
    /// The file keeps to its format, in a way that this program does not know.
    #[error("it {feature}, which is not supported; {remedy}")]
    Unsupported {
        /// What it does, as a verb and its object.
        feature: String,
        /// What to do.
        remedy: &'static str,
    },
    /// The file ends before everything that it announces.
    #[error("it is cut short: {reason}; copy or export it again")]
    Truncated {
        /// What is missing.
        reason: String,
    },
    /// A file that the mesh file names cannot be used.
    #[error("its buffer {} {reason}; keep it where the mesh expects it", path.display())]
    Buffer {
        /// The file.
        path: PathBuf,
        /// What is wrong with it, as a verb and its object.
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
    /// Names were asked of a format that has none.
    #[error("{format} names neither nodes nor materials; leave --node and --material away")]
    Nameless {
        /// Name of the format.
        format: &'static str,
    },
    /// No triangle has the names that were asked for.
    #[error("no triangle has the nodes and materials asked for; it has {known}")]
    NothingSelected {
        /// The names that it has.
        known: String,
    },
    /// More triangles than the search tree takes.
    #[error("it holds {triangles} triangles, and the limit is 2^28; split it")]
    TooLarge {
        /// Triangles, instances counted.
        triangles: usize,
    },
}
