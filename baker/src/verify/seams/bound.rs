//! How far an octree of interpolants can jump anywhere, from what its leaves hold.
//!
//! Across a face the difference of two tricubic polynomials is bicubic, and so is that of their slopes through the
//! face. In the Bernstein basis its control points bound it everywhere (Farin, Curves and Surfaces for CAGD, 5th
//! edition, section 4.3), so that no point of a face needs to be sampled.

use super::{CHUNK, FACES, Face, Tree, measured_from_here, neighbour};
use crate::corner::Corner;
use crate::octree::interpolant::Patch;
use crate::settings::Interpolant;
use glam::DVec3;
use nearfield::{Leaf, Octree};
use rayon::prelude::*;

/// What no face between leaves exceeds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SeamBound {
    /// Faces, each counted once: all of them.
    pub faces: usize,
    /// Of these, faces between leaves of different sizes.
    pub uneven_faces: usize,
    /// Largest difference of the distance, mesh units.
    pub value: f64,
    /// The same, in distance quanta of the smaller leaf.
    pub quanta: f64,
    /// Largest length of the difference of the gradients; none for trilinear leaves, whose gradients jump.
    pub gradient: Option<f64>,
}

/// The bound over every face of an octree.
pub(super) fn of_interpolants(octree: &Octree<'_>) -> SeamBound {
    let interpolant = match octree.interpolant() {
        nearfield::Interpolant::Tricubic => Interpolant::Tricubic,
        _ => Interpolant::Trilinear,
    };
    let tree = Tree::Interpolants(octree);
    let leaves: Vec<Leaf> = octree.leaves().collect();
    let of_chunk = |chunk: &[Leaf]| {
        let mut bound = SeamBound::default();
        for leaf in chunk {
            let own = Held::by(octree, leaf, interpolant);
            for face in FACES {
                if let Some(other) = neighbour(&tree, leaf, face).filter(|other| measured_from_here(leaf, other, face))
                {
                    bound = bound.or(across(&own, &Held::by(octree, &other, interpolant), face));
                }
            }
        }
        bound
    };
    leaves.par_chunks(CHUNK).map(of_chunk).reduce(SeamBound::default, SeamBound::or)
}

/// A leaf and the derivatives at its corners, x fastest, by its local coordinates.
struct Held<'a> {
    leaf: &'a Leaf,
    interpolant: Interpolant,
    corners: [Corner; 8],
    /// Mesh units.
    edge: f64,
    quantum: f64,
}

impl<'a> Held<'a> {
    fn by(octree: &Octree<'_>, leaf: &'a Leaf, interpolant: Interpolant) -> Self {
        // The reader counts x slowest, the baker fastest.
        let turned = |index: usize| (index & 1) << 2 | index & 2 | index >> 2;
        let jets = octree.corners(leaf);
        let derivative = |corner: usize, bits: usize| match interpolant {
            Interpolant::Trilinear if bits > 0 => 0.0,
            _ => f64::from(jets[turned(corner)][turned(bits)]),
        };
        Self {
            leaf,
            interpolant,
            corners: std::array::from_fn(|corner| Corner(std::array::from_fn(|bits| derivative(corner, bits)))),
            edge: f64::from(octree.edge(leaf.level)),
            quantum: f64::from(octree.quantum(leaf.level)),
        }
    }

    /// The derivatives at a corner of another leaf that is no larger, by that leaf's local coordinates.
    fn at_corner_of(&self, other: &Leaf, corner: usize) -> Corner {
        let local: [f64; 3] = std::array::from_fn(|axis| {
            let place = f64::from(other.cell[axis]) + f64::from(other.edge) * (corner >> axis & 1) as f64;
            (place - f64::from(self.leaf.cell[axis])) / f64::from(self.leaf.edge)
        });
        if other.edge == self.leaf.edge {
            let [x, y, z] = local.map(|end| end as usize);
            return self.corners[x | y << 1 | z << 2];
        }

        let patch = Patch::new(self.interpolant, &self.corners, 1.0);
        let local = DVec3::from_array(local);
        if self.interpolant == Interpolant::Trilinear {
            // What a leaf does not hold is compared with nothing.
            return Corner::first_order(patch.value(local), DVec3::ZERO);
        }
        let ratio = f64::from(other.edge) / f64::from(self.leaf.edge);
        let Corner(derivatives) = patch.derivatives(local);
        Corner(std::array::from_fn(|bits| derivatives[bits] * ratio.powi(bits.count_ones() as i32)))
    }
}

