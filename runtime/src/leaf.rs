//! From a leaf's sample block to its value and gradient.

use crate::bytes::Words;
use crate::hermite::{self, Corners, Mixed, Tricubic};
use crate::implied::{self, Jets, PARENT_CORNERS};
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
            Interpolant::Tricubic => self.tricubic(leaf, |corners, mixed| corners.value(mixed, local)),
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
            Interpolant::Tricubic => self.tricubic(leaf, |corners, mixed| corners.value_and_derivatives(mixed, local)),
            Interpolant::Trilinear => hermite::trilinear_and_derivatives(&self.distances(leaf), local),
        };
        let per_edge = 1.0 / self.edge(leaf.level);
        (value, derivatives.map(|derivative| derivative * per_edge))
    }

    /// Evaluates the corners of a tricubic leaf.
    ///
    /// A leaf with nothing but packed first-order samples is the common one: evaluating in a branch of its
    /// own lets the compiler leave the mixed derivatives out of it.
    #[inline]
    fn tricubic<T>(&self, leaf: &Leaf, evaluate: impl Fn(&Tricubic, Option<&Mixed>) -> T) -> T {
        let block = Block::at(self.samples, leaf.block);
        let scale = Scale { quantum: self.quantum(leaf.level), edge: self.edge(leaf.level) };
        let first = lattice_bit(leaf.octant);
        let corners = CORNER_MASK << first;
        if block.precision == precision::PACKED32 && block.full == 0 && block.present & corners == corners {
            return evaluate(&block.packed(&ranks(block.present, first), scale), None);
        }
        let (corners, mixed) = block.any_corners(leaf, scale);
        evaluate(&corners, Some(&mixed))
    }

    /// The distances at the corners of a trilinear leaf.
    #[inline]
    fn distances(&self, leaf: &Leaf) -> Corners {
        let block = Block::at(self.samples, leaf.block);
        let quantum = self.quantum(leaf.level);
        let first = lattice_bit(leaf.octant);
        if block.present & (CORNER_MASK << first) == CORNER_MASK << first {
            return ranks(block.present, first).map(|rank| block.trilinear_distance(rank, quantum));
        }
        let implied = block.implied(first);
        let ranks = choose(implied, parent_ranks(block.present), ranks(block.present, first));
        let distances = ranks.map(|rank| block.trilinear_distance(rank, quantum));
        implied::settle_distances(&distances, implied, leaf.octant)
    }
}

