//! Polynomial octrees (§12), a field at a time, with nothing of the reader's or the baker's.

use super::writer::{File, little_endian};
use std::collections::{BTreeSet, VecDeque};

pub(crate) const SINGLE: u8 = 0;
pub(crate) const MIN: u8 = 1;
pub(crate) const MAX: u8 = 2;

/// How many coefficients each degree has.
pub(crate) const TERMS: [usize; 4] = [1, 3, 6, 10];

/// How leaves are made (§12.4), in the order of the file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Shape {
    pub(crate) kind: u8,
    pub(crate) degrees: [u8; 2],
    pub(crate) exponent: u8,
    pub(crate) widths: [u8; 4],
}

impl Shape {
    /// The widths of all coefficients of a leaf.
    pub(crate) fn widths(&self) -> impl Iterator<Item = u8> {
        let polynomials = if self.kind == SINGLE { 1 } else { 2 };
        let degrees = self.degrees.into_iter().take(polynomials).flat_map(|degree| 0..=usize::from(degree));
        degrees.flat_map(|degree| std::iter::repeat_n(self.widths[degree], TERMS[degree]))
    }
}

/// A leaf: its shape, and its coefficients in steps, in the order of the file (§12.5).
#[derive(Clone, Debug)]
pub(crate) struct Leaf {
    pub(crate) shape: Shape,
    pub(crate) coefficients: Vec<i32>,
}

/// A cell of a tree to be.
#[derive(Clone, Debug)]
pub(crate) enum Cell {
    Leaf(Leaf),
    Inner(Box<[Cell; 8]>),
}

impl Cell {
    pub(crate) fn with_children(child: impl FnMut(usize) -> Self) -> Self {
        Self::Inner(Box::new(std::array::from_fn(child)))
    }

    fn depth(&self) -> u8 {
        match self {
            Self::Leaf(_) => 0,
            Self::Inner(children) => 1 + children.iter().map(Self::depth).max().unwrap_or(0),
        }
    }
}

/// A leaf where it lies, in finest cells, and its codes (§12.6).
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    pub(crate) leaf: Leaf,
    pub(crate) cell: [i64; 3],
    pub(crate) edge: i64,
    pub(crate) support: u32,
    pub(crate) reach: u32,
}

impl Placed {
    /// Whether the closed cells have a point in common.
    pub(crate) fn touches(&self, other: &Self) -> bool {
        (0..3).all(|axis| {
            self.cell[axis] <= other.cell[axis] + other.edge && other.cell[axis] <= self.cell[axis] + self.edge
        })
    }
}

/// The octree of a file, and the least corner of its box.
#[derive(Clone)]
pub(crate) struct PolynomialOctree {
    pub(crate) box_min: [f32; 3],
    pub(crate) root_cells: [u16; 3],
    pub(crate) depth: u8,
    pub(crate) shape_bits: u8,
    pub(crate) continuity: u8,
    pub(crate) reserved: [u8; 3],
    pub(crate) root_edge: f32,
    pub(crate) quantum: f32,
    pub(crate) overlap: f32,
    pub(crate) leaf_count: u32,
    pub(crate) shapes: Vec<Shape>,
    pub(crate) roots: Vec<u32>,
    /// Inner mask, starts, child, leaf.
    pub(crate) records: Vec<Record>,
    /// In the order of the file.
    pub(crate) leaves: Vec<Placed>,
    /// Which of the root cells, and then of the children of each record, are inner nodes.
    pub(crate) groups: Vec<Vec<bool>>,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Record {
    pub(crate) inner: u8,
    pub(crate) starts: [u8; 7],
    pub(crate) child: u64,
    pub(crate) leaf: u64,
}

impl PolynomialOctree {
    /// A tree below root cells of edge 2, x fastest.
    pub(crate) fn new(root_cells: [u16; 3], roots: Vec<Cell>, overlap: f32) -> Self {
        let depth = roots.iter().map(Cell::depth).max().expect("a root cell");
        let mut octree = Self {
            box_min: [1.0, 2.0, 3.0],
            root_cells,
            depth,
            shape_bits: 1,
            continuity: if overlap == 0.0 { 0 } else { 2 },
            reserved: [0; 3],
            root_edge: 2.0,
            quantum: 1.0 / 1024.0,
            overlap,
            leaf_count: 0,
            shapes: Vec::new(),
            roots: Vec::new(),
            records: Vec::new(),
            leaves: Vec::new(),
            groups: Vec::new(),
        };
        octree.lay_out(roots);
        octree
    }

    /// Everything in the order of §12.3.
    fn lay_out(&mut self, roots: Vec<Cell>) {
        let edge = 1_i64 << self.depth;
        let [x, y, _] = self.root_cells.map(i64::from);
        let place = |root: i64| [root % x * edge, root / x % y * edge, root / (x * y) * edge];
        let mut groups = VecDeque::from([(edge, (0..).map(place).zip(roots).collect::<Vec<_>>())]);
        while let Some((edge, cells)) = groups.pop_front() {
            self.groups.push(cells.iter().map(|(_, cell)| matches!(cell, Cell::Inner(_))).collect());
            for (cell, content) in cells {
                match content {
                    Cell::Leaf(leaf) => self.leaves.push(Placed { leaf, cell, edge, support: 0, reach: 3 }),
                    Cell::Inner(children) => {
                        let half = edge / 2;
                        let corner = |child: i64| [0, 1, 2].map(|axis: usize| cell[axis] + (child >> axis & 1) * half);
                        groups.push_back((half, (0..).map(corner).zip(*children).collect()));
                    }
                }
            }
        }

        self.leaf_count = self.leaves.len() as u32;
        let shapes: BTreeSet<Shape> = self.leaves.iter().map(|placed| placed.leaf.shape.clone()).collect();
        self.shapes = shapes.into_iter().collect();
        self.shape_bits = (self.shapes.len().next_power_of_two().trailing_zeros() as u8).max(1);
        if self.overlap != 0.0 {
            self.find_codes();
        }
        self.number();
    }

