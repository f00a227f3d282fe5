//! `nearfield bench`: nanoseconds a query.

mod dense_grid;
mod point_sets;

use super::arguments::LevelOfDetail;
use super::exit_code::Failure;
use super::{files, print, to_json};
use clap::Args;
use dense_grid::DenseGrid;
use glam::Vec3;
use nearfield::Field;
use serde::Serialize;
use std::hint::black_box;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Time the queries of a field
///
/// Nanoseconds a query on one thread, the median of several passes: points anywhere in the box in no
/// order (random), row by row (coherent), and near the surface in no order (band), or your own points
/// with --points. Beside it, in the same run, a plain dense grid of f32 distances sampled from the
/// field, interpolated trilinearly. Before anything is timed, the answers of the two are compared.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield bench spot.nfd
  nearfield bench spot.nfd --points queries.f32 --json")]
pub(super) struct Bench {
    /// The field
    field: PathBuf,

    #[command(flatten)]
    lod: LevelOfDetail,

    /// Points to time instead: little-endian f32 triples (x, y, z) without a header
    #[arg(long, value_name = "POINTS")]
    points: Option<PathBuf>,

    /// Print a report in JSON
    #[arg(long)]
    json: bool,
}

/// Cells of the dense grid along the longest side.
const DENSE_CELLS: u32 = 128;
/// Every figure is the median of the passes that fit into this time.
const TIME_PER_FIGURE: Duration = Duration::from_millis(150);

#[derive(Debug, Serialize)]
struct BenchReport {
    schema: u32,
    field_bytes: usize,
    dense_grid_bytes: usize,
    dense_grid_cells: u32,
    sets: Vec<SetReport>,
}

/// Nanoseconds a query.
#[derive(Debug, Serialize)]
struct SetReport {
    points: &'static str,
    distance: f64,
    distance_and_gradient: f64,
    distances: f64,
    distances_and_gradients: f64,
    dense_distance: f64,
    dense_distance_and_gradient: f64,
}

impl Bench {
    pub(super) fn run(self) -> Result<(), Failure> {
        let bytes = files::read_bytes(&self.field)?;
        let field = self.lod.open(&bytes, &self.field)?;
        let dense = DenseGrid::of(&field, DENSE_CELLS);
        let sets = match &self.points {
            Some(path) => vec![("given", files::read_points(path)?)],
            None => vec![
                ("random", point_sets::random(&field)),
                ("coherent", point_sets::coherent(&field)),
                ("band", point_sets::band(&field)),
            ],
        };

        for (_, points) in &sets {
            compare(&field, &dense, points).map_err(|sentence| {
                Failure::Verification(format!("{}: {sentence}; bake it again", self.field.display()))
            })?;
        }
        let report = BenchReport {
            schema: 1,
            field_bytes: field.bytes().len(),
            dense_grid_bytes: dense.bytes(),
            dense_grid_cells: DENSE_CELLS,
            sets: sets
                .iter()
                .filter(|(_, points)| !points.is_empty())
                .map(|(name, points)| time_set(name, &field, &dense, points))
                .collect(),
        };

        print(&if self.json { to_json(&report) } else { text(&report) })
    }
}

/// Whether a batch has the bits of its points asked one by one, and whether field and grid answer alike inside the box: each is within the contract's p99 of the truth at 99 % of the
/// points, and a true distance changes by at most half a cell's diagonal between a point and the
/// corners that the grid interpolates, on average over them.
fn compare(field: &Field<'_>, dense: &DenseGrid, points: &[[f32; 3]]) -> Result<(), String> {
    const SHARE: f64 = 0.98;
    let mut batch = vec![0.0; points.len()];
    field.distances(points, &mut batch);
    if points.iter().zip(&batch).any(|(&point, batch)| field.distance(point).to_bits() != batch.to_bits()) {
        return Err("a batch does not answer as its points do one by one".to_owned());
    }

    let contract = field.contract();
    let bound = 2.0 * contract.uniform.p99.max(contract.band.p99) + 0.5 * 3f32.sqrt() * dense.edge();

    let bounds = field.header().bounds;
    let (min, max) = (Vec3::from(bounds.min), Vec3::from(bounds.max));
    let inside = |&&point: &&[f32; 3]| Vec3::from(point).cmpge(min).all() && Vec3::from(point).cmple(max).all();
    let points: Vec<&[f32; 3]> = points.iter().filter(inside).collect();

    let alike = points.iter().filter(|&&&point| (field.distance(point) - dense.distance(point)).abs() <= bound).count();
    if alike as f64 >= SHARE * points.len() as f64 {
        return Ok(());
    }
    Err(format!(
        "{} of {} answers differ by more than {bound:e} from a dense grid of its own samples",
        points.len() - alike,
        points.len()
    ))
}

fn time_set(name: &'static str, field: &Field<'_>, dense: &DenseGrid, points: &[[f32; 3]]) -> SetReport {
    let mut distances = vec![0.0; points.len()];
    let mut gradients = vec![[0.0; 3]; points.len()];

    SetReport {
        points: name,
        distance: nanoseconds(points.len(), || {
            black_box(points.iter().map(|&point| field.distance(point)).sum::<f32>());
        }),
        distance_and_gradient: nanoseconds(points.len(), || {
            black_box(points.iter().map(|&point| sum(field.distance_and_gradient(point))).sum::<f32>());
        }),
        distances: nanoseconds(points.len(), || {
            field.distances(points, &mut distances);
            black_box(&distances);
        }),
        distances_and_gradients: nanoseconds(points.len(), || {
            field.distances_and_gradients(points, &mut distances, &mut gradients);
            black_box((&distances, &gradients));
        }),
        dense_distance: nanoseconds(points.len(), || {
            black_box(points.iter().map(|&point| dense.distance(point)).sum::<f32>());
        }),
        dense_distance_and_gradient: nanoseconds(points.len(), || {
            black_box(points.iter().map(|&point| sum(dense.distance_and_gradient(point))).sum::<f32>());
        }),
    }
}

/// Uses every part of an answer, so that none of it can be left out.
fn sum((distance, [x, y, z]): (f32, [f32; 3])) -> f32 {
    distance + x + y + z
}

fn nanoseconds(queries: usize, mut pass: impl FnMut()) -> f64 {
    let start = Instant::now();
    let mut passes = Vec::new();
    while start.elapsed() < TIME_PER_FIGURE {
        let before = Instant::now();
        pass();
        passes.push(before.elapsed());
    }
    passes.sort_unstable();
    passes[passes.len() / 2].as_secs_f64() * 1e9 / queries as f64
}

fn text(report: &BenchReport) -> String {
    let mut text = format!(
        "ns a query, one thread         field ({} bytes)              dense {}³ f32 ({} bytes)\n\
         points      distance  +gradient      batch  +gradient   distance  +gradient\n",
        report.field_bytes, report.dense_grid_cells, report.dense_grid_bytes
    );
    for set in &report.sets {
        text += &format!(
            "{:<10}{:>10.1}{:>11.1}{:>11.1}{:>11.1}{:>11.1}{:>11.1}\n",
            set.points,
            set.distance,
            set.distance_and_gradient,
            set.distances,
            set.distances_and_gradients,
            set.dense_distance,
            set.dense_distance_and_gradient
        );
    }
    text
}
