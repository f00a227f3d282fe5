//! Size against error.

use crate::support::{Bench, CUBE, json};
use std::fs;

#[test]
fn a_curve_is_drawn_and_written_from_coarse_to_fine() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    let command = "bake cube.obj --pareto curve.json --error 2e-3 --max-depth 6 --samples 2000 --layout auto";
    let run = bench.run(command);
    let table = run.succeeds().stdout().to_owned();

    let report = json(&bench.path("curve.json"));
    assert_eq!(report["mesh"], "cube.obj");
    let curves = report["curves"].as_array().expect("a list");
    let names: Vec<&str> = curves.iter().map(|curve| curve["name"].as_str().expect("a name")).collect();
    assert_eq!(names, ["uniform", "surface", "grid, hermite"]);
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    let mut rows = 0;
    for curve in curves {
        let fields = curve["fields"].as_array().expect("a list");
        assert!(!fields.is_empty(), "{curve}");
        for pair in fields.windows(2) {
            assert!(number(&pair[0]["bytes"]) <= number(&pair[1]["bytes"]), "{curve}");
        }
        rows += fields.len();
    }
    let uniform = curves[0]["fields"].as_array().expect("a list");
    let [coarsest, finest] = [&uniform[0], &uniform[5]];
    assert_eq!(uniform.len(), 6);
    assert!((number(&coarsest["error"]) / number(&finest["error"]) - 32.0).abs() < 1e-9);
    let rmse = |field: &serde_json::Value| number(&field["measured"]["uniform"]["rmse"]);
    assert!(rmse(finest) < 0.5 * rmse(coarsest), "{} and {}", rmse(coarsest), rmse(finest));
    assert_eq!(table.lines().count(), 2 + rows, "a row for each field: {table}");

    let chart = fs::read_to_string(bench.path("curve.svg")).expect("a chart");
    assert_eq!(chart.matches("<polyline").count(), 6, "three curves, over the box and near the surface");
    assert!(chart.starts_with("<svg") && chart.ends_with("</svg>\n") && !chart.contains("NaN"));

    // The finest field of the curve is the one that a bake of the same flags makes.
    bench.run("bake cube.obj -o cube.nfd --error 2e-3 --max-depth 6 --samples 2000").succeeds();
    assert_eq!(number(&finest["bytes"]), fs::metadata(bench.path("cube.nfd")).expect("the field").len() as f64);
}

#[test]
fn a_curve_that_cannot_be_written_is_refused_before_it_is_baked() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.run("bake cube.obj").fails(2, &["--output"]);
    bench.run("bake cube.obj --pareto curve.json -o cube.nfd").fails(2, &["--pareto"]);
    bench.run("bake cube.obj --pareto curve.svg").fails(2, &["curve.json"]);
    bench.run("bake cube.obj --pareto -").fails(2, &["curve.json"]);
    bench.run("bake cube.obj --pareto missing/curve.json").fails(4, &["missing"]);
    assert_eq!(bench.files(), ["cube.obj"]);
}

#[test]
fn the_published_schema_is_that_of_the_curves() {
    let bench = Bench::new();
    let printed = bench.run("generate pareto-schema");
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/pareto.schema.json");
    let published = fs::read_to_string(&path).expect("the published schema");
    assert!(
        printed.succeeds().stdout() == published,
        "docs/pareto.schema.json is stale: write it again with `nearfield generate pareto-schema`"
    );
}
