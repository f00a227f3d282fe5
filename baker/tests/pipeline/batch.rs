use crate::support::{Bench, CUBE, json};
use std::fs;
use std::time::{Duration, SystemTime};

const MANIFEST: &str = "\
output = 'fields'
settings = { max-depth = 4, samples = 500 }
[[assets]]
include = ['*.obj']
exclude = ['draft*.obj']
";

/// Two meshes that differ, a manifest for both, and times long past, so that no file counts as fresh.
fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("assets.toml", MANIFEST);
    bench.write("a.obj", CUBE);
    bench.write("b.obj", CUBE.replace("v 1 1 1", "v 1 1 1.1"));
    bench.write("draft1.obj", CUBE);
    for mesh in ["a.obj", "b.obj"] {
        age(&bench, mesh, 3600);
    }
    bench
}

fn age(bench: &Bench, name: &str, seconds: u64) {
    let file = fs::File::options().append(true).open(bench.path(name)).expect("the file");
    file.set_modified(SystemTime::now() - Duration::from_secs(seconds)).expect("its time");
}

/// What became of each mesh: `baked:new` and the like, in the order of the manifest.
fn verdicts(bench: &Bench, arguments: &str) -> Vec<String> {
    let outcome = bench.run(&format!("batch assets.toml --report batch.json {arguments}"));
    assert!(bench.path("batch.json").exists(), "{}", outcome.stderr());
    json(&bench.path("batch.json"))["assets"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|asset| {
            let text = |name: &str| asset[name].as_str().unwrap_or_default().to_owned();
            format!("{} {}: {}", text("mesh"), text("verdict"), text("reason"))
        })
        .collect()
}

#[test]
fn what_changed_is_baked_and_the_rest_is_left_alone() {
    let bench = bench();
    assert_eq!(verdicts(&bench, ""), ["a.obj baked: new", "b.obj baked: new"]);
    let first = fs::read(bench.path("fields/a.nfd")).expect("a field");
    bench.run("verify fields/b.nfd --mesh b.obj").succeeds();

    // Nothing changed; then nothing but a time.
    assert_eq!(verdicts(&bench, ""), ["a.obj unchanged: ", "b.obj unchanged: "]);
    age(&bench, "a.obj", 1800);
    assert_eq!(verdicts(&bench, ""), ["a.obj unchanged: ", "b.obj unchanged: "]);

    // One mesh; then the mesh as it was before.
    bench.write("a.obj", CUBE.replace("v 1 1 1", "v 1 1 1.2"));
    assert_eq!(verdicts(&bench, ""), ["a.obj baked: the mesh changed", "b.obj unchanged: "]);
    bench.write("a.obj", CUBE);
    assert_eq!(verdicts(&bench, ""), ["a.obj copied: the mesh changed", "b.obj unchanged: "]);
    assert!(fs::read(bench.path("fields/a.nfd")).expect("a field") == first, "the old field is back");

    // The outputs.
    fs::remove_file(bench.path("fields/b.nfd")).expect("the field is removed");
    assert_eq!(verdicts(&bench, "")[1], "b.obj copied: the field is missing");
    bench.write("fields/b.nfd", "scribble");
    assert_eq!(verdicts(&bench, "")[1], "b.obj copied: the field was changed by others");

    // The settings.
    bench.write("assets.toml", MANIFEST.replace("max-depth = 4", "max-depth = 5"));
    assert_eq!(verdicts(&bench, ""), ["a.obj baked: the settings changed", "b.obj baked: the settings changed"]);
    assert_eq!(verdicts(&bench, "--force"), ["a.obj baked: forced", "b.obj baked: forced"]);
    assert!(!bench.path("fields/draft1.nfd").exists(), "excluded");
}

