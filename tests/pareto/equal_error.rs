//! How many bytes a dense grid takes to be no worse than an octree.

use crate::{Family, Kind, Measured};
use std::fmt::Write;

/// What a grid may not be worse in.
type Metric = fn(&Measured) -> f64;

const EVERYWHERE: [Metric; 3] = [
    |field| field.figures.uniform.rmse,
    |field| field.figures.band.rmse,
    |field| field.figures.uniform.max.max(field.figures.band.max),
];
const NEAR: [Metric; 2] = [|field| field.figures.band.rmse, |field| field.figures.band.max];

/// The octrees, and the least dense grid that is no worse, interpolated between resolutions: of full range in uniform
/// RMSE, band RMSE and largest error; narrow in band RMSE and largest error of the band.
pub(crate) fn table(families: &[Family]) -> String {
    let mut text = String::from(
        "What dense grids of 8 bits and BC4 take to be no worse than an octree: those of full range in uniform RMSE, band\n\
         RMSE and largest error, narrow ones in RMSE and largest error of the band; interpolated between resolutions\n\
         (\"over\": worse at the finest that was tried).\n\n\
         | octree | target | bytes | full range | times | narrow | times |\n| --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for family in families.iter().filter(|family| family.name.starts_with("polynomials")) {
        for field in &family.fields {
            write!(text, "| {} | {} | {} |", family.name, field.setting, field.bytes).expect("memory");
            for (kind, metrics) in [(Kind::Everywhere, &EVERYWHERE[..]), (Kind::Narrow, &NEAR[..])] {
                let rivals = families.iter().filter(|rival| rival.kind == kind);
                let rivals = rivals.filter(|rival| rival.name.starts_with("8 bits") || rival.name.starts_with("BC4"));
                let needs = rivals.map(|rival| needed(rival, field, metrics));
                let (over, bytes) = needs
                    .min_by(|a, b| (a.0, a.1).partial_cmp(&(b.0, b.1)).expect("numbers"))
                    .expect("there are dense grids");
                let over = if over { "over " } else { "" };
                write!(text, " {over}{bytes:.0} | {over}{:.1} |", bytes / field.bytes as f64).expect("memory");
            }
            text.push('\n');
        }
    }
    text + "\n"
}

/// Whether no field of the family is good enough, and the bytes of the least that is or of the largest.
fn needed(rival: &Family, field: &Measured, metrics: &[Metric]) -> (bool, f64) {
    let each = metrics.iter().map(|metric| equal_bytes(&rival.fields, *metric, metric(field)));
    each.fold((false, 0.0), |(over, bytes), one| (over || one.0, f64::max(bytes, one.1)))
}

fn equal_bytes(fields: &[Measured], metric: Metric, error: f64) -> (bool, f64) {
    let point = |field: &Measured| (field.bytes as f64, metric(field));
    let Some(found) = fields.iter().position(|field| metric(field) <= error) else {
        return (true, fields.last().map_or(0.0, |field| field.bytes as f64));
    };
    let (high, error_high) = point(&fields[found]);
    if found == 0 {
        return (false, high);
    }
    let (low, error_low) = point(&fields[found - 1]);
    let t = (error_low.ln() - error.ln()) / (error_low.ln() - error_high.ln());
    (false, (low.ln() + t * (high.ln() - low.ln())).exp())
}
