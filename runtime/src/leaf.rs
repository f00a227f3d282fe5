//! From a leaf's sample block to its value and gradient.

use crate::bytes::Words;
use crate::hermite::{self, Corners, Tricubic};
use crate::layout::{block, packed_sample, precision};
use crate::octree::{Interpolant, Leaf, Octree};
use crate::sample::{decode_distance, decode_gradients, decode_half, decode_single};

/// A sample block: its header, and the words after it.
#[derive(Clone, Copy)]
pub(crate) struct Block<'a> {
    /// Which lattice samples are there.
    pub(crate) present: u32,
    /// Which of them are full.
    pub(crate) full: u32,
    pub(crate) precision: u32,
    pub(crate) base: i32,
    /// From the first sample to the end of the section.
    pub(crate) data: Words<'a>,
}

impl<'a> Block<'a> {
    #[inline]
    pub(crate) fn at(samples: Words<'a>, offset: u32) -> Self {
        let words = samples.tail(offset as usize);
        let header: [u32; block::HEADER_WORDS] = words.words(0);
        Self {
            present: header[block::PRESENT_WORD] & block::LATTICE_MASK,
            full: header[block::FULL_WORD] & block::LATTICE_MASK,
            precision: header[block::PRESENT_WORD] >> block::PRECISION_SHIFT & block::PRECISION_MASK,
            base: header[block::BASE_WORD].cast_signed(),
            data: words.tail(block::HEADER_WORDS),
        }
    }
}

/// Lattice bit of the least corner of an octant.
#[inline]
pub(crate) fn lattice_bit(octant: u32) -> u32 {
    (octant & 1) + 3 * (octant >> 1 & 1) + 9 * (octant >> 2 & 1)
}

/// Lattice bits of the corners of octant 0.
pub(crate) const CORNER_MASK: u32 = 0b011_011 | 0b011_011 << 9;

/// How many bits of `mask` precede each of an octant's corners at x = 0, ordered `2 y + z`.
///
/// `first` is the lattice bit of the octant's least corner. A row of three lattice samples always
/// holds two corners, so the next row starts two or three samples on.
#[inline]
fn ranks(mask: u32, first: u32) -> [usize; 4] {
    let below = (mask & ((1 << first) - 1)).count_ones() as usize;
    let layer = (mask >> first & 0x1FF).count_ones() as usize;
    let row = 2 + (mask >> first >> 2 & 1) as usize;
    let upper_row = 2 + (mask >> first >> 11 & 1) as usize;
    [below, below + layer, below + row, below + layer + upper_row]
}

