//! How far a field jumps across the faces between its leaves.

use crate::random::Draws;
use nearfield::{Field, Grid, Leaf, Octree, Reconstruction};
use rayon::prelude::*;

const STREAM: u64 = 3;
/// Faces of at most this many leaves are measured: in larger fields every n-th leaf of the file's order.
const MAX_LEAVES: usize = 1 << 17;
/// Random points on every face.
const POINTS_PER_FACE: usize = 4;
/// Points lie on a lattice of this many steps along an edge of the smaller leaf, so that the place
/// within either leaf is exact in `f32`.
const STEPS: u32 = 64;
/// Leaves measured by one task.
const CHUNK: usize = 1 << 10;

/// What differs between the two sides of the faces between leaves. Mesh units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SeamStatistics {
    /// Points at which both sides were asked.
    pub points: usize,
    /// Largest difference of the distance.
    pub max: f64,
    /// Root mean square difference of the distance.
    pub rms: f64,
    /// Largest length of the difference of the gradients.
    pub gradient_max: f64,
    /// Root mean square length of the difference of the gradients.
    pub gradient_rms: f64,
}

/// Asks both sides of every face between leaves at random points.
///
/// A face between leaves of different sizes is visited from the smaller one; a face between equals
/// from the one on its low side. So every face counts once.
pub(super) fn measure(field: &Field<'_>, seed: u64) -> SeamStatistics {
    match (field.octree(), field.grid()) {
        (Some(octree), _) => of_octree(&octree, seed),
        (None, Some(grid)) => of_grid(&grid, seed),
        (None, None) => SeamStatistics::default(),
    }
}

/// The faces between the cells of a grid; for the nearest sample's answer, those halfway.
fn of_grid(grid: &Grid<'_>, seed: u64) -> SeamStatistics {
    let [nx, ny, nz] = grid.resolution().map(|samples| samples as usize - 1);
    let stride = (nx * ny * nz).div_ceil(MAX_LEAVES).max(1);
    let cells: Vec<usize> = (0..nx * ny * nz).step_by(stride).collect();
    let is_nearest = grid.reconstruction() == Reconstruction::Nearest;

    let chunks: Vec<Sums> = cells
        .par_chunks(CHUNK)
        .map(|chunk| {
            let mut sums = Sums::default();
            for &index in chunk {
                let cell = [index % nx, index / nx % ny, index / nx / ny];
                let mut draws = Draws::new(seed, STREAM, index as u64);
                for axis in 0..3 {
                    let mut next = cell;
                    next[axis] += 1;
                    for _ in 0..POINTS_PER_FACE {
                        let mut here = [0; 3].map(|_: u32| draws.unit() as f32);
                        let mut there = here;
                        let other = if is_nearest {
                            (here[axis], there[axis]) = (0.5_f32.next_down(), 0.5);
                            cell
                        } else {
                            (here[axis], there[axis]) = (1.0, 0.0);
                            next
                        };
                        if other[axis] < [nx, ny, nz][axis] {
                            let answer = |cell: [usize; 3], local| grid.evaluate(cell.map(|at| at as u32), local);
                            sums.add(answer(cell, here), answer(other, there));
                        }
                    }
                }
            }
            sums
        })
        .collect();

    chunks.into_iter().fold(Sums::default(), Sums::plus).statistics()
}

fn of_octree(octree: &Octree<'_>, seed: u64) -> SeamStatistics {
    let stride = (octree.leaf_count() as usize).div_ceil(MAX_LEAVES).max(1);
    let leaves: Vec<(usize, Leaf)> = octree.leaves().enumerate().step_by(stride).collect();

    // Sums of fixed chunks, added in order: the figures do not depend on threads.
    let chunks: Vec<Sums> = leaves
        .par_chunks(CHUNK)
        .map(|chunk| {
            let mut sums = Sums::default();
            for (index, leaf) in chunk {
                let mut draws = Draws::new(seed, STREAM, *index as u64);
                for face in FACES {
                    across(octree, leaf, face, &mut draws, &mut sums);
                }
            }
            sums
        })
        .collect();

    chunks.into_iter().fold(Sums::default(), Sums::plus).statistics()
}

/// A side of a cell: the axis it is perpendicular to, and whether it is the high one.
#[derive(Clone, Copy)]
struct Face {
    axis: usize,
    high: bool,
}

const FACES: [Face; 6] = [
    Face { axis: 0, high: false },
    Face { axis: 0, high: true },
    Face { axis: 1, high: false },
    Face { axis: 1, high: true },
    Face { axis: 2, high: false },
    Face { axis: 2, high: true },
];

/// Adds the jumps across one face of a leaf, if it is this leaf's turn to measure it.
fn across(octree: &Octree<'_>, leaf: &Leaf, face: Face, draws: &mut Draws, sums: &mut Sums) {
    let Some(neighbour) = neighbour(octree, leaf, face) else {
        return;
    };
    let measured_from_here = neighbour.level < leaf.level || (neighbour.level == leaf.level && face.high);
    if !measured_from_here {
        return;
    }

    for _ in 0..POINTS_PER_FACE {
        let mut steps = [0; 3].map(|_: u32| (draws.unit() * f64::from(STEPS + 1)) as u32);
        steps[face.axis] = if face.high { STEPS } else { 0 };
        let here = steps.map(|steps| steps as f32 / STEPS as f32);
        let there = std::array::from_fn(|axis| {
            let offset = f64::from(leaf.cell[axis]) - f64::from(neighbour.cell[axis]);
            ((offset + f64::from(here[axis]) * f64::from(leaf.edge)) / f64::from(neighbour.edge)) as f32
        });

        sums.add(octree.evaluate(leaf, here), octree.evaluate(&neighbour, there));
    }
}

/// The leaf on the other side, at the low corner of the face; none at the border of the box.
fn neighbour(octree: &Octree<'_>, leaf: &Leaf, face: Face) -> Option<Leaf> {
    let mut cell = leaf.cell;
    cell[face.axis] = if face.high { cell[face.axis] + leaf.edge } else { cell[face.axis].checked_sub(1)? };
    (cell[face.axis] < octree.lattice()[face.axis]).then(|| octree.leaf_at(cell))
}

#[derive(Clone, Copy, Default)]
struct Sums {
    points: usize,
    max: f64,
    squares: f64,
    gradient_max: f64,
    gradient_squares: f64,
}

impl Sums {
    fn add(&mut self, (here, gradient_here): (f32, [f32; 3]), (there, gradient_there): (f32, [f32; 3])) {
        let jump = (f64::from(here) - f64::from(there)).abs();
        let gradient_square: f64 = (0..3)
            .map(|axis| f64::from(gradient_here[axis]) - f64::from(gradient_there[axis]))
            .map(|difference| difference * difference)
            .sum();

        *self = self.plus(Self {
            points: 1,
            max: jump,
            squares: jump * jump,
            gradient_max: gradient_square.sqrt(),
            gradient_squares: gradient_square,
        });
    }

    fn plus(self, other: Self) -> Self {
        Self {
            points: self.points + other.points,
            max: self.max.max(other.max),
            squares: self.squares + other.squares,
            gradient_max: self.gradient_max.max(other.gradient_max),
            gradient_squares: self.gradient_squares + other.gradient_squares,
        }
    }

    fn statistics(self) -> SeamStatistics {
        let root_mean = |sum: f64| (sum / self.points.max(1) as f64).sqrt();
        SeamStatistics {
            points: self.points,
            max: self.max,
            rms: root_mean(self.squares),
            gradient_max: self.gradient_max,
            gradient_rms: root_mean(self.gradient_squares),
        }
    }
}
