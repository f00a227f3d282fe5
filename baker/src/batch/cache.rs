//! A folder of finished fields, each under the hash of all that decides its bytes, and of what is known about outputs.
//!
//! Any number of processes may use one folder at once: every file appears whole, by a rename, and two processes that
//! write the same name write the same bytes.

use super::change::Stamp;
use crate::output;
use nearfield::Field;
use std::io;
use std::path::{self, Path, PathBuf};
use std::{fmt, fs};

/// Hash of all that decides the bytes of a field: inputs, settings, version of the baker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key(blake3::Hash);

impl Key {
    /// The key of a bake from the hashes of the contents of its inputs, in their order.
    pub(super) fn new(contents: &[String], settings: [u8; 8], baker: &str) -> Self {
        let mut hasher = blake3::Hasher::new_derive_key("nearfield field cache 1");
        hasher.update(&settings).update(&(baker.len() as u64).to_le_bytes()).update(baker.as_bytes());
        for content in contents {
            hasher.update(content.as_bytes());
        }
        Self(hasher.finalize())
    }
}

impl fmt::Display for Key {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

/// The folder. Deleting it, or any part of it at any time, costs nothing but time.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
}

impl Cache {
    /// The cache in this folder, which need not exist yet.
    pub fn new(folder: PathBuf) -> Self {
        Self { folder }
    }

    /// A field baked before. A damaged or unreadable entry is none.
    pub fn field(&self, key: &Key) -> Option<Vec<u8>> {
        let bytes = fs::read(self.field_path(key)).ok()?;
        let is_valid = Field::open(&bytes).is_ok_and(|field| field.validate().is_ok());
        is_valid.then_some(bytes)
    }

    /// Keeps a field.
    ///
    /// # Errors
    /// The cache cannot be written.
    pub fn keep(&self, key: &Key, field: &[u8]) -> io::Result<()> {
        write(&self.field_path(key), field)
    }

    /// What is known about an output.
    pub(super) fn stamp(&self, output: &Path) -> Option<Stamp> {
        serde_json::from_slice(&fs::read(self.stamp_path(output).ok()?).ok()?).ok()
    }

    /// Remembers it.
    pub(super) fn remember(&self, output: &Path, stamp: &Stamp) -> io::Result<()> {
        write(&self.stamp_path(output)?, &serde_json::to_vec(stamp)?)
    }

    fn field_path(&self, key: &Key) -> PathBuf {
        let name = key.to_string();
        // No folder of ten thousand files.
        self.folder.join("fields").join(&name[..2]).join(name).with_extension("nfd")
    }

    fn stamp_path(&self, output: &Path) -> io::Result<PathBuf> {
        let name = blake3::hash(path::absolute(output)?.as_os_str().as_encoded_bytes());
        Ok(self.folder.join("outputs").join(name.to_string()).with_extension("json"))
    }
}

fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    output::write(path, bytes)
}