impl Octree<'_> {
    /// Value of a leaf at local coordinates, 0 to 1 along each axis; mesh units.
    #[inline]
    pub(crate) fn value(&self, leaf: &Leaf, local: [f32; 3]) -> f32 {
        match self.interpolant() {
            Interpolant::Tricubic => self.tricubic(leaf, |corners| corners.value(local)),
            Interpolant::Trilinear => hermite::trilinear(&self.distances(leaf), local),
        }
    }

    /// Value and gradient of a leaf at local coordinates, 0 to 1 along each axis.
    ///
    /// The value is in mesh units, the gradient without unit. A leaf answers beyond its cell too,
    /// by extrapolation; finite coordinates of a few cells give finite answers.
    #[inline]
    pub fn evaluate(&self, leaf: &Leaf, local: [f32; 3]) -> (f32, [f32; 3]) {
        let (value, derivatives) = match self.interpolant() {
            Interpolant::Tricubic => self.tricubic(leaf, |corners| corners.value_and_derivatives(local)),
            Interpolant::Trilinear => hermite::trilinear_and_derivatives(&self.distances(leaf), local),
        };
        let per_edge = 1.0 / self.edge(leaf.level);
        (value, derivatives.map(|derivative| derivative * per_edge))
    }

    /// Evaluates the corners of a tricubic leaf.
    ///
    /// The leaf with no full samples is the common one: evaluating inside each branch lets the
    /// compiler leave the mixed derivatives out of it.
    #[inline]
    fn tricubic<T>(&self, leaf: &Leaf, evaluate: impl Fn(&Tricubic) -> T) -> T {
        let block = Block::at(self.samples, leaf.block);
        if block.precision == precision::PACKED32 && block.full == 0 {
            return evaluate(&self.packed_corners(leaf, &block));
        }
        evaluate(&self.any_corners(leaf, &block))
    }

    /// The corners of a leaf whose block has nothing but packed samples of one word.
    #[inline]
    fn packed_corners(&self, leaf: &Leaf, block: &Block<'_>) -> Tricubic {
        let rows = ranks(block.present, lattice_bit(leaf.octant));
        let [a, b, c, d] = rows.map(|row| block.data.words::<2>(row));
        let words = [[a[0], b[0], c[0], d[0]], [a[1], b[1], c[1], d[1]]];

        let quantum = self.quantum(leaf.level);
        let edge = self.edge(leaf.level);
        let distance = |word: u32| decode_distance(block.base, word >> packed_sample::DISTANCE_SHIFT, quantum);
        let [near, far] = words.map(|face| decode_gradients(face).map(|axis| axis.map(|component| component * edge)));
        Tricubic {
            distance: words.map(|face| face.map(distance)),
            gradient: [[near[0], far[0]], [near[1], far[1]], [near[2], far[2]]],
            mixed: None,
        }
    }

    /// The corners of any other tricubic leaf.
    fn any_corners(&self, leaf: &Leaf, block: &Block<'_>) -> Tricubic {
        let quantum = self.quantum(leaf.level);
        let edge = self.edge(leaf.level);
        let first = lattice_bit(leaf.octant);

        let mut distance = Corners::default();
        let mut gradient = [Corners::default(); 3];
        let mut mixed = [Corners::default(); 4];
        for corner in 0..8_u32 {
            let (x, y, z) = (corner >> 2, corner >> 1 & 1, corner & 1);
            let sample = Sample::read(block, first + x + 3 * y + 9 * z, quantum);

            // The masks say nothing to a reader, but show the compiler that no index can fail.
            let (x, lane) = ((x & 1) as usize, (corner & 3) as usize);
            distance[x][lane] = sample.distance;
            for (axis, component) in gradient.iter_mut().zip(sample.gradient) {
                axis[x][lane] = component * edge;
            }
            for (term, component) in mixed.iter_mut().zip(sample.mixed) {
                term[x][lane] = component * edge;
            }
        }

        let has_mixed = block.full >> first & CORNER_MASK != 0;
        Tricubic { distance, gradient, mixed: has_mixed.then_some(mixed) }
    }

    /// The distances at the corners of a trilinear leaf.
    #[inline]
    fn distances(&self, leaf: &Leaf) -> Corners {
        let block = Block::at(self.samples, leaf.block);
        let rows = ranks(block.present, lattice_bit(leaf.octant));
        let faces = [rows, rows.map(|rank| rank + 1)];

        match block.precision {
            precision::PACKED32 | precision::F16 => {
                let quantum = self.quantum(leaf.level) * SIXTEENTH;
                let base = block.base.wrapping_mul(16);
                let code = |rank| block.data.word(rank / 2) >> (16 * (rank & 1)) & 0xFFFF;
                faces.map(|face| face.map(|rank| decode_distance(base, code(rank), quantum)))
            }
            _ => faces.map(|face| face.map(|rank| decode_single(block.data.word(rank)))),
        }
    }
}

/// A 16-bit distance code counts sixteenths of a quantum.
const SIXTEENTH: f32 = 1.0 / 16.0;

/// One tricubic sample. Derivatives have no unit: mixed ones carry a factor of the leaf's edge for
/// each order beyond the first.
struct Sample {
    distance: f32,
    gradient: [f32; 3],
    mixed: [f32; 4],
}

impl Sample {
    /// The sample at a lattice bit of a tricubic block.
    fn read(block: &Block<'_>, bit: u32, quantum: f32) -> Self {
        let below = (1 << bit) - 1;
        let rank = (block.present & below).count_ones() as usize;
        let full_rank = (block.full & below).count_ones() as usize;
        let is_full = block.full >> bit & 1 == 1;

        let (stride, full_stride) = strides(block.precision);
        let at = rank * stride + full_rank * (full_stride - stride);
        match (block.precision, is_full) {
            (precision::PACKED32, false) => {
                let word = block.data.word(at);
                let code = word >> packed_sample::DISTANCE_SHIFT;
                Self {
                    distance: decode_distance(block.base, code, quantum),
                    gradient: crate::sample::decode_gradient(word),
                    mixed: [0.0; 4],
                }
            }
            (precision::PACKED32 | precision::F16, _) => {
                let [code_x, yz] = block.data.words(at);
                let [xy_xz, yz_xyz] = if is_full { block.data.words(at + 2) } else { [0; 2] };
                let base = block.base.wrapping_mul(16);
                Self {
                    distance: decode_distance(base, code_x & 0xFFFF, quantum * SIXTEENTH),
                    gradient: [high(code_x), low(yz), high(yz)],
                    mixed: [low(xy_xz), high(xy_xz), low(yz_xyz), high(yz_xyz)],
                }
            }
            _ => {
                let [distance, x, y, z] = block.data.words(at).map(decode_single);
                let mixed = if is_full { block.data.words(at + 4) } else { [0; 4] };
                Self { distance, gradient: [x, y, z], mixed: mixed.map(decode_single) }
            }
        }
    }
}

/// Words of a regular and of a full tricubic sample.
pub(crate) fn strides(precision: u32) -> (usize, usize) {
    match precision {
        precision::PACKED32 => (1, 4),
        precision::F16 => (2, 4),
        _ => (4, 8),
    }
}

#[inline]
fn low(word: u32) -> f32 {
    decode_half(word as u16)
}

#[inline]
fn high(word: u32) -> f32 {
    decode_half((word >> 16) as u16)
}
