//! Writes small files, a field of the format at a time, with nothing of the baker's.

use std::vec::Vec;

use crate::layout::{
    MAGIC, VERSION_MAJOR, VERSION_MINOR, block, family, header, interpolant, node, octree, section, section_entry,
};
use crate::{Field, crc32c, sample};

/// A file to be: the numbers of its header and octree, and its words.
#[derive(Clone)]
pub(super) struct File {
    pub(super) box_min: [f32; 3],
    pub(super) root_cells: [u16; 3],
    pub(super) depth: u8,
    pub(super) interpolant: u8,
    pub(super) root_edge: f32,
    pub(super) quantum: f32,
    pub(super) nodes: Vec<u32>,
    pub(super) samples: Vec<u32>,
}

impl File {
    /// A root cell of edge 2 at (1, 2, 3), as one leaf.
    pub(super) fn one_leaf(interpolant: u8, samples: Vec<u32>) -> Self {
        Self {
            box_min: [1.0, 2.0, 3.0],
            root_cells: [1, 1, 1],
            depth: 0,
            interpolant,
            root_edge: 2.0,
            quantum: 1.0 / 64.0,
            nodes: [leaf(0)].into(),
            samples,
        }
    }

    /// The bytes, checksums and all.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let leaves = self.nodes.iter().filter(|&&word| word >> node::OFFSET_BITS == node::LEAF);
        let mut parameters = [0; octree::LENGTH];
        let cells = self.root_cells.map(u16::to_le_bytes);
        parameters[octree::ROOT_CELLS].copy_from_slice(cells.as_flattened());
        parameters[octree::DEPTH] = self.depth;
        parameters[octree::INTERPOLANT] = self.interpolant;
        parameters[octree::ROOT_EDGE].copy_from_slice(&self.root_edge.to_le_bytes());
        parameters[octree::QUANTUM].copy_from_slice(&self.quantum.to_le_bytes());
        let leaf_count = leaves.count() as u32;
        parameters[octree::LEAF_COUNT].copy_from_slice(&leaf_count.to_le_bytes());

        let words = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let sections: [(u32, Vec<u8>); 3] = [
            (section::OCTREE, parameters.into()),
            (section::NODES, words(&self.nodes)),
            (section::SAMPLES, words(&self.samples)),
        ];

        let extent = self.root_cells.map(|cells| f32::from(cells) * self.root_edge);
        assemble(family::OCTREE, self.box_min, extent, &sections)
    }
}

/// A file of these sections, checksums and all.
pub(super) fn assemble(family: u8, box_min: [f32; 3], extent: [f32; 3], sections: &[(u32, Vec<u8>)]) -> Vec<u8> {
    let mut bytes = std::vec![0; header::LENGTH + sections.len() * section_entry::LENGTH];
    for (index, (kind, contents)) in sections.iter().enumerate() {
        let entry = header::LENGTH + index * section_entry::LENGTH;
        let offset = bytes.len() as u32;
        let values = [*kind, offset, contents.len() as u32, crc32c(contents)];
        let ranges =
            [section_entry::KIND, section_entry::OFFSET, section_entry::SECTION_LENGTH, section_entry::CHECKSUM];
        for (range, value) in ranges.into_iter().zip(values) {
            bytes[entry..][range].copy_from_slice(&value.to_le_bytes());
        }
        bytes.extend(contents);
    }

    bytes[header::MAGIC].copy_from_slice(&MAGIC);
    bytes[header::VERSION_MAJOR].copy_from_slice(&VERSION_MAJOR.to_le_bytes());
    bytes[header::VERSION_MINOR].copy_from_slice(&VERSION_MINOR.to_le_bytes());
    let length = bytes.len() as u32;
    bytes[header::FILE_LENGTH].copy_from_slice(&length.to_le_bytes());
    bytes[header::FAMILY] = family;
    bytes[header::SECTION_COUNT] = sections.len() as u8;
    for axis in 0..3 {
        put(&mut bytes, header::BOX_MIN.start + 4 * axis, box_min[axis]);
        put(&mut bytes, header::BOX_MAX.start + 4 * axis, box_min[axis] + extent[axis]);
    }
    put(&mut bytes, header::DIAGONAL.start, 1.0);
    put(&mut bytes, header::LIPSCHITZ.start, 1.0);
    seal(&mut bytes);
    bytes
}

fn put(bytes: &mut [u8], at: usize, value: f32) {
    bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
}

