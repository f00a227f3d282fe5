//! The vectors of `format-spec/vectors`: how they were made. Readers are held to the files, not to this.
//!
//! `NEARFIELD_WRITE_VECTORS=1 cargo test -p conformance vectors` writes those that are missing. None is ever rewritten:
//! what a published file means does not change.

mod grid;
pub(crate) mod invalid;
mod invalid_grids;
mod invalid_polynomials;
mod lods;
pub(crate) mod polynomial;
pub(crate) mod samples;
pub(crate) mod valid;
mod valid_grids;
mod valid_polynomials;
pub(crate) mod writer;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the valid or the invalid vectors.
pub(crate) fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../format-spec/vectors").join(name)
}

/// Names of the vectors in a folder, in order, without the extension.
pub(crate) fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let fields = paths.filter(|path| path.extension().is_some_and(|extension| extension == "nfd"));
    fields.map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned()).collect()
}

/// The bytes of a vector.
pub(crate) fn read(folder: &Path, name: &str) -> Vec<u8> {
    let path = folder.join(name).with_extension("nfd");
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The error that each invalid vector must be refused with.
pub(crate) fn manifest() -> BTreeMap<String, String> {
    let path = folder("invalid").join("manifest.json");
    let text = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_slice(&text).expect("names and errors")
}

#[test]
fn vectors_are_what_the_writer_writes() {
    let (valid, invalid) = (valid::all(), invalid::all());
    if std::env::var_os("NEARFIELD_WRITE_VECTORS").is_some() {
        write_missing(&valid, &invalid);
    }

    for (kind, vectors) in [
        ("valid", valid.iter().map(|(name, bytes)| (name, bytes)).collect::<BTreeMap<_, _>>()),
        ("invalid", invalid.iter().map(|vector| (&vector.name, &vector.bytes)).collect()),
    ] {
        let folder = folder(kind);
        assert!(names(&folder).iter().eq(vectors.keys().copied()), "{kind}: other files than the writer's");
        for (name, bytes) in vectors {
            assert!(read(&folder, name) == *bytes, "{kind}/{name} is not what the writer writes");
        }
    }
    assert_eq!(valid.len(), names(&folder("valid")).len(), "a name comes twice");
    assert_eq!(invalid.len(), names(&folder("invalid")).len(), "a name comes twice");
    let errors = invalid.iter().map(|vector| (vector.name.clone(), vector.error.to_owned()));
    assert_eq!(errors.collect::<BTreeMap<_, _>>(), manifest());
}

fn write_missing(valid: &[(String, Vec<u8>)], invalid: &[invalid::Invalid]) {
    for kind in ["valid", "invalid"] {
        fs::create_dir_all(folder(kind)).expect("a folder");
    }
    for (name, bytes) in valid {
        let path = folder("valid").join(name).with_extension("nfd");
        if !path.exists() {
            fs::write(&path, bytes).expect("written");
            let reader = folder("../reference_reader.py");
            let output = Command::new("python3").arg(reader).arg("expect").arg(&path).output().expect("python3");
            assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
            fs::write(path.with_extension("json"), output.stdout).expect("written");
        }
    }
    for vector in invalid {
        let path = folder("invalid").join(&vector.name).with_extension("nfd");
        if !path.exists() {
            fs::write(path, &vector.bytes).expect("written");
        }
    }
    let errors: BTreeMap<&str, &str> = invalid.iter().map(|vector| (vector.name.as_str(), vector.error)).collect();
    let text = serde_json::to_string_pretty(&errors).expect("names and errors");
    fs::write(folder("invalid").join("manifest.json"), text + "\n").expect("written");
}
