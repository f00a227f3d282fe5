use crate::support::{Bench, CUBE};
use std::fs;

#[test]
fn inputs_that_are_no_meshes_end_with_3_and_leave_no_file() {
    let bench = Bench::new();
    let spot = fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/meshes/spot.ply")).expect("the mesh");
    bench.write("empty.obj", "");
    bench.write("no_faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    bench.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    bench.write("nan.obj", CUBE.replacen("v 1 1 1", "v 1 nan 1", 1));
    bench.write("range.obj", CUBE.replacen("f 1 3 4", "f 1 3 9", 1));
    bench.write("truncated.ply", &spot[..spot.len() / 2]);
    bench.write("words.xyz", "no mesh at all");
    let edges = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    bench.write("tiny.obj", format!("v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nv 0 0 1e-30\n{edges}"));
    bench.write("huge.obj", format!("v 0 0 0\nv 1e60 0 0\nv 0 1e60 0\nv 0 0 1e60\n{edges}"));

    let before = bench.files();
    for name in [
        "missing.obj",
        "empty.obj",
        "no_faces.obj",
        "flat.obj",
        "nan.obj",
        "range.obj",
        "truncated.ply",
        "words.xyz",
        "tiny.obj",
        "huge.obj",
    ] {
        bench.run(&format!("bake {name} -o out.nfd --report out.json")).fails(3, &[name]);
    }
    assert_eq!(bench.files(), before, "no partial file");
}

#[test]
fn an_output_that_cannot_be_written_ends_with_4() {
    let bench = Bench::new();
    bench.bake_cube();
    let before = bench.files();

    bench.run("bake cube.obj -o missing/cube.nfd").fails(4, &["missing/cube.nfd", "not written"]);
    bench.run("bake cube.obj -o .").fails(4, &["not written"]);
    bench.run("bake cube.obj -o new.nfd --report missing/r.json").fails(4, &["missing/r.json"]);
    bench.run("slice cube.nfd -o missing/cube.png").fails(4, &["missing/cube.png"]);
    bench.run_with_input("query cube.nfd -o missing/answers", b"0 0 0\n").fails(4, &["missing/answers"]);

    assert_eq!(bench.files(), before, "no partial file");
}

#[test]
fn files_that_are_no_fields_end_with_5() {
    let bench = Bench::new();
    bench.bake_cube();
    let field = fs::read(bench.path("cube.nfd")).expect("the field");
    let mut flipped = field.clone();
    *flipped.last_mut().expect("bytes") ^= 1;
    bench.write("words.nfd", "no field at all");
    bench.write("truncated.nfd", &field[..field.len() - 4]);
    bench.write("flipped.nfd", flipped);

    for name in ["words.nfd", "truncated.nfd", "flipped.nfd", "cube.obj"] {
        for command in ["info {}", "query {}", "verify {} --mesh cube.obj", "slice {} -o s.png", "bench {}"] {
            bench.run(&command.replace("{}", name)).fails(5, &[name, "not a valid field"]);
        }
    }
    bench.run("info missing.nfd").fails(3, &["missing.nfd"]);
}

#[test]
fn usage_errors_end_with_2() {
    let bench = Bench::new();
    bench.bake_cube();

    for options in [
        "--error 0",
        "--error -1",
        "--error nan",
        "--error-abs inf",
        "--error 1e-3 --error-abs 1e-3",
        "--margin -0.1",
        "--max-depth 17",
        "--start-depth 6 --max-depth 5",
        "--interpolant trilinear --continuity c1",
        "--interpolant quartic",
        "--termination simpson",
        "--layout grid --termination simpson",
        "--layout grid --order 2 --sampling fitted",
        "--threads 0",
        "--samples 0",
        "--no-such-flag",
    ] {
        bench.run(&format!("bake cube.obj -o out.nfd {options}")).fails(2, &[]);
    }
    bench.run("bake cube.obj").fails(2, &["--output"]);
    bench.run("slice cube.nfd -o s.png --resolution 0").fails(2, &["--resolution"]);
    bench.run("slice cube.nfd -o s.png --at nowhere").fails(2, &["--at"]);
    bench.run("slice cube.nfd -o s.png --normal 0,0,0").fails(2, &["--normal", "length"]);
    bench.run("slice cube.nfd -o s.png --normal 1,0,0 --at 3").fails(2, &["--at", "--normal"]);
    bench.run("slice cube.nfd -o s.png --origin 1,0,0").fails(2, &["--normal"]);
    bench.run("slice cube.nfd -o s.png --error-map").fails(2, &["--mesh"]);
    bench.run("render cube.nfd -o r.png --mesh-up z").fails(2, &["--mesh"]);
    bench.run("verify cube.nfd --mesh cube.obj --samples 10").fails(2, &["--samples"]);
    bench.run("bake cube.obj -o ./cube.obj").fails(2, &["overwrite"]);
    bench.run("bake cube.obj -o out --report out").fails(2, &["same place"]);
    bench.run("slice cube.nfd -o cube.nfd").fails(2, &["overwrite"]);
    bench.run("frobnicate").fails(2, &["frobnicate"]);

    assert_eq!(bench.files(), ["cube.nfd", "cube.obj"], "no file is made");
}

#[test]
fn help_names_every_exit_code_and_every_command_has_an_example() {
    let bench = Bench::new();

    let help = bench.run("--help").succeeds().stdout();
    for code in 0..=6 {
        assert!(help.contains(&format!("\n  {code}  ")), "no exit code {code} in {help}");
    }
    for command in ["bake", "info", "query", "raycast", "closest-point", "verify", "slice", "bench"] {
        assert!(help.contains(command), "no {command} in {help}");
        let help = bench.run(&format!("{command} --help")).succeeds().stdout();
        assert!(help.contains("Example") && help.contains(&format!("nearfield {command} ")), "{help}");
    }
}
