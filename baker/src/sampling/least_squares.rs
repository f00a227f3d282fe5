//! Least-squares polynomials over a fine grid around each point (Bán and Valasek 2020, section 4).

use super::{EXPONENTS, monomial, terms};
use crate::field_function::FieldFunction;
use crate::settings::FineGrid;
use glam::DVec3;
use rayon::prelude::*;

/// The fit of a fine grid around the origin; around any other point it is the same.
pub(super) struct LeastSquares {
    /// Fine samples from the point, mesh units.
    offsets: Vec<DVec3>,
    /// The pseudoinverse, a row for each coefficient.
    rows: Vec<Vec<f64>>,
}

impl LeastSquares {
    /// Computes the pseudoinverse. The fine grid has more samples along each axis than the order, so its
    /// columns are independent: on a lattice of n points an axis, so are all powers below n.
    pub(super) fn new(order: u8, fine: &FineGrid, spacing: DVec3) -> Self {
        // The fine grid within [-1, 1]³, where all powers are of one size.
        let count = u32::from(fine.count);
        let place = |index: u32| 2.0 * f64::from(index) / f64::from(count - 1) - 1.0;
        let places: Vec<DVec3> = (0..count.pow(3))
            .map(|index| DVec3::new(place(index % count), place(index / count % count), place(index / count / count)))
            .collect();
        let weights: Vec<f64> =
            places.iter().map(|place| 1.0 / (1.0 + fine.falloff * place.length_squared())).collect();
        let terms = terms(order);
        let columns: Vec<Vec<f64>> = places
            .iter()
            .map(|&place| EXPONENTS[..terms].iter().map(|&exponents| monomial(place, exponents)).collect())
            .collect();

        // The normal equations.
        let mut normal = vec![vec![0.0; terms]; terms];
        for (column, weight) in columns.iter().zip(&weights) {
            for i in 0..terms {
                for j in 0..terms {
                    normal[i][j] += weight * column[i] * column[j];
                }
            }
        }
        let factor = cholesky(normal);

        // Each fine sample's share of the coefficients, and back to mesh units.
        let extent = fine.extent * spacing;
        let mut rows = vec![Vec::with_capacity(places.len()); terms];
        for (column, weight) in columns.iter().zip(&weights) {
            let weighted = column.iter().map(|value| weight * value).collect();
            for (term, share) in solve(&factor, weighted).into_iter().enumerate() {
                rows[term].push(share / monomial(extent, EXPONENTS[term]));
            }
        }
        Self { offsets: places.into_iter().map(|place| place * extent).collect(), rows }
    }

    /// How often the function is sampled for a point.
    pub(super) fn samples_per_point(&self) -> usize {
        self.offsets.len()
    }

    /// Appends the coefficients of each point.
    pub(super) fn append(
        &self,
        function: &dyn FieldFunction,
        points: &[DVec3],
        normalized: bool,
        coefficients: &mut Vec<f64>,
    ) {
        let fine: Vec<DVec3> =
            points.iter().flat_map(|&point| self.offsets.iter().map(move |&offset| point + offset)).collect();
        let samples = function.sample_all(&fine);
        let fits: Vec<Vec<f64>> = samples
            .par_chunks(self.offsets.len())
            .map(|samples| {
                let fit = |row: &Vec<f64>| row.iter().zip(samples).map(|(share, sample)| share * sample.distance).sum();
                let mut fit: Vec<f64> = self.rows.iter().map(fit).collect();
                if normalized {
                    let unit = DVec3::new(fit[1], fit[2], fit[3]).normalize_or_zero();
                    fit[1..].copy_from_slice(&unit.to_array());
                }
                fit
            })
            .collect();
        coefficients.extend(fits.into_iter().flatten());
    }
}

/// The lower triangular L of L Lᵀ = `matrix`, which is symmetric and positive definite.
fn cholesky(mut matrix: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    for i in 0..matrix.len() {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - sum;
            matrix[i][j] = if i == j { rest.sqrt() } else { rest / matrix[j][j] };
        }
    }
    matrix
}

/// The x of L Lᵀ x = `right`.
fn solve(factor: &[Vec<f64>], mut right: Vec<f64>) -> Vec<f64> {
    let size = right.len();
    for i in 0..size {
        let sum: f64 = (0..i).map(|k| factor[i][k] * right[k]).sum();
        right[i] = (right[i] - sum) / factor[i][i];
    }
    for i in (0..size).rev() {
        let sum: f64 = (i + 1..size).map(|k| factor[k][i] * right[k]).sum();
        right[i] = (right[i] - sum) / factor[i][i];
    }
    right
}
