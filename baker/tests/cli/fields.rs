use crate::support::{Bench, CUBE, json};
use std::fs;

#[test]
fn a_mesh_becomes_a_field_that_answers_and_keeps_its_contract() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);

    let bake = bench.run("bake cube.obj -o cube.nfd --max-depth 6 --samples 5000 --report report.json");
    bake.succeeds();
    for words in ["12 triangles", "closed", "bytes", "uniform", "band", "CPU", "total"] {
        assert!(bake.stdout().contains(words), "no {words:?} in {}", bake.stdout());
    }
    assert_eq!(bake.stderr(), "", "no progress bar without a terminal");
    let report = json(&bench.path("report.json"));
    assert_eq!(report["schema"], 1);
    assert_eq!(report["mesh"]["triangles"], 12);
    assert_eq!(report["field"]["bytes"], fs::metadata(bench.path("cube.nfd")).expect("the field").len());

    let info = bench.run("info cube.nfd");
    info.succeeds();
    assert!(info.stdout().contains("pseudonormal"), "{}", info.stdout());
    let info = bench.run("info cube.nfd --json");
    let info: serde_json::Value = serde_json::from_slice(&info.succeeds().output.stdout).expect("JSON");
    assert_eq!(info, report["field"]);

    let query = bench.run_with_input("query cube.nfd", b"0.5 0.5 0.5\n\n0.5 0.5 1.1\n");
    let answers: Vec<f64> =
        query.succeeds().stdout().lines().map(|line| line.parse().expect("a number per line")).collect();
    let max = report["measured"]["uniform"]["max"].as_f64().expect("a number");
    assert_eq!(answers.len(), 2);
    assert!((answers[0] + 0.5).abs() <= 2.0 * max, "{answers:?}, off by at most {max}");
    assert!((answers[1] - 0.1).abs() <= 2.0 * max, "{answers:?}, off by at most {max}");

    let verify = bench.run("verify cube.nfd --mesh cube.obj");
    verify.succeeds();
    assert!(verify.stdout().contains("keeps its contract"), "{}", verify.stdout());
    bench.run("verify cube.nfd --mesh cube.obj --samples 20000").succeeds();

    bench.run("slice cube.nfd -o cube.png --cells --resolution 64 --axis y --at -10%").succeeds();
    assert!(fs::read(bench.path("cube.png")).expect("the picture").starts_with(b"\x89PNG"));

    assert_eq!(bench.files(), ["cube.nfd", "cube.obj", "cube.png", "report.json"]);
}

#[test]
fn a_budget_misses_no_target() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    let bake = bench.run("bake cube.obj -o cube.nfd --max-bytes 3000 --samples 5000");
    bake.succeeds();
    assert_eq!(bake.stderr(), "", "no error was asked for");
}

#[test]
fn verification_repeats_the_contract_to_the_digit() {
    let bench = Bench::new();
    bench.bake_cube();

    let verify = bench.run("verify cube.nfd --mesh cube.obj --json --threads 3");
    let report: serde_json::Value = serde_json::from_slice(&verify.succeeds().output.stdout).expect("JSON");

    assert_eq!(report["holds"], true);
    for set in ["uniform", "band"] {
        for figure in ["rmse", "p99", "max"] {
            let of = |side: &str| report[side][set][figure].as_f64().expect("a number");
            let (stored, measured) = (of("stored"), of("measured"));
            assert!((measured - stored).abs() <= 1e-4 * stored, "{set} {figure}: {measured} against {stored}");
        }
    }
}

#[test]
fn another_mesh_contradicts_the_contract() {
    let bench = Bench::new();
    bench.bake_cube();
    bench.write("other.obj", CUBE.replace("v 1 1 1", "v 1 1 1.01"));

    for samples in ["", " --samples 10000"] {
        bench.run(&format!("verify cube.nfd --mesh other.obj{samples}")).fails(1, &["cube.nfd", "other.obj", "hash"]);
    }
}

#[test]
fn a_field_can_go_through_a_pipe() {
    let bench = Bench::new();
    bench.bake_cube();

    let bake = bench.run("bake cube.obj -o - --max-depth 5 --samples 2000");
    bake.succeeds();

    assert_eq!(bake.output.stdout, fs::read(bench.path("cube.nfd")).expect("the field"));
    assert!(bake.stderr().contains("12 triangles"), "the summary makes way");
}

#[test]
fn quiet_is_quiet_but_warns() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    let bake = bench.run("bake cube.obj -o cube.nfd --max-depth 6 --samples 2000 --quiet");
    assert_eq!((bake.succeeds().stdout(), bake.stderr()), (String::new(), String::new()));

    // Without its last triangle.
    let open = CUBE.trim_end().rsplit_once('\n').expect("many lines").0;
    bench.write("open.obj", open);
    let bake = bench.run("bake open.obj -o open.nfd --max-depth 6 --samples 2000 --quiet");
    let stderr = bake.succeeds().stderr();
    assert_eq!(bake.stdout(), "");
    let about_the_hole = stderr.lines().next().expect("a warning");
    for words in ["warning: ", "open.obj", "3 edges at the rim of a hole", "winding numbers"] {
        assert!(about_the_hole.contains(words), "no {words:?} in {stderr}");
    }

    // Inside out.
    let inverted: String = CUBE
        .lines()
        .map(|line| match line.split(' ').collect::<Vec<_>>()[..] {
            ["f", a, b, c] => format!("f {a} {c} {b}\n"),
            _ => format!("{line}\n"),
        })
        .collect();
    bench.write("inverted.obj", inverted);
    let stderr = bench.run("bake inverted.obj -o inverted.nfd --max-depth 6 --samples 2000 -q").succeeds().stderr();
    assert!(stderr.contains("inside out"), "{stderr}");
}

#[test]
fn the_bench_compares_with_a_dense_grid() {
    let bench = Bench::new();
    bench.bake_cube();

    let report = bench.run("bench cube.nfd --json");
    let report: serde_json::Value = serde_json::from_slice(&report.succeeds().output.stdout).expect("JSON");

    let sets = report["sets"].as_array().expect("sets");
    assert_eq!(
        sets.iter().map(|set| set["points"].as_str()).collect::<Vec<_>>(),
        [Some("random"), Some("coherent"), Some("band")]
    );
    for set in sets {
        for figure in ["distance", "distance_and_gradient", "distances", "distances_and_gradients", "dense_distance"] {
            assert!(set[figure].as_f64().expect("a number") > 0.0, "{figure}");
        }
    }

    // Inside, outside and on a corner of the mesh.
    let points: [[f32; 3]; 3] = [[0.5, 0.5, 0.5], [9.0, 0.0, 0.0], [1.0, 1.0, 1.0]];
    bench.write("points.f32", points.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>());
    let given = bench.run("bench cube.nfd --points points.f32").succeeds().stdout();
    assert!(given.contains("given") && !given.contains("random"), "{given}");
}
