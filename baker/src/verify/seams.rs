//! How far a field jumps across the faces between its leaves.

mod bound;

pub use bound::SeamBound;

use crate::random::Draws;
use nearfield::{Field, Grid, Leaf, Octree, PolynomialOctree, Reconstruction};
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
    /// What no face exceeds, from what the leaves hold; of octrees of interpolants.
    pub bound: Option<SeamBound>,
    /// Points at which both sides were asked.
    pub points: usize,
    /// Largest difference of the distance at these points.
    pub max: f64,
    /// Root mean square difference of the distance.
    pub rms: f64,
    /// Largest length of the difference of the gradients.
    pub gradient_max: f64,
    /// Root mean square length of the difference of the gradients.
    pub gradient_rms: f64,
    /// Length of the longest gradient.
    pub steepest: f64,
}

impl SeamStatistics {
    /// The largest jump of the distance that is known to occur, or that cannot be excluded.
    pub fn largest(&self) -> f64 {
        self.bound.map_or(self.max, |bound| bound.value.max(self.max))
    }
}

/// Asks both sides of every face between leaves at random points.
///
/// A face between leaves of different sizes is visited from the smaller one; a face between equals
/// from the one on its low side. So every face counts once.
pub(super) fn measure(field: &Field<'_>, seed: u64) -> SeamStatistics {
    match (field.octree(), field.polynomial_octree(), field.grid()) {
        (Some(octree), _, _) => {
            let bound = Some(bound::of_interpolants(&octree));
            SeamStatistics { bound, ..of_tree(&Tree::Interpolants(&octree), seed) }
        }
        (_, Some(octree), _) => of_tree(&Tree::Polynomials(&octree, field), seed),
        (_, _, Some(grid)) => of_grid(&grid, seed),
        (None, None, None) => SeamStatistics::default(),
    }
}

/// What has leaves.
enum Tree<'a> {
    Interpolants(&'a Octree<'a>),
    Polynomials(&'a PolynomialOctree<'a>, &'a Field<'a>),
}

type Answer = (f32, [f32; 3]);

impl Tree<'_> {
    fn leaf_count(&self) -> u32 {
        match self {
            Self::Interpolants(octree) => octree.leaf_count(),
            Self::Polynomials(octree, _) => octree.leaf_count(),
        }
    }

    fn lattice(&self) -> [u32; 3] {
        match self {
            Self::Interpolants(octree) => octree.lattice(),
            Self::Polynomials(octree, _) => octree.lattice(),
        }
    }

    fn leaf_at(&self, cell: [u32; 3]) -> Leaf {
        match self {
            Self::Interpolants(octree) => octree.leaf_at(cell),
            Self::Polynomials(octree, _) => octree.leaf_at(cell),
        }
    }

    /// Every n-th leaf, with its place in the file's order.
    fn every(&self, stride: usize) -> Vec<(usize, Leaf)> {
        match self {
            Self::Interpolants(octree) => octree.leaves().enumerate().step_by(stride).collect(),
            Self::Polynomials(octree, _) => octree.leaves().enumerate().step_by(stride).collect(),
        }
    }

    /// What holds on either side of a face between two leaves, at a point of both closures, local to each.
    ///
    /// Leaves that overlap have no sides of their own: there the whole field is asked, on the nearest numbers
    /// before and behind the face.
    fn sides(&self, leaf: &Leaf, here: [f32; 3], neighbour: &Leaf, there: [f32; 3], axis: usize) -> [Answer; 2] {
        match self {
            Self::Interpolants(octree) => [octree.evaluate(leaf, here), octree.evaluate(neighbour, there)],
            Self::Polynomials(octree, _) if octree.overlap() == 0.0 => {
                [octree.evaluate(leaf, here), octree.evaluate(neighbour, there)]
            }
            Self::Polynomials(octree, field) => {
                let (spacing, low) = (f64::from(octree.edge(octree.depth())), octree.bounds().min);
                let point: [f32; 3] = std::array::from_fn(|axis| {
                    let place = f64::from(leaf.cell[axis]) + f64::from(here[axis]) * f64::from(leaf.edge);
                    (f64::from(low[axis]) + place * spacing) as f32
                });
                let (mut before, mut behind) = (point, point);
                (before[axis], behind[axis]) = (point[axis].next_down(), point[axis].next_up());
                [field.distance_and_gradient(before), field.distance_and_gradient(behind)]
            }
        }
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

fn of_tree(tree: &Tree<'_>, seed: u64) -> SeamStatistics {
    let stride = (tree.leaf_count() as usize).div_ceil(MAX_LEAVES).max(1);
    let leaves = tree.every(stride);

    // Sums of fixed chunks, added in order: the figures do not depend on threads.
    let chunks: Vec<Sums> = leaves
        .par_chunks(CHUNK)
        .map(|chunk| {
            let mut sums = Sums::default();
            for (index, leaf) in chunk {
                let mut draws = Draws::new(seed, STREAM, *index as u64);
                for face in FACES {
                    across(tree, leaf, face, &mut draws, &mut sums);
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

/// Whether it is this leaf's turn: the smaller one's, between equals that on the low side.
fn measured_from_here(leaf: &Leaf, neighbour: &Leaf, face: Face) -> bool {
    neighbour.level < leaf.level || (neighbour.level == leaf.level && face.high)
}

/// Adds the jumps across one face of a leaf, if it is this leaf's turn to measure it.
fn across(tree: &Tree<'_>, leaf: &Leaf, face: Face, draws: &mut Draws, sums: &mut Sums) {
    let Some(neighbour) = neighbour(tree, leaf, face) else {
        return;
    };
    if !measured_from_here(leaf, &neighbour, face) {
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

        let [here, there] = tree.sides(leaf, here, &neighbour, there, face.axis);
        sums.add(here, there);
    }
}

/// The leaf on the other side, at the low corner of the face; none at the border of the box.
fn neighbour(tree: &Tree<'_>, leaf: &Leaf, face: Face) -> Option<Leaf> {
    let mut cell = leaf.cell;
    cell[face.axis] = if face.high { cell[face.axis] + leaf.edge } else { cell[face.axis].checked_sub(1)? };
    (cell[face.axis] < tree.lattice()[face.axis]).then(|| tree.leaf_at(cell))
}

#[derive(Clone, Copy, Default)]
struct Sums {
    points: usize,
    max: f64,
    squares: f64,
    gradient_max: f64,
    gradient_squares: f64,
    steepest: f64,
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
            steepest: length(gradient_here).max(length(gradient_there)),
        });
    }

    fn plus(self, other: Self) -> Self {
        Self {
            points: self.points + other.points,
            max: self.max.max(other.max),
            squares: self.squares + other.squares,
            gradient_max: self.gradient_max.max(other.gradient_max),
            gradient_squares: self.gradient_squares + other.gradient_squares,
            steepest: self.steepest.max(other.steepest),
        }
    }

    fn statistics(self) -> SeamStatistics {
        let root_mean = |sum: f64| (sum / self.points.max(1) as f64).sqrt();
        SeamStatistics {
            bound: None,
            points: self.points,
            max: self.max,
            rms: root_mean(self.squares),
            gradient_max: self.gradient_max,
            gradient_rms: root_mean(self.gradient_squares),
            steepest: self.steepest,
        }
    }
}

fn length(gradient: [f32; 3]) -> f64 {
    gradient.into_iter().map(f64::from).map(|part| part * part).sum::<f64>().sqrt()
}
