use crate::support::{Bench, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const MESH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/meshes/bob_small.ply");
const SIZE: [u32; 2] = [240, 180];

/// A picture, three bytes a pixel.
struct Picture {
    size: [u32; 2],
    pixels: Vec<[u8; 3]>,
}

impl Picture {
    fn read(path: &Path) -> Self {
        let decoder = png::Decoder::new(std::io::BufReader::new(fs::File::open(path).expect("a picture")));
        let mut reader = decoder.read_info().expect("a PNG");
        let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
        let frame = reader.next_frame(&mut bytes).expect("a frame");
        let channels = frame.color_type.samples();
        let pixels = bytes[..frame.buffer_size()].chunks(channels).map(|pixel| [pixel[0], pixel[1], pixel[2]]);
        Self { size: [frame.width, frame.height], pixels: pixels.collect() }
    }

    /// Mean absolute difference over the pixels that either picture covers, and how many these are.
    fn difference(&self, other: &Self) -> (f64, usize) {
        assert_eq!(self.size, other.size);
        let covered = self.pixels.iter().zip(&other.pixels).filter(|(a, b)| **a != [255; 3] || **b != [255; 3]);
        let differences: Vec<f64> =
            covered.flat_map(|(a, b)| [0, 1, 2].map(|channel| f64::from(a[channel].abs_diff(b[channel])))).collect();
        (differences.iter().sum::<f64>() / differences.len() as f64, differences.len() / 3)
    }
}

/// The folder that PLAYWRIGHT names, where Node finds playwright-core. The browser's test belongs to
/// `examples/run-integrations view`, which sets it; whoever sets it wants the test.
fn browser() -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("PLAYWRIGHT").map(PathBuf::from) else {
        eprintln!("SKIPPED: PLAYWRIGHT names no folder with playwright-core: see examples/run-integrations");
        return None;
    };
    let chromium = std::env::var_os("CHROMIUM").map_or_else(|| PathBuf::from("/usr/bin/chromium"), PathBuf::from);
    assert!(chromium.is_file(), "no browser at {}: CHROMIUM may name one", chromium.display());
    let found = Command::new("node").args(["-e", "require('playwright-core')"]).current_dir(&folder).output();
    assert!(found.is_ok_and(|output| output.status.success()), "no playwright-core in {}", folder.display());
    Some(folder)
}

fn bake(bench: &Bench) {
    bench.run(&format!("bake {MESH} -o first.nfd --error 2e-3 --samples 2000")).succeeds();
    bench.run(&format!("bake {MESH} -o other.nfd --layout grid --resolution 48 --samples 2000")).succeeds();
    bench.run("view first.nfd -o first.html --azimuth 50").succeeds();
}

#[test]
fn a_page_holds_the_field_and_needs_nothing_else() {
    let bench = Bench::new();
    bake(&bench);
    let page = fs::read_to_string(bench.path("first.html")).expect("a page");
    assert!(!page.contains("http") && !page.contains("{{"), "nothing to fetch, no place left open");
    let field = fs::metadata(bench.path("first.nfd")).expect("a field").len();
    assert!((page.len() as u64) < field * 4 / 3 + 200_000, "{} bytes for a field of {field}", page.len());

    bench.write("not.nfd", "no field");
    bench.run("view not.nfd -o not.html").fails(5, &["not.nfd"]);
    bench.run("view first.nfd -o first.nfd").fails(2, &["overwrite"]);
}

