//! The samples of a cell, and how far polynomials are from them.

use super::basis::TERMS_UP_TO;
use super::fit::Errors;
use super::piece::{Kind, Piece};
use super::stencil::{POINTS, SPACING, Stencil};
use crate::field_function::Sample;
use glam::DVec3;

/// A function as it is seen in one cell.
#[derive(Clone, Copy)]
pub struct CellSamples<'a> {
    /// Where it was sampled.
    pub stencil: &'a Stencil,
    /// The samples, one for each point.
    pub samples: &'a [Sample],
    /// Edge of the cell, mesh units.
    pub edge: f64,
}

impl CellSamples<'_> {
    /// The gradient at a point by the coordinates of the cube.
    pub(super) fn slope(&self, point: usize) -> DVec3 {
        0.5 * self.edge * self.samples[point].gradient
    }

    /// The errors of a piece.
    pub fn errors(&self, piece: &Piece) -> Errors {
        let terms = |i: usize| TERMS_UP_TO[usize::from(piece.degrees[i])];
        let first = self.stencil.values(&piece.coefficients[0], terms(0));
        if piece.kind == Kind::Single {
            return Errors::of(first.into_iter(), self.samples);
        }
        let second = self.stencil.values(&piece.coefficients[1], terms(1));
        let chosen = first.into_iter().zip(second).map(|(a, b)| if piece.kind.takes_first(a, b) { a } else { b });
        Errors::of(chosen, self.samples)
    }

    /// How far a piece may be from the function between its samples, by its slopes at them, mesh units: half the way to
    /// the next sample times the difference of the gradients. Where two polynomials meet, the better counts.
    ///
    /// This sees polynomials that swing between samples, and nothing else.
    pub fn doubt(&self, piece: &Piece) -> f64 {
        let squared = (0..POINTS).map(|point| {
            let wanted = self.slope(point);
            let of = |i: usize| {
                let terms = TERMS_UP_TO[usize::from(piece.degrees[i])];
                self.stencil.gradient(point, &piece.coefficients[i], terms).distance_squared(wanted)
            };
            (0..piece.kind.polynomials()).map(of).fold(f64::INFINITY, f64::min)
        });
        0.5 * SPACING * squared.fold(0.0, f64::max).sqrt()
    }

    /// Whether the function jumps between neighbouring samples: whether it changes by more than any slope that was found
    /// explains.
    pub fn jumps(&self) -> bool {
        /// Slopes between samples may be a little greater than at them.
        const SLACK: f64 = 1.1;
        let steepest = self.samples.iter().map(|sample| sample.gradient.length()).fold(0.0, f64::max);
        let most = SLACK * steepest * 0.5 * self.edge * SPACING;
        let change = |&[a, b]: &[usize; 2]| (self.samples[a].distance - self.samples[b].distance).abs();
        self.stencil.neighbours.iter().any(|pair| change(pair) > most)
    }
}
