//! The reader of Nearfield fields for shaders: one WGSL source, and what naga makes of it for other languages.
//!
//! `wgsl/` holds the source in parts, `generated/` the whole and its translations, which `cargo run` writes. A test fails
//! when they are stale.

mod layout;
mod translate;

use std::error::Error;
use std::path::{Path, PathBuf};
use translate::Shader;

/// The parts of the reader, in the order of the whole.
const PARTS: [&str; 7] = [
    include_str!("../wgsl/field.wgsl"),
    include_str!("../wgsl/octree.wgsl"),
    include_str!("../wgsl/grid.wgsl"),
    include_str!("../wgsl/polynomial.wgsl"),
    include_str!("../wgsl/blend.wgsl"),
    include_str!("../wgsl/hermite.wgsl"),
    include_str!("../wgsl/sample.wgsl"),
];

/// The vertices of a picture.
const CORNER: &str = include_str!("../wgsl/corner.wgsl");

/// Where the shader finds the bytes of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bytes {
    /// In a storage buffer.
    Buffer,
    /// In a texture of unsigned integers, four words a texel.
    Texture,
}

/// The reader, without an entry point: WGSL to which a shader appends its own.
pub fn reader(bytes: Bytes) -> String {
    let accessor = match bytes {
        Bytes::Buffer => include_str!("../wgsl/words_buffer.wgsl"),
        Bytes::Texture => include_str!("../wgsl/words_texture.wgsl"),
    };
    let mut text =
        String::from("// Made from the parts in `runtime/shaders/wgsl` by `cargo run` there. Do not edit.\n\n");
    for part in [accessor].into_iter().chain(PARTS) {
        text.push_str(part);
        text.push('\n');
    }
    text.push_str(&layout::wgsl());
    text
}

/// A compute shader that answers a list of points: the entry point `query`.
pub fn query() -> String {
    format!("{}\n{}", reader(Bytes::Buffer), include_str!("../wgsl/query.wgsl"))
}

/// Shaders that draw a view: the entry points `corner` and `pixel`.
pub fn render(bytes: Bytes) -> String {
    format!("{}\n{CORNER}\n{}", reader(bytes), include_str!("../wgsl/render.wgsl"))
}

/// A file that this package writes.
#[derive(Clone, Debug)]
pub struct Generated {
    /// Where it belongs.
    pub path: PathBuf,
    /// What it holds.
    pub contents: Vec<u8>,
}

/// Every file that this package writes.
///
/// # Errors
///
/// What naga finds wrong with the source.
pub fn generate() -> Result<Vec<Generated>, Box<dyn Error>> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = |name: &str, contents: Vec<u8>| Generated { path: package.join("generated").join(name), contents };
    // The viewer is part of the baker, which must find its shaders in its own folder.
    let viewer = |name: &str, contents: Vec<u8>| {
        let path = package.join("../../baker/src/picture/viewer/generated").join(name);
        Generated { path, contents }
    };
    let query = Shader::new(&query())?;
    let corner = Shader::new(CORNER)?;
    let render = Shader::new(&render(Bytes::Texture))?;
    Ok(vec![
        file("nearfield.wgsl", reader(Bytes::Buffer).into()),
        file("nearfield_texture.wgsl", reader(Bytes::Texture).into()),
        file("query.hlsl", query.hlsl()?),
        file("query.metal", query.metal()?),
        file("query.spv", query.spirv()?),
        file("query.comp", query.glsl("query", translate::GLSL_430)?),
        viewer("corner.vert", corner.glsl("corner", translate::GLSL_ES_300)?),
        viewer("pixel.frag", render.glsl("pixel", translate::GLSL_ES_300)?),
    ])
}
