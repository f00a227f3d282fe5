//! Errors of fields over the cube [-1, 1]³.

use glam::DVec3;
use nearfield::Field;
use nearfield_bake::bake_function;
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::geometry::Aabb;
use nearfield_bake::progress::Silent;
use nearfield_bake::random::Draws;
use nearfield_bake::settings::{GridSettings, Layout, Precision, Settings};
use rayon::prelude::*;

/// Random points at which errors are taken.
pub(crate) const POINTS: usize = 60_000;
/// Points along an axis of the lattice of the paper of 2020.
const LATTICE: usize = 256;
/// The papers' region.
pub(crate) const CUBE: Aabb = Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE };

/// A shape with its exact distances at the points.
pub(crate) struct Subject<'a> {
    pub(crate) name: &'static str,
    pub(crate) function: &'a dyn FieldFunction,
    points: Vec<[f32; 3]>,
    exact: Vec<f64>,
}

/// Absolute errors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Errors {
    pub(crate) mean: f64,
    pub(crate) median: f64,
    pub(crate) max: f64,
}

impl<'a> Subject<'a> {
    pub(crate) fn new(name: &'static str, function: &'a dyn FieldFunction) -> Self {
        let point = |index| {
            let mut draws = Draws::new(2020, 2022, index);
            2.0 * DVec3::new(draws.unit(), draws.unit(), draws.unit()) - 1.0
        };
        Self::at(name, function, (0..POINTS as u64).map(|index| point(index).as_vec3().to_array()).collect())
    }

    /// The ground truth of the paper of 2020: a lattice of 256³ over the cube.
    pub(crate) fn on_lattice(name: &'static str, function: &'a dyn FieldFunction) -> Self {
        let place = |step: usize| (2.0 * step as f64 / (LATTICE - 1) as f64 - 1.0) as f32;
        let point = |index: usize| [index % LATTICE, index / LATTICE % LATTICE, index / LATTICE / LATTICE].map(place);
        Self::at(name, function, (0..LATTICE.pow(3)).map(point).collect())
    }

    fn at(name: &'static str, function: &'a dyn FieldFunction, points: Vec<[f32; 3]>) -> Self {
        let of_chunk = |points: &[[f32; 3]]| {
            let points: Vec<DVec3> = points.iter().map(|&point| to_dvec3(point)).collect();
            function.sample_all(&points).into_iter().map(|sample| sample.distance)
        };
        let exact = points.chunks(1 << 16).flat_map(of_chunk).collect();
        Self { name, function, points, exact }
    }

    /// Errors of a grid over the cube, through its file; and the bytes of the file's samples and ranges.
    pub(crate) fn grid(&self, grid: GridSettings, precision: Precision) -> (Errors, usize) {
        let settings =
            Settings { layout: Layout::Grid(grid), precision, margin: 0.0, samples: 100, ..Settings::default() };
        let baked = bake_function(self.function, &CUBE, &settings, &Silent).expect("the function bakes");
        let field = Field::open(&baked.bytes).expect("a field");
        let bytes = field.sections().skip(1).map(|section| section.range.len()).sum();
        (self.errors(|point| f64::from(field.distance(point.as_vec3().to_array()))), bytes)
    }

    /// Errors of exact distances on `samples`³ points, the nearest of which answers.
    pub(crate) fn zero_order(&self, samples: u32) -> Errors {
        let last = f64::from(samples - 1);
        let place = |index: u32| {
            DVec3::new(
                f64::from(index % samples),
                f64::from(index / samples % samples),
                f64::from(index / samples / samples),
            )
        };
        let points: Vec<DVec3> = (0..samples.pow(3)).map(|index| place(index) * (2.0 / last) - 1.0).collect();
        let held = self.function.sample_all(&points);
        self.errors(|point| {
            let nearest = ((point + 1.0) * (0.5 * last)).round().as_uvec3();
            held[(nearest.x + samples * (nearest.y + samples * nearest.z)) as usize].distance
        })
    }

    /// Errors of exact distances on `samples`³ points, interpolated trilinearly. Only those that the points need
    /// are taken.
    pub(crate) fn trilinear(&self, samples: u32) -> Errors {
        let cells = f64::from(samples - 1);
        let place = |point: DVec3| (point + 1.0) * (0.5 * cells);
        let vertex = |at: DVec3| at * (2.0 / cells) - 1.0;
        let least = |point: DVec3| place(point).floor().min(DVec3::splat(cells - 1.0));
        let corner = |corner: usize| DVec3::new((corner & 1) as f64, (corner >> 1 & 1) as f64, (corner >> 2) as f64);
        self.errors(|point| {
            let corners: [DVec3; 8] = std::array::from_fn(|index| vertex(least(point) + corner(index)));
            let t = place(point) - least(point);
            let weight = |index: usize| (1.0 - t + corner(index) * (2.0 * t - 1.0)).element_product();
            self.function.sample_all(&corners).iter().enumerate().map(|(i, sample)| weight(i) * sample.distance).sum()
        })
    }

    /// Points, mesh frame.
    pub(crate) fn points(&self) -> impl Iterator<Item = DVec3> {
        self.points.iter().map(|&point| to_dvec3(point))
    }

    /// Errors of answers at the points.
    pub(crate) fn errors(&self, answer: impl Fn(DVec3) -> f64 + Sync) -> Errors {
        let error = |(&point, exact): (&[f32; 3], &f64)| (answer(to_dvec3(point)) - exact).abs();
        let mut errors: Vec<f64> = self.points.par_iter().zip(&self.exact).map(error).collect();
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        let max = errors.iter().copied().fold(0.0, f64::max);
        let middle = errors.len() / 2;
        Errors { mean, median: *errors.select_nth_unstable_by(middle, f64::total_cmp).1, max }
    }
}

fn to_dvec3([x, y, z]: [f32; 3]) -> DVec3 {
    DVec3::new(f64::from(x), f64::from(y), f64::from(z))
}

/// A figure of a paper, ours, and their ratio.
pub(crate) fn beside(paper: f64, ours: f64) -> String {
    format!("{} / {} / {:.2}", number(paper), number(ours), ours / paper)
}

pub(crate) fn number(value: f64) -> String {
    if value >= 0.01 { format!("{value:.4}") } else { format!("{value:.1e}") }
}
