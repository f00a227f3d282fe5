//! Cells to leaves that are good enough, level by level.

use super::cells::{Cell, Cells, Content, octant};
use super::choose::{self, Check, Tolerance};
use crate::field_function::{FieldFunction, Sample};
use crate::octree::domain::Domain;
use crate::progress::Progress;
use crate::quantize::piece::{Coded, Steps};
use crate::sampling::cell::{CellSamples, POINTS, Stencil};
use glam::{DVec3, UVec3};
use nearfield::layout::leaf::MAX_LEVELS_APART;
use rayon::prelude::*;

/// Cells whose samples are held at once.
const BATCH: usize = 1 << 11;

/// Edge of a cell, in greatest errors at its samples, from which its corners are looked at: the larger the cell, the more
/// may happen beyond its outermost samples.
const CORNERS_FROM: f64 = 6.0;
/// Edge of a large cell, in the same.
const LARGE: f64 = 16.0;
/// Greatest error of a leaf at a corner of its cell, in greatest errors at its samples. What is more in a small cell hardly
/// bears on the mean, and is blended with what its neighbours say.
const CORNER_MAX: f64 = 3.0;
/// The same for a large cell.
const LARGE_CORNER_MAX: f64 = 1.5;

/// So many cells are never too many.
const FEW: usize = 1 << 14;

/// What leaves must achieve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Demand {
    /// Tolerance at the surface.
    pub(super) near: Tolerance,
    /// Greatest error anywhere, at the surface; infinite if none is asked for.
    pub(super) greatest: f64,
    /// Mean square error times volume that may be left of jumps. They cannot be fitted, only be cut into cells: four times as
    /// many halve it.
    pub(super) left_of_jumps: f64,
    /// Farther from the surface than this, tolerances grow with the distance; mesh units.
    pub(super) constant_within: f64,
}

impl Demand {
    /// The tolerance for a cell with these samples.
    pub(super) fn of(&self, samples: &[Sample]) -> Tolerance {
        let nearest = samples.iter().map(|sample| sample.distance.abs()).fold(f64::INFINITY, f64::min);
        let growth = self.growth(nearest);
        Tolerance { rmse: growth * self.near.rmse, max: growth * self.near.max }
    }

    /// The greatest error at a point this far from the surface, mesh units.
    pub(super) fn greatest_at(&self, distance: f64) -> f64 {
        self.growth(distance.abs()) * self.greatest
    }

    fn growth(&self, distance: f64) -> f64 {
        (distance / self.constant_within).max(1.0)
    }
}

/// What became of a cell.
enum Found {
    /// A leaf that is good enough, or as good as any at the greatest depth.
    Leaf(Coded),
    /// No leaf: the cell is to be split.
    Nothing,
    /// No leaf is good enough because the function jumps; the best there is, and its mean square error.
    Jump(Coded, f64),
}

/// Builds the cells of a function.
pub(super) struct Refinement<'a> {
    pub(super) function: &'a dyn FieldFunction,
    pub(super) stencil: Stencil,
    pub(super) steps: Steps,
    pub(super) demand: Demand,
    /// Whether leaves that touch may not be too many levels apart.
    pub(super) graded: bool,
    pub(super) progress: &'a dyn Progress,
    /// Points sampled so far.
    pub(super) samples: usize,
}

