//! Valasek and Bán 2022: higher orders and their filters.

use crate::measure::{Errors, Subject};
use crate::shapes::{Formula, Shapes, scene_1, scene_2, torus};
use nearfield_bake::picture::chart::Curve;
use nearfield_bake::settings::{FineGrid, GridSettings, Precision, RangeScope, Reconstruction, Resolution, Sampling};
use std::fmt::Write;

const RESOLUTIONS: [u16; 3] = [8, 16, 32];
/// Resolutions of zero-order fields between which errors are interpolated.
const ZERO_ORDER: [u32; 12] = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 256];

struct Column {
    name: &'static str,
    order: u8,
    reconstruction: Reconstruction,
    precision: Precision,
    /// Reach of the fine grid; exact derivatives without one.
    extent: Option<f64>,
}

const fn column(
    name: &'static str,
    order: u8,
    reconstruction: Reconstruction,
    precision: Precision,
    extent: Option<f64>,
) -> Column {
    Column { name, order, reconstruction, precision, extent }
}

const COLUMNS: [Column; 9] = [
    column("O1c", 1, Reconstruction::Blend, Precision::F32, Some(0.5)),
    column("O1F", 1, Reconstruction::Hermite, Precision::F32, None),
    column("O2q", 2, Reconstruction::Blend, Precision::F32, Some(0.5)),
    column("O2F", 2, Reconstruction::Hermite, Precision::F32, Some(0.25)),
    column("O3s", 3, Reconstruction::Blend, Precision::F32, Some(0.5)),
    column("half", 1, Reconstruction::Half, Precision::F32, None),
    column("O1F packed", 1, Reconstruction::Hermite, Precision::Packed32, None),
    column("half packed", 1, Reconstruction::Half, Precision::Packed32, None),
    column("half O2 packed", 2, Reconstruction::Half, Precision::Packed32, Some(0.25)),
];

/// Percent of the paper's first five columns, mean, median and max, where the text of the paper survives;
/// rows as the resolutions. The O1c column of the mean is unreadable in our copy.
const PAPER: [[[[f64; 5]; 3]; 3]; 2] = [
    // Torus.
    [
        [[f64::NAN, 7.0, 19.0, 8.0, 13.0], [98.0, 3.0, 8.0, 2.0, 4.0], [21.0, 14.0, 31.0, 19.0, 31.0]],
        [[f64::NAN, 6.0, 10.0, 4.0, 8.0], [98.0, 2.0, 4.0, 1.0, 1.0], [21.0, 13.0, 26.0, 20.0, 26.0]],
        [[f64::NAN, 4.0, 7.0, 3.0, 5.0], [108.0, 2.0, 2.0, 0.0, 1.0], [21.0, 14.0, 25.0, 17.0, 21.0]],
    ],
    // Armadillo.
    [
        [[f64::NAN, 65.0, 114.0, 67.0, 105.0], [139.0, 41.0, 125.0, 53.0, 119.0], [98.0, 50.0, 53.0, 41.0, 61.0]],
        [[f64::NAN, 60.0, 103.0, 60.0, 105.0], [121.0, 32.0, 88.0, 38.0, 99.0], [98.0, 55.0, 46.0, 50.0, 57.0]],
        [[f64::NAN, 50.0, 96.0, 53.0, 97.0], [119.0, 25.0, 78.0, 31.0, 89.0], [79.0, 39.0, 37.0, 34.0, 42.0]],
    ],
];

