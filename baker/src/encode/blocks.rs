//! Sample blocks: the lattice samples that sibling leaves share, each once.

use crate::octree::corners::Vertex;
use crate::quantize::codes::Codes;
use crate::quantize::rounding::Rounding;
use crate::settings::{Interpolant, Precision};
use nearfield::layout::{block, precision};

/// Appends the block of the vertices present, the corners of leaves of this level.
pub(super) fn push_block(words: &mut Vec<u32>, rounding: &Rounding, level: u8, lattice: &[Option<&Vertex>; 27]) {
    let vertices = lattice.iter().flatten().copied();
    let codes = Codes::of(rounding, level, vertices.clone().map(|vertex| &vertex.corner));
    let is_full = |vertex: &Vertex| vertex.hangs && rounding.interpolant() == Interpolant::Tricubic;
    let mask = |holds: &dyn Fn(&Vertex) -> bool| {
        lattice.iter().enumerate().fold(0, |mask, (bit, vertex)| mask | u32::from(vertex.is_some_and(holds)) << bit)
    };

    let precision = match codes.precision() {
        Precision::Packed32 => precision::PACKED32,
        Precision::F16 => precision::F16,
        Precision::F32 => precision::F32,
    };
    words.extend([mask(&|_| true) | precision << block::PRECISION_SHIFT, mask(&is_full), codes.base().cast_unsigned()]);
    match rounding.interpolant() {
        Interpolant::Trilinear => words.extend(codes.distances(vertices.map(|vertex| &vertex.corner))),
        Interpolant::Tricubic => {
            words.extend(vertices.flat_map(|vertex| codes.sample(&vertex.corner, is_full(vertex))));
        }
    }
}
