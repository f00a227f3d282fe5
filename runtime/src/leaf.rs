//! From a leaf's sample block to its value and gradient.

use crate::bytes::Words;
use crate::hermite::{self, Corners, Mixed, Tricubic};
use crate::layout::{block, packed_sample, precision};
use crate::octree::{Interpolant, Leaf, Octree};
use crate::sample::{decode_distance, decode_gradient, decode_half, decode_single};

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
            precision: header[block::PRESENT_WORD] >> block::PRECISION_SHIFT
                & block::PRECISION_MASK,
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

/// How many bits of `mask` precede each corner of the octant whose least corner is bit `first`.
///
/// Two population counts serve all eight corners: a row of the lattice is 3 bits, a layer 9.
#[inline]
fn ranks(mask: u32, first: u32) -> [usize; 8] {
    let rest = mask >> first;
    let below = (mask & ((1 << first) - 1)).count_ones();
    let layer = (rest & 0x1FF).count_ones();
    let bit = |step: u32| rest >> step & 1;
    let row = |step: u32| bit(step) + bit(step + 1) + bit(step + 2);

    let least = [below, below + layer, below + row(0), below + layer + row(9)];
    let [a, b, c, d] = least;
    [a, b, c, d, a + bit(0), b + bit(9), c + bit(3), d + bit(12)].map(|rank| rank as usize)
}

impl Octree<'_> {
    /// Value of a leaf at local coordinates, 0 to 1 along each axis; mesh units.
    #[inline]
    pub(crate) fn value(&self, leaf: &Leaf, local: [f32; 3]) -> f32 {
        match self.interpolant() {
            Interpolant::Tricubic => {
                self.tricubic(leaf, |corners, mixed| corners.value(mixed, local))
            }
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
            Interpolant::Tricubic => self.tricubic(leaf, |corners, mixed| {
                corners.value_and_derivatives(mixed, local)
            }),
            Interpolant::Trilinear => {
                hermite::trilinear_and_derivatives(&self.distances(leaf), local)
            }
        };
        let per_edge = 1.0 / self.edge(leaf.level);
        (value, derivatives.map(|derivative| derivative * per_edge))
    }

    /// Evaluates the corners of a tricubic leaf.
    ///
    /// Leaves without full samples are the common ones: with a call of its own, the compiler leaves
    /// the mixed derivatives out of them.
    #[inline]
    fn tricubic<T>(&self, leaf: &Leaf, evaluate: impl Fn(&Tricubic, Option<&Mixed>) -> T) -> T {
        let block = Block::at(self.samples, leaf.block);
        let scale = Scale {
            quantum: self.quantum(leaf.level),
            edge: self.edge(leaf.level),
        };
        let first = lattice_bit(leaf.octant);
        let places = block.places(first);

        let mut corners = match block.precision {
            precision::PACKED32 => block.packed_corners(&places, scale),
            _ => block.wide_corners(&places, scale),
        };
        let full = block.full >> first & CORNER_MASK;
        if full == 0 {
            return evaluate(&corners, None);
        }
        let mixed = block.full_corners(full, &places, scale, &mut corners);
        evaluate(&corners, Some(&mixed))
    }

    /// The distances at the corners of a trilinear leaf.
    #[inline]
    fn distances(&self, leaf: &Leaf) -> Corners {
        let block = Block::at(self.samples, leaf.block);
        let ranks = ranks(block.present, lattice_bit(leaf.octant));
        match block.precision {
            precision::PACKED32 | precision::F16 => {
                let quantum = self.quantum(leaf.level) * SIXTEENTH;
                let base = block.base.wrapping_mul(16);
                let code = |rank| block.data.word(rank / 2) >> (16 * (rank & 1)) & 0xFFFF;
                ranks.map(|rank| decode_distance(base, code(rank), quantum))
            }
            _ => ranks.map(|rank| decode_single(block.data.word(rank))),
        }
    }
}

