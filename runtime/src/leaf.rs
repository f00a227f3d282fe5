//! From a leaf's sample block to its value and gradient.

use crate::bytes::Words;
use crate::hermite::{self, Corners, Jet, Jets};
use crate::implied;
use crate::lattice::Leaf;
use crate::layout::{block, packed_sample, precision};
use crate::octree::{Interpolant, Octree};
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
pub(crate) const fn lattice_bit(octant: u32) -> u32 {
    (octant & 1) + 3 * (octant >> 1 & 1) + 9 * (octant >> 2 & 1)
}

/// Lattice bits of the corners of octant 0.
pub(crate) const CORNER_MASK: u32 = 0b011_011 | 0b011_011 << 9;

/// Lattice bits of the corners of each octant, at `4 x + 2 y + z`, as masks.
const OCTANT_CORNERS: [[u32; 8]; 8] = {
    let mut corners = [[0; 8]; 8];
    let mut octant = 0;
    while octant < 8 {
        let mut corner = 0;
        while corner < 8 {
            let step = [0, 9, 3, 12, 1, 10, 4, 13][corner];
            corners[octant][corner] = 1 << (lattice_bit(octant as u32) + step);
            corner += 1;
        }
        octant += 1;
    }
    corners
};

/// Lattice bits of the corners of the eight siblings' parent, at `4 x + 2 y + z`, as masks.
const PARENT_CORNERS: [u32; 8] = [1 << 0, 1 << 18, 1 << 6, 1 << 24, 1 << 2, 1 << 20, 1 << 8, 1 << 26];

/// How many bits of `mask` precede each of `bits`, which are masks of one bit.
#[inline(never)]
fn ranks(mask: u32, bits: &[u32; 8], ranks: &mut [u32; 8]) {
    for (rank, bit) in ranks.iter_mut().zip(bits) {
        *rank = (mask & (bit - 1)).count_ones();
    }
}

impl<'a> Octree<'a> {
    /// Value of a leaf at local coordinates, 0 to 1 along each axis; mesh units.
    #[inline]
    pub(crate) fn value(&self, leaf: &Leaf, local: [f32; 3]) -> f32 {
        let mut jets = Jets::default();
        self.read_corners(leaf, &mut jets);
        self.value_between(&jets, local)
    }

    /// Value and gradient of a leaf at local coordinates, 0 to 1 along each axis.
    ///
    /// The value is in mesh units, the gradient without unit. A leaf answers beyond its cell too,
    /// by extrapolation; finite coordinates of a few cells give finite answers.
    #[inline]
    pub fn evaluate(&self, leaf: &Leaf, local: [f32; 3]) -> (f32, [f32; 3]) {
        let mut jets = Jets::default();
        self.read_corners(leaf, &mut jets);
        self.evaluate_between(leaf, &jets, local)
    }

    /// What a leaf interpolates: at each of its corners the value and its derivatives by local coordinates, mesh units.
    ///
    /// Both the corners and, at each, the derivatives are counted by `4 x + 2 y + z`: corner 6 is that of greatest x and
    /// y, and its derivative 6 is the one by x and y. Trilinear leaves have values only; their derivatives mean nothing.
    pub fn corners(&self, leaf: &Leaf) -> [[f32; 8]; 8] {
        let mut jets = Jets::default();
        self.read_corners(leaf, &mut jets);
        jets
    }

    /// Value between the corners of a leaf.
    #[inline(never)]
    pub(crate) fn value_between(&self, jets: &Jets, local: [f32; 3]) -> f32 {
        match self.interpolant() {
            Interpolant::Tricubic => hermite::tricubic(jets, local),
            Interpolant::Trilinear => hermite::trilinear(&distances(jets), local),
        }
    }

    /// Value and gradient between the corners of a leaf.
    #[inline(never)]
    pub(crate) fn evaluate_between(&self, leaf: &Leaf, jets: &Jets, local: [f32; 3]) -> (f32, [f32; 3]) {
        let (value, derivatives) = match self.interpolant() {
            Interpolant::Tricubic => hermite::tricubic_and_derivatives(jets, local),
            Interpolant::Trilinear => hermite::trilinear_and_derivatives(&distances(jets), local),
        };
        let per_edge = 1.0 / self.edge(leaf.level);
        (value, derivatives.map(|derivative| derivative * per_edge))
    }

    /// Writes the jets at the corners of a leaf; of a trilinear one only the distances.
    #[inline]
    pub(crate) fn read_corners(&self, leaf: &Leaf, jets: &mut Jets) {
        self.read_block(leaf, &self.block(leaf), jets);
    }

