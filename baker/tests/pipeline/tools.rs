use crate::support::{Bench, CUBE, json};
use serde_json::Value;
use std::fs;
use std::path::Path;

#[test]
fn a_field_does_not_differ_from_itself_and_differs_from_another() {
    let bench = Bench::new();
    bench.bake_cube();
    bench.run("bake cube.obj -o coarse.nfd --max-depth 4 --error 5e-3 --samples 2000").succeeds();

    let same = bench.run("diff cube.nfd cube.nfd --tolerance 0");
    assert_eq!(same.succeeds().stdout(), "the fields are the same, byte by byte\n");

    let diff = bench.run("diff cube.nfd coarse.nfd --samples 5000");
    let text = diff.succeeds().stdout();
    for words in ["target_error", "octree.leaves", "settings_hash", "near surface"] {
        assert!(text.contains(words), "no {words:?} in {text}");
    }
    assert!(!text.contains("mesh_hash"), "the mesh is the same: {text}");
    bench.run("diff cube.nfd coarse.nfd --tolerance 1e-6 --samples 5000").fails(1, &["cube.nfd", "coarse.nfd"]);
    bench.run("diff cube.nfd coarse.nfd --tolerance 0.5 --samples 5000").succeeds();
}

#[test]
fn the_difference_is_no_larger_than_both_errors() {
    let bench = Bench::new();
    bench.bake_cube();
    bench.run("bake cube.obj -o coarse.nfd --max-depth 4 --error 5e-3 --samples 20000").succeeds();

    let diff = bench.run("diff cube.nfd coarse.nfd --json");
    let diff: serde_json::Value = serde_json::from_slice(&diff.succeeds().output.stdout).expect("JSON");
    let rms = diff["shared_box"]["rms"].as_f64().expect("a number");
    let coarse = bench.run("info coarse.nfd --json");
    let coarse: serde_json::Value = serde_json::from_slice(&coarse.succeeds().output.stdout).expect("JSON");
    let error = coarse["errors"]["uniform"]["rmse"].as_f64().expect("a number");
    assert!(rms > 0.1 * error && rms < 3.0 * error, "{rms} beside {error}");
}

/// The published schema `docs/NAME.schema.json`, which must be what `generate NAME-schema` prints.
fn published_schema(bench: &Bench, name: &str) -> Value {
    let printed = bench.run(&format!("generate {name}-schema"));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../docs/{name}.schema.json"));
    let published = fs::read_to_string(&path).expect("the published schema");
    assert!(
        printed.succeeds().stdout() == published,
        "docs/{name}.schema.json is stale: write it again with `nearfield generate {name}-schema`"
    );
    json(&path)
}

/// Every name of a value is in its schema, and every name that this requires is in the value.
fn expect_described(value: &Value, schema: &Value) {
    let names = |value: &Value| -> Vec<String> { value.as_object().expect("an object").keys().cloned().collect() };
    assert_eq!(names(value), names(&schema["properties"]));
    for required in schema["required"].as_array().expect("a list") {
        let name = required.as_str().expect("a name");
        assert!(value.get(name).is_some(), "no {name}");
    }
}

#[test]
fn the_published_schemas_are_those_of_the_reports() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.run("bake cube.obj -o cube.nfd --max-depth 4 --samples 500 --report report.json").succeeds();
    expect_described(&json(&bench.path("report.json")), &published_schema(&bench, "report"));

    bench.write("assets.toml", "output = 'fields'\nassets = [{ include = ['*.obj'], max-depth = 4, samples = 500 }]\n");
    bench.run("batch assets.toml --report batch.json").succeeds();
    let (batch, schema) = (json(&bench.path("batch.json")), published_schema(&bench, "batch"));
    expect_described(&batch, &schema);
    expect_described(&batch["assets"][0], &schema["$defs"]["AssetReport"]);

    bench.run("bake cube.obj -o other.nfd --max-depth 3 --samples 500").succeeds();
    let diff = bench.run("diff cube.nfd other.nfd --json --samples 500");
    let diff: Value = serde_json::from_slice(&diff.succeeds().output.stdout).expect("JSON");
    let schema = published_schema(&bench, "diff");
    expect_described(&diff, &schema);
    expect_described(&diff["properties"][0], &schema["$defs"]["Property"]);
    expect_described(&diff["shared_box"], &schema["$defs"]["Figures"]);
}