/// A 16-bit distance code counts sixteenths of a quantum.
const SIXTEENTH: f32 = 1.0 / 16.0;

/// Units of a leaf's samples, mesh units: of its distances, and of its derivatives by local
/// coordinates.
#[derive(Clone, Copy)]
struct Scale {
    quantum: f32,
    edge: f32,
}

/// The words after a block's header at which the samples of a leaf's corners start.
type Places = [usize; 8];

impl Block<'_> {
    #[inline]
    fn places(&self, first: u32) -> Places {
        let ranks_present = ranks(self.present, first);
        let (stride, full_stride) = strides(self.precision);
        let mut places = ranks_present.map(|rank| rank * stride);
        if self.full != 0 {
            for (place, rank) in places.iter_mut().zip(ranks(self.full, first)) {
                *place += rank * (full_stride - stride);
            }
        }
        places
    }

    /// Corners of one word each: one plain loop, which compilers turn into vectors.
    #[inline]
    fn packed_corners(&self, places: &Places, scale: Scale) -> Tricubic {
        let words = places.map(|place| self.data.word(place));
        let mut distance = Corners::default();
        let mut gradient = [Corners::default(); 3];
        for (corner, &word) in words.iter().enumerate() {
            let code = word >> packed_sample::DISTANCE_SHIFT;
            distance[corner] = decode_distance(self.base, code, scale.quantum);
            let [x, y, z] = decode_gradient(word);
            gradient[0][corner] = x * scale.edge;
            gradient[1][corner] = y * scale.edge;
            gradient[2][corner] = z * scale.edge;
        }
        Tricubic { distance, gradient }
    }

    /// Corners of half floats or floats.
    fn wide_corners(&self, places: &Places, scale: Scale) -> Tricubic {
        let mut corners = Tricubic {
            distance: [0.0; 8],
            gradient: [[0.0; 8]; 3],
        };
        for (corner, &place) in places.iter().enumerate() {
            self.read_wide(corner, place, scale, &mut corners);
        }
        corners
    }

    /// Replaces the full corners, a bit each in `full`, and returns their mixed derivatives.
    fn full_corners(
        &self,
        full: u32,
        places: &Places,
        scale: Scale,
        corners: &mut Tricubic,
    ) -> Mixed {
        let mut mixed = [Corners::default(); 4];
        for (corner, &place) in places.iter().enumerate() {
            let bit = (corner >> 2) + 3 * (corner >> 1 & 1) + 9 * (corner & 1);
            if full >> bit & 1 == 0 {
                continue;
            }
            self.read_wide(corner, place, scale, corners);
            let terms = if self.precision == precision::F32 {
                self.data.words(place + 4).map(decode_single)
            } else {
                let [xy_xz, yz_xyz] = self.data.words(place + 2);
                [low(xy_xz), high(xy_xz), low(yz_xyz), high(yz_xyz)]
            };
            for (mixed, term) in mixed.iter_mut().zip(terms) {
                mixed[corner] = term * scale.edge;
            }
        }
        mixed
    }

    /// Reads distance and gradient of a corner that is not packed.
    #[inline]
    fn read_wide(&self, corner: usize, place: usize, scale: Scale, corners: &mut Tricubic) {
        let (distance, gradient) = if self.precision == precision::F32 {
            let [distance, x, y, z] = self.data.words(place).map(decode_single);
            (distance, [x, y, z])
        } else {
            let [code_x, y_z] = self.data.words(place);
            let base = self.base.wrapping_mul(16);
            let distance = decode_distance(base, code_x & 0xFFFF, scale.quantum * SIXTEENTH);
            (distance, [high(code_x), low(y_z), high(y_z)])
        };

        // The mask shows the compiler that no index can fail.
        corners.distance[corner & 7] = distance;
        for (axis, component) in corners.gradient.iter_mut().zip(gradient) {
            axis[corner & 7] = component * scale.edge;
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
