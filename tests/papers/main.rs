//! Measures what the papers behind Nearfield measured, and writes their figures beside ours.
//!
//! `cargo run --release -p conformance --bin papers -- [MESHES] OUTPUT.md`: MESHES is a folder with
//! `stanford-bunny.obj`, `armadillo.obj`, `horse.ply` and `sponza.obj`; the repository's own Spot stands in for the first
//! three.

mod first_order;
mod higher_order;
mod measure;
mod octree;
mod shapes;

use cpu_time::ProcessTime;
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
    let start = ProcessTime::now();
    let shapes = shapes::Shapes::read(meshes);

    let mut text = introduction(&shapes);
    text += &first_order::tables(&shapes);
    let (tables, curves) = higher_order::tables(&shapes);
    text += &tables;
    let (octrees, mut charts) = octree::tables(&shapes);
    text += &octrees;
    charts.push(("papers-error.svg", "mean error by bytes, armadillo", curves));

    let folder = output.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    for (file, title, curves) in charts {
        let unit = if file == "papers-error.svg" { " B" } else { "" };
        fs::write(folder.join(file), chart::log_log(title, unit, &curves))?;
    }
    let seconds = start.elapsed().as_secs();
    text += &format!("\nAll of this took {} min {} s of CPU time.\n", seconds / 60, seconds % 60);
    fs::write(output, text)
}

fn introduction(shapes: &shapes::Shapes) -> String {
    format!(
        "# The papers' figures beside ours\n\n\
         Written by `cargo run --release -p conformance --bin papers -- [MESHES] docs/measurements/papers.md`, on\n\
         2026-11-22, on a shared machine of 2 cores (x86-64).\n\
         Bunny: {}. Armadillo: {}. Horse: {}.\n\
         All are centred and scaled into [-1, 1]³ for the papers of 2020 and 2022, as there. The dragon of 2020 and the\n\
         scenes of 2022 are not published with the papers: the horse stands beside the dragon, and the scenes are our own.\n\n\
         Errors are against exact distances: for section 5.2 of 2020 over a lattice of 256³, as there, otherwise for 2020\n\
         and 2022 at {} random points of the cube.\n\
         Every field of ours went through its file and the shipping reader.\n\n",
        shapes.bunny.origin,
        shapes.armadillo.origin,
        shapes.horse.origin,
        measure::POINTS
    )
}