/// `parent` for the implied corners, `own` for the others.
#[inline]
fn choose<T: Copy>(implied: u32, parent: [T; 8], own: [T; 8]) -> [T; 8] {
    let mut chosen = own;
    for (corner, (chosen, parent)) in chosen.iter_mut().zip(parent).enumerate() {
        if implied >> corner & 1 == 1 {
            *chosen = parent;
        }
    }
    chosen
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

impl Block<'_> {
    /// Samples of one word each: one plain loop, which compilers turn into vectors.
    #[inline]
    fn packed(&self, places: &[usize; 8], scale: Scale) -> Tricubic {
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

    /// Corners of any kind, stored or implied.
    fn any_corners(&self, leaf: &Leaf, scale: Scale) -> (Tricubic, Mixed) {
        // What is not stored is implied by the parent's corner on the same side.
        let first = lattice_bit(leaf.octant);
        let implied = self.implied(first);
        let (stride, full_stride) = strides(self.precision);
        let present = choose(implied, parent_ranks(self.present), ranks(self.present, first));
        let mut places = present.map(|rank| rank * stride);
        if self.full != 0 {
            let full = choose(implied, parent_ranks(self.full), ranks(self.full, first));
            for (place, rank) in places.iter_mut().zip(full) {
                *place += rank * (full_stride - stride);
            }
        }

        let Tricubic { distance, gradient: [x, y, z] } = self.packed(&places, scale);
        let mut jets = [distance, x, y, [0.0; 8], z, [0.0; 8], [0.0; 8], [0.0; 8]];
        if self.full != 0 || self.precision != precision::PACKED32 {
            let bits = choose(implied, PARENT_CORNERS, corner_bits(first));
            self.replace_wide(&mut jets, &bits, &places, scale);
        }
        implied::settle(&mut jets, implied, leaf.octant);

        let [distance, x, y, xy, z, xz, yz, xyz] = jets;
        (Tricubic { distance, gradient: [x, y, z] }, [xy, xz, yz, xyz])
    }

    /// Replaces the samples that are not packed.
    fn replace_wide(&self, jets: &mut Jets, bits: &[u32; 8], places: &[usize; 8], scale: Scale) {
        for (corner, (&bit, &place)) in bits.iter().zip(places).enumerate() {
            let full = self.full >> bit & 1 == 1;
            if full || self.precision != precision::PACKED32 {
                for (derivatives, derivative) in jets.iter_mut().zip(self.wide_jet(place, full, scale)) {
                    // The mask shows the compiler that no index can fail.
                    derivatives[corner & 7] = derivative;
                }
            }
        }
    }

    /// Which corners of the octant whose least corner is bit `first` are not stored: a bit for each of [`Corners`].
    #[inline]
    fn implied(&self, first: u32) -> u32 {
        let absent = !self.present >> first;
        [0, 9, 3, 12, 1, 10, 4, 13].into_iter().rev().fold(0, |mask, step| mask << 1 | absent >> step & 1)
    }

    /// A sample of half floats or floats.
    fn wide_jet(&self, place: usize, full: bool, scale: Scale) -> [f32; 8] {
        let (distance, gradient) = if self.precision == precision::F32 {
            let [distance, x, y, z] = self.data.words(place).map(decode_single);
            (distance, [x, y, z])
        } else {
            let [code_x, y_z] = self.data.words(place);
            let base = self.base.wrapping_mul(16);
            let distance = decode_distance(base, code_x & 0xFFFF, scale.quantum * SIXTEENTH);
            (distance, [high(code_x), low(y_z), high(y_z)])
        };
        let mixed = match (full, self.precision) {
            (false, _) => [0.0; 4],
            (true, precision::F32) => self.data.words(place + 4).map(decode_single),
            (true, _) => {
                let [xy_xz, yz_xyz] = self.data.words(place + 2);
                [low(xy_xz), high(xy_xz), low(yz_xyz), high(yz_xyz)]
            }
        };

        let [x, y, z] = gradient.map(|derivative| derivative * scale.edge);
        let [xy, xz, yz, xyz] = mixed.map(|derivative| derivative * scale.edge);
        [distance, x, y, xy, z, xz, yz, xyz]
    }

    /// The distance of a trilinear sample.
    #[inline]
    fn trilinear_distance(&self, rank: usize, quantum: f32) -> f32 {
        if self.precision == precision::F32 {
            return decode_single(self.data.word(rank));
        }
        let code = self.data.word(rank / 2) >> (16 * (rank & 1)) & 0xFFFF;
        decode_distance(self.base.wrapping_mul(16), code, quantum * SIXTEENTH)
    }
}

/// Lattice bits of the corners of the octant whose least corner is bit `first`, in the order of [`Corners`].
fn corner_bits(first: u32) -> [u32; 8] {
    [0, 9, 3, 12, 1, 10, 4, 13].map(|step| first + step)
}

/// How many bits of `mask` precede each of [`PARENT_CORNERS`].
#[inline]
fn parent_ranks(mask: u32) -> [usize; 8] {
    let below = |bit: u32| (mask & ((1 << bit) - 1)).count_ones();
    let pair = |bit: u32| (mask >> bit & 1) + (mask >> bit >> 1 & 1);
    let [b, c, d] = [below(6), below(18), below(24)];
    [0, c, b, d, pair(0), c + pair(18), b + pair(6), d + pair(24)].map(|rank| rank as usize)
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
