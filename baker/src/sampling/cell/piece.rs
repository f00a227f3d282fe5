//! What a leaf answers: one polynomial, or the lesser or greater of two.

use super::basis::{self, TERMS, TERMS_UP_TO};
use glam::DVec3;

/// How the polynomials of a leaf make its answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// There is only one.
    Single,
    /// The lesser of two, as on the medial axis outside of a shape.
    Min,
    /// The greater of two, as on the medial axis inside.
    Max,
}

impl Kind {
    /// How many polynomials there are.
    pub fn polynomials(self) -> usize {
        if self == Self::Single { 1 } else { 2 }
    }

    /// Whether the first of two values is the answer.
    pub fn takes_first(self, first: f64, second: f64) -> bool {
        match self {
            Self::Single => true,
            Self::Min => first <= second,
            Self::Max => first >= second,
        }
    }
}

/// One polynomial or two over the cube [-1, 1]³ of a leaf, mesh units.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// How they make the answer.
    pub kind: Kind,
    /// Total degree of each; 0 for a second one that is not there.
    pub degrees: [u8; 2],
    /// Coefficients of each in the Legendre basis; zero beyond the degree.
    pub coefficients: [[f64; TERMS]; 2],
}

impl Piece {
    /// Coefficients that are stored.
    pub fn terms(&self) -> usize {
        (0..self.kind.polynomials()).map(|i| TERMS_UP_TO[usize::from(self.degrees[i])]).sum()
    }

    /// Value and gradient by the coordinates of the cube, anywhere in and around it.
    pub fn evaluate(&self, point: DVec3) -> (f64, DVec3) {
        let (terms, gradients) = (basis::values(point), basis::gradients(point));
        let value = |i: usize| -> f64 { terms.iter().zip(&self.coefficients[i]).map(|(term, c)| term * c).sum() };
        let (first, second) = (value(0), value(1));
        let (chosen, value) = if self.kind.takes_first(first, second) { (0, first) } else { (1, second) };
        let gradient = gradients.iter().zip(&self.coefficients[chosen]).map(|(gradient, &c)| *gradient * c).sum();
        (value, gradient)
    }
}
