//! The command line as its users meet it: text, exit codes, and files that are whole or absent.

mod support;

use std::fs;
use support::{Bench, CUBE, Outcome, json};

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
fn binary_points_give_binary_answers() {
    let bench = Bench::new();
    bench.bake_cube();
    let points: Vec<[f32; 3]> = vec![[0.5, 0.5, 0.5], [0.25, 0.75, 1.2], [3.0, 0.5, 0.5], [0.1, 0.2, 0.3]];
    bench.write("points.f32", points.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>());
    let text: String = points.iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();

    // Binary, from file to file and from pipe to pipe.
    bench.run("query cube.nfd --points points.f32 -o distances.f32").succeeds();
    let distances = floats(&fs::read(bench.path("distances.f32")).expect("the answers"));
    let input = fs::read(bench.path("points.f32")).expect("the points");
    let piped = bench.run_with_input("query cube.nfd --points - -o - --gradient", &input);
    let answers = floats(&piped.succeeds().output.stdout);

    // Text.
    let spoken = bench.run_with_input("query cube.nfd --gradient", text.as_bytes());
    let lines: Vec<f32> =
        spoken.succeeds().stdout().split_ascii_whitespace().map(|number| number.parse().expect("a number")).collect();

    assert_eq!(distances.len(), points.len());
    assert_eq!(answers.len(), 4 * points.len());
    assert_eq!(answers, lines, "text carries every bit");
    for (distance, answer) in distances.iter().zip(answers.chunks(4)) {
        assert_eq!(*distance, answer[0], "the gradient does not change the distance");
    }
}

