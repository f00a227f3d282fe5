//! What may go wrong beside a bake: nothing is torn, nothing is lost, and the next run heals it.
//!
//! The kill loops are short here. The long form, with full disks and read-only folders: `.ci/faults`

use crate::support::{Bench, CUBE};
use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

const MANIFEST: &str = "\
output = 'fields'
settings = { max-depth = 4, samples = 500 }
[[assets]]
include = ['*.obj']
";

fn kills() -> u32 {
    std::env::var("NEARFIELD_KILLS").ok().and_then(|count| count.parse().ok()).unwrap_or(8)
}

fn start(bench: &Bench, arguments: &str) -> Child {
    Command::new(env!("CARGO_BIN_EXE_nearfield"))
        .args(arguments.split_whitespace())
        .current_dir(bench.path("."))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts")
}

/// Kills the program after a while that grows from run to run, from at once to well past its end.
fn kill_during(bench: &Bench, arguments: &str, run: u32, longest: Duration) {
    let mut child = start(bench, arguments);
    std::thread::sleep(longest * run / kills());
    // It may be done already.
    let _ = child.kill();
    child.wait().expect("the program ends");
}

/// How long an undisturbed run takes.
fn duration_of(bench: &Bench, arguments: &str) -> Duration {
    let start = std::time::Instant::now();
    bench.run(arguments).succeeds();
    start.elapsed()
}

#[test]
fn a_killed_bake_leaves_a_whole_field_or_none() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    let bake = "bake cube.obj -o cube.nfd --max-depth 5 --samples 500 --quiet";
    let longest = duration_of(&bench, bake).mul_f64(1.2);
    let whole = fs::read(bench.path("cube.nfd")).expect("the field");

    for run in 0..kills() {
        fs::remove_file(bench.path("cube.nfd")).ok();
        kill_during(&bench, bake, run, longest);
        if let Ok(bytes) = fs::read(bench.path("cube.nfd")) {
            assert!(bytes == whole, "run {run}");
        }
    }
}

#[test]
fn a_killed_batch_leaves_whole_fields_and_a_cache_that_heals() {
    let bench = Bench::new();
    bench.write("assets.toml", MANIFEST);
    for size in 1..=4 {
        bench.write(&format!("{size}.obj"), CUBE.replace("v 1 1 1", &format!("v 1 1 1.{size}")));
    }
    let longest = duration_of(&bench, "batch assets.toml").mul_f64(1.2);
    let fields = || {
        (1..=4).map(|size| fs::read(bench.path(&format!("fields/{size}.nfd"))).ok()).collect::<Vec<Option<Vec<u8>>>>()
    };
    let whole = fields();

    for run in 0..kills() {
        // Every other run starts from nothing, the rest from what the one before left.
        if run % 2 == 0 {
            fs::remove_dir_all(bench.path("fields")).ok();
            fs::remove_dir_all(bench.path(".nearfield-cache")).ok();
        }
        kill_during(&bench, "batch assets.toml", run, longest);
        for (found, expected) in fields().iter().zip(&whole) {
            assert!(found.is_none() || found == expected, "run {run}");
        }
        bench.run("batch assets.toml").succeeds();
        assert!(fields() == whole, "run {run}");
    }
}

#[test]
fn two_batches_at_once_agree() {
    let bench = Bench::new();
    bench.write("assets.toml", MANIFEST);
    for size in 1..=4 {
        bench.write(&format!("{size}.obj"), CUBE.replace("v 1 1 1", &format!("v 1 1 1.{size}")));
    }
    let mut batches: Vec<Child> = (0..3).map(|_| start(&bench, "batch assets.toml")).collect();
    for batch in &mut batches {
        assert!(batch.wait().expect("the program ends").success());
    }
    let outcome = bench.run("batch assets.toml");
    assert!(outcome.succeeds().stdout().contains("4 unchanged"), "{}", outcome.stdout());
    for size in 1..=4 {
        bench.run(&format!("info fields/{size}.nfd")).succeeds();
    }
}

#[test]
fn a_full_disk_is_said_and_leaves_nothing() {
    // /dev/full takes no byte; it is a device, so it is written directly.
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.run("bake cube.obj -o /dev/full --max-depth 4 --samples 500").fails(4, &["/dev/full", "space"]);
    bench.run("bake cube.obj -o cube.nfd --depfile /dev/full --max-depth 4 --samples 500").fails(4, &["/dev/full"]);
}

#[test]
fn an_output_that_is_a_folder_or_has_none_is_refused() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.write("assets.toml", MANIFEST);
    fs::create_dir_all(bench.path("fields/cube.nfd")).expect("a folder in the way");

    bench.run("bake cube.obj -o fields/cube.nfd").fails(4, &["fields/cube.nfd", "folder"]);
    bench.run("bake cube.obj -o missing/cube.nfd").fails(4, &["missing/cube.nfd"]);
    let batch = bench.run("batch assets.toml");
    assert_eq!(batch.output.status.code(), Some(4), "{}", batch.stderr());
}

#[test]
fn a_cache_that_cannot_be_used_costs_a_warning_and_no_field() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.write("assets.toml", MANIFEST);
    bench.write(".nearfield-cache", "a file where the cache should be");

    let batch = bench.run("batch assets.toml");
    batch.succeeds();
    assert!(batch.stderr().contains("the cache did not take it"), "{}", batch.stderr());
    bench.run("info fields/cube.nfd").succeeds();
}

#[cfg(unix)]
#[test]
fn a_mesh_that_changes_while_it_is_read_fails() {
    let bench = Bench::new();
    bench.write("assets.toml", MANIFEST.replace("*.obj", "pipe.obj"));
    bench.write("cube.obj", CUBE);

    // A pipe is written while it is read, and its time says so; the pauses are longer than the tick of any clock.
    let fill = "mkfifo pipe.obj; for turn in 1 2; do sleep 0.1; cat cube.obj > pipe.obj; done";
    let mut writer = Command::new("sh").args(["-c", fill]).current_dir(bench.path(".")).spawn().expect("a shell");
    while !bench.path("pipe.obj").exists() {
        std::thread::sleep(Duration::from_millis(5));
    }
    let batch = bench.run("batch assets.toml");
    writer.kill().ok();
    writer.wait().expect("the shell ends");

    assert_eq!(batch.output.status.code(), Some(3), "{}", batch.stderr());
    assert!(batch.stderr().contains("changed while it was read"), "{}", batch.stderr());
    assert!(!bench.path("fields/pipe.nfd").exists());
}

#[test]
fn paths_that_make_cannot_express_are_refused_before_the_bake() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.run("bake cube.obj -o cube.nfd --max-depth 4 --samples 500 --depfile cube.d").succeeds();
    let rule = fs::read_to_string(bench.path("cube.d")).expect("the depfile");
    assert_eq!(rule, "cube.nfd: \\\n  cube.obj\n");
    bench.run("bake cube.obj -o cube.nfd --depfile cube.nfd").fails(2, &["cube.nfd"]);
}
