//! The octree: its parameters, and from a point to the leaf that holds it.

use crate::bytes::{Words, f32_at, u8_at, u16x3_at, u32_at};
use crate::error::Error;
use crate::header::Aabb;
use crate::lattice::{Lattice, Leaf};
use crate::layout::{continuity, interpolant, limit, node, octree as at, section};
use crate::{math, section as sections};

/// How a leaf answers between its corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Interpolant {
    /// Eight distances.
    Trilinear,
    /// Tensor-product cubic Hermite of eight distances and gradients (Pujol and Chica 2023, §4).
    Tricubic,
}

/// What happens at a face between leaves of different levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Continuity {
    /// Nothing is promised: see [`ErrorContract::seam_max`](crate::ErrorContract::seam_max).
    None,
    /// The value is continuous up to rounding.
    C0,
    /// Value and gradient are continuous up to rounding.
    C1,
}

/// The octree of a field: what a query works with.
#[derive(Clone, Copy, Debug)]
pub struct Octree<'a> {
    pub(crate) nodes: Words<'a>,
    pub(crate) samples: Words<'a>,
    pub(crate) lattice: Lattice,
    interpolant: Interpolant,
    continuity: Continuity,
    quantum: f32,
    leaf_count: u32,
}

impl<'a> Octree<'a> {
    /// The octree of a file whose header has been checked (SPEC.md §5).
    pub(crate) fn open(bytes: &'a [u8], bounds: Aabb) -> Result<Self, Error> {
        let parameter_section = sections::find(bytes, section::OCTREE)?;
        let parameters = sections::find_bytes(bytes, section::OCTREE)?;
        let nodes = Words::new(sections::find_bytes(bytes, section::NODES)?);
        let samples = Words::new(sections::find_bytes(bytes, section::SAMPLES)?);

        // Small enough to be summed in constant time, and every query rests on it.
        if parameters.len() != at::LENGTH {
            return Err(Error::OctreeLength);
        }
        sections::check_sum(bytes, &parameter_section)?;
        let [.., a, b, c] = parameters.get(..at::RESERVED.end).unwrap_or(&[]) else {
            return Err(Error::OctreeLength);
        };
        if a | b | c != 0 {
            return Err(Error::Reserved);
        }

        let root_edge = f32_at(parameters, at::ROOT_EDGE);
        let root_cells = u16x3_at(parameters, at::ROOT_CELLS);
        let lattice = Lattice::new(root_cells, u8_at(parameters, at::DEPTH), root_edge, bounds)?;
        if lattice.root_count() > nodes.len() as u64 {
            return Err(Error::NodeLength);
        }
        let quantum = f32_at(parameters, at::QUANTUM);
        if !(limit::MIN_QUANTUM..=root_edge).contains(&quantum) {
            return Err(Error::OctreeScale);
        }
        lattice.check_bounds()?;

        Ok(Self {
            nodes,
            samples,
            lattice,
            interpolant: match u8_at(parameters, at::INTERPOLANT) {
                interpolant::TRILINEAR => Interpolant::Trilinear,
                interpolant::TRICUBIC => Interpolant::Tricubic,
                _ => return Err(Error::Interpolant),
            },
            continuity: match u8_at(parameters, at::CONTINUITY) {
                continuity::NONE => Continuity::None,
                continuity::C0 => Continuity::C0,
                continuity::C1 => Continuity::C1,
                _ => return Err(Error::Continuity),
            },
            quantum,
            leaf_count: u32_at(parameters, at::LEAF_COUNT),
        })
    }

    /// Cells of the root grid along x, y, z; each at least 1.
    pub fn root_cells(&self) -> [u32; 3] {
        self.lattice.root_cells
    }

    /// Levels below the root grid, at most 16: a root cell is `1 << depth` finest cells wide.
    pub fn depth(&self) -> u8 {
        self.lattice.depth
    }

    /// Edge of a root cell, mesh units, positive.
    pub fn root_edge(&self) -> f32 {
        self.lattice.root_edge
    }

    /// Edge of a cell at a level, mesh units.
    pub fn edge(&self, level: u8) -> f32 {
        self.lattice.edge(level)
    }

    /// Step of a packed distance at a level, mesh units.
    pub fn quantum(&self, level: u8) -> f32 {
        self.quantum * math::power_of_half(level)
    }

    /// How leaves answer between their corners.
    pub fn interpolant(&self) -> Interpolant {
        self.interpolant
    }

    /// What the baker promises across faces between leaves of different levels.
    pub fn continuity(&self) -> Continuity {
        self.continuity
    }

    /// Leaves of the tree.
    pub fn leaf_count(&self) -> u32 {
        self.leaf_count
    }

    /// The box that the root grid fills.
    pub fn bounds(&self) -> Aabb {
        self.lattice.bounds()
    }

    /// Finest cells along x, y, z, at most 2²⁰.
    pub fn lattice(&self) -> [u32; 3] {
        self.lattice.cells()
    }

    /// Words of the root grid: at most those of the node section.
    pub(crate) fn root_count(&self) -> usize {
        self.lattice.root_count() as usize
    }

    /// The leaf that holds a point of the box, and where in the leaf the point is, 0 to 1.
    ///
    /// Only the subtraction of the box's corner and the product round: the cell and the local
    /// coordinates follow from the product exactly. A point on a face between leaves belongs to
    /// the greater one.
    #[inline(never)]
    pub(crate) fn locate(&self, point: [f32; 3]) -> (Leaf, [f32; 3]) {
        let position = self.lattice.position(point);
        let leaf = self.leaf_in(self.lattice.cell_of(position));
        (leaf, self.lattice.local(&leaf, position))
    }

    /// The leaves, depth first.
    pub fn leaves(&self) -> Leaves<'a> {
        Leaves { octree: *self, next: Some([0; 3]) }
    }

    /// The leaf that holds a finest cell; cells beyond the lattice count as its last.
    #[inline]
    pub fn leaf_at(&self, cell: [u32; 3]) -> Leaf {
        self.leaf_in(self.lattice.clamp(cell))
    }

    /// The leaf that holds a finest cell of the lattice.
    #[inline]
    pub(crate) fn leaf_in(&self, cell @ [x, y, z]: [u32; 3]) -> Leaf {
        let mut word = self.nodes.word(self.lattice.root_of(cell));
        let mut shift = u32::from(self.lattice.depth);
        let mut octant = 0;

        // Down the tree, never below the deepest level.
        while word >> node::OFFSET_BITS == node::INNER && shift > 0 {
            shift -= 1;
            octant = (x >> shift & 1) | (y >> shift & 1) << 1 | (z >> shift & 1) << 2;
            word = self.nodes.word((word & node::OFFSET_MASK) as usize + octant as usize);
        }

        let align = u32::MAX << shift;
        Leaf {
            level: self.lattice.depth - shift as u8,
            cell: [x & align, y & align, z & align],
            edge: 1 << shift,
            place: word & node::OFFSET_MASK,
            octant,
        }
    }
}

/// The leaves of an octree: the root grid x fastest, below it depth first, the octants of a cell in
/// the order of their numbers.
#[derive(Clone, Debug)]
pub struct Leaves<'a> {
    octree: Octree<'a>,
    /// Least corner of the next leaf.
    next: Option<[u32; 3]>,
}

impl Iterator for Leaves<'_> {
    type Item = Leaf;

    fn next(&mut self) -> Option<Leaf> {
        let leaf = self.octree.leaf_at(self.next?);
        self.next = self.octree.lattice.cell_after(&leaf);
        Some(leaf)
    }
}
