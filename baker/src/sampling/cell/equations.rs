//! What the samples of a cell ask of a polynomial: their values, and with a small weight their gradients.

use super::basis::TERMS;
use super::normal_equations::NormalEquations;
use super::samples::CellSamples;
use super::stencil::{GRADIENT_WEIGHT, POINTS, Stencil};

/// Which samples belong to the first of two sides.
pub(super) type Side = [bool; POINTS];

/// The equations of each sample and of all.
pub(super) struct Equations<'a> {
    stencil: &'a Stencil,
    /// Right-hand side of each sample.
    right: Vec<[f64; TERMS]>,
    /// Sums over all samples.
    pub(super) all: NormalEquations,
}

impl<'a> Equations<'a> {
    pub(super) fn new(cell: &CellSamples<'a>) -> Self {
        let stencil = cell.stencil;
        let right: Vec<[f64; TERMS]> = (0..POINTS)
            .map(|point| {
                let (terms, gradients) = (&stencil.terms[point], &stencil.gradients[point]);
                let (distance, slope) = (cell.samples[point].distance, GRADIENT_WEIGHT * cell.slope(point));
                std::array::from_fn(|term| terms[term] * distance + gradients[term].dot(slope))
            })
            .collect();
        let mut all = NormalEquations { products: stencil.all_products, right: [0.0; TERMS] };
        for right in &right {
            all.right.iter_mut().zip(right).for_each(|(sum, right)| *sum += right);
        }
        Self { stencil, right, all }
    }

    /// Sums over the samples of each side, for fits up to a degree.
    pub(super) fn both_sides(&self, degree: u8, side: &Side) -> [NormalEquations; 2] {
        let mut first = NormalEquations::ZERO;
        for point in (0..POINTS).filter(|&point| side[point]) {
            first.add(degree, &self.stencil.products[point], &self.right[point]);
        }
        let second = self.all.without(&first);
        [first, second]
    }
}
