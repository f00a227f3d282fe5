//! The reader of Nearfield fields for shaders: one WGSL source, and what naga makes of it for other languages.
//!
//! `wgsl/` holds the source in parts, `generated/` the whole and its translations, which `cargo run` writes. A test fails
//! when they are stale.

mod layout;
mod translate;

use std::error::Error;
use std::path::{Path, PathBuf};
use translate::Shader;

/// Where the shader finds the bytes of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bytes {
    /// In a storage buffer.
    Buffer,
    /// In a texture of unsigned integers, four words a texel.
    Texture,
}

/// Which files a shader can read. One family alone makes a shader that is smaller and needs fewer registers; what it
/// answers from a file of another family has no meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Families {
    /// Every family: the shader looks which it is.
    All,
    /// Grids alone.
    Grid,
    /// Octrees of interpolants alone.
    Octree,
    /// Octrees of polynomials alone.
    Polynomial,
}

impl Families {
    /// The parts of the reader that are for these families.
    fn parts(self) -> Vec<&'static str> {
        let grid = include_str!("../wgsl/grid.wgsl");
        let octree = include_str!("../wgsl/octree.wgsl");
        let polynomial = [include_str!("../wgsl/polynomial.wgsl"), include_str!("../wgsl/blend.wgsl")];
        let lattice = include_str!("../wgsl/lattice.wgsl");
        let hermite = include_str!("../wgsl/hermite.wgsl");
        match self {
            Self::All => [&[grid, octree][..], &polynomial, &[lattice, hermite]].concat(),
            Self::Grid => vec![grid, hermite],
            Self::Octree => vec![octree, lattice, hermite],
            Self::Polynomial => [&polynomial[..], &[lattice]].concat(),
        }
    }

    /// The function between the door and the families.
    fn choice(self) -> String {
        let only = |function: &str| format!("    return {function}(field, position);\n");
        let body = match self {
            Self::All => {
                let case = |label: &str, function: &str| {
                    format!("        {label}: {{ return {function}(field, position); }}\n")
                };
                [
                    "    switch field.family {\n",
                    &case("case FAMILY_GRID", "evaluate_grid"),
                    &case("case FAMILY_OCTREE", "evaluate_octree"),
                    &case("default", "evaluate_polynomial_octree"),
                    "    }\n",
                ]
                .concat()
            }
            Self::Grid => only("evaluate_grid"),
            Self::Octree => only("evaluate_octree"),
            Self::Polynomial => only("evaluate_polynomial_octree"),
        };
        format!(
            "// The answer at a position in the box, in finest cells from its least corner.\n\
             fn answer_at(field: Field, position: vec3<f32>) -> Answer {{\n{body}}}\n"
        )
    }
}

/// The vertices of a picture.
const CORNER: &str = include_str!("../wgsl/corner.wgsl");

/// The reader, without an entry point: WGSL to which a shader appends its own.
pub fn reader(bytes: Bytes, families: Families) -> String {
    let words = match bytes {
        Bytes::Buffer => include_str!("../wgsl/words_buffer.wgsl"),
        Bytes::Texture => include_str!("../wgsl/words_texture.wgsl"),
    };
    let (choice, layout) = (families.choice(), layout::wgsl());
    let mut parts =
        vec!["// Made from the parts in `runtime/shaders/wgsl` by `cargo run` there. Do not edit.\n", words];
    parts.extend([include_str!("../wgsl/field.wgsl"), &choice]);
    parts.extend(families.parts());
    parts.extend([include_str!("../wgsl/sample.wgsl"), &layout]);
    parts.join("\n")
}

/// A compute shader that answers a list of points: the entry point `query`.
pub fn query() -> String {
    [&reader(Bytes::Buffer, Families::All), include_str!("../wgsl/query.wgsl")].join("\n")
}

/// Shaders that draw a view: the entry points `corner` and `pixel`.
pub fn render(bytes: Bytes, families: Families) -> String {
    [&reader(bytes, families), CORNER, include_str!("../wgsl/render.wgsl")].join("\n")
}

/// The reader, without an entry point, in the GLSL of WebGL 2: a shader appends its own `main` and sets `nearfield_words`.
///
/// # Errors
///
/// What naga finds wrong with the source, or a translation that is not laid out as expected.
pub fn webgl_reader(families: Families) -> Result<String, Box<dyn Error>> {
    let library = [&reader(Bytes::Texture, families), include_str!("../wgsl/library.wgsl")].join("\n");
    let translated = Shader::new(&library)?.glsl("pixel", translate::GLSL_ES_300)?;
    let translated = String::from_utf8(translated)?.replace("_group_0_binding_0_fs", "nearfield_words");

    // What is before the functions and after them belongs to the entry point, and to the shader that this will be part of.
    let (functions, _) = translated.split_once("void main()").ok_or("GLSL without an entry point")?;
    let is_of_shader = |line: &&str| {
        ["#version", "precision", "smooth in", "layout(location"].iter().any(|start| line.starts_with(start))
    };
    let lines = functions.lines().filter(|line| !is_of_shader(line)).map(|line| format!("{line}\n"));
    Ok(lines.collect::<String>().trim().to_owned() + "\n")
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
    let pixel =
        |families: Families| Shader::new(&render(Bytes::Texture, families))?.glsl("pixel", translate::GLSL_ES_300);
    let webgl_file =
        |name: &str, families: Families| Ok::<_, Box<dyn Error>>(file(name, webgl_reader(families)?.into()));
    let query = Shader::new(&query())?;
    Ok(vec![
        file("nearfield.wgsl", reader(Bytes::Buffer, Families::All).into()),
        file("nearfield_texture.wgsl", reader(Bytes::Texture, Families::All).into()),
        webgl_file("nearfield-grid.glsl", Families::Grid)?,
        webgl_file("nearfield-octree.glsl", Families::Octree)?,
        webgl_file("nearfield-polynomial.glsl", Families::Polynomial)?,
        file("query.hlsl", query.hlsl()?),
        file("query.metal", query.metal()?),
        file("query.spv", query.spirv()?),
        file("query.comp", query.glsl("query", translate::GLSL_430)?),
        viewer("corner.vert", Shader::new(CORNER)?.glsl("corner", translate::GLSL_ES_300)?),
        viewer("grid.frag", pixel(Families::Grid)?),
        viewer("octree.frag", pixel(Families::Octree)?),
        viewer("polynomial.frag", pixel(Families::Polynomial)?),
    ])
}
