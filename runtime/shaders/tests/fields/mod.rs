//! Fields to compare readers on.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Bytes of a field, and what to call it.
pub(crate) struct Sample {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Every valid vector of the format, with the points of its answers.
pub(crate) fn vectors() -> Vec<(Sample, Vec<[f32; 3]>)> {
    let folder = repository().join("format-spec/vectors/valid");
    let entries = folder.read_dir().expect("the vectors").map(|entry| entry.expect("a vector").path());
    let mut paths: Vec<PathBuf> = entries.filter(|path| path.extension() == Some(OsStr::new("nfd"))).collect();
    paths.sort();
    paths.iter().map(|path| (sample(path), points_of(&path.with_extension("json")))).collect()
}

/// The field in a file.
pub(crate) fn sample(path: &Path) -> Sample {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Sample { name, bytes: std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display())) }
}

fn points_of(path: &Path) -> Vec<[f32; 3]> {
    let text = std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let answers: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
    let number = |value: &serde_json::Value| match value.as_str() {
        Some(name) => name.parse().expect("nan, inf or -inf"),
        None => value.as_f64().expect("a number") as f32,
    };
    let answers = answers.as_array().expect("a list").iter();
    answers.map(|answer| [0, 1, 2].map(|axis| number(&answer["point"][axis]))).collect()
}

/// The command line of this repository, from `NEARFIELD` or where Cargo builds it. Says aloud that there is none; panics
/// if that may not be.
pub(crate) fn baker() -> Option<PathBuf> {
    let named = std::env::var_os("NEARFIELD").map(PathBuf::from);
    let built = ["release", "debug"].map(|profile| repository().join("target").join(profile).join("nearfield"));
    let found = named.into_iter().chain(built).find(|path| path.is_file());
    if found.is_none() {
        let ci = std::env::var("CI").is_ok_and(|value| value == "true");
        assert!(!ci, "build the command line first: cargo build --release");
        eprintln!("SKIPPED: the command line is not built (cargo build --release)");
    }
    found
}

/// Runs the command line with these arguments.
pub(crate) fn run(baker: &Path, arguments: &[&str]) {
    let output = Command::new(baker).args(arguments).output().expect("the command line starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {errors}");
}

/// A field of the mesh of the tests, baked into a folder.
pub(crate) fn bake(baker: &Path, folder: &Path, name: &str, arguments: &[&str]) -> PathBuf {
    let mesh = repository().join("tests/meshes/spot.ply");
    let path = folder.join(name).with_extension("nfd");
    let (mesh, output) = (mesh.to_string_lossy(), path.to_string_lossy());
    run(baker, &[&["bake", &mesh, "-o", &output, "--samples", "2000", "--quiet"], arguments].concat());
    path
}
