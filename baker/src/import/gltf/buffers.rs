//! The bytes behind a glTF description.

use super::document::{Buffer, BufferView, Document};
use super::{Problem, malformed, truncated};
use base64::Engine;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use percent_encoding::percent_decode_str;
use std::fs;
use std::path::{Component, Path, PathBuf};

/// Encoders disagree on the padding.
pub(super) const BASE64: GeneralPurpose = GeneralPurpose::new(
    &base64::alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

pub(super) struct Buffers<'a> {
    views: &'a [BufferView],
    contents: Vec<Vec<u8>>,
}

impl<'a> Buffers<'a> {
    pub(super) fn read(document: &'a Document, binary: Option<&[u8]>, folder: &Path) -> Result<Self, Problem> {
        let mut contents = Vec::with_capacity(document.buffers.len());
        for (number, buffer) in document.buffers.iter().enumerate() {
            let mut bytes = match &buffer.uri {
                Some(uri) if is_data(uri) => decode_data(uri)?,
                Some(uri) => read_file(&place_of(uri, folder)?)?,
                None if number == 0 => {
                    binary.ok_or_else(|| malformed("its first buffer has neither a place nor a binary chunk"))?.to_vec()
                }
                None => return Err(malformed(format!("buffer {number} has no place"))),
            };
            if bytes.len() < buffer.byte_length {
                let Buffer { byte_length, .. } = buffer;
                return Err(truncated(&format!(
                    "buffer {number} has {} of {byte_length} bytes, the others",
                    bytes.len()
                )));
            }
            bytes.truncate(buffer.byte_length);
            contents.push(bytes);
        }
        Ok(Self { views: &document.buffer_views, contents })
    }

    /// The bytes of a view, and the distance from one element to the next if it says so.
    pub(super) fn view(&self, number: usize) -> Result<(&[u8], Option<usize>), Problem> {
        let view = self.views.get(number).ok_or_else(|| malformed(format!("buffer view {number} is not there")))?;
        let bytes = || self.contents.get(view.buffer)?.get(view.byte_offset..)?.get(..view.byte_length);
        let bytes = bytes().ok_or_else(|| malformed(format!("buffer view {number} leaves its buffer")))?;
        Ok((bytes, view.byte_stride))
    }

    /// Bytes in all buffers.
    pub(super) fn len(&self) -> usize {
        self.contents.iter().map(Vec::len).sum()
    }
}

/// The files that hold buffers, in the order of the document.
pub(super) fn external_files(document: &Document, folder: &Path) -> Result<Vec<PathBuf>, Problem> {
    let uris = document.buffers.iter().filter_map(|buffer| buffer.uri.as_deref());
    let mut files = Vec::new();
    for uri in uris.filter(|uri| !is_data(uri)) {
        let file = place_of(uri, folder)?;
        if !files.contains(&file) {
            files.push(file);
        }
    }
    Ok(files)
}

fn is_data(uri: &str) -> bool {
    uri.get(..5).is_some_and(|scheme| scheme.eq_ignore_ascii_case("data:"))
}

fn decode_data(uri: &str) -> Result<Vec<u8>, Problem> {
    let (kind, data) = uri.split_once(',').ok_or_else(|| malformed("a data URI has no comma"))?;
    if kind.ends_with(";base64") {
        BASE64.decode(data.trim_ascii()).map_err(|error| malformed(format!("a data URI is not base64: {error}")))
    } else {
        Ok(percent_decode_str(data).collect())
    }
}

/// The file that a relative URI names.
fn place_of(uri: &str, folder: &Path) -> Result<PathBuf, Problem> {
    let decoded = percent_decode_str(uri).decode_utf8().map_err(|_| malformed("the name of a buffer is not UTF-8"))?;
    let path = Path::new(decoded.as_ref());
    let is_relative =
        path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir | Component::ParentDir));
    // A scheme, as in https://, or a letter of a drive.
    if decoded.is_empty() || decoded.contains([':', '\0']) || !is_relative {
        let feature = "keeps a buffer in a place that is not beside it".into();
        return Err(Problem::Unsupported { feature, remedy: "export it with its buffers beside it or inside" });
    }
    Ok(folder.join(path))
}

/// The bytes of a regular file: a device or a pipe might never end.
fn read_file(path: &Path) -> Result<Vec<u8>, Problem> {
    let problem = |reason: String| Problem::Buffer { path: path.to_owned(), reason };
    let unreadable = |error: std::io::Error| problem(format!("cannot be read: {error}"));
    if !fs::metadata(path).map_err(unreadable)?.is_file() {
        return Err(problem("is not a file".into()));
    }
    fs::read(path).map_err(unreadable)
}