/// Makes the checksum of the header right again.
pub(super) fn seal(bytes: &mut [u8]) {
    let table = usize::from(bytes[header::SECTION_COUNT]) * section_entry::LENGTH;
    bytes[header::CHECKSUM].fill(0);
    let checksum = crc32c(&bytes[..header::LENGTH + table]);
    bytes[header::CHECKSUM].copy_from_slice(&checksum.to_le_bytes());
}

/// Opens bytes that must be valid.
pub(super) fn open(bytes: &[u8]) -> Field<'_> {
    let field = Field::open(bytes).expect("the file opens");
    field.validate().expect("the file is valid");
    field
}

pub(super) fn leaf(block: usize) -> u32 {
    node::LEAF << node::OFFSET_BITS | block as u32
}

pub(super) fn inner(group: usize) -> u32 {
    node::INNER << node::OFFSET_BITS | group as u32
}

/// The corners of octant 0 and all 27 lattice samples.
pub(super) const CORNERS: u32 = 0b000_011_011 | 0b000_011_011 << 9;
pub(super) const ALL: u32 = block::LATTICE_MASK;

/// Lattice coordinates of the samples in a mask, in the order of the file.
pub(super) fn lattice(mask: u32) -> impl Iterator<Item = [f64; 3]> {
    let bits = (0..block::LATTICE).filter(move |bit| mask >> bit & 1 == 1);
    bits.map(|bit| [bit % 3, bit / 3 % 3, bit / 9].map(f64::from))
}

/// A block: its header, and what is put after it.
pub(super) fn block(
    present: u32,
    full: u32,
    precision: u32,
    base: i32,
    data: impl IntoIterator<Item = u32>,
) -> Vec<u32> {
    let header = [present | precision << block::PRECISION_SHIFT, full, base.cast_unsigned()];
    header.into_iter().chain(data).collect()
}

/// A trilinear leaf of `f32` distances.
pub(super) fn trilinear(distance: impl Fn([f64; 3]) -> f64) -> File {
    let data = lattice(CORNERS).map(|point| (distance(point) as f32).to_bits());
    let samples = block(CORNERS, 0, crate::layout::precision::F32, 0, data);
    File::one_leaf(interpolant::TRILINEAR, samples)
}

/// The words of two half floats each, from numbers that are halves exactly.
pub(super) fn halves(values: &[f32]) -> Vec<u32> {
    let half = |value: &f32| {
        let exact = (0..=u16::MAX).find(|&bits| sample::decode_half(bits) == *value);
        u32::from(exact.expect("the number is a half float"))
    };
    values.chunks(2).map(|pair| half(&pair[0]) | half(&pair[1]) << 16).collect()
}

/// Numbers without pattern: xorshift (Marsaglia 2003).
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed | 1)
    }

    pub(super) fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) as u32
    }

    /// From 0 up to 1.
    pub(super) fn unit(&mut self) -> f32 {
        (self.word() >> 8) as f32 / (1 << 24) as f32
    }

    pub(super) fn point(&mut self) -> [f32; 3] {
        [self.unit(), self.unit(), self.unit()]
    }

    /// A first-order sample that a valid file may hold.
    pub(super) fn packed_sample(&mut self) -> u32 {
        (self.word() % 1023) | ((self.word() % 1023) << 10) | ((self.word() & 0xFFF) << 20)
    }
}

/// A root cell divided once: eight leaves on one block.
pub(super) fn divided(samples: Vec<u32>) -> File {
    let mut file = File::one_leaf(interpolant::TRICUBIC, samples);
    file.depth = 1;
    file.nodes = [inner(1)].into_iter().chain([leaf(0); 8]).collect();
    file
}

/// Three root cells: a leaf, one divided into eight leaves, and one divided into seven leaves and
/// again eight; random packed samples.
pub(super) fn three_levels() -> File {
    let mut random = Random::new(5);
    let mut samples = Vec::new();
    let mut put_block = |present: u32| {
        let start = samples.len();
        let data = lattice(present).map(|_| random.packed_sample());
        samples.extend(block(present, 0, crate::layout::precision::PACKED32, -2000, data));
        leaf(start)
    };

    let root_leaf = put_block(CORNERS);
    let middle = put_block(ALL);
    let coarse = put_block(ALL);
    let fine = put_block(ALL);
    let mut nodes = std::vec![root_leaf, inner(3), inner(11)];
    nodes.extend([middle; 8]);
    nodes.extend([coarse, coarse, coarse, inner(19), coarse, coarse, coarse, coarse]);
    nodes.extend([fine; 8]);

    File { root_cells: [3, 1, 1], depth: 2, nodes, ..File::one_leaf(interpolant::TRICUBIC, samples) }
}
