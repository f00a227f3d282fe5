use crate::support::{Bench, CUBE, json};
use std::fs;

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
    assert!(!bake.stderr().contains("--sign sheet"), "a cube without a side is no sheet: {}", bake.stderr());
    bench.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n");
    let sheet = bench.run("bake sheet.obj -o sheet.nfd --max-depth 4 --samples 2000");
    assert!(sheet.succeeds().stderr().contains("use --sign sheet"), "{}", sheet.stderr());
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
