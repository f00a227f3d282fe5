//! Whether an output is what its inputs and settings would give now.
//!
//! Sizes and times of files decide where they can; contents are read where they cannot.

use super::cache::{Cache, Key};
use crate::import::{self, ImportError, Problem};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};
use std::{fmt, fs, io};

/// Files modified this shortly before they were looked at may change again without a new time: coarse file systems
/// count in two seconds.
const UNSETTLED: Duration = Duration::from_secs(2);
/// Part of every key: another version of the baker may give other bytes.
const BAKER: &str = env!("CARGO_PKG_VERSION");

/// What the file system says about a file: enough to notice most changes without reading it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct FileStamp {
    bytes: u64,
    modified: Duration,
}

impl FileStamp {
    fn of(path: &Path) -> io::Result<Self> {
        let metadata = fs::metadata(path)?;
        let modified = metadata.modified()?.duration_since(UNIX_EPOCH).unwrap_or_default();
        Ok(Self { bytes: metadata.len(), modified })
    }
}

/// What was known when an output was last found or made right.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Stamp {
    inputs: Vec<(PathBuf, FileStamp)>,
    contents: Vec<String>,
    settings: [u8; 8],
    baker: String,
    output: FileStamp,
    taken: Duration,
}

impl Stamp {
    /// Whether nothing can have changed, as far as sizes and times tell.
    ///
    /// Which files a mesh refers to is part of its content: the list is right as long as the mesh is.
    fn is_current(&self, mesh: &Path, settings: [u8; 8], output: &Path) -> bool {
        let unchanged = |path: &Path, stamp: &FileStamp| {
            let settled = stamp.modified + UNSETTLED < self.taken;
            settled && FileStamp::of(path).is_ok_and(|now| now == *stamp)
        };
        self.settings == settings
            && self.baker == BAKER
            && self.inputs.first().is_some_and(|(path, _)| path == mesh)
            && self.inputs.iter().all(|(path, stamp)| unchanged(path, stamp))
            && FileStamp::of(output).is_ok_and(|now| now == self.output)
    }
}

/// The inputs of a bake, as they were when they were read.
#[derive(Clone, Debug)]
pub struct Inputs {
    files: Vec<(PathBuf, FileStamp)>,
    contents: Vec<String>,
    settings: [u8; 8],
    /// Names the field that they give.
    pub key: Key,
}

impl Inputs {
    fn read(mesh: &Path, settings: [u8; 8]) -> Result<Self, ImportError> {
        // Before the mesh is asked what it refers to: should it change meanwhile, it will not be as it was.
        let mut files = vec![(mesh.to_owned(), FileStamp::of(mesh).map_err(|error| unreadable(mesh, error))?)];
        for path in import::inputs(mesh)?.into_iter().skip(1) {
            let stamp = FileStamp::of(&path).map_err(|error| unreadable(&path, error))?;
            files.push((path, stamp));
        }

        let mut contents = Vec::new();
        for (path, _) in &files {
            contents.push(blake3::hash(&fs::read(path).map_err(|error| unreadable(path, error))?).to_string());
        }
        Ok(Self { key: Key::new(&contents, settings, BAKER), files, contents, settings })
    }

    /// Length of all files together.
    pub fn bytes(&self) -> u64 {
        self.files.iter().map(|(_, stamp)| stamp.bytes).sum()
    }

    /// The first input that is no longer as it was when it was read, by the size and the time of the file.
    pub fn disturbed(&self) -> Option<&Path> {
        let changed = |(path, stamp): &&(PathBuf, FileStamp)| FileStamp::of(path).ok() != Some(*stamp);
        self.files.iter().find(changed).map(|(path, _)| path.as_path())
    }

    /// Remembers that `output` holds what these inputs give.
    ///
    /// # Errors
    /// The cache cannot be written.
    pub fn remember(&self, cache: &Cache, output: &Path) -> io::Result<()> {
        let stamp = Stamp {
            inputs: self.files.clone(),
            contents: self.contents.clone(),
            settings: self.settings,
            baker: BAKER.to_owned(),
            output: FileStamp::of(output)?,
            taken: SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default(),
        };
        cache.remember(output, &stamp)
    }
}

fn unreadable(path: &Path, error: io::Error) -> ImportError {
    ImportError { path: path.to_owned(), problem: Problem::Unreadable(error) }
}

/// Why an output is not up to date.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Nothing is known about it, and it is not there.
    New,
    /// It is there, but nothing is known about it.
    Unknown,
    /// An input has other contents.
    MeshChanged,
    /// It was baked with other settings.
    SettingsChanged,
    /// It was baked by another version.
    BakerChanged,
    /// It was there and is gone.
    OutputMissing,
    /// It is not what was written.
    OutputChanged,
    /// The user wants it.
    Forced,
}

impl fmt::Display for Reason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::New => "new",
            Self::Unknown => "the field is not known to the cache",
            Self::MeshChanged => "the mesh changed",
            Self::SettingsChanged => "the settings changed",
            Self::BakerChanged => "the baker changed",
            Self::OutputMissing => "the field is missing",
            Self::OutputChanged => "the field was changed by others",
            Self::Forced => "forced",
        })
    }
}

/// What is to be done about an output whose inputs were read.
#[derive(Clone, Debug)]
pub enum Change {
    /// Nothing: the time of an input was new, its content is not.
    Touched(Inputs),
    /// It must be made again.
    Stale(Reason, Inputs),
}

/// Whether an output is what its mesh would give now, by sizes and times alone: no mesh is opened.
///
/// A content that changed while size and time did not is not seen.
pub fn is_up_to_date(cache: &Cache, mesh: &Path, settings: [u8; 8], output: &Path) -> bool {
    cache.stamp(output).is_some_and(|stamp| stamp.is_current(mesh, settings, output))
}

/// Compares an output with what is remembered about it, by the contents of its inputs: the mesh and the files it refers to.
///
/// # Errors
/// An input cannot be read, or is a glTF whose description is damaged.
pub fn examine(
    cache: &Cache,
    mesh: &Path,
    settings: [u8; 8],
    output: &Path,
    force: bool,
) -> Result<Change, ImportError> {
    let inputs = Inputs::read(mesh, settings)?;
    Ok(match reason(cache.stamp(output).as_ref(), &inputs, output, force) {
        Some(reason) => Change::Stale(reason, inputs),
        None => Change::Touched(inputs),
    })
}

fn reason(stamp: Option<&Stamp>, inputs: &Inputs, output: &Path, force: bool) -> Option<Reason> {
    let now = FileStamp::of(output).ok();
    match (stamp, now) {
        (None, None) => Some(Reason::New),
        (None, Some(_)) => Some(Reason::Unknown),
        (Some(stamp), _) if stamp.contents != inputs.contents => Some(Reason::MeshChanged),
        (Some(stamp), _) if stamp.settings != inputs.settings => Some(Reason::SettingsChanged),
        (Some(stamp), _) if stamp.baker != BAKER => Some(Reason::BakerChanged),
        (Some(_), None) => Some(Reason::OutputMissing),
        (Some(stamp), Some(now)) if stamp.output != now => Some(Reason::OutputChanged),
        (Some(_), Some(_)) => force.then_some(Reason::Forced),
    }
}
