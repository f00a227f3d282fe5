use std::fs;
use std::path::Path;

/// The folders `regressions` and `seeds` of `fuzz/` have one for each target that needs it.
#[test]
fn what_the_fuzzers_found_stays_fixed() {
    let mut replayed = 0;
    for (name, property) in nearfield_fuzz::PROPERTIES {
        for kind in ["regressions", "seeds"] {
            let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz").join(kind).join(name);
            for entry in fs::read_dir(folder).into_iter().flatten() {
                let path = entry.expect("an entry").path();
                println!("{}", path.display());
                property(&fs::read(&path).expect("an input"));
                replayed += 1;
            }
        }
    }
    assert!(replayed > 0, "nothing was replayed");
}

/// Vectors are the seeds of the targets that read fields.
#[test]
fn the_vectors_hold_every_property_of_the_reader() {
    for kind in ["valid", "invalid"] {
        let folder = crate::vectors::folder(kind);
        for name in crate::vectors::names(&folder) {
            let bytes = crate::vectors::read(&folder, &name);
            for (_, property) in &nearfield_fuzz::PROPERTIES[..4] {
                property(&bytes);
            }
        }
    }
}
