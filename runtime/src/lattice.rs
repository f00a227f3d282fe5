//! The box of an octree and the lattice of its finest cells: from a point to a cell, and from a leaf to the next.

use crate::error::Error;
use crate::header::Aabb;
use crate::layout::{limit, octree as at};
use crate::math;

/// A leaf of an octree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Levels below the root grid.
    pub level: u8,
    /// Least corner, in finest cells from the least corner of the box.
    pub cell: [u32; 3],
    /// Edge, in finest cells: a power of two.
    pub edge: u32,
    /// Where its data are: the word of its block in the section of samples, or its byte in the section of leaves.
    pub(crate) place: u32,
    /// Which child of its parent it is: x | y << 1 | z << 2. A root cell counts as child 0.
    pub(crate) octant: u32,
}

/// A root grid of cubes, each divided into finest cells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lattice {
    pub(crate) bounds: Aabb,
    /// Finest cells per mesh unit.
    cells_per_unit: f32,
    pub(crate) root_cells: [u32; 3],
    /// Finest cells along each axis.
    pub(crate) cells: [u32; 3],
    /// The same as numbers.
    extent: [f32; 3],
    /// Levels below the root grid.
    pub(crate) depth: u8,
    /// Edge of a root cell, mesh units.
    pub(crate) root_edge: f32,
}

impl Lattice {
    /// Checks the numbers of SPEC.md §5.1 and §5.4 apart from the box.
    pub(crate) fn new(root_cells: [u16; 3], depth: u8, root_edge: f32, bounds: Aabb) -> Result<Self, Error> {
        let root_cells = root_cells.map(u32::from);
        let in_lattice = |&cells: &u32| cells >= 1 && cells <= at::MAX_LATTICE >> depth;
        if depth > at::MAX_DEPTH || !root_cells.iter().all(in_lattice) {
            return Err(Error::OctreeLattice);
        }
        if !(limit::MIN_ROOT_EDGE..=limit::MAX_MAGNITUDE).contains(&root_edge) {
            return Err(Error::OctreeScale);
        }
        Ok(Self {
            bounds,
            cells_per_unit: (1_u32 << depth) as f32 / root_edge,
            root_cells,
            cells: root_cells.map(|cells| cells << depth),
            extent: root_cells.map(|cells| (cells << depth) as f32),
            depth,
            root_edge,
        })
    }

    /// Checks that the box is the root grid (SPEC.md §5.4).
    pub(crate) fn check_bounds(&self) -> Result<(), Error> {
        let Aabb { min, max } = self.bounds;
        for ((min, max), cells) in min.into_iter().zip(max).zip(self.root_cells) {
            let extent = cells as f32 * self.root_edge;
            let largest = extent.max(min.abs()).max(max.abs());
            if (max - (min + extent)).abs() > limit::BOX_TOLERANCE * largest {
                return Err(Error::OctreeBounds);
            }
        }
        Ok(())
    }

    /// Cells of the root grid: below 2⁶⁰.
    pub(crate) fn root_count(&self) -> u64 {
        self.root_cells.iter().map(|&cells| u64::from(cells)).product()
    }

    /// Edge of a cell at a level, mesh units.
    #[inline]
    pub(crate) fn edge(&self, level: u8) -> f32 {
        self.root_edge * math::power_of_half(level)
    }

    /// Whether a point lies in the box, faces included. False for a NaN.
    #[inline]
    pub(crate) fn contains(&self, point: [f32; 3]) -> bool {
        let Aabb { min, max } = &self.bounds;
        let [x, y, z] = point;
        // Not short-circuited: one branch that is well predicted beats six.
        (x >= min[0]) & (x <= max[0]) & (y >= min[1]) & (y <= max[1]) & (z >= min[2]) & (z <= max[2])
    }

    /// A point of the box in finest cells from the least corner of the box.
    ///
    /// Only the subtraction and the product round: the cell and the local coordinates follow from the
    /// product exactly.
    #[inline]
    pub(crate) fn position(&self, point: [f32; 3]) -> [f32; 3] {
        [0, 1, 2].map(|axis: usize| {
            let cells = (point[axis] - self.bounds.min[axis]) * self.cells_per_unit;
            let limit = self.extent[axis];
            // Never a NaN: one comparison does.
            if cells < limit { cells } else { limit }
        })
    }

    /// The finest cell itself, or the nearest of the lattice.
    #[inline]
    pub(crate) fn clamp(&self, cell: [u32; 3]) -> [u32; 3] {
        [0, 1, 2].map(|axis: usize| cell[axis].min(self.cells[axis] - 1))
    }

    /// Number of the root cell that holds a finest cell of the lattice, x fastest.
    #[inline]
    pub(crate) fn root_of(&self, [x, y, z]: [u32; 3]) -> usize {
        let shift = u32::from(self.depth);
        let row = (y >> shift) as usize + self.root_cells[1] as usize * (z >> shift) as usize;
        (x >> shift) as usize + self.root_cells[0] as usize * row
    }

    /// Local coordinates of a position, 0 to 1 within the leaf.
    #[inline]
    pub(crate) fn local(&self, leaf: &Leaf, position: [f32; 3]) -> [f32; 3] {
        let scale = math::power_of_half(self.depth.saturating_sub(leaf.level));
        [0, 1, 2].map(|axis: usize| (position[axis] - leaf.cell[axis] as f32) * scale)
    }

    /// Whether a leaf holds a position: whether a query there would find it.
    #[inline]
    pub(crate) fn holds(&self, leaf: &Leaf, position: [f32; 3]) -> bool {
        let is_in = [0, 1, 2].map(|axis: usize| {
            let cell = (position[axis] as u32).min(self.cells[axis] - 1);
            cell ^ leaf.cell[axis] < leaf.edge
        });
        is_in == [true; 3]
    }

    /// Least corner of the leaf that follows, found by counting up in octal digits of octants: the root grid x fastest,
    /// below it depth first, the octants of a cell in the order of their numbers.
    pub(crate) fn cell_after(&self, leaf: &Leaf) -> Option<[u32; 3]> {
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
        if x >= self.cells[0] {
            (x, y) = (0, y + step);
        }
        if y >= self.cells[1] {
            (y, z) = (0, z + step);
        }
        (z < self.cells[2]).then_some([x, y, z])
    }
}