#[test]
fn an_oblique_slice_covers_the_box_and_one_along_an_axis_is_that_of_the_axis() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.run("bake cube.obj -o cube.nfd --max-depth 4 --samples 500").succeeds();
    bench.run("slice cube.nfd -o axis.png --resolution 60").succeeds();
    bench.run("slice cube.nfd -o plane.png --resolution 60 --normal 0,0,3").succeeds();
    let [axis, plane] = ["axis.png", "plane.png"].map(|name| decode(&bench.path(name)));
    assert_eq!((axis.0, axis.1), (plane.0, plane.1));
    assert!(axis.2.iter().zip(&plane.2).all(|(a, b)| a.abs_diff(*b) <= 3), "but for rounding");

    bench
        .run("slice cube.nfd -o oblique.png --resolution 60 --normal -1,1,0.5 --origin 0.5,0.5,0.9 --cells")
        .succeeds();
    let (width, height, _) = decode(&bench.path("oblique.png"));
    assert!(width.max(height) == 60 && width.min(height) > 45, "{width} by {height}");
}

#[test]
fn an_error_map_is_white_where_nothing_is_wrong_and_has_a_scale() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.run("bake cube.obj -o cube.nfd --max-depth 6 --samples 500").succeeds();
    bench.run("slice cube.nfd -o plain.png --resolution 120").succeeds();
    bench.run("slice cube.nfd -o errors.png --resolution 120 --mesh cube.obj --error-map").succeeds();
    let (width, plain_height, _) = decode(&bench.path("plain.png"));
    let (map_width, height, pixels) = decode(&bench.path("errors.png"));
    assert!(width == map_width && height > plain_height, "a scale is below it");

    // Most of the map is pale: errors are far below the greatest. Some of it is not.
    let light = |index: usize| pixels[3 * index..][..3].iter().map(|&c| u32::from(c)).sum::<u32>();
    let count = width * plain_height;
    let pale = (0..count).filter(|&index| light(index) > 500).count();
    assert!(pale > count / 2 && pale < count, "{pale} of {count}");
}

#[test]
fn an_oblique_error_map_is_grey_outside_the_box_and_its_colours_are_those_of_the_errors_inside() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.run("bake cube.obj -o cube.nfd --max-depth 6 --samples 500").succeeds();
    bench.run("slice cube.nfd -o errors.png --resolution 120 --normal 1,1,1 --mesh cube.obj --error-map").succeeds();
    let (width, _, pixels) = decode(&bench.path("errors.png"));

    // The box cuts a hexagon out of the plane: the corners of the picture lie outside. Were they on the scale, what is
    // inside would be all but white.
    let at = |index: usize| -> [u8; 3] { pixels[3 * index..][..3].try_into().unwrap() };
    assert_eq!((at(0), at(width - 1)), ([176, 176, 178], [176, 176, 178]));
    let light = |index: usize| at(index).into_iter().map(u32::from).sum::<u32>();
    let inside = || (0..width * 100).filter(|&index| at(index) != at(0));
    assert!(inside().count() > width * 50, "{} points inside", inside().count());
    assert!(inside().any(|index| (100..300).contains(&light(index))), "the greatest error is dark");
}

#[test]
fn a_render_shows_the_shape_and_agrees_with_the_mesh() {
    let bench = Bench::new();
    bench.write("cube.obj", CUBE);
    bench.run("bake cube.obj -o cube.nfd --max-depth 7 --samples 2000").succeeds();
    bench.run("render cube.nfd -o cube.png --size 96x64 --mesh cube.obj --antialias 1 --quiet").succeeds();
    let (width, height, pixels) = decode(&bench.path("cube.png"));
    assert_eq!((width, height), (3 * 96, 64));

    // The middle of the field's view shows the cube, its corner the background; both views are much the same.
    let at = |x: usize, y: usize| &pixels[3 * (y * width + x)..][..3];
    assert!(at(48, 32) != at(0, 0), "the cube is in the middle");
    assert_eq!(at(0, 0), [255; 3]);
    let covered: Vec<(usize, usize)> =
        (0..64).flat_map(|y| (96..192).map(move |x| (x, y))).filter(|&(x, y)| at(x, y) != [255; 3]).collect();
    let sum: f64 = covered
        .iter()
        .flat_map(|&(x, y)| (0..3).map(move |channel| (x, y, channel)))
        .map(|(x, y, channel)| f64::from(at(x, y)[channel].abs_diff(at(x - 96, y)[channel])))
        .sum();
    let mean = sum / (3 * covered.len()) as f64;
    assert!(covered.len() > 500 && mean < 3.0, "{} covered pixels, mean difference {mean}", covered.len());
}

