//! The octree: its parameters, and from a point to the leaf that holds it.

use crate::bytes::{Words, f32_at, u8_at, u16x3_at, u32_at};
use crate::error::Error;
use crate::header::Aabb;
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

/// A leaf of an octree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Levels below the root grid.
    pub level: u8,
    /// Least corner, in finest cells from the least corner of the box.
    pub cell: [u32; 3],
    /// Edge, in finest cells: a power of two.
    pub edge: u32,
    /// Word of its sample block in the sample section.
    pub(crate) block: u32,
    /// Which child of its parent it is: x | y << 1 | z << 2. A root cell counts as child 0.
    pub(crate) octant: u32,
}

/// The octree of a field: what a query works with.
#[derive(Clone, Copy, Debug)]
pub struct Octree<'a> {
    pub(crate) nodes: Words<'a>,
    pub(crate) samples: Words<'a>,
    bounds: Aabb,
    /// Finest cells per mesh unit.
    cells_per_unit: f32,
    root_cells: [u32; 3],
    /// Finest cells along each axis.
    lattice: [u32; 3],
    /// The same as numbers.
    lattice_edge: [f32; 3],
    depth: u8,
    interpolant: Interpolant,
    continuity: Continuity,
    root_edge: f32,
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

        let depth = u8_at(parameters, at::DEPTH);
        let root_cells = u16x3_at(parameters, at::ROOT_CELLS).map(u32::from);
        let in_lattice = |&cells: &u32| cells >= 1 && cells <= at::MAX_LATTICE >> depth;
        if depth > at::MAX_DEPTH || !root_cells.iter().all(in_lattice) {
            return Err(Error::OctreeLattice);
        }
        let root_count: u64 = root_cells.iter().map(|&cells| u64::from(cells)).product();
        if root_count > nodes.len() as u64 {
            return Err(Error::NodeLength);
        }

        let root_edge = f32_at(parameters, at::ROOT_EDGE);
        let quantum = f32_at(parameters, at::QUANTUM);
        if !(limit::MIN_ROOT_EDGE..=limit::MAX_MAGNITUDE).contains(&root_edge)
            || !(limit::MIN_QUANTUM..=root_edge).contains(&quantum)
        {
            return Err(Error::OctreeScale);
        }
        check_bounds(bounds, root_cells, root_edge)?;

        Ok(Self {
            nodes,
            samples,
            bounds,
            cells_per_unit: (1_u32 << depth) as f32 / root_edge,
            root_cells,
            lattice: root_cells.map(|cells| cells << depth),
            lattice_edge: root_cells.map(|cells| (cells << depth) as f32),
            depth,
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
            root_edge,
            quantum,
            leaf_count: u32_at(parameters, at::LEAF_COUNT),
        })
    }

    /// Cells of the root grid along x, y, z; each at least 1.
    pub fn root_cells(&self) -> [u32; 3] {
        self.root_cells
    }

    /// Levels below the root grid, at most 16: a root cell is `1 << depth` finest cells wide.
    pub fn depth(&self) -> u8 {
        self.depth
    }

    /// Edge of a root cell, mesh units, positive.
    pub fn root_edge(&self) -> f32 {
        self.root_edge
    }

    /// Edge of a cell at a level, mesh units.
    pub fn edge(&self, level: u8) -> f32 {
        self.root_edge * math::power_of_half(level)
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
        self.bounds
    }

    /// Finest cells along x, y, z, at most 2²⁰.
    pub fn lattice(&self) -> [u32; 3] {
        self.lattice
    }

    /// Words of the root grid: at most those of the node section.
    pub(crate) fn root_count(&self) -> usize {
        self.root_cells.iter().map(|&cells| cells as usize).product()
    }

    /// Whether a point lies in the box, faces included. False for a NaN.
    #[inline]
    pub(crate) fn contains(&self, point: [f32; 3]) -> bool {
        let Aabb { min, max } = &self.bounds;
        let [x, y, z] = point;
        // Not short-circuited: one branch that is well predicted beats six.
        (x >= min[0]) & (x <= max[0]) & (y >= min[1]) & (y <= max[1]) & (z >= min[2]) & (z <= max[2])
    }

    /// The leaf that holds a point of the box, and where in the leaf the point is, 0 to 1.
    ///
    /// Only the subtraction of the box's corner and the product round: the cell and the local
    /// coordinates follow from the product exactly. A point on a face between leaves belongs to
    /// the greater one.
    #[inline]
    pub(crate) fn locate(&self, point: [f32; 3]) -> (Leaf, [f32; 3]) {
        let position = self.position(point);
        let leaf = self.leaf_at(position.map(|cells| cells as u32));
        (leaf, self.local(&leaf, position))
    }

    /// A point of the box in finest cells from the least corner of the box.
    #[inline]
    pub(crate) fn position(&self, point: [f32; 3]) -> [f32; 3] {
        [0, 1, 2].map(|axis: usize| {
            let cells = (point[axis] - self.bounds.min[axis]) * self.cells_per_unit;
            let limit = self.lattice_edge[axis];
            // Never a NaN: one comparison does.
            if cells < limit { cells } else { limit }
        })
    }

    /// Local coordinates of a position, 0 to 1 within the leaf.
    #[inline]
    pub(crate) fn local(&self, leaf: &Leaf, position: [f32; 3]) -> [f32; 3] {
        let scale = math::power_of_half(self.depth.saturating_sub(leaf.level));
        [0, 1, 2].map(|axis: usize| (position[axis] - leaf.cell[axis] as f32) * scale)
    }

    /// Whether a leaf holds a position: whether [`leaf_at`](Self::leaf_at) would find it.
    #[inline]
    pub(crate) fn holds(&self, leaf: &Leaf, position: [f32; 3]) -> bool {
        let is_in = [0, 1, 2].map(|axis: usize| {
            let cell = (position[axis] as u32).min(self.lattice[axis] - 1);
            cell ^ leaf.cell[axis] < leaf.edge
        });
        is_in == [true; 3]
    }

    /// The leaves, depth first.
    pub fn leaves(&self) -> Leaves<'a> {
        Leaves { octree: *self, next: Some([0; 3]) }
    }

    /// Least corner of the leaf that follows, found by counting up in octal digits of octants.
    fn cell_after(&self, leaf: &Leaf) -> Option<[u32; 3]> {
        let [mut x, mut y, mut z] = leaf.cell;
        for shift in self.depth - leaf.level.min(self.depth)..self.depth {
            let octant = (x >> shift & 1) | (y >> shift & 1) << 1 | (z >> shift & 1) << 2;
            let next = (octant + 1) & 7;
            let set = |digit: u32, bit: u32| digit & !(1 << shift) | (next >> bit & 1) << shift;
            (x, y, z) = (set(x, 0), set(y, 1), set(z, 2));
            if next != 0 {
                return Some([x, y, z]);
            }
        }

        // The next root cell.
        let step = 1 << self.depth;
        x += step;
        if x >= self.lattice[0] {
            (x, y) = (0, y + step);
        }
        if y >= self.lattice[1] {
            (y, z) = (0, z + step);
        }
        (z < self.lattice[2]).then_some([x, y, z])
    }

    /// The leaf that holds a finest cell; cells beyond the lattice count as its last.
    #[inline]
    pub fn leaf_at(&self, lattice: [u32; 3]) -> Leaf {
        let x = lattice[0].min(self.lattice[0] - 1);
        let y = lattice[1].min(self.lattice[1] - 1);
        let z = lattice[2].min(self.lattice[2] - 1);

        // The root grid, x fastest.
        let mut shift = u32::from(self.depth);
        let row = (y >> shift) as usize + self.root_cells[1] as usize * (z >> shift) as usize;
        let root = (x >> shift) as usize + self.root_cells[0] as usize * row;
        let mut word = self.nodes.word(root);
        let mut octant = 0;

        // Down the tree, never below the deepest level.
        while word >> node::OFFSET_BITS == node::INNER && shift > 0 {
            shift -= 1;
            octant = (x >> shift & 1) | (y >> shift & 1) << 1 | (z >> shift & 1) << 2;
            word = self.nodes.word((word & node::OFFSET_MASK) as usize + octant as usize);
        }

        let align = u32::MAX << shift;
        Leaf {
            level: self.depth - shift as u8,
            cell: [x & align, y & align, z & align],
            edge: 1 << shift,
            block: word & node::OFFSET_MASK,
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
        self.next = self.octree.cell_after(&leaf);
        Some(leaf)
    }
}

/// Checks that the box is the root grid (SPEC.md §5.4).
fn check_bounds(bounds: Aabb, root_cells: [u32; 3], root_edge: f32) -> Result<(), Error> {
    for ((min, max), cells) in bounds.min.into_iter().zip(bounds.max).zip(root_cells) {
        let extent = cells as f32 * root_edge;
        let largest = extent.max(min.abs()).max(max.abs());
        if (max - (min + extent)).abs() > limit::BOX_TOLERANCE * largest {
            return Err(Error::OctreeBounds);
        }
    }
    Ok(())
}