#[test]
fn a_change_that_keeps_size_and_time_within_the_clocks_tick_is_seen() {
    let bench = bench();
    // Fresh: the file system may not tell the second write from the first.
    bench.write("a.obj", CUBE);
    let modified = fs::metadata(bench.path("a.obj")).and_then(|file| file.modified()).expect("a time");
    verdicts(&bench, "");
    bench.write("a.obj", CUBE.replace("v 1 1 1", "v 1 1 2"));
    fs::File::options()
        .append(true)
        .open(bench.path("a.obj"))
        .and_then(|file| file.set_modified(modified))
        .expect("a time");

    assert_eq!(verdicts(&bench, "")[0], "a.obj baked: the mesh changed");
}

/// A triangle whose corners are in a file of their own.
const GLTF: &str = r#"{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": "corners.bin", "byteLength": 36}]}"#;

#[test]
fn a_mesh_whose_size_and_time_stayed_is_not_opened_and_its_buffers_are_known_all_the_same() {
    let bench = Bench::new();
    let corners = |last: f32| -> Vec<u8> {
        [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, last].into_iter().flat_map(f32::to_le_bytes).collect()
    };
    let write_long_ago = |name: &str, contents: &[u8]| {
        bench.write(name, contents);
        fs::File::options()
            .append(true)
            .open(bench.path(name))
            .and_then(|file| file.set_modified(SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000)))
            .expect("its time");
    };
    bench.write("assets.toml", MANIFEST.replace("*.obj", "*.gltf"));
    write_long_ago("lid.gltf", GLTF.as_bytes());
    write_long_ago("corners.bin", &corners(0.0));
    assert_eq!(verdicts(&bench, ""), ["lid.gltf baked: new"]);

    // Whoever opened this would see that it is no glTF.
    write_long_ago("lid.gltf", " ".repeat(GLTF.len()).as_bytes());
    assert_eq!(verdicts(&bench, ""), ["lid.gltf unchanged: "]);
    assert!(bench.run("batch assets.toml --force").stderr().contains("cannot read lid.gltf"));
    write_long_ago("lid.gltf", GLTF.as_bytes());

    // A file that the mesh names is watched without a look at the mesh.
    bench.write("corners.bin", corners(0.5));
    assert_eq!(verdicts(&bench, ""), ["lid.gltf baked: the mesh changed"]);
    fs::remove_file(bench.path("corners.bin")).expect("the buffer is removed");
    assert!(bench.run("batch assets.toml").stderr().contains("cannot read corners.bin"));
}

#[test]
fn a_dry_run_says_what_would_be_done_and_does_nothing() {
    let bench = bench();
    let files = bench.files();
    let outcome = bench.run("batch assets.toml --dry-run");
    outcome.succeeds();
    let command = "nearfield bake a.obj -o fields/a.nfd --max-depth=4 --samples=500";
    assert!(outcome.stdout().contains(command), "{}", outcome.stdout());
    assert_eq!(bench.files(), files);

    // The command does what the batch would have done.
    bench.run(&command.replace("nearfield ", "").replace("fields/", "")).succeeds();
    bench.run("batch assets.toml").succeeds();
    assert!(fs::read(bench.path("a.nfd")).expect("a field") == fs::read(bench.path("fields/a.nfd")).expect("a field"));
}

#[test]
fn a_bad_mesh_fails_alone() {
    let bench = bench();
    bench.write("a.obj", "v 0 0 0\nf 1 2 3\n");
    let outcome = bench.run("batch assets.toml");

    assert_eq!(outcome.output.status.code(), Some(3), "{}", outcome.stderr());
    assert!(outcome.stderr().contains("error: 1 of 2 meshes failed"), "{}", outcome.stderr());
    assert!(bench.path("fields/b.nfd").exists() && !bench.path("fields/a.nfd").exists());

    // Asked to stop at the first failure, it starts nothing more.
    let stopped = verdicts(&bench, "--jobs 1 --keep-going 1 --force");
    assert!(
        stopped[0].starts_with("a.obj failed: ") && stopped[1] == "b.obj not-started: others failed",
        "{stopped:?}"
    );

    // Repaired, it alone is baked.
    bench.write("a.obj", CUBE);
    assert_eq!(verdicts(&bench, ""), ["a.obj baked: new", "b.obj unchanged: "]);
}