    /// Root words and records, by counting.
    pub(crate) fn number(&mut self) {
        self.roots.clear();
        self.records.clear();
        let lengths: Vec<usize> = self.leaves.iter().map(|placed| self.bits(placed).len().div_ceil(8)).collect();
        let (mut next_record, mut next_leaf, mut byte) = (0, 0, 0);
        for (index, cells) in self.groups.iter().enumerate() {
            let mut record = Record { child: u64::from(next_record), leaf: byte as u64, inner: 0, starts: [0; 7] };
            let first_byte = byte;
            for (child, &is_inner) in cells.iter().enumerate() {
                if index == 0 {
                    self.roots.push(if is_inner { next_record } else { 1 << 31 | byte as u32 });
                } else if child > 0 {
                    let start =
                        if is_inner { u64::from(next_record) - record.child } else { (byte - first_byte) as u64 };
                    record.starts[child - 1] = start.try_into().expect("leaves of a record in 255 bytes");
                }
                if is_inner {
                    record.inner |= (1_u32 << (child & 7)) as u8;
                    next_record += 1;
                } else {
                    byte += lengths[next_leaf];
                    next_leaf += 1;
                }
            }
            if index > 0 {
                self.records.push(record);
            }
        }
    }

    /// Support and reach of every leaf, from every other.
    fn find_codes(&mut self) {
        let leaves = &self.leaves;
        let touching: Vec<Vec<usize>> = (0..leaves.len())
            .map(|own| (0..leaves.len()).filter(|&other| other != own && leaves[own].touches(&leaves[other])).collect())
            .collect();
        for (own, others) in touching.iter().enumerate() {
            let finest = others.iter().map(|&other| self.leaves[other].edge).min().unwrap_or(i64::MAX);
            let edge = self.leaves[own].edge;
            self.leaves[own].support = (0..3).take_while(|&levels| edge >> levels > finest).count() as u32;
        }
        for (own, others) in touching.iter().enumerate() {
            // Eighths of the overlap, in finest cells: exact.
            let reach_of = |other: &usize| (self.leaves[*other].edge * 8) >> self.leaves[*other].support;
            let greatest = others.iter().map(reach_of).max().unwrap_or(0);
            let edge = self.leaves[own].edge;
            let reach = (1..=3).rev().find(|&code| greatest <= (edge * 8) >> (code - 1)).unwrap_or(0);
            self.leaves[own].reach = reach;
        }
    }

    /// The bits of a leaf.
    pub(crate) fn bits(&self, placed: &Placed) -> Vec<bool> {
        let shape = &placed.leaf.shape;
        let number = self.shapes.iter().position(|known| known == shape).expect("a shape of the file");
        let mut bits = Vec::new();
        let mut put = |value: u64, width: u8| bits.extend((0..width).map(|bit| value >> bit & 1 == 1));
        put(number as u64, self.shape_bits);
        if self.overlap != 0.0 {
            put(placed.support.into(), 2);
            put(placed.reach.into(), 2);
        }
        let coefficients = &placed.leaf.coefficients;
        assert_eq!(coefficients.len(), shape.widths().count(), "coefficients of {shape:?}");
        for (&coefficient, width) in coefficients.iter().zip(shape.widths()).filter(|(_, width)| *width > 0) {
            let code = i64::from(coefficient) + (1 << (width - 1));
            assert!((0..1 << width).contains(&code), "{coefficient} in {width} bits");
            put(code as u64, width);
        }
        bits
    }

    /// The section of leaves.
    fn leaf_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        for placed in &self.leaves {
            let bits = self.bits(placed);
            bytes.extend(bits.chunks(8).map(|byte| byte.iter().rev().fold(0, |byte, &bit| byte << 1 | u8::from(bit))));
        }
        bytes.extend([0; 72]);
        padded(bytes)
    }

    /// A file that holds the octree.
    pub(crate) fn file(&self) -> File {
        let box_max = [0, 1, 2].map(|axis| self.box_min[axis] + f32::from(self.root_cells[axis]) * self.root_edge);
        let shape = |shape: &Shape| {
            let [first, second] = shape.degrees;
            [&[shape.kind, first, second, shape.exponent][..], &shape.widths].concat()
        };
        let record = |record: &Record| {
            let first = record.child | record.leaf << 21;
            [&[record.inner][..], &record.starts, &first.to_le_bytes()[..6]].concat()
        };
        let sections = vec![
            (*b"PTRE", self.parameters()),
            (*b"ROOT", little_endian(&self.roots)),
            (*b"SHPE", self.shapes.iter().flat_map(shape).collect()),
            (*b"TREE", padded(self.records.iter().flat_map(record).collect())),
            (*b"LEAF", self.leaf_bytes()),
        ];
        File::holding(3, [self.box_min, box_max], sections)
    }

    fn parameters(&self) -> Vec<u8> {
        let mut bytes: Vec<u8> = self.root_cells.iter().flat_map(|cells| cells.to_le_bytes()).collect();
        bytes.extend([self.depth, self.shape_bits, self.continuity]);
        bytes.extend(self.reserved);
        bytes.extend([self.root_edge, self.quantum, self.overlap].iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend(self.leaf_count.to_le_bytes());
        bytes
    }
}

/// Zeros up to a multiple of four.
fn padded(mut bytes: Vec<u8>) -> Vec<u8> {
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    bytes
}
