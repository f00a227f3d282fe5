//! The points of a cell at which the function is sampled, and what fits need to know of them.

use super::basis::{self, TERMS};
use super::normal_equations::{NormalEquations, PAIRS};
use crate::field_function::Sample;
use glam::DVec3;

/// Points along each axis.
const PER_AXIS: usize = 5;
/// Where they are. Middles of equal parts (0.8 and 0.4) see less of what happens near the faces, where the error is
/// greatest: at equal root mean square error they leave twice the greatest one.
const NODES: [f64; PER_AXIS] = [-OUTERMOST, -0.45, 0.0, 0.45, OUTERMOST];
/// The outermost.
pub const OUTERMOST: f64 = 0.9;
/// Distance between neighbours.
pub(super) const SPACING: f64 = 0.45;
/// Points of a cell.
pub const POINTS: usize = PER_AXIS * PER_AXIS * PER_AXIS;

/// The same for every cell.
pub struct Stencil {
    /// The points in the cube [-1, 1]³.
    points: [DVec3; POINTS],
    /// Every term at every point.
    terms: Vec<[f64; TERMS]>,
    /// The gradient of every term at every point.
    gradients: Vec<[DVec3; TERMS]>,
    /// Products of all pairs of terms at every point.
    products: Vec<[f64; PAIRS]>,
    /// Sum of the products over all points.
    all_products: [f64; PAIRS],
}

impl Default for Stencil {
    /// Tabulates the basis.
    fn default() -> Self {
        let points: [DVec3; POINTS] = std::array::from_fn(|i| {
            DVec3::new(NODES[i % PER_AXIS], NODES[i / PER_AXIS % PER_AXIS], NODES[i / PER_AXIS / PER_AXIS])
        });
        let terms: Vec<[f64; TERMS]> = points.iter().map(|&point| basis::values(point)).collect();
        let products: Vec<[f64; PAIRS]> = terms
            .iter()
            .map(|terms| {
                let mut pairs = (0..TERMS).flat_map(|i| (0..=i).map(move |j| terms[i] * terms[j]));
                std::array::from_fn(|_| pairs.next().expect("as many pairs"))
            })
            .collect();
        let gradients = points.iter().map(|&point| basis::gradients(point)).collect();
        let mut all_products = [0.0; PAIRS];
        for products in &products {
            all_products.iter_mut().zip(products).for_each(|(sum, product)| *sum += product);
        }
        Self { points, terms, gradients, products, all_products }
    }
}

impl Stencil {
    /// The points of a cell, mesh units.
    pub fn points_of(&self, centre: DVec3, edge: f64) -> impl Iterator<Item = DVec3> {
        self.points.iter().map(move |&point| centre + 0.5 * edge * point)
    }

    /// The values of a polynomial at the points.
    pub(super) fn values(&self, coefficients: &[f64; TERMS], terms: usize) -> [f64; POINTS] {
        std::array::from_fn(|point| {
            let (terms_here, coefficients) = (&self.terms[point][..terms], &coefficients[..terms]);
            terms_here.iter().zip(coefficients).map(|(term, coefficient)| term * coefficient).sum()
        })
    }

    /// The gradient of a polynomial at a point, by the coordinates of the cube.
    pub(super) fn gradient(&self, point: usize, coefficients: &[f64; TERMS], terms: usize) -> DVec3 {
        let gradients = self.gradients[point][..terms].iter().zip(&coefficients[..terms]);
        gradients.map(|(gradient, &coefficient)| *gradient * coefficient).sum()
    }

    /// The equations of all samples.
    pub(super) fn all(&self, samples: &[Sample]) -> NormalEquations {
        let mut right = [0.0; TERMS];
        for (terms, sample) in self.terms.iter().zip(samples) {
            right.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term * sample.distance);
        }
        NormalEquations { products: self.all_products, right }
    }

    /// The equations of the samples of one side.
    pub(super) fn side(&self, samples: &[Sample], degree: u8, side: &[bool; POINTS]) -> NormalEquations {
        let mut equations = NormalEquations::ZERO;
        for point in (0..POINTS).filter(|&point| side[point]) {
            equations.add(degree, &self.products[point], &self.terms[point], samples[point].distance);
        }
        equations
    }
}

/// Whether the function jumps between neighbouring samples of a cell with this edge: whether it changes by more than any slope
/// that was found explains.
pub fn jumps(samples: &[Sample], edge: f64) -> bool {
    /// Slopes between samples may be a little greater than at them.
    const SLACK: f64 = 1.5;
    let steepest = samples.iter().map(|sample| sample.gradient.length()).fold(0.0, f64::max);
    let most = SLACK * steepest * 0.5 * edge * SPACING;
    (0..POINTS).any(|point| {
        [1, PER_AXIS, PER_AXIS * PER_AXIS].into_iter().any(|step| {
            let is_inside = point / step % PER_AXIS + 1 < PER_AXIS;
            is_inside && (samples[point + step].distance - samples[point].distance).abs() > most
        })
    })
}
