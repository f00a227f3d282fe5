//! glTF 2.0, as text with buffers beside or inside it, or as one binary file (GLB).
//!
//! What is read: the default scene, or every root node where there is none; transforms of nodes; the
//! same mesh shown by several nodes; triangles, strips and fans; external, embedded and binary buffers;
//! sparse and quantized positions. Skins and morph targets stay in their rest pose.

mod accessor;
mod buffers;
mod document;
mod scene;
#[cfg(test)]
mod tests;

use super::{Problem, Selection, TriangleSoup};
use buffers::Buffers;
use document::Document;
use std::path::{Path, PathBuf};

const MAGIC: &[u8] = b"glTF";
const CHUNK_JSON: &[u8] = b"JSON";
const CHUNK_BINARY: &[u8] = b"BIN\0";

pub(super) fn is_gltf(bytes: &[u8]) -> bool {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    bytes.starts_with(MAGIC) || text.starts_with(b"{")
}

pub(super) fn parse(bytes: &[u8], folder: &Path, selection: &Selection) -> Result<TriangleSoup, Problem> {
    let (document, binary) = open(bytes)?;
    document.check_extensions()?;
    let buffers = Buffers::read(&document, binary, folder)?;
    scene::triangles(&document, &buffers, selection)
}

/// The files that hold buffers, in the order of the document.
pub(super) fn external_buffers(bytes: &[u8], folder: &Path) -> Result<Vec<PathBuf>, Problem> {
    let (document, _) = open(bytes)?;
    buffers::external_files(&document, folder)
}

/// The description and the binary chunk, if there is one.
fn open(bytes: &[u8]) -> Result<(Document, Option<&[u8]>), Problem> {
    if !bytes.starts_with(MAGIC) {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        return Ok((Document::parse(text)?, None));
    }
    let word = |at: usize| {
        let word = bytes.get(at..).and_then(|rest| rest.first_chunk());
        word.map(|word| u32::from_le_bytes(*word)).ok_or_else(|| truncated("its header"))
    };
    let (version, length) = (word(4)?, word(8)? as usize);
    if version != 2 {
        let feature = format!("is a GLB of version {version}");
        return Err(Problem::Unsupported { feature, remedy: "export it as glTF 2.0" });
    }
    let contents = bytes
        .get(..length)
        .ok_or_else(|| truncated(&format!("of the {length} bytes that it announces, some {}", length - bytes.len())))?;

    let (text, rest) = chunk(contents.get(12..).ok_or_else(|| truncated("its first chunk"))?, CHUNK_JSON)?;
    let binary = if rest.is_empty() { None } else { Some(chunk(rest, CHUNK_BINARY)?.0) };
    Ok((Document::parse(text)?, binary))
}

/// The contents of the first chunk, which must be of this kind, and what follows it.
fn chunk<'a>(bytes: &'a [u8], kind: &[u8]) -> Result<(&'a [u8], &'a [u8]), Problem> {
    let (length, bytes) = bytes.split_first_chunk::<4>().ok_or_else(|| truncated("a chunk"))?;
    let (found, bytes) = bytes.split_first_chunk::<4>().ok_or_else(|| truncated("a chunk"))?;
    if found != kind {
        return Err(malformed(format!("its chunks are not {:?} and {:?}", "JSON", "BIN")));
    }
    bytes.split_at_checked(u32::from_le_bytes(*length) as usize).ok_or_else(|| truncated("a part of a chunk"))
}

fn malformed(reason: impl Into<String>) -> Problem {
    Problem::Malformed { format: "glTF", reason: reason.into() }
}

fn truncated(missing: &str) -> Problem {
    Problem::Truncated { reason: format!("{missing} missing") }
}