impl Refinement<'_> {
    /// Splits cells until each leaf is good enough or the depth ends.
    pub(super) fn refine(&mut self, domain: Domain) -> Cells {
        let edge = domain.lattice_edge(0);
        let UVec3 { x: nx, y: ny, z: nz } = domain.root_cells;
        let origins = (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| edge * UVec3::new(x, y, z))));
        let mut cells = Cells { domain, all: Vec::new() };
        self.append(&mut cells, origins.collect(), 0);

        self.complete(&mut cells);
        cells
    }

    /// Gives every cell that found no leaf its children, and splits leaves that touch too fine ones.
    pub(super) fn complete(&mut self, cells: &mut Cells) {
        loop {
            for level in 1..=cells.domain.depth {
                self.split_failed(cells, level);
            }
            // What is split by force may have children that are not good enough, though rarely.
            if !(self.graded && self.split_leaves_beside_fine_ones(cells)) {
                return;
            }
        }
    }

    /// Splits the cells of the level above that have found no leaf.
    fn split_failed(&mut self, cells: &mut Cells, level: u8) {
        let failed: Vec<usize> = (0..cells.all.len())
            .filter(|&place| {
                cells.all[place].level + 1 == level && matches!(cells.all[place].content, Content::Inner(_))
            })
            .filter(|&place| matches!(cells.all[place].content, Content::Inner(u32::MAX)))
            .collect();
        self.split(cells, &failed, level);
    }

    /// Gives cells of one level their children.
    pub(super) fn split(&mut self, cells: &mut Cells, parents: &[usize], level: u8) {
        let half = cells.domain.lattice_edge(level);
        let mut origins = Vec::with_capacity(8 * parents.len());
        for &place in parents {
            let first = cells.all.len() + origins.len();
            cells.all[place].content = Content::Inner(u32::try_from(first).expect("fewer than 2^32 cells"));
            origins.extend((0..8).map(|child| cells.all[place].origin + half * octant(child)));
        }
        self.append(cells, origins, level);
    }

    /// Appends cells of one level, those that are not good enough as inner ones that still lack children. Where the function
    /// jumps they are good enough when all of the level together hardly bear on the mean, or when their children would
    /// outnumber all leaves.
    fn append(&mut self, cells: &mut Cells, origins: Vec<UVec3>, level: u8) {
        let domain = cells.domain;
        let edge = domain.edge(level);
        let (mut jumps, mut left_of_jumps) = (Vec::new(), 0.0);
        for batch in origins.chunks(BATCH) {
            let points: Vec<DVec3> = batch.iter().flat_map(|&origin| self.points_of(&domain, origin, level)).collect();
            let samples = self.sample_all(&points);
            let corners = self.corners_of(&domain, batch, level);
            let is_last = level == domain.depth;
            let found: Vec<Found> = samples
                .par_chunks(POINTS)
                .enumerate()
                .map(|(index, samples)| {
                    let corners = corners.get(8 * index..8 * (index + 1)).unwrap_or_default();
                    self.leaf(samples, corners, edge, is_last)
                })
                .collect();
            for (&origin, found) in batch.iter().zip(found) {
                let content = match found {
                    Found::Leaf(coded) => Content::Leaf(Box::new(coded)),
                    Found::Nothing => Content::Inner(u32::MAX),
                    Found::Jump(coded, mean_square) => {
                        left_of_jumps += mean_square * edge.powi(3);
                        jumps.push((cells.all.len(), coded));
                        Content::Inner(u32::MAX)
                    }
                };
                cells.all.push(Cell { origin, level, content });
            }
        }
        let leaves = || cells.all.iter().filter(|cell| matches!(cell.content, Content::Leaf(_))).count();
        if left_of_jumps <= self.demand.left_of_jumps || 8 * jumps.len() > leaves().max(FEW) {
            for (place, coded) in jumps {
                cells.all[place].content = Content::Leaf(Box::new(coded));
            }
        }
    }

    /// Where the function is sampled for a cell, mesh frame.
    pub(super) fn points_of(&self, domain: &Domain, origin: UVec3, level: u8) -> impl Iterator<Item = DVec3> {
        let edge = domain.edge(level);
        self.stencil.points_of(domain.point(origin) + 0.5 * edge, edge)
    }

    /// The function at the corners of cells whose outermost samples may miss what happens there; nothing of smaller cells.
    fn corners_of(&mut self, domain: &Domain, origins: &[UVec3], level: u8) -> Vec<Sample> {
        let edge = domain.edge(level);
        if edge < CORNERS_FROM * self.demand.near.max {
            return Vec::new();
        }
        // Most are corners of several cells.
        let step = domain.lattice_edge(level);
        let corners = |&origin: &UVec3| (0..8).map(move |corner| (origin + step * octant(corner)).to_array());
        let mut vertices: Vec<[u32; 3]> = origins.iter().flat_map(corners).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let points: Vec<DVec3> = vertices.iter().map(|&vertex| domain.point(vertex.into())).collect();
        let samples = self.sample_all(&points);
        let sample_at =
            |vertex: [u32; 3]| samples[vertices.binary_search(&vertex).expect("a corner of one of the cells")];
        origins.iter().flat_map(corners).map(sample_at).collect()
    }

    /// Samples the function.
    pub(super) fn sample_all(&mut self, points: &[DVec3]) -> Vec<Sample> {
        self.samples += points.len();
        self.progress.advance(points.len() as u64);
        self.function.sample_all(points)
    }

    fn leaf(&self, samples: &[Sample], corners: &[Sample], edge: f64, is_last: bool) -> Found {
        let tolerance = self.demand.of(samples);
        let is_large = edge >= LARGE * self.demand.near.max;
        let within = tolerance.max * if is_large { LARGE_CORNER_MAX } else { CORNER_MAX };
        let check = |(corner, sample): (usize, &Sample)| Check {
            at: 2.0 * octant(corner as u32).as_dvec3() - 1.0,
            distance: sample.distance,
            within,
        };
        let checks: Vec<Check> = corners.iter().enumerate().map(check).collect();
        let cell = CellSamples { stencil: &self.stencil, samples, edge };
        let fits = cell.fits();
        let cheapest = choose::cheapest(&self.steps, &cell, &fits, &checks, tolerance);
        let best = || choose::best(&self.steps, &cell, &fits, tolerance);
        match cheapest {
            Some(coded) => Found::Leaf(coded),
            None if is_last => Found::Leaf(best().0),
            None if cell.jumps() => {
                let (coded, mean_square) = best();
                Found::Jump(coded, mean_square)
            }
            None => Found::Nothing,
        }
    }

    /// Splits leaves that touch one too many levels below them; whether there were any.
    fn split_leaves_beside_fine_ones(&mut self, cells: &mut Cells) -> bool {
        let too_coarse: Vec<usize> = cells
            .leaves()
            .filter(|(place, cell, _)| {
                let mut deepest = 0;
                cells.visit_touching(*place, |_, other| deepest = deepest.max(other.level));
                u32::from(deepest.saturating_sub(cell.level)) > MAX_LEVELS_APART
            })
            .map(|(place, _, _)| place)
            .collect();
        for &place in &too_coarse {
            let level = cells.all[place].level + 1;
            self.split(cells, &[place], level);
        }
        !too_coarse.is_empty()
    }
}
