use crate::support::{Bench, json};
use std::fs;

const SPOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/meshes/spot.ply");

/// A field of Spot with two levels of detail, and what the bake reported.
fn spot_with_levels(bench: &Bench) -> serde_json::Value {
    let bake = format!("bake {SPOT} -o spot.nfd --error 2e-3 --samples 10000 --lods 2 --report report.json");
    let bake = bench.run(&bake);
    bake.succeeds();
    assert_eq!(bake.stderr(), "", "no level is left out");
    for words in ["lod 1: ", "lod 2: ", "% of the field", "levels  "] {
        assert!(bake.stdout().contains(words), "no {words:?} in {}", bake.stdout());
    }
    json(&bench.path("report.json"))
}

fn answer(bench: &Bench, arguments: &str) -> f64 {
    let query = bench.run_with_input(arguments, b"0.1 0.2 0.3\n");
    query.succeeds().stdout().trim().parse().expect("a number")
}

#[test]
fn levels_are_baked_listed_and_cost_a_fifth_at_most() {
    let bench = Bench::new();
    let report = spot_with_levels(&bench);
    let levels = report["field"]["lods"].as_array().expect("levels");
    assert_eq!(levels.len(), 2);
    let bytes = |value: &serde_json::Value| value["bytes"].as_u64().expect("a number");
    let taken: u64 = levels.iter().map(bytes).sum();
    let all = bytes(&report["field"]);
    assert!(5 * taken <= all - taken, "{taken} of {all} bytes");
    assert_eq!(all, fs::metadata(bench.path("spot.nfd")).expect("the field").len());

    let mut finer = &report["field"];
    for level in levels {
        let number = |value: &serde_json::Value, name: &str| value[name].as_f64().expect("a number");
        let steps = number(level, "target_error") / number(finer, "target_error");
        assert!((steps - 4.0).abs() < 1e-5, "{steps} times the target");
        assert!(number(&level["errors"]["uniform"], "rmse") > number(&finer["errors"]["uniform"], "rmse"));
        finer = level;
    }
    let info = bench.run("info spot.nfd");
    assert!(info.succeeds().stdout().contains("LODS") && info.stdout().contains("lod 2: "), "{}", info.stdout());
}

#[test]
fn without_levels_the_field_is_the_same() {
    let bench = Bench::new();
    spot_with_levels(&bench);
    bench.run(&format!("bake {SPOT} -o plain.nfd --error 2e-3 --samples 10000")).succeeds();
    let diff = bench.run("diff plain.nfd spot.nfd --json");
    let diff: serde_json::Value = serde_json::from_slice(&diff.output.stdout).expect("JSON");
    assert_eq!((&diff["shared_box"]["max"], &diff["near_surface"]["max"]), (&0.0.into(), &0.0.into()), "{diff}");
    assert!(!bench.run("info plain.nfd --json").succeeds().stdout().contains("lods"));
}

#[test]
fn every_command_looks_at_the_level_that_it_is_told_to() {
    let bench = Bench::new();
    spot_with_levels(&bench);

    let [field, first, second] = [0, 1, 2].map(|level| answer(&bench, &format!("query spot.nfd --lod {level}")));
    assert_eq!(field, answer(&bench, "query spot.nfd"));
    assert!(field != first && first != second, "{field}, {first}, {second}");

    let verify = bench.run(&format!("verify spot.nfd --mesh {SPOT} --lod 1"));
    assert!(verify.succeeds().stdout().contains("keeps its contract"));
    bench.run(&format!("verify spot.nfd --mesh {SPOT} --lod 2 --samples 20000")).succeeds();

    for (command, output) in [
        ("slice spot.nfd --cells --resolution 64", "png"),
        ("render spot.nfd --size 48x48 --quiet", "png"),
        ("mesh spot.nfd --resolution 24", "ply"),
        ("view spot.nfd", "html"),
    ] {
        let name = command.split(' ').next().expect("a command");
        let [fine, coarse] = [0, 2].map(|level| {
            let place = format!("{name}-{level}.{output}");
            bench.run(&format!("{command} --lod {level} -o {place}")).succeeds();
            fs::read(bench.path(&place)).expect("the output")
        });
        assert!(fine != coarse, "{command}");
    }
    let ray = |level: u8| {
        let ray = bench.run_with_input(&format!("raycast spot.nfd --lod {level}"), b"0.1 0.2 9 0 0 -1\n");
        ray.succeeds().stdout()
    };
    assert!(ray(0).starts_with("hit") && ray(1).starts_with("hit") && ray(0) != ray(1));

    bench.run("query spot.nfd --lod 3").fails(2, &["spot.nfd", "no level of detail 3", "2"]);
}

#[test]
fn a_field_with_levels_fits_the_bytes_that_it_may_take() {
    let bench = Bench::new();
    bench.run(&format!("bake {SPOT} -o spot.nfd --max-bytes 16K --samples 2000 --lods 2")).succeeds();
    let bytes = fs::metadata(bench.path("spot.nfd")).expect("the field").len();
    assert!((14 << 10..=16 << 10).contains(&bytes), "{bytes} bytes");
    assert!(bench.run("info spot.nfd").stdout().contains("lod 1: "));
}

#[test]
fn what_would_cost_more_is_left_out_with_a_warning() {
    let bench = Bench::new();
    bench.bake_cube();
    bench.run("query cube.nfd --lod 1").fails(2, &["cube.nfd", "no levels of detail", "--lods"]);
    let bake = bench.run("bake cube.obj -o cube.nfd --error 0.1 --start-depth 0 --samples 2000 --lods 2");
    bake.succeeds();
    assert!(bake.stderr().contains("2 of the levels of detail"), "{}", bake.stderr());
    assert!(!bench.run("info cube.nfd").stdout().contains("LODS"));

    bench.run("bake cube.obj --pareto curve.json --lods 2").fails(2, &["--pareto", "--lods"]);
    bench.run("bake cube.obj -o cube.nfd --lods 9").fails(2, &["--lods"]);
}

#[test]
fn a_manifest_asks_for_levels_like_for_any_setting() {
    let bench = Bench::new();
    fs::copy(SPOT, bench.path("spot.ply")).expect("the mesh");
    let manifest = |lods: u8| {
        let settings = format!("settings = {{ error = 4e-3, samples = 2000, lods = {lods} }}");
        bench.write("assets.toml", format!("output = \"fields\"\n{settings}\n[[assets]]\ninclude = [\"spot.ply\"]\n"));
        bench.run("batch assets.toml").succeeds();
        bench.run("info fields/spot.nfd").succeeds().stdout()
    };
    assert!(!manifest(0).contains("lod 1"));
    assert!(manifest(1).contains("lod 1"), "other levels are another field");
}
