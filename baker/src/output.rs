//! Files that are there whole or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;
use tempfile::NamedTempFile;

/// A file that appears under its name only once it is complete.
///
/// It is written beside its place and renamed on [`commit`](Self::commit). Dropped without that, it
/// leaves nothing behind and an older file untouched. A device or a pipe cannot be renamed over
/// without destroying it: those are written directly.
#[derive(Debug)]
pub struct OutputFile {
    target: PathBuf,
    destination: Destination,
}

#[derive(Debug)]
enum Destination {
    Temporary(NamedTempFile),
    Special(File),
}

impl OutputFile {
    /// Begins to write `path`.
    ///
    /// # Errors
    /// The folder does not exist or does not let this process create files, or `path` is a folder.
    pub fn create(path: &Path) -> io::Result<Self> {
        let target = match fs::metadata(path) {
            Ok(existing) if existing.is_dir() => {
                return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
            }
            Ok(existing) if !existing.is_file() => {
                let device = File::options().write(true).open(path)?;
                return Ok(Self { target: path.to_owned(), destination: Destination::Special(device) });
            }
            // A link stays a link: what it points to is replaced.
            Ok(_) => path.canonicalize()?,
            Err(_) => path.to_owned(),
        };
        let temporary = builder().tempfile_in(folder_of(&target))?;

        Ok(Self { target, destination: Destination::Temporary(temporary) })
    }

    /// Puts the complete file in its place.
    ///
    /// # Errors
    /// The disk is full or the place cannot be written; nothing is left behind then.
    pub fn commit(mut self) -> io::Result<()> {
        self.flush()?;

        match self.destination {
            Destination::Temporary(temporary) => {
                temporary.persist(&self.target).map_err(|failed| failed.error)?;
                Ok(())
            }
            Destination::Special(_) => Ok(()),
        }
    }
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.destination {
            Destination::Temporary(temporary) => temporary.write(bytes),
            Destination::Special(device) => device.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.destination {
            Destination::Temporary(temporary) => temporary.flush(),
            Destination::Special(device) => device.flush(),
        }
    }
}

/// Writes a whole file or nothing.
///
/// # Errors
/// As [`OutputFile::create`] and [`OutputFile::commit`].
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OutputFile::create(path)?;
    file.write_all(bytes)?;
    file.commit()
}

/// Writes a whole file, unless it is there already and holds these bytes. Returns whether it was written.
///
/// # Errors
/// As [`write()`].
pub fn write_if_changed(path: &Path, bytes: &[u8]) -> io::Result<bool> {
    // The length first: another length is another content, and nothing need be read.
    let same_length = fs::metadata(path).is_ok_and(|file| file.is_file() && file.len() == bytes.len() as u64);
    if same_length && fs::read(path).is_ok_and(|existing| existing == bytes) {
        return Ok(false);
    }
    write(path, bytes).map(|()| true)
}

/// Whether `path` could be written now: asked before the hours of work, not after.
///
/// # Errors
/// As [`OutputFile::create`].
pub fn check_writable(path: &Path) -> io::Result<()> {
    OutputFile::create(path).map(drop)
}

/// Removes the temporary files that killed processes left in a folder: those of this program that nobody has written to
/// for an hour. What cannot be removed stays.
pub fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let is_ours = entry.file_name().as_encoded_bytes().starts_with(TEMPORARY.as_bytes());
        let modified = entry.metadata().and_then(|file| file.modified()).ok();
        let age = modified.and_then(|modified| modified.elapsed().ok()).unwrap_or_default();
        if is_ours && entry.file_type().is_ok_and(|kind| kind.is_file()) && age >= ABANDONED {
            // Another process may have been faster.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// How the names of temporary files begin.
const TEMPORARY: &str = ".nearfield-temporary-";
/// A temporary file lives for as long as its bytes take to write.
const ABANDONED: Duration = Duration::from_secs(3600);

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Temporary files are private by default; this one becomes an ordinary file, so the umask decides.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(TEMPORARY);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(folder)
            .expect("the folder lists")
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_dropped_before_its_commit_leaves_the_old_one() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("field.nfd");
        write(&path, b"old").expect("the first write");

        let mut file = OutputFile::create(&path).expect("the second file");
        file.write_all(b"half of the ne").expect("its first half");
        drop(file);

        assert_eq!(fs::read(&path).expect("the old file"), b"old");
        assert_eq!(entries(folder.path()), ["field.nfd"]);
    }

    #[test]
    fn a_commit_replaces_the_old_file_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("field.nfd");
        write(&path, b"old").expect("the first write");
        write(&path, b"new").expect("the second write");

        assert_eq!(fs::read(&path).expect("the new file"), b"new");
        assert_eq!(entries(folder.path()), ["field.nfd"]);
    }

    #[test]
    fn the_same_bytes_are_not_written_again() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("field.nfd");
        let modified = || fs::metadata(&path).and_then(|file| file.modified()).expect("a time");

        assert!(write_if_changed(&path, b"old").expect("the first write"));
        let before = modified();
        assert!(!write_if_changed(&path, b"old").expect("no write"));
        assert_eq!(modified(), before);
        assert!(write_if_changed(&path, b"new").expect("the second write"));
        assert_eq!(fs::read(&path).expect("the new file"), b"new");
    }

    #[test]
    fn abandoned_temporary_files_are_swept_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder");
        let old = std::time::SystemTime::now() - 2 * ABANDONED;
        for (name, modified) in [("field.nfd", old), (".nearfield-temporary-old", old), (".nearfield-cache", old)] {
            let file = File::create(folder.path().join(name)).expect("a file");
            file.set_modified(modified).expect("its time");
        }
        File::create(folder.path().join(".nearfield-temporary-new")).expect("a file");

        sweep(folder.path());

        assert_eq!(entries(folder.path()), [".nearfield-cache", ".nearfield-temporary-new", "field.nfd"]);
    }

    #[test]
    fn a_folder_or_a_missing_folder_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");

        assert!(check_writable(folder.path()).is_err());
        assert!(check_writable(&folder.path().join("missing").join("field.nfd")).is_err());
        assert!(entries(folder.path()).is_empty());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_a_device_stays_a_device() {
        use std::os::unix::fs::FileTypeExt;
        let folder = tempfile::tempdir().expect("a folder");
        let (path, link) = (folder.path().join("field.nfd"), folder.path().join("link.nfd"));
        write(&path, b"old").expect("the first write");
        std::os::unix::fs::symlink(&path, &link).expect("a link");

        write(&link, b"new").expect("a write through the link");
        write(Path::new("/dev/null"), b"nowhere").expect("a write to a device");

        assert!(fs::symlink_metadata(&link).expect("the link").is_symlink());
        assert_eq!(fs::read(&path).expect("the file behind it"), b"new");
        assert!(fs::metadata("/dev/null").expect("the device").file_type().is_char_device());
    }
}
