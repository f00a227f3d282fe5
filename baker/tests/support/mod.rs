//! A folder for every test, and the program run in it.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

pub(crate) const CUBE: &str = "\
v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1
f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5
f 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n";

/// A folder of its own for every test.
pub(crate) struct Bench {
    folder: TempDir,
}

impl Bench {
    pub(crate) fn new() -> Self {
        Self { folder: tempfile::tempdir().expect("a folder") }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, contents: impl AsRef<[u8]>) {
        fs::write(self.path(name), contents).expect("the file is written");
    }

    pub(crate) fn run(&self, arguments: &str) -> Outcome {
        self.run_with_input(arguments, b"")
    }

    pub(crate) fn run_with_input(&self, arguments: &str, input: &[u8]) -> Outcome {
        let mut child = Command::new(env!("CARGO_BIN_EXE_nearfield"))
            .args(arguments.split_whitespace())
            .current_dir(self.folder.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        // A program that fails early does not read its input: the pipe may be closed already.
        let _ = child.stdin.take().expect("a pipe").write_all(input);
        Outcome { arguments: arguments.to_owned(), output: child.wait_with_output().expect("the program ends") }
    }

    /// Bakes the cube, coarsely, and checks that it worked.
    pub(crate) fn bake_cube(&self) {
        self.write("cube.obj", CUBE);
        self.run("bake cube.obj -o cube.nfd --max-depth 5 --samples 2000").succeeds();
    }

    pub(crate) fn files(&self) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(self.folder.path())
            .expect("the folder lists")
            .map(|entry| entry.expect("an entry").file_name().into_string().expect("a name in UTF-8"))
            .collect();
        names.sort();
        names
    }
}

pub(crate) struct Outcome {
    arguments: String,
    pub(crate) output: Output,
}

impl Outcome {
    pub(crate) fn stdout(&self) -> String {
        String::from_utf8(self.output.stdout.clone()).expect("text")
    }

    pub(crate) fn stderr(&self) -> String {
        String::from_utf8(self.output.stderr.clone()).expect("text")
    }

    #[track_caller]
    pub(crate) fn succeeds(&self) -> &Self {
        assert_eq!(self.output.status.code(), Some(0), "{}: {}", self.arguments, self.stderr());
        self
    }

    /// Fails with this code and one sentence that holds all of `words`.
    #[track_caller]
    pub(crate) fn fails(&self, code: i32, words: &[&str]) -> &Self {
        let stderr = self.stderr();
        assert_eq!(self.output.status.code(), Some(code), "{}: {stderr}", self.arguments);
        assert!(stderr.starts_with("error: "), "{}: {stderr}", self.arguments);
        if code != 2 {
            assert_eq!(stderr.lines().count(), 1, "one sentence: {stderr}");
        }
        for word in words {
            assert!(stderr.contains(word), "{}: no {word:?} in {stderr:?}", self.arguments);
        }
        self
    }
}

pub(crate) fn json(path: &Path) -> serde_json::Value {
    serde_json::from_slice(&fs::read(path).expect("the report")).expect("JSON")
}
