//! The box of an octree and the lattice of its finest cells: from a point to a cell, and from a leaf to the next.

use crate::error::Error;
use crate::header::Aabb;
use crate::layout::{limit, octree as at};
use crate::math::{self, each_axis};

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

/// Coordinates along x, y and z and a zero: four lanes, for the sake of vectors.
pub(crate) type Position = [f32; 4];

/// A root grid of cubes, each divided into finest cells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lattice {
    min: Position,
    max: Position,
    /// Finest cells along each axis, and 1: the last lane has a cell too, and that is 0.
    pub(crate) extent: Position,
    /// Finest cells per mesh unit.
    cells_per_unit: f32,
    pub(crate) root_cells: [u32; 3],
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
        let [x, y, z] = root_cells.map(|cells| (cells << depth) as f32);
        Ok(Self {
            min: padded(bounds.min),
            max: padded(bounds.max),
            extent: [x, y, z, 1.0],
            cells_per_unit: (1_u32 << depth) as f32 / root_edge,
            root_cells,
            depth,
            root_edge,
        })
    }

    /// The box that the root grid fills.
    pub(crate) fn bounds(&self) -> Aabb {
        let [min, max] = [self.min, self.max].map(|[x, y, z, _]| [x, y, z]);
        Aabb { min, max }
    }

    /// Finest cells along each axis.
    #[inline]
    pub(crate) fn cells(&self) -> [u32; 3] {
        self.root_cells.map(|cells| cells << self.depth)
    }

    /// Checks that the box is the root grid (SPEC.md §5.4).
    pub(crate) fn check_bounds(&self) -> Result<(), Error> {
        let Aabb { min, max } = self.bounds();
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

    /// Halves of the edge of a cell in a mesh unit. The edge is 2^`shift` finest cells.
    #[inline]
    pub(crate) fn per_half(&self, shift: u32) -> f32 {
        self.cells_per_unit * f32::from_bits((128 - shift) << 23)
    }

    /// Whether a point lies in the box, faces included. False for a NaN.
    #[inline]
    pub(crate) fn contains(&self, point: [f32; 3]) -> bool {
        let is_within = |axis: usize| (point[axis] >= self.min[axis]) & (point[axis] <= self.max[axis]);
        is_within(0) & is_within(1) & is_within(2)
    }

    /// A point of the box in finest cells from the least corner of the box.
    ///
    /// Only the subtraction and the product round: the cell and the local coordinates follow from the
    /// product exactly.
    #[inline]
    pub(crate) fn position(&self, point: [f32; 3]) -> Position {
        let mut position = padded(point);
        for (lane, part) in position.iter_mut().enumerate() {
            let cells = (*part - self.min[lane]) * self.cells_per_unit;
            let limit = self.extent[lane];
            // Never a NaN: one comparison does.
            *part = if cells < limit { cells } else { limit };
        }
        position
    }

    /// The finest cell of a position, the last for those on a greater face.
    #[inline]
    pub(crate) fn cell_of(&self, position: Position) -> [u32; 3] {
        // Adding 2²³ rounds to an integer, and leaves it in the lowest bits.
        const ROUNDING: f32 = (1 << 23) as f32;
        let mut cell = [0; 4];
        for (lane, &part) in position.iter().enumerate() {
            let nearest = (part + ROUNDING) - ROUNDING;
            let floor = if nearest > part { nearest - 1.0 } else { nearest };
            let last = self.extent[lane] - 1.0;
            let floor = if floor < last { floor } else { last };
            cell[lane] = (floor + ROUNDING).to_bits() & ((1 << 23) - 1);
        }
        let [x, y, z, _] = cell;
        [x, y, z]
    }

    /// [`position`](Self::position) and [`cell_of`](Self::cell_of), and a zero, and along which axes the point is not in the
    /// box: apart and to memory, which makes four-wide code. The coordinates come in registers: processors wait for what is
    /// written to memory one by one and read together.
    #[inline(never)]
    pub(crate) fn locate(
        &self,
        x: f32,
        y: f32,
        z: f32,
        position: &mut Position,
        cell: &mut [u32; 4],
        outside: &mut [u32; 4],
    ) {
        const ROUNDING: f32 = (1 << 23) as f32;
        let point = [x, y, z, 0.0];
        for lane in 0..4 {
            outside[lane] = u32::from(!((point[lane] >= self.min[lane]) & (point[lane] <= self.max[lane])));
            let cells = (point[lane] - self.min[lane]) * self.cells_per_unit;
            let limit = self.extent[lane];
            let part = if cells < limit { cells } else { limit };
            position[lane] = part;
            let nearest = (part + ROUNDING) - ROUNDING;
            let floor = nearest - if nearest > part { 1.0 } else { 0.0 };
            let last = limit - 1.0;
            let floor = if floor < last { floor } else { last };
            cell[lane] = (floor + ROUNDING).to_bits() & ((1 << 23) - 1);
        }
    }

    /// The finest cell itself, or the nearest of the lattice.
    #[inline]
    pub(crate) fn clamp(&self, cell: [u32; 3]) -> [u32; 3] {
        let cells = self.cells();
        each_axis(|axis| cell[axis].min(cells[axis] - 1))
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
    pub(crate) fn local(&self, leaf: &Leaf, position: Position) -> [f32; 3] {
        let scale = math::power_of_half(self.depth.saturating_sub(leaf.level));
        each_axis(|axis| (position[axis] - leaf.cell[axis] as f32) * scale)
    }

    /// Whether a leaf holds a position: whether a query there would find it.
    #[inline]
    pub(crate) fn holds(&self, leaf: &Leaf, position: Position) -> bool {
        let [x, y, z] = self.cell_of(position);
        (x ^ leaf.cell[0]) | (y ^ leaf.cell[1]) | (z ^ leaf.cell[2]) < leaf.edge
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
        let cells = self.cells();
        let step = 1 << self.depth;
        x += step;
        if x >= cells[0] {
            (x, y) = (0, y + step);
        }
        if y >= cells[1] {
            (y, z) = (0, z + step);
        }
        (z < cells[2]).then_some([x, y, z])
    }
}

#[inline]
pub(crate) fn padded([x, y, z]: [f32; 3]) -> Position {
    [x, y, z, 0.0]
}
