//! The leaves of a polynomial octree that meet a box, one after the other, in fixed memory.

use crate::lattice::Leaf;
use crate::layout::octree;
use crate::math::each_axis;
use crate::polynomial_octree::{Node, PolynomialOctree};

/// The leaves that hold any of the finest cells from `low` to `high`: the root grid x fastest, below it depth first.
#[derive(Clone, Debug)]
pub(crate) struct Region<'t, 'a> {
    octree: &'t PolynomialOctree<'a>,
    low: [u32; 3],
    high: [u32; 3],
    /// Leaves with edges below 2^`finest` are passed over.
    finest: u32,
    /// Least corner of the root cell that comes next; beyond the region if none does.
    root: [u32; 3],
    /// Least corner of the last cell, and its edge as a power of two.
    cell: [u32; 3],
    shift: u32,
    /// For the inner nodes on the way to the last cell, by the power of two of their children's edge: the record, and which
    /// children are yet to come.
    path: [(u32, u32); octree::MAX_DEPTH as usize],
}

impl<'t, 'a> Region<'t, 'a> {
    /// `low` and `high` are cells of the lattice, `low` at most `high`. Leaves with edges below 2^`finest` are passed over.
    pub(crate) fn new(octree: &'t PolynomialOctree<'a>, low: [u32; 3], high: [u32; 3], finest: u32) -> Self {
        let depth = u32::from(octree.lattice.depth);
        let root = low.map(|cell| cell >> depth << depth);
        Self { octree, low, high, finest, root, cell: root, shift: depth, path: [(0, 0); octree::MAX_DEPTH as usize] }
    }

    /// Which children of the node at `cell`, whose edges are 2^`shift`, meet the region: a bit for each.
    #[inline]
    fn children(&self, cell: [u32; 3], shift: u32) -> u32 {
        const LESSER: [u32; 3] = [0x55, 0x33, 0x0F];
        let mut children = 0xFF;
        for axis in 0..3 {
            let middle = cell[axis] + (1 << shift);
            if self.high[axis] < middle {
                children &= LESSER[axis];
            }
            if self.low[axis] >= middle {
                children &= !LESSER[axis];
            }
        }
        children
    }

    /// Moves to the next root cell of the region.
    fn next_root(&mut self) -> Option<Node> {
        let [x, y, z] = self.root;
        if z > self.high[2] {
            return None;
        }
        let depth = u32::from(self.octree.lattice.depth);
        (self.cell, self.shift) = (self.root, depth);

        let step = 1 << depth;
        let first = self.low.map(|cell| cell >> depth << depth);
        self.root = if x + step <= self.high[0] {
            [x + step, y, z]
        } else if y + step <= self.high[1] {
            [first[0], y + step, z]
        } else {
            [first[0], first[1], z + step]
        };
        Some(self.octree.root(self.octree.lattice.root_of([x, y, z])))
    }

    /// Moves to the next child, up the path until there is one.
    fn next_child(&mut self) -> Option<Node> {
        let depth = u32::from(self.octree.lattice.depth);
        while self.shift < depth {
            let (record, pending) = self.path[self.shift as usize & 15];
            if pending != 0 {
                let octant = pending.trailing_zeros();
                self.path[self.shift as usize & 15].1 = pending & (pending - 1);
                let parent = self.cell.map(|cell| cell >> (self.shift + 1) << (self.shift + 1));
                self.cell = each_axis(|axis| parent[axis] + ((octant >> axis & 1) << self.shift));
                return Some(self.octree.record(record).child(octant));
            }
            self.shift += 1;
        }
        None
    }
}

impl Iterator for Region<'_, '_> {
    type Item = Leaf;

    fn next(&mut self) -> Option<Leaf> {
        let depth = self.octree.lattice.depth;
        loop {
            let node = self.next_child().or_else(|| self.next_root())?;
            match node {
                Node::Inner(_) if self.shift > 0 && self.shift == self.finest => {}
                Node::Inner(record) if self.shift > 0 => {
                    self.shift -= 1;
                    self.path[self.shift as usize & 15] = (record, self.children(self.cell, self.shift));
                }
                Node::Leaf(place) | Node::Inner(place) => {
                    let level = depth - self.shift as u8;
                    return Some(Leaf { level, cell: self.cell, edge: 1 << self.shift, place, octant: 0 });
                }
            }
        }
    }
}
