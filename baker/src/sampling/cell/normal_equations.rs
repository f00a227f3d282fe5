//! Least squares by the normal equations of a few terms.

use super::basis::{MEAN_SQUARE, TERMS, TERMS_UP_TO};
use super::stencil::POINTS;

/// Products of two terms, those of the first i terms before those of term i.
pub(super) const PAIRS: usize = TERMS * (TERMS + 1) / 2;

/// What is added to each diagonal entry, as a share of what all samples of a cell would add: only keeps sets of
/// samples that do not decide a coefficient solvable. More of it costs bytes (1e-4: 10 %).
const RIDGE: f64 = 1e-7;

/// Sums over samples from which fits of any degree follow. Differences of sums are sums of differences.
#[derive(Clone)]
pub(super) struct NormalEquations {
    /// Sum of the products of terms and of their gradients, lower triangle by rows.
    pub(super) products: [f64; PAIRS],
    /// Sum of each term times the sample, and of its gradient times the sample's.
    pub(super) right: [f64; TERMS],
}

impl NormalEquations {
    pub(super) const ZERO: Self = Self { products: [0.0; PAIRS], right: [0.0; TERMS] };

    /// Adds a sample.
    pub(super) fn add(&mut self, degree: u8, products: &[f64; PAIRS], right: &[f64; TERMS]) {
        let terms = TERMS_UP_TO[usize::from(degree)];
        let pairs = terms * (terms + 1) / 2;
        self.products[..pairs].iter_mut().zip(products).for_each(|(sum, product)| *sum += product);
        self.right[..terms].iter_mut().zip(right).for_each(|(sum, right)| *sum += right);
    }

    /// What is left of a larger set without these samples.
    pub(super) fn without(&self, part: &Self) -> Self {
        let mut rest = self.clone();
        for (rest, part) in rest.products.iter_mut().zip(&part.products) {
            *rest -= part;
        }
        for (rest, part) in rest.right.iter_mut().zip(&part.right) {
            *rest -= part;
        }
        rest
    }

    /// The coefficients of the best polynomial of a degree, the others zero.
    pub(super) fn solve(&self, degree: u8) -> [f64; TERMS] {
        let size = TERMS_UP_TO[usize::from(degree)];

        // The lower triangular L of L Lᵀ = products.
        let mut factor = [[0.0; TERMS]; TERMS];
        for i in 0..size {
            let row = i * (i + 1) / 2;
            for j in 0..=i {
                let known: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
                let rest = self.products[row + j] - known;
                factor[i][j] = if i == j {
                    (rest + RIDGE * POINTS as f64 * MEAN_SQUARE[i]).max(f64::MIN_POSITIVE).sqrt()
                } else {
                    rest / factor[j][j]
                };
            }
        }

        // L y = right, Lᵀ x = y.
        let mut x = [0.0; TERMS];
        for i in 0..size {
            let known: f64 = (0..i).map(|k| factor[i][k] * x[k]).sum();
            x[i] = (self.right[i] - known) / factor[i][i];
        }
        for i in (0..size).rev() {
            let known: f64 = (i + 1..size).map(|k| factor[k][i] * x[k]).sum();
            x[i] = (x[i] - known) / factor[i][i];
        }
        x
    }
}
