//! Coefficients of a leaf to whole steps, and the bits that these take.

use crate::sampling::cell::basis::{MEAN_SQUARE, TERMS, TERMS_UP_TO, degree_of};
use crate::sampling::cell::{Kind, Piece};
use nearfield::layout::shape::{MAX_COEFFICIENT_BITS, MAX_CONSTANT_BITS, MAX_EXPONENT};

/// A leaf as the file can hold it.
#[derive(Clone, Debug)]
pub struct Coded {
    /// How the polynomials make the answer.
    pub kind: Kind,
    /// Total degree of each.
    pub degrees: [u8; 2],
    /// The step of the constant is the quantum times two to this power.
    pub exponent: u8,
    /// Coefficients in steps; zero beyond the degree.
    pub codes: [[i32; TERMS]; 2],
    /// Bits that the codes of each degree need, as offset binary numbers.
    pub widths: [u8; 4],
}

impl Coded {
    /// The coefficients that are stored, with the degrees of their terms.
    pub fn stored(&self) -> impl Iterator<Item = (u8, i32)> {
        (0..self.kind.polynomials()).flat_map(move |i| {
            let terms = TERMS_UP_TO[usize::from(self.degrees[i])];
            (0..terms).map(move |term| (degree_of(term), self.codes[i][term]))
        })
    }

    /// Bits of all coefficients, if those of each degree take so many.
    pub fn bits(&self, widths: &[u8; 4]) -> u32 {
        self.stored().map(|(degree, _)| u32::from(widths[usize::from(degree)])).sum()
    }
}

/// The steps of a file.
#[derive(Clone, Copy, Debug)]
pub struct Steps {
    quantum: f32,
}

impl Steps {
    /// Steps that are whole powers of two of a quantum, the finest step of all, mesh units.
    pub fn new(quantum: f32) -> Self {
        Self { quantum }
    }

    /// The finest step, as the file states it.
    pub fn quantum(&self) -> f32 {
        self.quantum
    }

    /// One step for all degrees. Steps that grow as the terms' mean squares shrink were tried: a power of two a
    /// degree saved 1.5 % of the bytes.
    fn step(&self, exponent: u8) -> f64 {
        f64::from(self.quantum) * f64::from(1u32 << exponent)
    }

    /// Mean square error over the leaf that rounding to steps of this exponent is expected to make.
    pub fn noise(&self, piece: &Piece, exponent: u8) -> f64 {
        let polynomials = piece.kind.polynomials();
        let of = |i: usize| -> f64 { MEAN_SQUARE[..TERMS_UP_TO[usize::from(piece.degrees[i])]].iter().sum() };
        let step = self.step(exponent);
        step * step / 12.0 * (0..polynomials).map(of).sum::<f64>() / polynomials as f64
    }

    /// The greatest exponent for which the noise is at most this much; none if there is none.
    pub fn coarsest(&self, piece: &Piece, noise: f64) -> Option<u8> {
        let finest = self.noise(piece, 0);
        (0..=MAX_EXPONENT).take_while(|&exponent| finest * 4f64.powi(i32::from(exponent)) <= noise).last()
    }

    /// Rounds a piece; none if a coefficient takes more bits than the format has.
    pub fn code(&self, piece: &Piece, exponent: u8) -> Option<Coded> {
        let mut coded =
            Coded { kind: piece.kind, degrees: piece.degrees, exponent, codes: [[0; TERMS]; 2], widths: [0; 4] };
        for i in 0..piece.kind.polynomials() {
            for term in 0..TERMS_UP_TO[usize::from(piece.degrees[i])] {
                let degree = degree_of(term);
                let code = (piece.coefficients[i][term] / self.step(exponent)).round();
                let limit = if degree == 0 { MAX_CONSTANT_BITS } else { MAX_COEFFICIENT_BITS };
                if code.abs() >= f64::from(1u32 << (limit - 1)) {
                    return None;
                }
                coded.codes[i][term] = code as i32;
                let width = &mut coded.widths[usize::from(degree)];
                *width = (*width).max(bits_of(code as i32));
            }
        }
        Some(coded)
    }

    /// The piece that a reader will see.
    pub fn decode(&self, coded: &Coded) -> Piece {
        let coefficients = coded.codes.map(|codes| codes.map(|code| f64::from(code) * self.step(coded.exponent)));
        Piece { kind: coded.kind, degrees: coded.degrees, coefficients }
    }
}

/// Bits of an offset binary number w bits wide, -2^(w-1) to 2^(w-1) - 1; none for zero.
fn bits_of(code: i32) -> u8 {
    match code {
        0 => 0,
        code if code > 0 => (33 - code.leading_zeros()) as u8,
        code => (33 - (!code).leading_zeros()) as u8,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_hold_their_codes() {
        for (code, bits) in [(0, 0), (-1, 1), (1, 2), (-2, 2), (-3, 3), (3, 3), (4, 4), (-4, 3), (127, 8), (-128, 8)] {
            assert_eq!(bits_of(code), bits, "{code}");
        }
    }

    #[test]
    fn a_decoded_piece_is_within_half_a_step() {
        let steps = Steps::new(0.25);
        let coefficients = [std::array::from_fn(|term| 3.0 * (term as f64 - 7.3)), [0.0; TERMS]];
        let piece = Piece { kind: Kind::Single, degrees: [3, 0], coefficients };
        let coded = steps.code(&piece, 1).expect("it fits");
        let decoded = steps.decode(&coded);
        for term in 0..TERMS {
            let error = (decoded.coefficients[0][term] - piece.coefficients[0][term]).abs();
            assert!(error <= 0.5 * steps.step(1), "term {term}: {error}");
        }
        assert_eq!(coded.bits(&[1; 4]), 20, "a bit for each of the coefficients of a cubic");
    }
}
