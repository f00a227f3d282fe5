//! Samples whose reconstruction is nearest the function: least squares over all cells at once.
//!
//! Exact samples are best where the function is smooth. At the cut locus, where most of the error is, each of them
//! speaks for its own side alone, and the reconstruction between them is too high. What a reconstruction answers is
//! linear in its coefficients, so that those nearest the function at points of every cell follow from a sparse
//! symmetric system, solved by conjugate gradients (Hestenes and Stiefel 1952) from the exact samples on.

use super::Domain;
use super::basis::{contributions, share, value};
use crate::field_function::FieldFunction;
use crate::sampling::{EXPONENTS, monomial, terms};
use crate::settings::GridSettings;
use glam::{DVec3, UVec3};
use rayon::prelude::*;

/// Points along an axis of a cell at which the function is met, evenly apart.
const POINTS: u32 = 3;
/// Steps of the solver. Later ones change the mean error by less than a percent.
const STEPS: usize = 20;
/// Steps that settle the values once the gradients are unit vectors.
const VALUE_STEPS: usize = 8;

/// Moves exact coefficients, those of [`EXPONENTS`] for each sample in turn, to the least squares over all cells;
/// and how often the function was sampled. `unit_gradients` are for storage that knows no others.
pub(super) fn fit(
    function: &dyn FieldFunction,
    domain: &Domain,
    grid: &GridSettings,
    unit_gradients: bool,
    coefficients: &mut [f64],
) -> usize {
    let terms = terms(grid.order);
    let system = System::new(domain, grid);
    let wanted = system.wanted(function);

    system.solve(coefficients, &wanted, STEPS, terms);
    if unit_gradients && terms > 1 {
        for sample in coefficients.chunks_mut(terms) {
            let gradient = DVec3::new(sample[1], sample[2], sample[3]).normalize_or(DVec3::X);
            sample[1..4].copy_from_slice(&gradient.to_array());
        }
        system.solve(coefficients, &wanted, VALUE_STEPS, 1);
    }
    system.cells().element_product() as usize * system.points.len()
}

/// The normal equations of all cells, which have one matrix since they have one shape.
struct System<'a> {
    domain: &'a Domain,
    terms: usize,
    /// Places in a cell, 0 to 1.
    points: Vec<DVec3>,
    /// For each of them what the coefficients of the eight corners, x fastest, contribute there.
    weights: Vec<Vec<f64>>,
    /// Sums of products of weights over the points, row by row.
    matrix: Vec<Vec<f64>>,
}

impl<'a> System<'a> {
    fn new(domain: &'a Domain, grid: &GridSettings) -> Self {
        let terms = terms(grid.order);
        let contributions = contributions(grid);
        let powers = usize::from(grid.order) + 1;
        let at = |corner: usize, exponents: [u8; 3], point: DVec3| -> f64 {
            let along = |axis: usize| {
                let number = (corner >> axis & 1) * powers + usize::from(exponents[axis]);
                value(&contributions[number], point[axis])
            };
            along(0) * along(1) * along(2) * share(grid, exponents) * monomial(domain.spacing, exponents)
        };

        let place = |step: u32| (f64::from(step) + 0.5) / f64::from(POINTS);
        let points: Vec<DVec3> = (0..POINTS.pow(3))
            .map(|i| DVec3::new(place(i % POINTS), place(i / POINTS % POINTS), place(i / POINTS / POINTS)))
            .collect();
        let weights_at = |&point: &DVec3| -> Vec<f64> {
            (0..8 * terms).map(|number| at(number / terms, EXPONENTS[number % terms], point)).collect()
        };
        let weights: Vec<Vec<f64>> = points.iter().map(weights_at).collect();
        let entry = |i: usize, j: usize| weights.iter().map(|weights| weights[i] * weights[j]).sum();
        let matrix = (0..8 * terms).map(|i| (0..8 * terms).map(|j| entry(i, j)).collect()).collect();
        Self { domain, terms, points, weights, matrix }
    }

