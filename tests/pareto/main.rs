//! Bytes against error: polynomial octrees beside dense grids, at the same points, in the same run.
//!
//! `cargo run --release -p conformance --bin pareto -- [MESHES] OUTPUT.md`: MESHES is a folder with `armadillo.obj` and
//! `fandisk.obj`; without it there is the repository's own Spot. Charts are written beside the table.

mod dense;
mod equal_error;
mod openvdb;
mod ours;
mod subject;

use nearfield_bake::picture::chart;
use openvdb::OpenVdb;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};
use subject::{Figures, Subject};

/// Fields of one kind, ascending in bytes.
struct Family {
    name: &'static str,
    kind: Kind,
    fields: Vec<Measured>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// Valid in the whole box.
    Everywhere,
    /// Clamped: valid near the surface alone.
    Narrow,
}

/// A field and what it was found to be.
struct Measured {
    /// The target or the resolution.
    setting: String,
    bytes: usize,
    figures: Figures,
}

fn main() -> io::Result<()> {
    let arguments: Vec<PathBuf> = env::args_os().skip(1).map(PathBuf::from).collect();
    let (meshes, output) = match arguments.as_slice() {
        [output] => (None, output),
        [meshes, output] => (Some(meshes.as_path()), output),
        _ => return Err(io::Error::other("usage: pareto [MESHES] OUTPUT.md")),
    };
    let spot = Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes/spot.ply");
    let subjects = match meshes {
        None => vec![("spot", spot)],
        Some(folder) => ["armadillo", "fandisk"].map(|name| (name, folder.join(format!("{name}.obj")))).to_vec(),
    };

    let folder = output.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let open_vdb = OpenVdb::find();
    let mut text = introduction(open_vdb.is_some());
    for (name, path) in subjects {
        let subject = Subject::read(name, &path);
        let mut families = ours::families(&subject);
        families.extend(dense::families(&subject));
        if let Some(open_vdb) = &open_vdb {
            families.extend(open_vdb.families(&subject)?);
        }

        writeln!(text, "## {name}, {} triangles\n", subject.mesh.triangles.len()).expect("memory");
        text += &equal_error::table(&families);
        text += &table(&families);
        type Metric = fn(&Figures) -> f64;
        let charts: [(&str, Metric); 2] =
            [("uniform", |figures| figures.uniform.rmse), ("band", |figures| figures.band.rmse)];
        for (points, metric) in charts {
            let kinds = if points == "uniform" { &[Kind::Everywhere][..] } else { &[Kind::Everywhere, Kind::Narrow] };
            let shown = families.iter().filter(|family| kinds.contains(&family.kind));
            let curves: Vec<chart::Curve> = shown
                .map(|family| {
                    let points = family.fields.iter().map(|field| (field.bytes as f64, metric(&field.figures)));
                    (family.name.to_owned(), points.collect())
                })
                .collect();
            let file = format!("pareto-{name}-{points}.svg");
            fs::write(folder.join(&file), chart::log_log(&format!("{name}: RMSE, {points}, by bytes"), " B", &curves))?;
            write!(text, "![RMSE of {name}, {points}, by bytes]({file})\n\n").expect("memory");
        }
    }
    fs::write(output, text)
}

fn introduction(has_open_vdb: bool) -> String {
    let open_vdb = if has_open_vdb {
        "Level sets of OpenVDB have as many voxels\n\
         as named along the longest side, are not renormalized, and reach as far as the band or the box; they are counted as\n\
         files, compressed, and as grids of NanoVDB."
    } else {
        "OpenVDB and NanoVDB were not at hand."
    };
    format!(
        "# Bytes against error\n\n\
         Written by `cargo run --release -p conformance --bin pareto -- [MESHES] docs/measurements/pareto.md` on\n\
         23 November 2026; two cores of an AMD EPYC, x86-64, shared with other work.\n\n\
         Errors are relative to the diagonal, at {} points uniform in the mesh's box and as many of the band, the same\n\
         points for every field. Times are thread CPU times of one distance, points of the box in random order; the machine\n\
         was busy, and they say little beyond their order of magnitude.\n\n\
         Dense grids are as plain as can be: samples of the exact distance over the mesh's box and the band around it,\n\
         as many as named along the longest side, no header, trilinear. 8 bits and BC4 are signed and normalized to the\n\
         farthest sample, or narrow: to {} % of the diagonal, clamped beyond, so that their uniform errors say little.\n\
         BC4 chooses the better of its two modes and the best of nine pairs of ends. Our files count every byte, and\n\
         octrees cover 20 % more on every side. {open_vdb}\n\n",
        subject::POINTS,
        100.0 * dense::NARROW
    )
}

fn table(families: &[Family]) -> String {
    let mut text = String::from(
        "| field | setting | bytes | uniform RMSE | p99 | max | band RMSE | p99 | max | ns |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for family in families {
        for Measured { setting, bytes, figures: Figures { uniform, band, nanoseconds } } in &family.fields {
            write!(text, "| {} | {setting} | {bytes} |", family.name).expect("memory");
            for errors in [uniform, band] {
                write!(text, " {:.2e} | {:.2e} | {:.2e} |", errors.rmse, errors.p99, errors.max).expect("memory");
            }
            writeln!(text, " {nanoseconds:.0} |").expect("memory");
        }
    }
    text + "\n"
}
