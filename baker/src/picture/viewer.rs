//! A page that shows a field in a browser, by itself: the shader reads the bytes of the file.

use super::camera::{Camera, Up};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

const PAGE: &str = include_str!("viewer/page.html");
const STYLE: &str = include_str!("viewer/page.css");
const SCRIPTS: [&str; 4] = [
    include_str!("viewer/field.js"),
    include_str!("viewer/camera.js"),
    include_str!("viewer/draw.js"),
    include_str!("viewer/page.js"),
];
/// GLSL ES 3.00, which `runtime/shaders` makes.
const VERTEX: &str = include_str!("viewer/generated/corner.vert");
const GRID: &str = include_str!("viewer/generated/grid.frag");
const OCTREE: &str = include_str!("viewer/generated/octree.frag");
const POLYNOMIAL: &str = include_str!("viewer/generated/polynomial.frag");

/// What a page shows first.
#[derive(Clone, Debug)]
pub struct Viewer<'a> {
    /// What the field is called.
    pub name: &'a str,
    /// Where it is seen from.
    pub camera: Camera,
    /// The surface drawn is where the distance is this, mesh units.
    pub offset: f64,
}

/// What the script reads.
#[derive(Serialize)]
struct Settings<'a> {
    name: &'a str,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
    up: &'a str,
    offset: f64,
}

/// HTML that needs no network: WebGL2, the bytes of the field, and a panel with its error contract.
///
/// `bytes` are those of a field that has been checked; the page checks those that are dropped on it.
pub fn viewer_page(bytes: &[u8], viewer: &Viewer<'_>) -> String {
    let Camera { azimuth, elevation, zoom, up } = viewer.camera;
    let up = match up {
        Up::Y => "y",
        Up::Z => "z",
    };
    let settings = Settings { name: viewer.name, azimuth, elevation, zoom, up, offset: viewer.offset };
    let settings = serde_json::to_string(&settings).expect("strings and finite numbers");
    let values = [
        ("title", escape(viewer.name)),
        ("style", STYLE.to_owned()),
        ("vertex", VERTEX.to_owned()),
        ("grid", GRID.to_owned()),
        ("octree", OCTREE.to_owned()),
        ("polynomial", POLYNOMIAL.to_owned()),
        // Within a script nothing ends it but "</".
        ("settings", settings.replace('<', "\\u003c")),
        ("script", SCRIPTS.join("\n")),
        ("field", STANDARD.encode(bytes)),
    ];
    fill(PAGE, &values)
}

/// The page with a value in the place of each `{{name}}`.
fn fill(page: &str, values: &[(&str, String)]) -> String {
    let mut parts = page.split("{{");
    let mut filled = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once("}}").expect("a place that ends");
        let (_, value) = values.iter().find(|(known, _)| *known == name).expect("a value for each place");
        filled.push_str(value);
        filled.push_str(rest);
    }
    filled
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}
