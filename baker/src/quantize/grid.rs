//! The samples of a grid to the words of its sections.
//!
//! A distance is a whole multiple of one quantum, counted from the base of its brick, or of the file. One
//! quantum serves all bricks: a distance field rises by at most its slope from sample to sample, so all
//! bricks have ranges of one size.

use super::sample::{encode_gradient, encode_half};
use crate::sampling::{EXPONENTS, terms};
use crate::settings::{GridSettings, Precision, RangeScope};
use glam::{DVec3, UVec3};
use half::f16;
use nearfield::layout::{block, grid::BRICK_EDGE, limit, packed_sample};
use nearfield::sample::decode_gradient;

/// Where samples lie: what rounding needs of a lattice.
pub trait Lattice {
    /// Samples along each axis.
    fn resolution(&self) -> UVec3;
    /// Distance between samples, mesh units.
    fn spacing(&self) -> DVec3;
}

/// The samples of a grid as the file stores them.
#[derive(Clone, Debug, PartialEq)]
pub struct Stored {
    /// How they are stored.
    pub precision: Precision,
    /// What the distance codes count from.
    pub range: RangeScope,
    /// Unit of the distance codes, mesh units.
    pub quantum: f32,
    /// Base distances in quanta, brick by brick; none for [`Precision::F32`].
    pub bases: Vec<i32>,
    /// Words of the samples, x fastest.
    pub words: Vec<u32>,
}

/// Rounds the coefficients of a grid's samples, in place, to what the reader will decode.
pub fn round(coefficients: &mut [f64], lattice: &dyn Lattice, grid: &GridSettings, precision: Precision) -> Stored {
    let order = grid.order;
    let codes = match (precision, order) {
        (Precision::F32, _) => return round_singles(coefficients, lattice, order),
        (Precision::Packed32, 1..) => packed_sample::DISTANCE_MAX,
        _ => u32::from(u16::MAX),
    };
    let bricks = Bricks::new(lattice.resolution(), grid.range);

    // The quantum by the widest brick, the bases by the least distance of each.
    let terms = terms(order);
    let mut ranges = vec![(f64::INFINITY, f64::NEG_INFINITY); bricks.count()];
    for (index, sample) in coefficients.chunks(terms).enumerate() {
        let (least, greatest) = &mut ranges[bricks.of_sample(index)];
        (*least, *greatest) = (least.min(sample[0]), greatest.max(sample[0]));
    }
    let widest = ranges.iter().map(|(least, greatest)| greatest - least).fold(0.0, f64::max);
    let largest = ranges.iter().map(|(least, greatest)| least.abs().max(greatest.abs())).fold(0.0, f64::max);
    let quantum = (widest / f64::from(codes - 1))
        .max(largest / f64::from(block::MAX_BASE))
        .max(f64::from(limit::MIN_QUANTUM)) as f32;
    let quantum = quantum.next_up();
    let unit = f64::from(quantum);
    let bases: Vec<i32> = ranges.iter().map(|(least, _)| (least / unit).floor() as i32).collect();

    // Sample by sample.
    let mut halves: Vec<u16> = Vec::new();
    let powers = Powers::new(lattice.spacing());
    for (index, sample) in coefficients.chunks_mut(terms).enumerate() {
        let base = bases[bricks.of_sample(index)];
        let code = ((sample[0] / unit).round() - f64::from(base)).clamp(0.0, f64::from(codes)) as u32;
        sample[0] = (f64::from(base) + f64::from(code)) * unit;
        let wide = if order > 0 && precision == Precision::Packed32 {
            let gradient = encode_gradient(DVec3::new(sample[1], sample[2], sample[3]));
            let decoded = decode_gradient(gradient).map(f64::from);
            sample[1..4].copy_from_slice(&decoded);
            let word = gradient | code << packed_sample::DISTANCE_SHIFT;
            halves.extend([word as u16, (word >> 16) as u16]);
            4
        } else {
            halves.push(code as u16);
            1
        };
        for (term, coefficient) in sample.iter_mut().enumerate().skip(wide) {
            let scale = powers.scale(term);
            let bits = encode_half(*coefficient * scale);
            *coefficient = f16::from_bits(bits).to_f64_const() / scale;
            halves.push(bits);
        }
    }
    if halves.len() % 2 == 1 {
        halves.push(0);
    }
    let words = halves.chunks(2).map(|pair| u32::from(pair[0]) | u32::from(pair[1]) << 16).collect();
    Stored { precision, range: grid.range, quantum, bases, words }
}

/// Rounds to `f32`: nothing is counted from a base.
fn round_singles(coefficients: &mut [f64], lattice: &dyn Lattice, order: u8) -> Stored {
    let powers = Powers::new(lattice.spacing());
    let terms = terms(order);
    let largest = f64::from(limit::MAX_MAGNITUDE);
    let mut words = Vec::with_capacity(coefficients.len());
    for (index, coefficient) in coefficients.iter_mut().enumerate() {
        let scale = powers.scale(index % terms);
        let stored = (*coefficient * scale).clamp(-largest, largest) as f32;
        *coefficient = f64::from(stored) / scale;
        words.push(stored.to_bits());
    }
    Stored { precision: Precision::F32, range: RangeScope::File, quantum: 1.0, bases: Vec::new(), words }
}

/// Powers of the unit of length of stored coefficients, the greatest spacing, by which they lose their
/// own unit.
struct Powers(f64);

impl Powers {
    fn new(spacing: DVec3) -> Self {
        Self(spacing.max_element())
    }

    /// What a coefficient is multiplied by.
    fn scale(&self, term: usize) -> f64 {
        let degree: u8 = EXPONENTS[term].iter().sum();
        (1..degree).fold(1.0, |power, _| power * self.0)
    }
}

/// Which samples share a base.
struct Bricks {
    resolution: [usize; 3],
    bricks: [usize; 3],
    edge: usize,
}

impl Bricks {
    fn new(resolution: UVec3, range: RangeScope) -> Self {
        let resolution = resolution.to_array().map(|samples| samples as usize);
        let edge = match range {
            RangeScope::File => resolution.into_iter().fold(1, usize::max),
            RangeScope::Brick => BRICK_EDGE as usize,
        };
        Self { resolution, bricks: resolution.map(|samples| samples.div_ceil(edge)), edge }
    }

    fn count(&self) -> usize {
        self.bricks.iter().product()
    }

    fn of_sample(&self, index: usize) -> usize {
        let [nx, ny, _] = self.resolution;
        let [x, y, z] = [index % nx, index / nx % ny, index / nx / ny].map(|place| place / self.edge);
        x + self.bricks[0] * (y + self.bricks[1] * z)
    }
}
