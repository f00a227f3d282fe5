//! A field function to polynomials around points: the samples of a grid.

pub mod cell;
mod least_squares;

use crate::field_function::{FieldFunction, Sample};
use crate::settings::Sampling;
use glam::DVec3;
use least_squares::LeastSquares;

/// Exponents of x, y and z in each term of a polynomial, in the order of the file format: by total
/// degree, 1, 3, 6 and 10 of them.
pub const EXPONENTS: [[u8; 3]; 20] = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [2, 0, 0],
    [0, 2, 0],
    [0, 0, 2],
    [1, 1, 0],
    [1, 0, 1],
    [0, 1, 1],
    [3, 0, 0],
    [0, 3, 0],
    [0, 0, 3],
    [2, 1, 0],
    [2, 0, 1],
    [1, 2, 0],
    [1, 0, 2],
    [0, 2, 1],
    [0, 1, 2],
    [1, 1, 1],
];

/// Points whose fine grids are sampled at once: enough for all threads, few enough for memory.
const BATCH: usize = 1 << 13;

/// Terms of a polynomial of this total degree.
pub fn terms(order: u8) -> usize {
    [1, 4, 10, 20][usize::from(order)]
}

/// A term without its coefficient: x^a y^b z^c.
pub fn monomial(offset: DVec3, exponents: [u8; 3]) -> f64 {
    let power = |base: f64, exponent: u8| (0..exponent).fold(1.0, |power, _| power * base);
    power(offset.x, exponents[0]) * power(offset.y, exponents[1]) * power(offset.z, exponents[2])
}

/// Polynomials of order `order` around points: the coefficients of [`EXPONENTS`] for each point in turn,
/// by offsets in mesh units; and how often the function was sampled.
///
/// What is to be fitted starts from the exact derivatives. `spacing` is the distance of grid samples along each axis. Where a first-order fit is to be
/// normalized, its gradient becomes a unit vector and its value stays: dividing both, as Algorithm 1 of
/// Bán and Valasek 2020 does, moves the value where the gradient is short, at the cut locus.
pub fn polynomials(
    function: &dyn FieldFunction,
    points: &[DVec3],
    order: u8,
    sampling: Sampling,
    spacing: DVec3,
) -> (Vec<f64>, usize) {
    match sampling {
        Sampling::Taylor | Sampling::Fitted => {
            let samples = function.sample_all(points);
            let terms = terms(order.min(1));
            let coefficients = samples
                .into_iter()
                .flat_map(|Sample { distance, gradient: g }| [distance, g.x, g.y, g.z].into_iter().take(terms));
            (coefficients.collect(), points.len())
        }
        Sampling::LeastSquares(fine) => {
            let fit = LeastSquares::new(order, &fine, spacing);
            let mut coefficients = Vec::with_capacity(points.len() * terms(order));
            for batch in points.chunks(BATCH) {
                fit.append(function, batch, fine.normalized && order == 1, &mut coefficients);
            }
            (coefficients, points.len() * fit.samples_per_point())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::FineGrid;

    struct Cubic;

    impl FieldFunction for Cubic {
        fn sample(&self, point: DVec3) -> Sample {
            let distance = (0..20).map(|term| coefficient(term) * monomial(point, EXPONENTS[term])).sum();
            Sample { distance, gradient: DVec3::X }
        }
    }

    fn coefficient(term: usize) -> f64 {
        0.3 * term as f64 - 2.0 + 0.1 * (term * term % 7) as f64
    }

    #[test]
    fn a_fit_of_order_three_is_exact_on_cubics() {
        for (count, falloff) in [(4, 0.0), (5, 0.0), (5, 2.0), (8, 0.5)] {
            let fine = FineGrid { count, extent: 0.4, falloff, normalized: false };
            let spacing = DVec3::new(0.5, 0.25, 1.0);
            let (found, samples) = polynomials(&Cubic, &[DVec3::ZERO], 3, Sampling::LeastSquares(fine), spacing);
            assert_eq!(samples, usize::from(count).pow(3));
            for (term, found) in found.into_iter().enumerate() {
                assert!((found - coefficient(term)).abs() < 1e-8, "{count} {term}: {found} {}", coefficient(term));
            }
        }
    }

    #[test]
    fn a_fit_of_order_one_is_the_mean_and_may_be_normalized() {
        let linear = |normalized| {
            let fine = FineGrid { normalized, ..FineGrid::default() };
            polynomials(&Plane, &[DVec3::new(3.0, 4.0, 5.0)], 1, Sampling::LeastSquares(fine), DVec3::ONE).0
        };
        assert!(linear(false).iter().zip([50.0, 3.0, 4.0, 5.0]).all(|(a, b): (&f64, f64)| (a - b).abs() < 1e-11));
        let unit = linear(true);
        assert!((unit[0] - 50.0).abs() < 1e-11, "the value stays");
        assert!((DVec3::new(unit[1], unit[2], unit[3]).length() - 1.0).abs() < 1e-12);
    }

    struct Plane;

    impl FieldFunction for Plane {
        fn sample(&self, point: DVec3) -> Sample {
            Sample { distance: point.dot(DVec3::new(3.0, 4.0, 5.0)), gradient: DVec3::X }
        }
    }
}