#[test]
fn rays_and_closest_points_meet_the_surface() {
    let bench = Bench::new();
    bench.bake_cube();
    let rays: [[f32; 6]; 3] =
        [[0.5, 0.4, 3.0, 0.0, 0.0, -2.0], [0.5, 0.4, 3.0, 0.0, 0.0, 1.0], [0.3, 0.6, -0.5, 0.1, 0.0, 0.9]];
    let points: [[f32; 3]; 2] = [[0.5, 0.4, 0.9], [0.3, -0.05, 0.5]];
    let bytes = |numbers: &[f32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>();
    let text = |numbers: &[f32]| numbers.iter().map(f32::to_string).collect::<Vec<_>>().join(" ") + "\n";
    bench.write("rays.f32", bytes(rays.as_flattened()));
    bench.write("points.f32", bytes(points.as_flattened()));
    let ray_lines: String = rays.iter().map(|ray| text(ray)).collect();
    let point_lines: String = points.iter().map(|point| text(point)).collect();

    // Both ways and the field's own answers agree to the bit.
    bench.run("raycast cube.nfd --rays rays.f32 -o hits.f32").succeeds();
    let hits = floats(&fs::read(bench.path("hits.f32")).expect("the hits"));
    let spoken = bench.run_with_input("raycast cube.nfd", ray_lines.as_bytes()).succeeds().stdout();
    let field = fs::read(bench.path("cube.nfd")).expect("the field");
    let field = nearfield::Field::open(&field).expect("a field");
    assert_eq!(hits.len(), 8 * rays.len());
    for ((ray, hit), line) in rays.iter().zip(hits.chunks(8)).zip(spoken.lines()) {
        let &[x, y, z, u, v, w] = ray;
        match field.raycast([x, y, z], [u, v, w], f32::INFINITY, 0.0) {
            nearfield::Raycast::Hit(expected) => {
                let [a, b, c] = expected.point;
                let [d, e, f] = expected.normal;
                assert_eq!(hit, [1.0, expected.distance, a, b, c, d, e, f]);
                assert_eq!(line, format!("hit {}", text(&hit[1..]).trim_end()));
            }
            nearfield::Raycast::Miss { .. } => assert_eq!((hit, line), ([0.0; 8].as_slice(), "miss")),
            nearfield::Raycast::OutOfSteps { clear } => panic!("out of steps at {clear}"),
        }
    }
    assert_eq!(hits.iter().step_by(8).copied().collect::<Vec<f32>>(), [1.0, 0.0, 1.0]);
    assert!((hits[1] - 2.0).abs() < 0.02, "the top of the cube is 2 below: {}", hits[1]);

    bench.run("closest-point cube.nfd --points points.f32 -o ends.f32").succeeds();
    let ends = floats(&fs::read(bench.path("ends.f32")).expect("the ends"));
    let spoken = bench.run_with_input("closest-point cube.nfd", point_lines.as_bytes()).succeeds().stdout();
    for ((&point, end), line) in points.iter().zip(ends.chunks(4)).zip(spoken.lines()) {
        let nearfield::ClosestPoint { point: [x, y, z], residual, .. } = field.closest_point(point);
        assert_eq!(end, [x, y, z, residual]);
        assert_eq!(line, text(end).trim_end());
    }

    // In JSON, and shorter than the way to the cube.
    let json = |outcome: Outcome| -> Vec<serde_json::Value> {
        outcome.succeeds().stdout().lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
    };
    let ends = json(bench.run_with_input("closest-point cube.nfd --json", point_lines.as_bytes()));
    assert!(ends[0]["steps"].as_u64().expect("a number") >= 1 && ends[0]["point"][2].is_number(), "{}", ends[0]);
    let hits = json(bench.run("raycast cube.nfd --rays rays.f32 --json --length 1"));
    assert_eq!(
        hits.iter().map(|hit| hit["end"].as_str()).collect::<Vec<_>>(),
        [Some("miss"), Some("miss"), Some("hit")]
    );
    assert!(hits[2]["normal"][2].as_f64().expect("a number") < -0.9, "{}", hits[2]);
    let distances = json(bench.run("query cube.nfd --points points.f32 --gradient --json"));
    assert_eq!(distances[1]["gradient"].as_array().map(Vec::len), Some(3));

    bench.run_with_input("raycast cube.nfd", b"0 0 0 1 0\n").fails(3, &["line 1", "dx dy dz"]);
    bench.run("raycast cube.nfd --rays points.f32 --length 0 -o out.f32").succeeds();
    bench.run("raycast cube.nfd --length -1").fails(2, &["--length"]);
}

fn floats(bytes: &[u8]) -> Vec<f32> {
    let (numbers, rest) = bytes.as_chunks::<4>();
    assert!(rest.is_empty(), "whole floats");
    numbers.iter().map(|&number| f32::from_le_bytes(number)).collect()
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
fn points_that_are_no_points_end_with_3() {
    let bench = Bench::new();
    bench.bake_cube();
    bench.write("half.f32", [0; 18]);

    bench.run_with_input("query cube.nfd", b"0 0 0\n0 0\n").fails(3, &["line 2", "x y z"]);
    bench.run("query cube.nfd --points half.f32 -o out.f32").fails(3, &["half.f32"]);
    bench.run("query cube.nfd --points missing.f32 -o out.f32").fails(3, &["missing.f32"]);
    bench.run("bench cube.nfd --points half.f32").fails(3, &["half.f32"]);
    assert!(!bench.path("out.f32").exists(), "no partial file");
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

/// A quad over (0, 0) to (1, 1), in the node "lid" under the node "box", and its buffer in a file.
fn write_gltf(bench: &Bench) {
    let corners: Vec<u8> = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]
        .into_iter()
        .flat_map(f32::to_le_bytes)
        .collect();
    bench.write("lid.bin", &corners);
    bench.write(
        "lid.gltf",
        r#"{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "box", "children": [1]}, {"name": "lid", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 6}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}], "buffers": [{"uri": "lid.bin", "byteLength": 48}]}"#,
    );
}

#[test]
fn a_sheet_of_a_gltf_is_scaled_turned_and_given_a_thickness() {
    let bench = Bench::new();
    write_gltf(&bench);
    let mesh = "lid.gltf --node box --scale 2 --up z";
    let bake = bench.run(&format!("bake {mesh} -o lid.nfd --sign sheet --thickness 0.2 --max-depth 6 --depfile lid.d"));
    assert!(bake.succeeds().stdout().contains("in (0, 0, 0) to (2, 0, 2)"), "{}", bake.stdout());
    let depfile = fs::read_to_string(bench.path("lid.d")).expect("the depfile");
    assert!(depfile.contains("lid.gltf") && depfile.contains("lid.bin"), "{depfile}");

    let answer = bench.run_with_input("query lid.nfd", b"1 0.3 1\n");
    let distance: f64 = answer.succeeds().stdout().trim().parse().expect("a number");
    assert!((distance - 0.2).abs() < 5e-3, "{distance} from a sheet that is 0.1 away on either side");
    bench.run("verify lid.nfd --mesh lid.gltf --scale 2 --up z --thickness 0.2").succeeds();
    bench.run("verify lid.nfd --mesh lid.gltf").fails(1, &["lid.nfd", "hash"]);

    bench.run("bake lid.gltf -o other.nfd --node door").fails(3, &["lid.gltf", "box, lid"]);
    bench.run("bake lid.gltf -o other.nfd --node [").fails(2, &["pattern"]);
    bench.run("bake lid.gltf -o other.nfd --thickness 1").fails(2, &["--sign sheet"]);
    fs::remove_file(bench.path("lid.bin")).expect("the buffer goes");
    bench.run("bake lid.gltf -o other.nfd").fails(3, &["lid.bin", "cannot be read"]);
}

#[test]
fn doubt_fails_where_it_should_and_is_painted_red() {
    let bench = Bench::new();
    let open = CUBE.trim_end().rsplit_once('\n').expect("many lines").0;
    bench.write("open.obj", open);
    bench.write("cube.obj", CUBE);
    let settings = "--max-depth 5 --samples 2000";
    bench.run(&format!("bake open.obj -o open.nfd {settings} --fail-on-doubt")).fails(1, &["open.obj", "is a guess"]);
    assert!(!bench.path("open.nfd").exists(), "a field that fails is not written");
    bench.run(&format!("bake cube.obj -o cube.nfd {settings} --fail-on-doubt")).succeeds();

    let bake = bench.run(&format!("bake open.obj -o open.nfd {settings} --report report.json"));
    assert!(bake.succeeds().stderr().contains("is a guess, first at"), "{}", bake.stderr());
    let report = json(&bench.path("report.json"));
    assert_eq!(report["sign"]["method"], "winding numbers");
    let places = report["sign"]["doubtful_places"].as_array().expect("a list");
    assert!(!places.is_empty() && report["sign"]["doubtful"].as_u64() >= Some(places.len() as u64));

    let slice = "slice open.nfd --resolution 64 --axis x --at 1.02";
    bench.run(&format!("{slice} -o plain.png")).succeeds();
    bench.run(&format!("{slice} -o doubt.png --mesh open.obj")).succeeds();
    let picture = |name: &str| fs::read(bench.path(name)).expect("a picture");
    assert!(picture("plain.png") != picture("doubt.png"), "doubt is drawn");
    bench.run(&format!("{slice} -o other.png --mesh cube.obj")).fails(1, &["open.nfd", "cube.obj", "hash"]);
}

#[test]
fn a_mesh_is_inspected_before_it_is_baked() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    let inspect = bench.run("inspect cube.obj");
    for words in
        ["12 triangles", "pieces            1", "from pseudonormals, for the surface is closed", "median 1.000"]
    {
        assert!(inspect.succeeds().stdout().contains(words), "no {words:?} in {}", inspect.stdout());
    }

    // A wall a thousandth thick is too thin for a coarse target; a cube within the cube is nested.
    let flat = CUBE.replace("v 1 1 1", "v 1 1 0.001").replace("v 0 1 1", "v 0 1 0.001");
    let flat = flat.replace("v 1 0 1", "v 1 0 0.001").replace("v 0 0 1", "v 0 0 0.001");
    bench.write("flat.obj", flat);
    for (error, lost) in [("1e-5", 0.0), ("1e-3", 1.0)] {
        let inspect = bench.run(&format!("inspect flat.obj --json --error {error}"));
        let report: serde_json::Value = serde_json::from_slice(&inspect.succeeds().output.stdout).expect("JSON");
        let share = report["thickness"]["too_thin_for_target"].as_f64().expect("a share");
        assert!((share - lost).abs() < 0.05, "{error}: {share}");
        assert_eq!(report["nested_shells"], 0);
    }
    let inner: String = (0..8)
        .map(|corner| {
            let [x, y, z] = [0, 1, 2].map(|axis| if corner >> axis & 1 == 1 { 0.75 } else { 0.25 });
            format!("v {x} {y} {z}\n")
        })
        .collect();
    let faces = CUBE.lines().filter(|line| line.starts_with('f')).map(|line| {
        let corners = line[2..].split(' ').map(|corner| (8 + corner.parse::<u32>().expect("a number")).to_string());
        format!("f {}\n", corners.collect::<Vec<_>>().join(" "))
    });
    bench.write("nested.obj", format!("{CUBE}{inner}{}", faces.collect::<String>()));
    let inspect = bench.run("inspect nested.obj");
    assert!(inspect.succeeds().stdout().contains("1 shells within shells"), "{}", inspect.stdout());
    for name in ["flat.obj", "nested.obj"] {
        fs::remove_file(bench.path(name)).expect("it is removed");
    }

    // A copy, a triangle turned over, one missing.
    let mut lines: Vec<&str> = CUBE.lines().collect();
    lines.pop();
    lines.push("f 1 4 3\nf 1 3 4");
    bench.write("broken.obj", lines.join("\n"));
    let inspect = bench.run("inspect broken.obj --json");
    let report: serde_json::Value = serde_json::from_slice(&inspect.succeeds().output.stdout).expect("JSON");
    for (name, count) in
        [("triangles", 13), ("duplicate_triangles", 2), ("boundary_edges", 3), ("rims", 1), ("self_intersections", 0)]
    {
        assert_eq!(report[name], count, "{name} in {report}");
    }
    assert_eq!(report["sign"]["method"], "winding numbers");
    assert!(report["sign"]["doubtful"].as_f64() > Some(0.0));
    assert_eq!(bench.files(), ["broken.obj", "cube.obj"]);
}
