//! `nearfield bake --pareto`: the curve of size against error, for eyes and for programs.

use super::error_table::MeasurementReport;
use super::exit_code::Failure;
use super::{files, to_json};
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::pareto::{Curve, Point};
use nearfield_bake::picture::chart;
use nearfield_bake::settings::{Layout, Resolution, Target};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Version of the names and meanings.
const SCHEMA: u32 = 1;

/// What `--pareto` writes. Lengths in mesh units.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct ParetoReport {
    schema: u32,
    mesh: String,
    triangles: usize,
    /// Diagonal of the mesh's box.
    diagonal: f64,
    curves: Vec<CurveReport>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct CurveReport {
    /// `uniform` and `surface`, the profiles of octrees of polynomials; `octree`, of interpolants; or a kind of grid.
    name: &'static str,
    /// From the coarsest to the finest.
    fields: Vec<FieldReport>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct FieldReport {
    /// The error asked for, as `--error-abs` takes it; absent of grids.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<f64>,
    /// The largest error asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    max_error: Option<f64>,
    /// As `--resolution` takes it; absent of octrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    resolution: Option<String>,
    bytes: usize,
    measured: MeasurementReport,
}

impl ParetoReport {
    fn of(path: &Path, mesh: &CheckedMesh, curves: &[Curve]) -> Self {
        let diagonal = mesh.bounds.diagonal();
        let field = |point: &Point| {
            let settings = &point.settings;
            let (error, max_error, resolution) = match &settings.layout {
                Layout::Octree => (Some(settings.error), None, None),
                Layout::Polynomial(polynomial) => (Some(settings.error), polynomial.max_error, None),
                Layout::Grid(grid) => (None, None, Some(resolution(grid.resolution))),
            };
            let absolute = |target: Target| target.absolute(diagonal);
            FieldReport {
                error: error.map(absolute),
                max_error: max_error.map(absolute),
                resolution,
                bytes: point.bytes,
                measured: (&point.measurement).into(),
            }
        };
        let curves = curves
            .iter()
            .map(|curve| CurveReport { name: curve.name, fields: curve.fields.iter().map(field).collect() })
            .collect();
        Self { schema: SCHEMA, mesh: path.display().to_string(), triangles: mesh.triangles.len(), diagonal, curves }
    }
}

/// Above the rows of the table.
pub(super) const HEADING: &str = concat!(
    "                                    uniform, / diagonal        band\n",
    "field            asked       bytes   RMSE     p99      max       RMSE     p99      max\n"
);

/// A row of the table: errors relative to the diagonal.
pub(super) fn row(name: &str, point: &Point, diagonal: f64) -> String {
    let asked = match &point.settings.layout {
        Layout::Octree | Layout::Polynomial(_) => {
            format!("{:.2e}", point.settings.error.absolute(diagonal) / diagonal)
        }
        Layout::Grid(grid) => resolution(grid.resolution),
    };
    let mut row = format!("{name:<14}{asked:>8}{:>12}", point.bytes);
    for errors in [&point.measurement.uniform, &point.measurement.band] {
        row += " ";
        for error in [errors.rmse, errors.p99(), errors.max()] {
            row += &format!("  {:.1e}", error / diagonal);
        }
    }
    row + "\n"
}

fn resolution(resolution: Resolution) -> String {
    match resolution {
        Resolution::Longest(samples) => samples.to_string(),
        Resolution::Each([x, y, z]) => format!("{x}x{y}x{z}"),
    }
}

/// Where the chart goes: beside the numbers.
pub(super) fn chart_path(numbers: &Path) -> Result<PathBuf, Failure> {
    let chart = numbers.with_extension("svg");
    match files::is_standard_stream(numbers) || chart == numbers {
        true => Err(Failure::Usage(
            "--pareto names a file of numbers, as curve.json: a chart, curve.svg, goes beside it".into(),
        )),
        false => Ok(chart),
    }
}

/// Writes the numbers and the chart: root mean square errors by bytes, over the box and in the band.
pub(super) fn write(
    numbers: &Path,
    chart: &Path,
    mesh_path: &Path,
    mesh: &CheckedMesh,
    curves: &[Curve],
) -> Result<(), Failure> {
    let diagonal = mesh.bounds.diagonal();
    let lines = |points: &str, rmse: fn(&Point) -> f64| -> Vec<chart::Curve> {
        let of = |curve: &Curve| {
            let line = curve.fields.iter().map(|point| (point.bytes as f64, rmse(point) / diagonal));
            (format!("{}: {points}", curve.name), line.collect())
        };
        curves.iter().filter(|curve| !curve.fields.is_empty()).map(of).collect()
    };
    let in_box = lines("box", |point| point.measurement.uniform.rmse);
    let in_band = lines("band", |point| point.measurement.band.rmse);
    let name = mesh_path.file_name().unwrap_or_default().display();
    let title = format!("{name}: RMSE / diagonal by bytes");

    let report = ParetoReport::of(mesh_path, mesh, curves);
    files::write_bytes(numbers, to_json(&report).as_bytes())?;
    files::write_bytes(chart, chart::log_log(&title, " B", &[in_box, in_band].concat()).as_bytes())
}
