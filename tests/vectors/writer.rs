//! Writes files a field at a time, in the order of SPEC.md and with nothing of the reader's or the baker's: every
//! number can be wrong.

use crc32c::{crc32c, crc32c_append};
use std::collections::VecDeque;

const HEADER_LENGTH: usize = 128;
const ENTRY_LENGTH: usize = 16;

/// What the header says (§3), apart from lengths and checksums, and the sections (§4).
#[derive(Clone)]
pub(crate) struct File {
    pub(crate) version: [u16; 2],
    pub(crate) family: u8,
    pub(crate) sign_method: u8,
    pub(crate) reserved: u8,
    pub(crate) box_min: [f32; 3],
    pub(crate) box_max: [f32; 3],
    /// Diagonal, target error, Lipschitz bound.
    pub(crate) quantities: [f32; 3],
    /// RMSE, 99th percentile and maximum, uniform and in the band, and the seam.
    pub(crate) contract: [f32; 7],
    pub(crate) sample_count: u32,
    pub(crate) doubtful_signs: u32,
    pub(crate) hashes: [u8; 24],
    pub(crate) baker_version: u32,
    pub(crate) unused: u32,
    pub(crate) sections: Vec<([u8; 4], Vec<u8>)>,
}

impl File {
    /// Sections in a box, with plausible numbers for the rest.
    pub(crate) fn holding(family: u8, [box_min, box_max]: [[f32; 3]; 2], sections: Vec<([u8; 4], Vec<u8>)>) -> Self {
        Self {
            version: [1, 0],
            family,
            sign_method: 1,
            reserved: 0,
            box_min,
            box_max,
            quantities: [1.5, 0.01, 2.0],
            contract: [0.01, 0.02, 0.05, 0.01, 0.02, 0.04, 0.03],
            sample_count: 100_000,
            doubtful_signs: 7,
            hashes: std::array::from_fn(|index| index as u8 + 1),
            baker_version: 1 << 16 | 2 << 8 | 3,
            unused: 0,
            sections,
        }
    }

    /// The bytes, with the sections one after the other and the right checksums.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let mut table = Vec::new();
        let mut offset = HEADER_LENGTH + self.sections.len() * ENTRY_LENGTH;
        for (kind, contents) in &self.sections {
            table.extend(kind);
            for word in [offset as u32, contents.len() as u32, crc32c(contents)] {
                table.extend(word.to_le_bytes());
            }
            offset += contents.len();
        }

