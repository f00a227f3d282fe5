//! The examples under `examples/`, run by the real tools. A tool that is missing is skipped aloud, and is a failure where
//! `CI=true`.

use crate::support::{Bench, CUBE};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, SystemTime};

/// One way to build the example.
struct Tool {
    example: &'static str,
    /// What must be installed.
    programs: &'static [&'static str],
    /// The command line; `NEARFIELD` stands for the program.
    command: &'static str,
    /// Folder of the fields.
    output: &'static str,
    /// A setting, and what to write over it.
    setting: (&'static str, &'static str, &'static str),
}

const NINJA: Tool = Tool {
    example: "ninja",
    programs: &["ninja"],
    command: "sed -i s#^nearfield.=.*#nearfield=NEARFIELD# build.ninja && ninja",
    output: ".",
    setting: ("settings.ninja", "1e-3", "2e-3"),
};
const MAKE: Tool = Tool {
    example: "make",
    programs: &["make"],
    command: "make NEARFIELD=NEARFIELD",
    output: ".",
    setting: ("settings.mk", "1e-3", "2e-3"),
};
const CMAKE_NINJA: Tool = Tool {
    example: "cmake",
    programs: &["cmake", "ninja"],
    command: "cmake -G Ninja -S . -B out -DNEARFIELD=NEARFIELD && cmake --build out",
    output: "out",
    setting: ("CMakeLists.txt", "1e-3", "2e-3"),
};
const CMAKE_MAKE: Tool = Tool {
    example: "cmake",
    programs: &["cmake", "make"],
    command: "cmake -G 'Unix Makefiles' -S . -B out -DNEARFIELD=NEARFIELD && cmake --build out",
    output: "out",
    setting: ("CMakeLists.txt", "1e-3", "2e-3"),
};

impl Tool {
    fn is_installed(&self) -> bool {
        let missing = self.programs.iter().find(|program| {
            !Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
        });
        if let Some(program) = missing {
            assert!(std::env::var("CI").as_deref() != Ok("true"), "{program} is not installed");
            eprintln!("SKIPPED: {program} is not installed");
        }
        missing.is_none()
    }

    fn set_up(&self) -> Bench {
        let bench = Bench::new();
        let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(self.example);
        for entry in fs::read_dir(example).expect("the example") {
            let path = entry.expect("an entry").path();
            let name = path.file_name().and_then(|name| name.to_str()).expect("a name in UTF-8");
            bench.write(name, fs::read(&path).expect("a file of the example"));
        }
        bench
    }

    fn build(&self, bench: &Bench) -> Output {
        let command = self.command.replace("=NEARFIELD", concat!("=", env!("CARGO_BIN_EXE_nearfield")));
        Command::new("sh").args(["-c", &command]).current_dir(bench.path(".")).output().expect("a shell")
    }

    #[track_caller]
    fn builds(&self, bench: &Bench) {
        let output = self.build(bench);
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
    }

    /// When the field was written.
    fn time(&self, bench: &Bench, field: &str) -> SystemTime {
        fs::metadata(bench.path(self.output).join(field)).and_then(|file| file.modified()).expect("the field is there")
    }

    /// The whole story.
    fn exercise(&self) {
        if !self.is_installed() {
            return;
        }
        let bench = self.set_up();
        let times = || ["left.nfd", "right.nfd"].map(|field| self.time(&bench, field));

        // The first build, and one with nothing to do.
        self.builds(&bench);
        let first = times();
        self.builds(&bench);
        assert_eq!(times(), first, "no-op");

        // A changed mesh, alone. Make counts whole ticks: give it one.
        tick();
        bench.write("left.obj", CUBE.replace("v 1 1 1", "v 1 1 1.5"));
        self.builds(&bench);
        let [left, right] = times();
        assert!(left > first[0] && right == first[1], "changed mesh");

        // A touched mesh builds, and then there is nothing to do.
        tick();
        touch(&bench, "left.obj");
        self.builds(&bench);
        let touched = times();
        self.builds(&bench);
        assert_eq!(times(), touched, "no-op after a touch");

        // A changed setting.
        tick();
        let (file, from, to) = self.setting;
        let text = fs::read_to_string(bench.path(file)).expect("the settings");
        assert!(text.contains(from), "{file} has no {from}");
        bench.write(file, text.replace(from, to));
        fs::remove_file(bench.path("out/CMakeCache.txt")).ok();
        let before = fs::read(bench.path(self.output).join("left.nfd")).expect("a field");
        self.builds(&bench);
        assert!(fs::read(bench.path(self.output).join("left.nfd")).expect("a field") != before, "changed setting");

        // A deleted output.
        fs::remove_file(bench.path(self.output).join("right.nfd")).expect("the field is removed");
        self.builds(&bench);
        let whole = times();

        // A broken mesh fails the build and leaves the old field; repaired, it builds.
        tick();
        bench.write("left.obj", "f 1 2 3\n");
        assert!(!self.build(&bench).status.success(), "a broken mesh fails");
        assert!(!bench.path(self.output).join("left.nfd").exists() || self.time(&bench, "left.nfd") == whole[0]);
        tick();
        bench.write("left.obj", CUBE);
        self.builds(&bench);
    }
}

fn tick() {
    std::thread::sleep(Duration::from_millis(20));
}

fn touch(bench: &Bench, name: &str) {
    let file = fs::File::options().append(true).open(bench.path(name)).expect("the file");
    file.set_modified(SystemTime::now()).expect("its time");
}

#[test]
fn ninja() {
    NINJA.exercise();
}

#[test]
fn ninja_stops_where_bytes_stay_the_same() {
    if !NINJA.is_installed() {
        return;
    }
    let bench = NINJA.set_up();
    NINJA.builds(&bench);
    let packed = fs::metadata(bench.path("pack.bin")).and_then(|file| file.modified()).expect("the pack");
    tick();
    touch(&bench, "left.obj");
    NINJA.builds(&bench);
    let after = fs::metadata(bench.path("pack.bin")).and_then(|file| file.modified()).expect("the pack");
    assert_eq!(after, packed, "restat cuts the build off");
}

#[test]
fn make() {
    MAKE.exercise();
}

#[test]
fn cmake_for_ninja() {
    CMAKE_NINJA.exercise();
}

#[test]
fn cmake_for_make() {
    CMAKE_MAKE.exercise();
}