pub(crate) fn tables(shapes: &Shapes) -> (String, Vec<Curve>) {
    let formulas = [Formula(torus), Formula(scene_1), Formula(scene_2)];
    let subjects = [
        (Subject::new("torus", &formulas[0]), Some(&PAPER[0])),
        (Subject::new(shapes.armadillo.name, &shapes.armadillo.distance), Some(&PAPER[1])),
        (Subject::new("scene 1", &formulas[1]), None),
        (Subject::new("scene 2", &formulas[2]), None),
    ];

    let mut text = String::from(
        "## Valasek and Bán 2022, Higher order algebraic signed distance fields\n\n\
         ### Table 1\n\nBytes in percent of the trilinear f32 field of equal error, paper / ours where the paper has the\n\
         shape. Rows of the paper are not labelled with resolutions; its first to third stand beside 8³, 16³ and 32³.\n\
         Blends and O2F are fitted over 3³ points (O3s 5³) that reach half a spacing (O2F a quarter); O1F and `half` use\n\
         exact gradients. \"packed\" is 32 bits a first-order sample and its brick's range, and 16 bits a coefficient of\n\
         degree 2.\n\n",
    );
    let mut curves = Vec::new();
    let names: Vec<&str> = COLUMNS.iter().map(|column| column.name).collect();
    writeln!(text, "| shape | error | N | {} |", names.join(" | ")).expect("memory");
    writeln!(text, "| --- | --- | --- |{}", " --- |".repeat(COLUMNS.len())).expect("memory");
    for (subject, paper) in &subjects {
        let zero: Vec<(f64, Errors)> = ZERO_ORDER
            .iter()
            .map(|&samples| (4.0 * f64::from(samples).powi(3), subject.zero_order(samples, true)))
            .collect();
        let ours: Vec<Vec<(Errors, usize)>> = RESOLUTIONS
            .iter()
            .map(|&samples| {
                COLUMNS.iter().map(|column| subject.grid(settings(column, samples), column.precision)).collect()
            })
            .collect();

        type Metric = fn(&Errors) -> f64;
        let metrics: [(&str, Metric); 3] =
            [("mean", |errors| errors.mean), ("median", |errors| errors.median), ("max", |errors| errors.max)];
        for (metric_index, (metric_name, metric)) in metrics.into_iter().enumerate() {
            let curve: Vec<(f64, f64)> = zero.iter().map(|(bytes, errors)| (*bytes, metric(errors))).collect();
            for (row, samples) in RESOLUTIONS.iter().enumerate() {
                write!(text, "| {} | {metric_name} | {samples} |", subject.name).expect("memory");
                for (index, (errors, bytes)) in ours[row].iter().enumerate() {
                    let share = 100.0 * *bytes as f64 / equal_bytes(&curve, metric(errors));
                    let paper = paper.and_then(|paper| paper[row][metric_index].get(index));
                    match paper {
                        Some(paper) if paper.is_finite() => write!(text, " {paper:.0} / {share:.1} % |"),
                        _ => write!(text, " {share:.1} % |"),
                    }
                    .expect("memory");
                }
                text.push('\n');
            }
        }
        if subject.name == shapes.armadillo.name {
            curves.push(("trilinear f32".to_owned(), zero.iter().map(|(b, e)| (*b, e.mean)).collect()));
            for (index, column) in COLUMNS.iter().enumerate() {
                let points = ours.iter().map(|row| (row[index].1 as f64, row[index].0.mean)).collect();
                curves.push((column.name.to_owned(), points));
            }
        }
    }
    text += "\n![Mean error by bytes on the armadillo](papers-error.svg)\n\n\
             `half` is Σ wᵢ (fᵢ + ½ gᵢ·(x − xᵢ)), trilinear weights: the same samples as O1F at a lower cost. Where ours\n\
             differ from the paper's: it builds its samples from a trilinear field of 257³, ours are exact; its fine grid's\n\
             reach is not stated; its procedural scenes are not given, and the errors of a scene depend on how much of the\n\
             cube its medial axis fills.\n\n";
    (text, curves)
}

fn settings(column: &Column, samples: u16) -> GridSettings {
    let sampling = column.extent.map_or(Sampling::Taylor, |extent| {
        let count = if column.order == 3 { 5 } else { 3 };
        Sampling::LeastSquares(FineGrid { count, extent, falloff: 0.0, normalized: false })
    });
    let range = if column.precision == Precision::F32 { RangeScope::File } else { RangeScope::Brick };
    GridSettings {
        resolution: Resolution::Longest(samples),
        order: column.order,
        reconstruction: column.reconstruction,
        sampling,
        range,
    }
}

/// Bytes at which a falling curve of bytes and errors has an error, interpolated between logarithms and
/// extended by its last piece.
fn equal_bytes(curve: &[(f64, f64)], error: f64) -> f64 {
    let last = curve.len() - 2;
    let piece = curve.windows(2).position(|pair| pair[1].1 <= error).unwrap_or(last);
    let [(low, error_low), (high, error_high)] = [curve[piece], curve[piece + 1]].map(|(b, e)| (b.ln(), e.ln()));
    let t = (error.ln() - error_low) / (error_high - error_low);
    (low + t * (high - low)).exp()
}
