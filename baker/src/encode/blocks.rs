//! Sample blocks: the lattice samples that sibling leaves share, each once.

use crate::octree::corners::Vertex;
use crate::quantize::rounding::{FINE_PER_QUANTUM, Rounding};
use crate::quantize::sample::encode_gradient;
use crate::settings::{Interpolant, Precision};
use half::f16;
use nearfield::layout::{block, packed_sample, precision};

/// Appends the block of the vertices present, the corners of leaves of this level.
pub(super) fn push_block(words: &mut Vec<u32>, rounding: &Rounding, level: u8, lattice: &[Option<&Vertex>; 27]) {
    let present: Vec<&Vertex> = lattice.iter().flatten().copied().collect();
    let mask = |holds: &dyn Fn(&Vertex) -> bool| {
        lattice.iter().enumerate().fold(0, |mask, (bit, vertex)| mask | u32::from(vertex.is_some_and(holds)) << bit)
    };
    let quantum = rounding.quantum(level);
    let base = present.iter().map(|vertex| (vertex.corner.distance() / quantum).floor()).fold(f64::INFINITY, f64::min);
    let block = Block { edge: rounding.edge(level), quantum, base };

    // A block whose distances or derivatives leave the range of its codes stores the same numbers as floats.
    let fits = present.iter().all(|vertex| block.fits(vertex));
    let precision = if fits { rounding.precision() } else { Precision::F32 };
    let code = match precision {
        Precision::Packed32 => precision::PACKED32,
        Precision::F16 => precision::F16,
        Precision::F32 => precision::F32,
    };
    let base = if precision == Precision::F32 { 0 } else { base as i32 };
    words.extend([
        mask(&|_| true) | code << block::PRECISION_SHIFT,
        mask(&|vertex| vertex.hangs && rounding.interpolant() == Interpolant::Tricubic),
        base.cast_unsigned(),
    ]);
    match (rounding.interpolant(), precision) {
        (Interpolant::Trilinear, Precision::F32) => {
            words.extend(present.iter().map(|vertex| float(vertex.corner.0[0])))
        }
        (Interpolant::Trilinear, _) => {
            let codes: Vec<u16> = present.iter().map(|vertex| block.fine_code(vertex)).collect();
            words.extend(codes.chunks(2).map(|pair| halves(pair[0], pair.get(1).copied().unwrap_or(0))));
        }
        (Interpolant::Tricubic, precision) => {
            present.iter().for_each(|vertex| block.push_sample(words, precision, vertex));
        }
    }
}

struct Block {
    edge: f64,
    quantum: f64,
    /// In quanta.
    base: f64,
}

impl Block {
    fn fits(&self, vertex: &Vertex) -> bool {
        let code = vertex.corner.distance() / self.quantum - self.base;
        let small = self.stored_derivatives(vertex).iter().all(|&stored| f16::from_f64(stored).is_finite());
        code <= f64::from(packed_sample::DISTANCE_MAX) && self.base.abs() < f64::from(1 << 26) && small
    }

    /// Distance above the base in fine quanta: a whole number, since the vertex was rounded.
    fn fine_code(&self, vertex: &Vertex) -> u16 {
        (FINE_PER_QUANTUM * (vertex.corner.distance() / self.quantum - self.base)).round() as u16
    }

    /// Distance above the base in quanta.
    fn code(&self, vertex: &Vertex) -> u32 {
        (vertex.corner.distance() / self.quantum - self.base).round() as u32
    }

    /// Derivatives as stored: mixed ones per cell edge.
    fn stored_derivatives(&self, vertex: &Vertex) -> [f64; 7] {
        let [_, x, y, xy, z, xz, yz, xyz] = vertex.corner.0;
        let edge = self.edge;
        [x, y, z, xy * edge, xz * edge, yz * edge, xyz * edge * edge]
    }

    fn push_sample(&self, words: &mut Vec<u32>, precision: Precision, vertex: &Vertex) {
        let derivatives = self.stored_derivatives(vertex);
        let stored = if vertex.hangs { &derivatives[..] } else { &derivatives[..3] };
        if precision == Precision::F32 {
            words.push(float(vertex.corner.distance()));
            words.extend(stored.iter().map(|&derivative| float(derivative)));
        } else if precision == Precision::F16 || vertex.hangs {
            let half = |i: usize| f16::from_f64(stored[i]).to_bits();
            words.push(halves(self.fine_code(vertex), half(0)));
            words.extend((1..stored.len()).step_by(2).map(|i| halves(half(i), half(i + 1))));
        } else {
            let gradient = encode_gradient(vertex.corner.gradient());
            words.push(gradient | self.code(vertex) << packed_sample::DISTANCE_SHIFT);
        }
    }
}

fn float(value: f64) -> u32 {
    (value as f32).to_bits()
}

fn halves(low: u16, high: u16) -> u32 {
    u32::from(low) | u32::from(high) << 16
}
