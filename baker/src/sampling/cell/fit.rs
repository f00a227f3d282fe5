//! Polynomials through the samples of a cell, in the sense of least squares.

use super::basis::{MAX_DEGREE, TERMS, TERMS_UP_TO};
use super::kink;
use super::piece::{Kind, Piece};
use super::stencil::{SPACING, Stencil};
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

/// The errors of a piece at the samples of its cell.
pub fn errors(stencil: &Stencil, piece: &Piece, samples: &[Sample]) -> Errors {
    let terms = |i: usize| TERMS_UP_TO[usize::from(piece.degrees[i])];
    let first = stencil.values(&piece.coefficients[0], terms(0));
    if piece.kind == Kind::Single {
        return Errors::of(first.into_iter(), samples);
    }
    let second = stencil.values(&piece.coefficients[1], terms(1));
    let chosen = first.into_iter().zip(second).map(|(a, b)| if piece.kind.takes_first(a, b) { a } else { b });
    Errors::of(chosen, samples)
}

/// How far a piece may be from the function between its samples, by its slopes at them, mesh units: half the way to
/// the next sample times the difference of the gradients. Where two polynomials meet, the better counts.
///
/// This sees polynomials that swing between samples, and nothing else.
pub fn doubt(stencil: &Stencil, piece: &Piece, samples: &[Sample], edge: f64) -> f64 {
    let squared = samples.iter().enumerate().map(|(point, sample)| {
        let wanted = 0.5 * edge * sample.gradient;
        let of = |i: usize| {
            let terms = TERMS_UP_TO[usize::from(piece.degrees[i])];
            stencil.gradient(point, &piece.coefficients[i], terms).distance_squared(wanted)
        };
        (0..piece.kind.polynomials()).map(of).fold(f64::INFINITY, f64::min)
    });
    0.5 * SPACING * squared.fold(0.0, f64::max).sqrt()
}

/// The best polynomial of each degree, and the best pairs.
pub fn fits(stencil: &Stencil, samples: &[Sample]) -> Vec<Fit> {
    let equations = stencil.all(samples);
    let mut fits: Vec<Fit> = (0..=MAX_DEGREE)
        .map(|degree| {
            let coefficients = [equations.solve(degree), [0.0; TERMS]];
            let piece = Piece { kind: Kind::Single, degrees: [degree, 0], coefficients };
            Fit { piece, errors: errors(stencil, &piece, samples) }
        })
        .collect();
    fits.extend(kink::fits(stencil, samples, &equations));
    fits
}
