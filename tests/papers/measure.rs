//! Errors of fields over the cube [-1, 1]³.

use glam::DVec3;
use nearfield::Field;
use nearfield_bake::bake_function;
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::geometry::Aabb;
use nearfield_bake::progress::Silent;
use nearfield_bake::random::Draws;
use nearfield_bake::settings::{GridSettings, Layout, Precision, Settings};

/// Random points at which errors are taken.
pub(crate) const POINTS: usize = 60_000;
/// The papers' region.
pub(crate) const CUBE: Aabb = Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE };

/// A shape with its exact distances at the points.
pub(crate) struct Subject<'a> {
    pub(crate) name: &'static str,
    pub(crate) function: &'a dyn FieldFunction,
    points: Vec<DVec3>,
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
        let points: Vec<DVec3> = (0..POINTS as u64)
            .map(|index| {
                let mut draws = Draws::new(2020, 2022, index);
                let unit = DVec3::new(draws.unit(), draws.unit(), draws.unit());
                (2.0 * unit - 1.0).as_vec3().as_dvec3()
            })
            .collect();
        let exact = function.sample_all(&points).into_iter().map(|sample| sample.distance).collect();
        Self { name, function, points, exact }
    }

    /// Errors of a grid over the cube, through its file; and the bytes of the file's samples and ranges.
    pub(crate) fn grid(&self, grid: GridSettings, precision: Precision) -> (Errors, usize) {
        let settings =
            Settings { layout: Layout::Grid(grid), precision, margin: 0.0, samples: 100, ..Settings::default() };
        let baked = bake_function(self.function, &CUBE, &settings, &Silent).expect("the function bakes");
        let field = Field::open(&baked.bytes).expect("a field");
        let bytes = field.sections().skip(1).map(|section| section.range.len()).sum();
        let found = self.points.iter().map(|point| f64::from(field.distance(point.as_vec3().to_array())));
        (self.errors(found), bytes)
    }

    /// Errors of exact distances on `samples`³ points, the nearest or interpolated trilinearly. Only the
    /// samples that the points need are taken.
    pub(crate) fn zero_order(&self, samples: u32, trilinear: bool) -> Errors {
        let cells = f64::from(samples - 1);
        let place = |point: &DVec3| (*point + 1.0) * (0.5 * cells);
        let vertex = |at: DVec3| at * (2.0 / cells) - 1.0;
        if !trilinear {
            let nearest: Vec<DVec3> = self.points.iter().map(|point| vertex(place(point).round())).collect();
            let found = self.function.sample_all(&nearest);
            return self.errors(found.into_iter().map(|sample| sample.distance));
        }

        let least = |point: &DVec3| place(point).floor().min(DVec3::splat(cells - 1.0));
        let corner = |corner: usize| DVec3::new((corner & 1) as f64, (corner >> 1 & 1) as f64, (corner >> 2) as f64);
        let corners: Vec<DVec3> = self
            .points
            .iter()
            .flat_map(|point| (0..8).map(move |index| vertex(least(point) + corner(index))))
            .collect();
        let samples = self.function.sample_all(&corners);
        let found = self.points.iter().zip(samples.chunks(8)).map(|(point, samples)| {
            let t = place(point) - least(point);
            let weight = |index: usize| (1.0 - t + corner(index) * (2.0 * t - 1.0)).element_product();
            samples.iter().enumerate().map(|(index, sample)| weight(index) * sample.distance).sum()
        });
        self.errors(found)
    }

    /// Points and exact distances.
    pub(crate) fn points(&self) -> &[DVec3] {
        &self.points
    }

    pub(crate) fn errors(&self, found: impl Iterator<Item = f64>) -> Errors {
        let mut errors: Vec<f64> = found.zip(&self.exact).map(|(found, exact)| (found - exact).abs()).collect();
        errors.sort_unstable_by(f64::total_cmp);
        Errors {
            mean: errors.iter().sum::<f64>() / errors.len() as f64,
            median: errors[errors.len() / 2],
            max: errors[errors.len() - 1],
        }
    }
}

/// A figure of a paper, ours, and their ratio.
pub(crate) fn beside(paper: f64, ours: f64) -> String {
    format!("{} / {} / {:.2}", number(paper), number(ours), ours / paper)
}

pub(crate) fn number(value: f64) -> String {
    if value >= 0.01 { format!("{value:.4}") } else { format!("{value:.1e}") }
}