    fn cells(&self) -> UVec3 {
        self.domain.resolution - 1
    }

    /// The right-hand side: what the function's values at the points ask of each coefficient.
    fn wanted(&self, function: &dyn FieldFunction) -> Vec<f64> {
        self.sum_over_cells(|layer| {
            let places = layer.iter().flat_map(|cell| self.points.iter().map(move |point| cell.as_dvec3() + *point));
            let points: Vec<DVec3> = places.map(|place| self.domain.origin + place * self.domain.spacing).collect();
            let samples = function.sample_all(&points);
            let asked = samples.par_chunks(self.points.len()).map(|samples| {
                let by_point = |number: usize| {
                    self.weights.iter().zip(samples).map(move |(weights, sample)| weights[number] * sample.distance)
                };
                (0..8 * self.terms).map(|number| by_point(number).sum()).collect()
            });
            asked.collect()
        })
    }

    /// The matrix times coefficients.
    fn applied(&self, coefficients: &[f64]) -> Vec<f64> {
        self.sum_over_cells(|layer| {
            let products = layer.par_iter().map(|&cell| {
                let held: Vec<f64> =
                    (0..8).flat_map(|corner| &coefficients[self.range(cell, corner)]).copied().collect();
                self.matrix.iter().map(|row| dot(row, &held)).collect()
            });
            products.collect()
        })
    }

    /// Adds up what cells contribute to the coefficients of their corners, layer by layer and cell by cell, so that
    /// the sums do not depend on threads.
    fn sum_over_cells(&self, of_layer: impl Fn(&[UVec3]) -> Vec<Vec<f64>>) -> Vec<f64> {
        let UVec3 { x: nx, y: ny, z: nz } = self.cells();
        let mut sums = vec![0.0; self.domain.resolution.element_product() as usize * self.terms];
        for z in 0..nz {
            let layer: Vec<UVec3> = (0..ny).flat_map(|y| (0..nx).map(move |x| UVec3::new(x, y, z))).collect();
            for (&cell, contribution) in layer.iter().zip(of_layer(&layer)) {
                for (corner, of_corner) in contribution.chunks(self.terms).enumerate() {
                    for (sum, term) in sums[self.range(cell, corner)].iter_mut().zip(of_corner) {
                        *sum += term;
                    }
                }
            }
        }
        sums
    }

    /// Where the coefficients of a cell's corner are.
    fn range(&self, cell: UVec3, corner: usize) -> std::ops::Range<usize> {
        let corner = corner as u32;
        let start = self.domain.index(cell + UVec3::new(corner & 1, corner >> 1 & 1, corner >> 2)) * self.terms;
        start..start + self.terms
    }

    /// Steps of conjugate gradients that move the first `free` coefficients of each sample.
    fn solve(&self, coefficients: &mut [f64], wanted: &[f64], steps: usize, free: usize) {
        let is_free = |index: usize| index % self.terms < free;
        let masked = |index: usize, value: f64| if is_free(index) { value } else { 0.0 };
        let mut residual: Vec<f64> = self.applied(coefficients);
        for (index, residual) in residual.iter_mut().enumerate() {
            *residual = masked(index, wanted[index] - *residual);
        }
        let mut direction = residual.clone();
        let mut square = dot(&residual, &residual);

        for _ in 0..steps {
            let applied = self.applied(&direction);
            let curvature = dot(&direction, &applied);
            if curvature <= 0.0 || square <= 0.0 {
                return;
            }
            let step = square / curvature;
            for (index, residual) in residual.iter_mut().enumerate() {
                coefficients[index] += step * direction[index];
                *residual -= masked(index, step * applied[index]);
            }
            let next = dot(&residual, &residual);
            let ratio = next / square;
            square = next;
            for (direction, residual) in direction.iter_mut().zip(&residual) {
                *direction = residual + ratio * *direction;
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
