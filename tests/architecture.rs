use std::fs;
use std::path::{Path, PathBuf};

/// The rooms of the baker in the order of the data. A room may use those before it.
const FLOW: [&str; 10] =
    ["import", "mesh", "distance", "sampling", "quantize", "octree", "grid", "polynomial", "encode", "verify"];
/// Plain shapes and doors that every room may use.
const SHARED: [&str; 7] = ["corner", "field_function", "geometry", "morton", "progress", "random", "settings"];
/// Rooms that do not know that there are files.
const BYTELESS: [&str; 3] = ["import", "mesh", "distance"];

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The source files of a room, which is a folder or a file.
fn sources(room: &str) -> Vec<PathBuf> {
    let file = repository().join("baker/src").join(room).with_extension("rs");
    if file.exists() {
        return vec![file];
    }
    let mut found = Vec::new();
    let mut folders = vec![repository().join("baker/src").join(room)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    assert!(!found.is_empty(), "the room {room} has no source");
    found
}

/// What follows `crate::` in a source, once for each time it occurs.
fn rooms_used(source: &str) -> Vec<String> {
    let after = source.split("crate::").skip(1);
    after.map(|rest| rest.chars().take_while(|&letter| letter.is_alphanumeric() || letter == '_').collect()).collect()
}

#[test]
fn data_flows_one_way() {
    for (index, room) in FLOW.iter().enumerate() {
        let allowed = [&FLOW[..=index], &SHARED].concat();
        for path in sources(room) {
            for used in rooms_used(&read(&path)) {
                assert!(allowed.contains(&used.as_str()), "{} uses crate::{used:?}", path.display());
            }
        }
    }
}

#[test]
fn shared_shapes_do_not_know_the_pipeline() {
    // The settings name the sign choice, whose home is the distance.
    let allowed = [&SHARED[..], &["distance"]].concat();
    for shape in SHARED {
        for path in sources(shape) {
            for used in rooms_used(&read(&path)) {
                assert!(allowed.contains(&used.as_str()), "{} uses crate::{used:?}", path.display());
            }
        }
    }
}

#[test]
fn distances_know_no_bytes() {
    for room in BYTELESS {
        for path in sources(room) {
            assert!(!read(&path).contains("nearfield::"), "{} uses the file format", path.display());
        }
    }
}

#[test]
fn every_room_is_held_to_these_rules() {
    // What stands at the end of the pipeline or beside it may use everything.
    const ABOVE: [&str; 13] = [
        "bake", "lod", "smallest", "pareto", "inspect", "batch", "budget", "depfile", "report", "output", "picture",
        "cli", "main",
    ];
    let known = [&FLOW[..], &SHARED, &ABOVE, &["lib"]].concat();
    for entry in fs::read_dir(repository().join("baker/src")).expect("the baker's source") {
        let path = entry.expect("an entry").path();
        let room = path.file_stem().and_then(|stem| stem.to_str()).expect("a name in UTF-8");
        assert!(known.contains(&room), "{room} has no place in the flow");
    }
}

#[test]
fn the_reader_stands_alone() {
    let manifest = read(&repository().join("runtime/Cargo.toml"));
    let tables = manifest.lines().filter(|line| line.starts_with('['));
    for table in tables {
        assert!(!table.contains("dependencies"), "the reader has {table}");
    }

    let library = read(&repository().join("runtime/src/lib.rs"));
    for promise in ["#![no_std]", "#![forbid(unsafe_code)]"] {
        assert!(library.contains(promise), "the reader does not promise {promise}");
    }
}

#[test]
fn the_scan_sees_what_it_should() {
    let source = "use crate::mesh::Weld;\nlet x = crate::octree::build();\nuse crate::{verify, mesh};\n";
    assert_eq!(rooms_used(source), ["mesh", "octree", ""]);
    // A group gives an empty name, which no rule allows: groups are written out.
}