/// The bound across one face of a leaf, to a neighbour that is no smaller.
fn across(own: &Held<'_>, other: &Held<'_>, face: Face) -> SeamBound {
    let (through, u, v) = (face.axis, (face.axis + 1) % 3, (face.axis + 2) % 3);
    let mut value = Net::default();
    let mut slope = Net::default();
    for corner in (0..8).filter(|corner| (corner >> through & 1 == 1) == face.high) {
        let (ours, theirs) = (own.corners[corner], other.at_corner_of(own.leaf, corner));
        let difference = |bits: usize| ours.0[bits] - theirs.0[bits];
        let [far_u, far_v] = [u, v].map(|axis| corner >> axis & 1 == 1);
        let of = |through: usize| [0, 1 << u, 1 << v, 1 << u | 1 << v].map(|bits| difference(bits | through));
        value.add(far_u, far_v, of(0));
        slope.add(far_u, far_v, of(1 << through));
    }

    let [along_u, along_v] = value.steepest();
    let gradient = DVec3::new(slope.largest(), along_u, along_v).length() / own.edge;
    SeamBound {
        faces: 1,
        uneven_faces: usize::from(own.leaf.edge != other.leaf.edge),
        value: value.largest(),
        quanta: value.largest() / own.quantum,
        gradient: (own.interpolant == Interpolant::Tricubic).then_some(gradient),
    }
}

/// The Bernstein control points of a bicubic over the unit square, `[v][u]`.
#[derive(Default)]
struct Net([[f64; 4]; 4]);

impl Net {
    /// Adds the four control points at a corner of the square that follow from value, derivative by u, by v and by both.
    fn add(&mut self, far_u: bool, far_v: bool, [value, by_u, by_v, by_both]: [f64; 4]) {
        let (end_u, next_u, inward_u) = if far_u { (3, 2, -1.0 / 3.0) } else { (0, 1, 1.0 / 3.0) };
        let (end_v, next_v, inward_v) = if far_v { (3, 2, -1.0 / 3.0) } else { (0, 1, 1.0 / 3.0) };
        self.0[end_v][end_u] = value;
        self.0[end_v][next_u] = value + inward_u * by_u;
        self.0[next_v][end_u] = value + inward_v * by_v;
        self.0[next_v][next_u] = value + inward_u * by_u + inward_v * by_v + inward_u * inward_v * by_both;
    }

    /// Bound of the magnitude.
    fn largest(&self) -> f64 {
        self.0.as_flattened().iter().map(|point| point.abs()).fold(0.0, f64::max)
    }

    /// Bounds of the magnitudes of the derivatives by u and by v: three times the steps between control points.
    fn steepest(&self) -> [f64; 2] {
        let Self(points) = self;
        let along_u = points.iter().flat_map(|row| row.windows(2).map(|pair| pair[1] - pair[0]));
        let along_v = points.windows(2).flat_map(|rows| (0..4).map(|at| rows[1][at] - rows[0][at]));
        [
            along_u.fold(0.0, |largest: f64, step| largest.max(3.0 * step.abs())),
            along_v.fold(0.0, |largest: f64, step| largest.max(3.0 * step.abs())),
        ]
    }
}

impl SeamBound {
    /// What neither exceeds.
    fn or(self, other: Self) -> Self {
        Self {
            faces: self.faces + other.faces,
            uneven_faces: self.uneven_faces + other.uneven_faces,
            value: self.value.max(other.value),
            quanta: self.quanta.max(other.quanta),
            gradient: [self.gradient, other.gradient].into_iter().flatten().reduce(f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The net of u³ - 2 u v² + v, from its derivatives at the corners.
    fn net() -> Net {
        let mut net = Net::default();
        for (u, v) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let of = [u * u * u - 2.0 * u * v * v + v, 3.0 * u * u - 2.0 * v * v, 1.0 - 4.0 * u * v, -4.0 * v];
            net.add(u > 0.5, v > 0.5, of);
        }
        net
    }

    /// The greatest of a function over a lattice of the unit square.
    fn greatest(of: impl Fn(f64, f64) -> f64) -> f64 {
        (0..=10_200).map(|i| of(f64::from(i % 101) / 100.0, f64::from(i / 101) / 100.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn control_points_bound_a_bicubic_and_its_slopes_closely() {
        let (found, [by_u, by_v]) = (net().largest(), net().steepest());
        for (bound, greatest) in [
            (found, greatest(|u, v| u * u * u - 2.0 * u * v * v + v)),
            (by_u, greatest(|u, v| 3.0 * u * u - 2.0 * v * v)),
            (by_v, greatest(|u, v| 1.0 - 4.0 * u * v)),
        ] {
            assert!(greatest <= bound + 1e-12 && bound <= 1.4 * greatest, "{bound} for {greatest}");
        }
    }
}