#[test]
fn a_turntable_is_as_many_pictures_and_threads_do_not_change_them() {
    let bench = Bench::new();
    bench.bake_cube();
    bench.run("render cube.nfd -o turn.png --size 32x32 --frames 3 --quiet --shading normals").succeeds();
    for frame in 0..3 {
        assert_eq!(decode(&bench.path(&format!("turn-00{frame}.png"))).0, 32);
    }
    bench.run("render cube.nfd -o one.png --size 32x32 --threads 1").succeeds();
    bench.run("render cube.nfd -o four.png --size 32x32 --threads 4").succeeds();
    assert!(
        fs::read(bench.path("one.png")).expect("a picture") == fs::read(bench.path("four.png")).expect("a picture")
    );
}

fn decode(path: &Path) -> (usize, usize, Vec<u8>) {
    let file = std::io::BufReader::new(fs::File::open(path).expect("the picture"));
    let mut reader = png::Decoder::new(file).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a small picture")];
    let info = reader.next_frame(&mut pixels).expect("its pixels");
    (info.width as usize, info.height as usize, pixels)
}

#[test]
fn a_field_becomes_a_closed_mesh_at_its_offset() {
    let bench = Bench::new();
    bench.bake_cube();
    for (format, offset) in [("ply", "0"), ("obj", "0.1"), ("ply", "-0.1")] {
        bench.run(&format!("mesh cube.nfd -o again.{format} --offset {offset} --resolution 40")).succeeds();
        bench.run(&format!("bake again.{format} -o again.nfd --max-depth 5 --samples 2000 --report r.json")).succeeds();
        let mesh = &json(&bench.path("r.json"))["mesh"];
        assert_eq!(mesh["boundary_edges"], 0, "closed");

        // The middle is as deep as half the cube and the offset: so the mesh is the right way out, too.
        let query = bench.run_with_input("query again.nfd", b"0.5 0.5 0.5\n");
        let depth: f64 = query.succeeds().stdout().trim().parse().expect("a number");
        let expected = -0.5 - offset.parse::<f64>().expect("a number");
        assert!((depth - expected).abs() < 0.02, "{depth}, not {expected}");
    }
    bench.run("mesh cube.nfd -o again.stl --resolution 40").succeeds();
    let stl = fs::read(bench.path("again.stl")).expect("the mesh");
    let triangles = u32::from_le_bytes(stl[80..84].try_into().expect("four bytes"));
    assert_eq!(stl.len(), 84 + 50 * triangles as usize);
    bench.run("mesh cube.nfd -o again.xyz").fails(2, &["again.xyz", ".ply"]);
}

#[test]
fn man_pages_and_completions_know_every_command() {
    let bench = Bench::new();
    bench.run("generate man -o man").succeeds();
    let completions = bench.run("generate completions bash").succeeds().stdout();
    for command in ["bake", "batch", "diff", "render", "mesh", "slice", "verify", "query", "info", "bench"] {
        let page = fs::read_to_string(bench.path(&format!("man/nearfield-{command}.1"))).expect("a page");
        assert!(page.contains("OPTIONS"), "{command}");
        assert!(completions.contains(command), "{command}");
    }
}

#[test]
fn an_unchanged_field_is_not_touched_when_asked() {
    let bench = Bench::new();
    bench.bake_cube();
    let modified = || fs::metadata(bench.path("cube.nfd")).and_then(|file| file.modified()).expect("a time");
    let before = modified();
    bench.run("bake cube.obj -o cube.nfd --max-depth 5 --samples 2000 --if-changed").succeeds();
    assert_eq!(modified(), before);
    bench.run("bake cube.obj -o cube.nfd --max-depth 4 --samples 2000 --if-changed").succeeds();
    assert!(modified() > before);
}