        let mut bytes = b"\x89NFD\r\n\x1a\n".to_vec();
        bytes.extend(self.version.iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend((offset as u32).to_le_bytes());
        bytes.extend([self.family, self.sign_method, self.sections.len() as u8, self.reserved]);
        bytes.extend([0; 4]);
        let numbers = [&self.box_min[..], &self.box_max, &self.quantities, &self.contract].concat();
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend([self.sample_count, self.doubtful_signs].iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend(self.hashes);
        bytes.extend([self.baker_version, self.unused].iter().flat_map(|number| number.to_le_bytes()));
        assert_eq!(bytes.len(), HEADER_LENGTH, "a header");

        bytes.extend(table);
        for (_, contents) in &self.sections {
            bytes.extend(contents);
        }
        seal(&mut bytes);
        bytes
    }
}

/// Where an entry of the section table begins.
pub(crate) fn entry(index: usize) -> usize {
    HEADER_LENGTH + index * ENTRY_LENGTH
}

/// Makes the checksum of header and table right (§3.4).
pub(crate) fn seal(bytes: &mut [u8]) {
    let table_end = entry(bytes[18].into()).min(bytes.len());
    let before = crc32c_append(crc32c(&bytes[..20]), &[0; 4]);
    let checksum = crc32c_append(before, &bytes[24..table_end]);
    put(bytes, 20, checksum);
}

/// Writes a word.
pub(crate) fn put(bytes: &mut [u8], at: usize, word: u32) {
    bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
}

/// The bytes of words.
pub(crate) fn little_endian(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// The octree of a file (§5 to §7), and the least corner of its box.
#[derive(Clone)]
pub(crate) struct Octree {
    pub(crate) box_min: [f32; 3],
    pub(crate) root_cells: [u16; 3],
    pub(crate) depth: u8,
    pub(crate) interpolant: u8,
    pub(crate) continuity: u8,
    pub(crate) reserved: [u8; 3],
    pub(crate) root_edge: f32,
    pub(crate) quantum: f32,
    pub(crate) leaf_count: u32,
    pub(crate) nodes: Vec<u32>,
    pub(crate) samples: Vec<u32>,
}

pub(crate) const TRILINEAR: u8 = 0;
pub(crate) const TRICUBIC: u8 = 1;

impl Octree {
    /// A tree below a row of root cells of edge 2 along x; `block` gives the words of the block of each group that has
    /// leaves, from the samples that they need.
    pub(crate) fn new(interpolant: u8, roots: Vec<Cell>, block: impl FnMut(u32) -> Vec<u32>) -> Self {
        let root_cells = [roots.len() as u16, 1, 1];
        let depth = roots.iter().map(Cell::depth).max().expect("a root cell");
        let (nodes, samples) = lay_out(roots, block);
        Self {
            box_min: [1.0, 2.0, 3.0],
            root_cells,
            depth,
            interpolant,
            continuity: 0,
            reserved: [0; 3],
            root_edge: 2.0,
            quantum: 1.0 / 256.0,
            leaf_count: nodes.iter().filter(|&word| word >> 28 == 1).count() as u32,
            nodes,
            samples,
        }
    }

    /// A file that holds the octree.
    pub(crate) fn file(&self) -> File {
        let box_max = [0, 1, 2].map(|axis| self.box_min[axis] + f32::from(self.root_cells[axis]) * self.root_edge);
        let sections = vec![
            (*b"OCTR", self.parameters()),
            (*b"NODE", little_endian(&self.nodes)),
            (*b"SAMP", little_endian(&self.samples)),
        ];
        File::holding(2, [self.box_min, box_max], sections)
    }

    fn parameters(&self) -> Vec<u8> {
        let mut bytes: Vec<u8> = self.root_cells.iter().flat_map(|cells| cells.to_le_bytes()).collect();
        bytes.extend([self.depth, self.interpolant, self.continuity]);
        bytes.extend(self.reserved);
        bytes.extend(self.root_edge.to_le_bytes());
        bytes.extend(self.quantum.to_le_bytes());
        bytes.extend(self.leaf_count.to_le_bytes());
        bytes
    }
}

/// A cell of a tree to be.
#[derive(Clone)]
pub(crate) enum Cell {
    Leaf,
    Inner(Box<[Cell; 8]>),
}

impl Cell {
    /// Eight leaves.
    pub(crate) fn divided() -> Self {
        Self::with_children(|_| Self::Leaf)
    }

    pub(crate) fn with_children(child: impl FnMut(usize) -> Self) -> Self {
        Self::Inner(Box::new(std::array::from_fn(child)))
    }

    fn depth(&self) -> u8 {
        match self {
            Self::Leaf => 0,
            Self::Inner(children) => 1 + children.iter().map(Self::depth).max().unwrap_or(0),
        }
    }
}

/// Node words and sample words in the order of §6 and §7.
fn lay_out(roots: Vec<Cell>, mut block: impl FnMut(u32) -> Vec<u32>) -> (Vec<u32>, Vec<u32>) {
    let (mut nodes, mut samples) = (Vec::new(), Vec::new());
    let mut next_group = roots.len() as u32;
    let mut groups: VecDeque<Vec<Cell>> = roots.into_iter().map(|root| vec![root]).collect();
    while let Some(group) = groups.pop_front() {
        let leaves = group.iter().enumerate().filter(|(_, cell)| matches!(cell, Cell::Leaf));
        let needed = leaves.fold(0, |needed, (child, _)| needed | corners(child as u32));
        let start = samples.len() as u32;
        if needed != 0 {
            samples.extend(block(needed));
        }
        for cell in group {
            match cell {
                Cell::Leaf => nodes.push(1 << 28 | start),
                Cell::Inner(children) => {
                    nodes.push(next_group);
                    next_group += 8;
                    groups.push_back(children.to_vec());
                }
            }
        }
    }
    (nodes, samples)
}

/// The samples that a child needs, as bits (§7).
pub(crate) fn corners(child: u32) -> u32 {
    let least = (child & 1) + 3 * (child >> 1 & 1) + 9 * (child >> 2);
    0b011_011_000_011_011 << least
}