#[test]
fn shards_share_the_manifest_out() {
    let bench = bench();
    assert_eq!(verdicts(&bench, "--shard 1/2"), ["a.obj baked: new"]);
    assert_eq!(verdicts(&bench, "--shard 2/2"), ["b.obj baked: new"]);
    assert_eq!(verdicts(&bench, ""), ["a.obj unchanged: ", "b.obj unchanged: "]);
    bench.run("batch assets.toml --shard 3/2").fails(2, &["I/N"]);
}

#[test]
fn jobs_and_threads_do_not_change_the_bytes() {
    let bench = bench();
    let bytes = |arguments: &str| {
        bench.run(&format!("batch assets.toml --force {arguments}")).succeeds();
        ["a", "b"].map(|name| fs::read(bench.path(&format!("fields/{name}.nfd"))).expect("a field"))
    };
    let one = bytes("--jobs 1 --threads 1");
    assert!(bytes("--jobs 2 --threads 8") == one);
    assert!(bytes("--jobs 8 --threads 2") == one);
}

#[test]
fn a_memory_budget_is_kept_or_refused_with_a_sentence() {
    let bench = bench();
    assert_eq!(verdicts(&bench, "--memory 40M --jobs 4"), ["a.obj baked: new", "b.obj baked: new"]);
    let refused = bench.run("batch assets.toml --force --memory 1M");
    assert_eq!(refused.output.status.code(), Some(6), "{}", refused.stderr());
    assert!(refused.stderr().starts_with("error: ") && refused.stderr().contains("raise --memory"));
    bench.run("batch assets.toml --memory 1M").succeeds();
    bench.run("batch assets.toml --memory 1T").fails(2, &["--memory"]);
}

#[test]
fn a_cache_may_be_shared_and_damaged() {
    let bench = bench();
    bench.run("batch assets.toml --cache shared").succeeds();

    // Another checkout with the same cache bakes nothing.
    let other = bench_with_cache(&bench);
    assert_eq!(other, ["a.obj copied: new", "b.obj copied: new"]);

    // A damaged entry is baked again, and healed.
    for entry in walk(&bench, "shared/fields") {
        let mut bytes = fs::read(&entry).expect("an entry");
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        fs::write(&entry, bytes).expect("damage");
    }
    assert_eq!(bench_with_cache(&bench), ["a.obj baked: new", "b.obj baked: new"]);
    assert_eq!(bench_with_cache(&bench), ["a.obj copied: new", "b.obj copied: new"]);
}

/// The verdicts of a second folder of the same meshes that uses the first one's cache.
fn bench_with_cache(first: &Bench) -> Vec<String> {
    let second = bench();
    verdicts(&second, &format!("--cache {}", first.path("shared").display()))
}

fn walk(bench: &Bench, folder: &str) -> Vec<std::path::PathBuf> {
    let list = |folder: std::path::PathBuf| {
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect::<Vec<_>>()
    };
    list(bench.path(folder)).into_iter().flat_map(list).collect()
}

#[test]
fn a_wrong_manifest_is_a_usage_error_that_says_where() {
    let bench = bench();
    let wrong = |manifest: &str, words: &[&str]| {
        bench.write("assets.toml", manifest);
        bench.run("batch assets.toml").fails(2, words);
    };
    wrong("output = ", &["assets.toml", "line 1"]);
    wrong(&MANIFEST.replace("max-depth", "max-dept"), &["a.obj", "--max-dept"]);
    wrong(&MANIFEST.replace("max-depth = 4", "max-depth = 99"), &["a.obj", "99"]);
    bench.run("batch missing.toml").fails(2, &["missing.toml"]);
}
