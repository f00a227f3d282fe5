//! The example draws what `nearfield render` draws.

#[expect(dead_code, reason = "other tests compare the readers themselves")]
mod fields;

use std::path::Path;
use std::process::Command;

const SIZE: &str = "320x240";

/// Red, green and blue of each pixel.
fn pixels(path: &Path) -> Vec<[u8; 3]> {
    let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(path).expect("a picture")));
    let mut reader = decoder.read_info().expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    let frame = reader.next_frame(&mut bytes).expect("a frame");
    let pixels = bytes[..frame.buffer_size()].chunks(frame.color_type.samples());
    pixels.map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

#[test]
fn the_example_draws_what_the_command_line_draws() {
    let Some(baker) = fields::baker() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    for (name, arguments) in
        [("default", &["--error", "2e-3"][..]), ("grid", &["--layout", "grid", "--resolution", "48"])]
    {
        let field = fields::bake(&baker, folder.path(), name, arguments);
        let [rendered, drawn] = ["rendered", "drawn"].map(|kind| folder.path().join(format!("{name}-{kind}.png")));
        let text = |path: &Path| path.to_string_lossy().into_owned();
        fields::run(&baker, &["render", &text(&field), "-o", &text(&rendered), "--size", SIZE, "--quiet"]);

        // Examples are built beside the tests.
        let tests = std::env::current_exe().expect("a path");
        let example = tests.ancestors().nth(2).expect("the folder of the build").join("examples/render");
        let output = Command::new(example).arg(&field).arg(&drawn).arg(SIZE).output().expect("the example starts");
        let errors = String::from_utf8_lossy(&output.stderr);
        if errors.contains("SKIPPED") {
            eprintln!("SKIPPED: no driver of Vulkan");
            return;
        }
        assert!(output.status.success(), "{errors}");

        let pairs: Vec<_> = pixels(&rendered).into_iter().zip(pixels(&drawn)).collect();
        let covered: Vec<_> = pairs.iter().filter(|(a, b)| *a != [255; 3] || *b != [255; 3]).collect();
        let sum: u32 =
            covered.iter().flat_map(|(a, b)| [0, 1, 2].map(|channel| u32::from(a[channel].abs_diff(b[channel])))).sum();
        let difference = f64::from(sum) / (3 * covered.len()) as f64;
        println!("{name}: mean absolute difference {difference:.4} of 255 over {} pixels", covered.len());
        assert!(covered.len() > 5_000, "{name}: only {} pixels", covered.len());
        assert!(difference <= 3.0, "{name}: {difference}");
    }
}
