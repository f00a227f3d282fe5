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