    /// The block of a leaf.
    #[inline]
    pub(crate) fn block(&self, leaf: &Leaf) -> Block<'a> {
        Block::at(self.samples, leaf.place)
    }

    /// [`read_corners`](Self::read_corners) from the leaf's block.
    #[inline]
    pub(crate) fn read_block(&self, leaf: &Leaf, block: &Block<'_>, jets: &mut Jets) {
        match self.interpolant() {
            Interpolant::Tricubic => self.read_jets(leaf, block, jets),
            Interpolant::Trilinear => self.read_distances(leaf, block, jets),
        }
    }

    /// Writes the jets at the corners of a tricubic leaf.
    #[inline(never)]
    fn read_jets(&self, leaf: &Leaf, block: &Block<'_>, jets: &mut Jets) {
        let scale = Scale { quantum: self.quantum(leaf.level), edge: self.edge(leaf.level) };
        let sources = block.sources(leaf.octant);
        let mut places = [0; 8];
        ranks(block.present, &sources, &mut places);
        if block.full == 0 && block.precision == precision::PACKED32 {
            block.packed(&places, scale, jets);
        } else {
            block.place_wide(&sources, &mut places);
            block.packed(&places, scale, jets);
            block.replace_wide(jets, &sources, &places, scale);
        }
        let implied = block.implied(leaf.octant);
        if implied != 0 {
            implied::settle(jets, implied, leaf.octant);
        }
    }

    /// Writes the distances at the corners of a trilinear leaf.
    fn read_distances(&self, leaf: &Leaf, block: &Block<'_>, jets: &mut Jets) {
        let quantum = self.quantum(leaf.level);
        let mut places = [0; 8];
        ranks(block.present, &block.sources(leaf.octant), &mut places);
        for (jet, place) in jets.iter_mut().zip(places) {
            *jet = [block.trilinear_distance(place, quantum), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        }
        let implied = block.implied(leaf.octant);
        if implied != 0 {
            implied::settle(jets, implied, leaf.octant);
            // The settled slopes are of no use: between the corners everything is linear.
        }
    }
}

/// The distances of jets.
#[inline]
fn distances(jets: &Jets) -> Corners {
    jets.map(|[distance, ..]| distance)
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
    /// The sample that each corner of an octant comes from, a mask of one lattice bit: its own, or that of the parent's
    /// corner on the same side where its own is implied.
    #[inline]
    fn sources(&self, octant: u32) -> [u32; 8] {
        let mut sources = [0; 8];
        let corners = &OCTANT_CORNERS[octant as usize & 7];
        for corner in 0..8 {
            let own = corners[corner];
            sources[corner] = if self.present & own == 0 { PARENT_CORNERS[corner] } else { own };
        }
        sources
    }

    /// From ranks to places where samples differ in size from a word.
    fn place_wide(&self, sources: &[u32; 8], places: &mut [u32; 8]) {
        let (stride, full_stride) = strides(self.precision);
        let mut full_ranks = [0; 8];
        ranks(self.full, sources, &mut full_ranks);
        for (place, full_rank) in places.iter_mut().zip(full_ranks) {
            *place = *place * stride + full_rank * (full_stride - stride);
        }
    }

    /// Samples of one word each: one plain loop, which compilers turn into vectors.
    #[inline(never)]
    fn packed(&self, places: &[u32; 8], scale: Scale, jets: &mut Jets) {
        // One check for all where it is known that no sample is farther: packed blocks have at most 27.
        let words = match self.data.window::<32>() {
            Some(window) if self.full == 0 => places.map(|place| u32::from_le_bytes(window[place as usize & 31])),
            _ => places.map(|place| self.data.word(place as usize)),
        };
        for (corner, &word) in words.iter().enumerate() {
            let code = word >> packed_sample::DISTANCE_SHIFT;
            let [x, y, z] = decode_gradient(word);
            let distance = decode_distance(self.base, code, scale.quantum);
            jets[corner] = [distance, z * scale.edge, y * scale.edge, 0.0, x * scale.edge, 0.0, 0.0, 0.0];
        }
    }

    /// Replaces the samples that are not packed.
    #[cold]
    #[inline(never)]
    fn replace_wide(&self, jets: &mut Jets, bits: &[u32; 8], places: &[u32; 8], scale: Scale) {
        for (corner, (bit, &place)) in bits.iter().zip(places).enumerate() {
            let full = self.full & bit != 0;
            if full || self.precision != precision::PACKED32 {
                // The mask shows the compiler that no index can fail.
                self.read_wide(place as usize, full, scale, &mut jets[corner & 7]);
            }
        }
    }

    /// Which corners of an octant are not stored: a bit for each, `4 x + 2 y + z`.
    #[inline]
    fn implied(&self, octant: u32) -> u32 {
        let absent = !self.present >> lattice_bit(octant);
        if absent & CORNER_MASK == 0 {
            return 0;
        }
        [0, 9, 3, 12, 1, 10, 4, 13].into_iter().rev().fold(0, |mask, bit| mask << 1 | absent >> bit & 1)
    }

    /// A sample of half floats or floats: a distance, then derivatives by x, y, z, xy, xz, yz and xyz.
    fn read_wide(&self, place: usize, full: bool, scale: Scale, jet: &mut Jet) {
        let mut numbers = Jet::default();
        for (index, number) in numbers.iter_mut().enumerate().take(if full { 8 } else { 4 }) {
            *number = if self.precision == precision::F32 {
                decode_single(self.data.word(place + index))
            } else {
                decode_half(self.data.half(2 * place + index) as u16)
            };
            *number *= scale.edge;
        }
        let [_, x, y, z, xy, xz, yz, xyz] = numbers;
        let code = self.data.word(place);
        let distance = if self.precision == precision::F32 {
            decode_single(code)
        } else {
            decode_distance(self.base.wrapping_mul(16), code & 0xFFFF, scale.quantum * SIXTEENTH)
        };
        *jet = [distance, z, y, yz, x, xz, xy, xyz];
    }

    /// The distance of a trilinear sample.
    #[inline]
    fn trilinear_distance(&self, rank: u32, quantum: f32) -> f32 {
        if self.precision == precision::F32 {
            return decode_single(self.data.word(rank as usize));
        }
        decode_distance(self.base.wrapping_mul(16), self.data.half(rank as usize), quantum * SIXTEENTH)
    }
}

/// Words of a regular and of a full tricubic sample.
pub(crate) fn strides(precision: u32) -> (u32, u32) {
    match precision {
        precision::PACKED32 => (1, 4),
        precision::F16 => (2, 4),
        _ => (4, 8),
    }
}
