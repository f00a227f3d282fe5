//! Polynomials through the samples of a cell, in the sense of least squares.

use super::basis::{MAX_DEGREE, TERMS};
use super::equations::Equations;
use super::kink;
use super::piece::{Kind, Piece};
use super::samples::CellSamples;
use crate::field_function::Sample;

/// A fit and how far it is from the samples.
#[derive(Clone, Copy, Debug)]
pub struct Fit {
    /// The polynomials.
    pub piece: Piece,
    /// How far they are.
    pub errors: Errors,
}

/// Differences between a fit and the samples of its cell.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Mean of the squares.
    pub mean_square: f64,
    /// Greatest magnitude.
    pub max: f64,
}

impl Errors {
    pub(super) fn of(values: impl Iterator<Item = f64>, samples: &[Sample]) -> Self {
        let (mut squares, mut max) = (0.0, 0.0f64);
        for (value, sample) in values.zip(samples) {
            let error = value - sample.distance;
            squares += error * error;
            max = max.max(error.abs());
        }
        Self { mean_square: squares / samples.len() as f64, max }
    }
}

impl CellSamples<'_> {
    /// The best polynomial of each degree, and the best pairs.
    pub fn fits(&self) -> Vec<Fit> {
        let equations = Equations::new(self);
        let mut fits: Vec<Fit> = (0..=MAX_DEGREE)
            .map(|degree| {
                let coefficients = [equations.all.solve(degree), [0.0; TERMS]];
                let piece = Piece { kind: Kind::Single, degrees: [degree, 0], coefficients };
                Fit { piece, errors: self.errors(&piece) }
            })
            .collect();
        fits.extend(kink::fits(self, &equations));
        fits
    }
}

#[cfg(test)]
mod tests {
    use super::super::stencil::Stencil;
    use super::*;
    use glam::DVec3;

    const CENTRE: DVec3 = DVec3::new(3.0, -1.0, 0.5);
    const EDGE: f64 = 0.25;

    /// Fits of a function of the coordinates of the cube.
    fn fits(function: impl Fn(DVec3) -> Sample) -> Vec<Fit> {
        let stencil = Stencil::default();
        let local = |point: DVec3| (point - CENTRE) / (0.5 * EDGE);
        let in_mesh_units = |sample: Sample| Sample { gradient: sample.gradient / (0.5 * EDGE), ..sample };
        let samples: Vec<Sample> =
            stencil.points_of(CENTRE, EDGE).map(|point| in_mesh_units(function(local(point)))).collect();
        CellSamples { stencil: &stencil, samples: &samples, edge: EDGE }.fits()
    }

    fn polynomial(coefficients: [f64; TERMS]) -> impl Fn(DVec3) -> Sample {
        move |point| {
            let piece = Piece { kind: Kind::Single, degrees: [3, 0], coefficients: [coefficients, [0.0; TERMS]] };
            let (distance, gradient) = piece.evaluate(point);
            Sample { distance, gradient }
        }
    }

    #[test]
    fn a_polynomial_is_found_again() {
        let wanted: [f64; TERMS] = std::array::from_fn(|term| 0.1 * (term * term % 7) as f64 - 0.2);
        let fits = fits(polynomial(wanted));
        let cubic = &fits[usize::from(MAX_DEGREE)];
        assert!(cubic.errors.max < 1e-6, "{:?}", cubic.errors);
        for (found, wanted) in cubic.piece.coefficients[0].iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-6, "{found} instead of {wanted}");
        }
    }

    #[test]
    fn a_crease_is_found_where_few_samples_are_on_one_side() {
        let plane = |at: f64, x: f64, y: f64| std::array::from_fn(|term| [at, x, y].get(term).copied().unwrap_or(0.0));
        let (first, second) = (polynomial(plane(0.0, 0.6, 0.8)), polynomial(plane(1.0, -0.8, 0.6)));
        let lesser = |point: DVec3| {
            let (a, b) = (first(point), second(point));
            if a.distance <= b.distance { a } else { b }
        };
        let stencil = Stencil::default();
        let beyond = stencil.points_of(DVec3::ZERO, 2.0).filter(|&p| second(p).distance < first(p).distance).count();
        assert!((5..15).contains(&beyond), "{beyond} samples");
        let fits = fits(lesser);
        let pair = fits.iter().find(|fit| fit.piece.degrees == [1, 1]).expect("a pair of planes");
        assert!(pair.errors.max < 1e-5, "{:?}", pair.errors);
        assert!(fits[usize::from(MAX_DEGREE)].errors.max > 0.01, "no cubic has a crease");
    }
}
