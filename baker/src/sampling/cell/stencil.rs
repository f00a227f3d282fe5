//! The points of a cell at which the function is sampled, and what fits need to know of them.

use super::basis::{self, TERMS};
use super::normal_equations::{NormalEquations, PAIRS};
use crate::field_function::Sample;
use glam::DVec3;

/// Points along each axis, in the middles of equal parts: they see the whole cell and weigh alike.
const PER_AXIS: usize = 5;
/// Points of a cell.
pub const POINTS: usize = PER_AXIS * PER_AXIS * PER_AXIS;

/// The same for every cell.
pub struct Stencil {
    /// The points in the cube [-1, 1]³.
    points: [DVec3; POINTS],
    /// Every term at every point.
    terms: Vec<[f64; TERMS]>,
    /// Products of all pairs of terms at every point.
    products: Vec<[f64; PAIRS]>,
    /// Sum of the products over all points.
    all_products: [f64; PAIRS],
    pub weights: Vec<f64>,
}

impl Stencil {
    /// Tabulates the basis.
    pub fn new() -> Self {
        let kind = std::env::var("NF_STENCIL").unwrap_or_default();
        let (nodes, axis_weights): ([f64; PER_AXIS], [f64; PER_AXIS]) = match kind.as_str() {
            "gauss" => ([-0.9061798459, -0.5384693101, 0.0, 0.5384693101, 0.9061798459], [0.2369268851, 0.4786286705, 0.5688888889, 0.4786286705, 0.2369268851]),
            "lobatto" => ([-1.0, -0.6546536707, 0.0, 0.6546536707, 1.0], [0.1, 0.5444444, 0.7111111, 0.5444444, 0.1]),
            "trap" => ([-1.0, -0.5, 0.0, 0.5, 1.0], [0.25, 0.5, 0.5, 0.5, 0.25]),
            "stretch" => ([-0.9, -0.45, 0.0, 0.45, 0.9], [0.4; 5]),
            "gausseq" => ([-0.9061798459, -0.5384693101, 0.0, 0.5384693101, 0.9061798459], [0.4; 5]),
            _ => ([-0.8, -0.4, 0.0, 0.4, 0.8], [0.4; 5]),
        };
        let sumw: f64 = axis_weights.iter().sum();
        let place = |index: usize| nodes[index];
        let weights: Vec<f64> = (0..POINTS).map(|i| axis_weights[i % 5] * axis_weights[i / 5 % 5] * axis_weights[i / 25] / sumw.powi(3)).collect();
        let points: [DVec3; POINTS] = std::array::from_fn(|i| {
            DVec3::new(place(i % PER_AXIS), place(i / PER_AXIS % PER_AXIS), place(i / PER_AXIS / PER_AXIS))
        });
        let terms: Vec<[f64; TERMS]> = points.iter().map(|&point| basis::values(point)).collect();
        let products: Vec<[f64; PAIRS]> = terms
            .iter()
            .zip(&weights).map(|(terms, weight)| {
                let mut pairs = (0..TERMS).flat_map(|i| (0..=i).map(move |j| weight * terms[i] * terms[j]));
                std::array::from_fn(|_| pairs.next().expect("as many pairs"))
            })
            .collect();
        let mut all_products = [0.0; PAIRS];
        for products in &products {
            all_products.iter_mut().zip(products).for_each(|(sum, product)| *sum += product);
        }
        Self { points, terms, products, all_products, weights }
    }

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

    /// The equations of all samples.
    pub(super) fn all(&self, samples: &[Sample]) -> NormalEquations {
        let mut right = [0.0; TERMS];
        for (terms, sample) in self.terms.iter().zip(samples).zip(&self.weights).map(|((t, s), w)| (t, s, w)) .map(|(t, s, w)| (t, s.distance * w)) {
            right.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term * sample);
        }
        NormalEquations { products: self.all_products, right }
    }

    /// The equations of the samples of one side.
    pub(super) fn side(&self, samples: &[Sample], degree: u8, side: &[bool; POINTS]) -> NormalEquations {
        let mut equations = NormalEquations::ZERO;
        for point in (0..POINTS).filter(|&point| side[point]) {
            equations.add(degree, &self.products[point], &self.terms[point], self.weights[point] * samples[point].distance);
        }
        equations
    }
}
