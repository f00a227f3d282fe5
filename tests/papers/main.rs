//! Measures what the papers behind Nearfield measured, and writes their figures beside ours.
//!
//! `cargo run --release -p conformance --bin papers -- [MESHES] OUTPUT.md`: MESHES is a folder with
//! `stanford-bunny.obj`, `armadillo.obj` and `sponza.obj`; the repository's own Spot stands in for the first two.

mod first_order;
mod higher_order;
mod measure;
mod octree;
mod shapes;

use nearfield_bake::picture::chart;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let arguments: Vec<PathBuf> = env::args_os().skip(1).map(PathBuf::from).collect();
    let (meshes, output) = match arguments.as_slice() {
        [output] => (None, output),
        [meshes, output] => (Some(meshes.as_path()), output),
        _ => return Err(io::Error::other("usage: papers [MESHES] OUTPUT.md")),
    };
    let shapes = shapes::Shapes::read(meshes);

    let mut text = introduction(&shapes);
    text += &first_order::tables(&shapes);
    let (tables, curves) = higher_order::tables(&shapes);
    text += &tables;
    let octree::Tables { text: octrees, sweep, by_distance } = octree::tables(&shapes);
    text += &octrees;

    let folder = output.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let charts = [
        ("papers-error.svg", "mean error by bytes, mesh", " B", curves),
        ("papers-target.svg", "megabytes and RMSE by target", "", sweep),
        ("papers-distance.svg", "RMSE by distance to the surface", "", by_distance),
    ];
    for (file, title, unit, curves) in charts {
        fs::write(folder.join(file), chart::log_log(title, unit, &curves))?;
    }
    fs::write(output, text)
}

fn introduction(shapes: &shapes::Shapes) -> String {
    format!(
        "# The papers' figures beside ours\n\n\
         Written by `cargo run --release -p conformance --bin papers -- [MESHES] docs/measurements/papers.md`, on\n\
         2026-11-22, on a shared machine of 2 cores (x86-64).\n\
         Bunny: {}. Armadillo: {}.\n\
         Both are centred and scaled into [-1, 1]³ for the papers of 2020 and 2022, as there. The dragon and the two\n\
         procedural scenes of 2022 are not published with the papers: there is no dragon here, and the scenes are our own.\n\n\
         Errors are taken at {} random points of the cube, against exact distances. The papers resample to a lattice of\n\
         256³ that is itself their ground truth; a random point sees the same mean error without the lattice's own.\n\
         Every field of ours went through its file and the shipping reader.\n\n",
        shapes.bunny.origin,
        shapes.armadillo.origin,
        measure::POINTS
    )
}
