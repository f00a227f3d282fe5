//! Pujol and Chica 2023: adaptive octrees.

use crate::measure::number;
use crate::shapes::{MeshShape, Shapes};
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Continuity, Interpolant, Settings, Target};
use std::fmt::Write;

/// Megabytes, root mean square error and maximum of the paper: trilinear, tricubic.
struct Row<'a> {
    shape: &'a MeshShape,
    paper: [[f64; 3]; 2],
}

pub(crate) fn tables(shapes: &Shapes) -> String {
    let rows = [
        Row { shape: &shapes.armadillo, paper: [[66.15, 3.30e-4, 0.0019], [103.72, 2.51e-4, 0.0035]] },
        Row { shape: &shapes.bunny, paper: [[39.88, 3.25e-4, 0.00169], [55.62, 2.39e-4, 0.00347]] },
    ];
    let mut text = String::from(
        "## Pujol and Chica 2023, Adaptive approximation of signed distance fields\n\n\
         ### Tables 1 and 2\n\nTarget 5e-4 of the diagonal, depth 9, continuity forced (c0 and c1); paper / ours / ratio.\n\
         Uniform points of the mesh's box. The paper's armadillo has 345 944 triangles.\n\n\
         | shape | interpolant | MB | RMSE | max | seam | bake CPU s |\n| --- | --- | --- | --- | --- | --- | --- |\n",
    );
    let interpolants =
        [("trilinear", Interpolant::Trilinear, Continuity::C0), ("tricubic", Interpolant::Tricubic, Continuity::C1)];
    for Row { shape, paper } in rows {
        for ((name, interpolant, continuity), [bytes, rmse, max]) in interpolants.into_iter().zip(paper) {
            let settings = Settings {
                error: Target::Relative(5e-4),
                interpolant,
                continuity,
                samples: 50_000,
                ..Settings::default()
            };
            let baked = bake(&shape.mesh, &settings, &Silent).expect("the mesh bakes");
            let (errors, diagonal) = (&baked.report.measurement, shape.mesh.bounds.diagonal());
            let seconds: f64 = baked.report.stages.iter().map(|stage| stage.cpu.as_secs_f64()).sum();
            let beside = |paper: f64, ours: f64| format!("{} / {} / {:.2}", number(paper), number(ours), ours / paper);
            writeln!(
                text,
                "| {} | {name} | {} | {} | {} | {} | {seconds:.1} |",
                shape.name,
                beside(bytes, baked.bytes.len() as f64 / 1e6),
                beside(rmse, errors.uniform.rmse / diagonal),
                beside(max, errors.uniform.max() / diagonal),
                number(errors.seams.max / diagonal)
            )
            .expect("memory");
        }
    }

    text += "\nThe bunny has holes, so its sign comes from winding numbers and jumps across them: there lie the largest errors.\n\
             Times are of a loaded machine.\n\n### The sweep of figure 5\n\nArmadillo, tricubic, c1.\n\n\
             | target | MB | RMSE | max | bake CPU s |\n| --- | --- | --- | --- | --- |\n";
    for target in [8e-3, 4e-3, 2e-3, 1e-3] {
        let settings = Settings { error: Target::Relative(target), samples: 50_000, ..Settings::default() };
        let shape = &shapes.armadillo;
        let baked = bake(&shape.mesh, &settings, &Silent).expect("the mesh bakes");
        let (errors, diagonal) = (&baked.report.measurement.uniform, shape.mesh.bounds.diagonal());
        let seconds: f64 = baked.report.stages.iter().map(|stage| stage.cpu.as_secs_f64()).sum();
        writeln!(
            text,
            "| {} | {:.3} | {} | {} | {seconds:.1} |",
            number(target),
            baked.bytes.len() as f64 / 1e6,
            number(errors.rmse / diagonal),
            number(errors.max() / diagonal)
        )
        .expect("memory");
    }
    text
}