#[test]
fn the_page_takes_whole_fields_and_refuses_damaged_ones() {
    // As much of the script as knows files, without a browser: every valid vector, then with a bit turned somewhere.
    let vectors = concat!(env!("CARGO_MANIFEST_DIR"), "/../format-spec/vectors/valid/");
    let script = concat!(
        include_str!("../../src/picture/viewer/field.js"),
        "const fs = require('node:fs');",
        "const check = (bytes) => { try { readField(bytes); return true; } catch { return false; } };",
        "const [folder] = process.argv.slice(1);",
        "const names = fs.readdirSync(folder).filter((name) => name.endsWith('.nfd'));",
        "const told = names.map((name) => {",
        "  const bytes = new Uint8Array(fs.readFileSync(folder + name));",
        "  const whole = check(bytes);",
        "  const places = [0, 9, 13, 16, 25, 130, bytes.length >> 1, bytes.length - 1];",
        "  const damaged = places.filter((at) => check(bytes.map((byte, place) => place === at ? byte ^ 4 : byte)));",
        "  return { name, whole, damaged, cut: check(bytes.slice(0, -4)) };",
        "});",
        "console.log(JSON.stringify(told));",
    );
    let Ok(output) = Command::new("node").args(["-e", script, vectors]).output() else {
        let ci = std::env::var("CI").is_ok_and(|value| value == "true");
        assert!(!ci, "node is not installed");
        eprintln!("SKIPPED: node is not installed");
        return;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let told = told.as_array().expect("a list");
    assert!(told.len() > 100, "only {} vectors", told.len());
    for vector in told {
        assert_eq!(vector["whole"], true, "{vector}");
        assert_eq!(vector["damaged"], serde_json::json!([]), "{vector}");
        assert_eq!(vector["cut"], false, "{vector}");
    }
}

#[test]
fn a_browser_shows_what_render_draws() {
    let Some(playwright) = browser() else { return };
    let bench = Bench::new();
    bake(&bench);
    let bytes = fs::read(bench.path("first.nfd")).expect("a field");
    let mut damaged = bytes.clone();
    *damaged.last_mut().expect("a byte") ^= 1;
    bench.write("damaged.nfd", damaged);
    let [width, height] = SIZE;
    for (field, picture) in [("first", "rendered.png"), ("other", "rendered_other.png")] {
        // A dropped field is seen from where the page says.
        bench.run(&format!("render {field}.nfd -o {picture} --azimuth 50 --size {width}x{height} --quiet")).succeeds();
    }

    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/pipeline/viewer.mjs");
    let files = [bench.path("first.html"), bench.path("."), bench.path("other.nfd"), bench.path("damaged.nfd")];
    let [page, folder, other, damaged] = files.each_ref();
    let output = Command::new("node")
        .arg(script)
        .arg(page)
        .args(SIZE.map(|side| side.to_string()))
        .args([folder, other, damaged])
        .current_dir(playwright)
        .output()
        .expect("node starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    for (shown, rendered) in [("first.png", "rendered.png"), ("dropped.png", "rendered_other.png")] {
        let (difference, covered) = Picture::read(&bench.path(shown)).difference(&Picture::read(&bench.path(rendered)));
        println!("{shown}: mean absolute difference {difference:.4} of 255 over {covered} pixels");
        assert!(covered > 4_000, "{shown}: only {covered} pixels");
        assert!(difference <= 3.0, "{shown}: {difference}");
    }
    let first = Picture::read(&bench.path("first.png"));
    for moved in ["cut.png", "moved.png"] {
        assert!(Picture::read(&bench.path(moved)).difference(&first).0 > 3.0, "{moved} is another picture");
    }

    let told = json(&bench.path("told.json"));
    assert_eq!(told["complaints"], serde_json::json!([]));
    assert_eq!(told["requests"].as_array().map(Vec::len), Some(1), "the page alone: {}", told["requests"]);
    assert_eq!(told["refusal"], "damaged.nfd: damaged: a section has the wrong checksum");
    let info = bench.run("info first.nfd --json");
    let info: serde_json::Value = serde_json::from_slice(&info.succeeds().output.stdout).expect("JSON");
    let contract = info["errors"]["uniform"]["max"].as_f64().expect("a number");
    let shown: f64 = format!("{contract:.2e}").parse().expect("a number");
    let panel = told["panel"].as_str().expect("text");
    assert!(panel.contains(&shown.to_string()), "no {shown} in {panel}");
}
