//! The cells of a polynomial octree.

use crate::octree::domain::Domain;
use crate::quantize::piece::Coded;
use glam::{DVec3, UVec3};

/// A cell.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Smallest corner, lattice coordinates.
    pub origin: UVec3,
    /// Level below the root grid.
    pub level: u8,
    /// What it holds.
    pub content: Content,
}

/// What a cell holds.
#[derive(Clone, Debug)]
pub enum Content {
    /// Eight children, x fastest, the first of them in this place.
    Inner(u32),
    /// A field of its own.
    Leaf(Box<Coded>),
}

/// A forest over a root grid, each cell after its parent.
#[derive(Clone, Debug)]
pub struct Cells {
    /// The box that it covers.
    pub domain: Domain,
    /// All cells, the root cells first, x fastest.
    pub all: Vec<Cell>,
}

impl Cells {
    /// How many root cells there are.
    pub fn roots(&self) -> usize {
        self.domain.root_cells.element_product() as usize
    }

    /// The leaves and their places.
    pub fn leaves(&self) -> impl Iterator<Item = (usize, &Cell, &Coded)> {
        self.all.iter().enumerate().filter_map(|(place, cell)| match &cell.content {
            Content::Leaf(coded) => Some((place, cell, &**coded)),
            Content::Inner(_) => None,
        })
    }

    /// A point by the coordinates of a cell, from -1 to 1 within it, and half the cell's edge, mesh units.
    pub fn local(&self, place: usize, point: DVec3) -> (DVec3, f64) {
        let cell = &self.all[place];
        let half = 0.5 * self.domain.edge(cell.level);
        ((point - self.domain.point(cell.origin)) / half - 1.0, half)
    }

    /// Visits the leaves whose closed cells meet a closed box of the lattice.
    pub fn visit_leaves_in(&self, min: UVec3, max: UVec3, mut visit: impl FnMut(usize, &Cell)) {
        let edge = self.domain.lattice_edge(0);
        let cells = self.domain.root_cells;
        let first = min.saturating_sub(UVec3::ONE) / edge;
        let last = (max / edge).min(cells - 1);
        let mut stack: Vec<u32> = Vec::new();
        for z in first.z..=last.z {
            for y in first.y..=last.y {
                stack.extend((first.x..=last.x).map(|x| x + cells.x * (y + cells.y * z)));
            }
        }
        while let Some(place) = stack.pop() {
            let cell = &self.all[place as usize];
            let far = cell.origin + self.domain.lattice_edge(cell.level);
            if cell.origin.cmpgt(max).any() || far.cmplt(min).any() {
                continue;
            }
            match cell.content {
                Content::Inner(first) => stack.extend(first..first + 8),
                Content::Leaf(_) => visit(place as usize, cell),
            }
        }
    }

    /// The levels of the leaves that touch a leaf by a face, an edge or a corner.
    pub fn visit_touching(&self, place: usize, mut visit: impl FnMut(usize, &Cell)) {
        let cell = &self.all[place];
        let far = cell.origin + self.domain.lattice_edge(cell.level);
        self.visit_leaves_in(cell.origin, far, |other, cell| {
            if other != place {
                visit(other, cell);
            }
        });
    }
}

/// Offsets of the octant, x fastest: bit 0 of the index is x.
pub fn octant(index: u32) -> UVec3 {
    UVec3::new(index & 1, index >> 1 & 1, index >> 2 & 1)
}
