//! The tree in memory, and how far a query is from a node's boxes and from a packet's triangles in
//! single precision.
//!
//! The frame is that of [`LocalMesh`]: triangles within [−1, 1]³. With Q the largest coordinate of
//! the query (at least 1), u = 2⁻²⁴ and δ = 32 u (1 + Q), for every triangle at distance d:
//!
//! 1. A packet reports √F ≥ d − δ. F is the squared length of a vector from the query to a point
//!    that lies on the triangle up to rounding, whichever branch was taken: its parameters are
//!    clamped, or tested, in the rounded arithmetic itself. What is left is the rounding of the
//!    query, of corner a and of the edges (√3 u/2 · (Q + 1 + 4)), of the difference and of at most
//!    two products and sums per component (each at most 4 √3 u (Q + 1)) and of the sum of squares
//!    (relative 3 u, on d ≤ √3 (Q + 1)): in all under 16 u (1 + Q).
//! 2. It reports √F ≤ d + δ unless the triangle is *thin*. The parameter along an edge is off by a
//!    few u · |q − a| / |edge|, which moves the point by a few u · |q − a| and, as the distance is
//!    stationary there, costs its square. The parameters in the face are off by κ = longest edge ÷
//!    height times as much; far away this costs a square again, near by it moves the point by at
//!    most 4 u κ L for a longest edge L. A triangle is thin when this could exceed δ/2, unless its
//!    height is below δ: then the closest edge point is as good as the face. See [`is_thin`].
//! 3. A node reports √L ≤ d + δ for the triangles below it: see [`OrientedBox`].

use super::local_mesh::LocalMesh;
use super::oriented_box::OrientedBox;
use glam::DVec3;
use std::ops::Range;
use wide::f32x8;

/// Children of a node, triangles of a packet.
pub(super) const LANES: usize = 8;
/// Levels below the root, at most.
pub(super) const MAX_DEPTH: usize = 48;
/// Entries that a search from the top must remember: every level leaves at most seven siblings
/// behind, and the last has eight.
pub(super) const STACK: usize = (LANES - 1) * MAX_DEPTH + LANES;

/// 32 u.
const DELTA: f64 = 1.0 / (1 << 19) as f64;
/// Largest coordinate of a query that single precision takes: farther out it cannot tell the
/// triangles apart.
const FARTHEST: f64 = (1 << 20) as f64;

/// Whether single precision takes a local point.
pub(super) fn is_within_reach(point: DVec3) -> bool {
    point.abs().max_element() <= FARTHEST
}

/// The bound δ for a local point.
pub(super) fn coarse_error(point: DVec3) -> f64 {
    DELTA * (1.0 + point.abs().max_element().max(1.0))
}

/// A local point in every lane.
pub(super) type Query = [f32x8; 3];

pub(super) fn splat(point: DVec3) -> Query {
    point.as_vec3().to_array().map(f32x8::splat)
}

/// The tree: node 0 is the root, children come after their parents.
pub(super) struct Bvh {
    pub(super) nodes: Vec<Node>,
    pub(super) packets: Vec<Packet>,
}

/// A node or a packet, by index.
#[derive(Clone, Copy)]
pub(super) enum Child {
    Node(usize),
    Packet(usize),
}

/// A [`Child`] in a word.
#[derive(Clone, Copy)]
pub(super) struct ChildRef(u32);

impl ChildRef {
    pub(super) const ROOT: Self = Self(0);
    const PACKET: u32 = 1 << 31;

    pub(super) fn child(self) -> Child {
        let index = (self.0 & !Self::PACKET) as usize;
        if self.0 & Self::PACKET == 0 { Child::Node(index) } else { Child::Packet(index) }
    }
}

impl From<Child> for ChildRef {
    fn from(child: Child) -> Self {
        match child {
            Child::Node(index) => Self(index as u32),
            Child::Packet(index) => Self(index as u32 | Self::PACKET),
        }
    }
}

/// Eight oriented boxes. Unused ones are infinitely far from everything.
#[repr(align(64))]
pub(super) struct Node {
    axes: [[f32x8; 3]; 3],
    centre: [f32x8; 3],
    half: [f32x8; 3],
    pub(super) children: [ChildRef; LANES],
}

impl Node {
    pub(super) const EMPTY: Self = Self {
        axes: [[f32x8::ZERO; 3]; 3],
        centre: [f32x8::ZERO; 3],
        half: [f32x8::splat(f32::NEG_INFINITY); 3],
        children: [ChildRef::ROOT; LANES],
    };

    pub(super) fn set_child(&mut self, lane: usize, bounds: &OrientedBox, child: Child) {
        for k in 0..3 {
            for axis in 0..3 {
                self.axes[k][axis].as_mut_array()[lane] = bounds.axes[k][axis];
            }
            self.centre[k].as_mut_array()[lane] = bounds.centre[k];
            self.half[k].as_mut_array()[lane] = bounds.half[k];
        }
        self.children[lane] = child.into();
    }

    pub(super) fn child(&self, lane: usize) -> Option<Child> {
        let is_used = self.half[0].as_array()[lane] != f32::NEG_INFINITY;
        is_used.then(|| self.children[lane].child())
    }

    /// Squared distances to the boxes.
    #[inline(always)]
    pub(super) fn distances_squared(&self, query: Query) -> f32x8 {
        let outside = |k: usize| {
            let along = dot(self.axes[k], query) - self.centre[k];
            (along.abs() - self.half[k]).fast_max(f32x8::ZERO)
        };
        let outside = [outside(0), outside(1), outside(2)];
        dot(outside, outside)
    }
}

/// Eight triangles in single precision: a corner and the two edges that leave it.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct Packet {
    pub(super) a: [f32x8; 3],
    pub(super) ab: [f32x8; 3],
    pub(super) ac: [f32x8; 3],
    /// Triangle of each lane, with [`THIN`] added for thin ones, or [`NO_TRIANGLE`].
    triangles: [u32; LANES],
}

const THIN: u32 = 1 << 31;
const NO_TRIANGLE: u32 = !THIN;

impl Packet {
    /// Unused lanes hold a point that is far beyond every query.
    pub(super) const EMPTY: Self = Self {
        a: [f32x8::splat(1e17); 3],
        ab: [f32x8::ZERO; 3],
        ac: [f32x8::ZERO; 3],
        triangles: [NO_TRIANGLE; LANES],
    };

    /// Takes in at most eight triangles.
    pub(super) fn new(mesh: &LocalMesh, triangles: Range<usize>) -> Self {
        let mut packet = Self::EMPTY;
        for (lane, triangle) in triangles.enumerate() {
            packet.set_triangle(lane, triangle as u32, mesh);
        }
        packet
    }

    fn set_triangle(&mut self, lane: usize, triangle: u32, mesh: &LocalMesh) {
        let corners = mesh.corners(triangle);
        let [a, b, c] = corners;
        for axis in 0..3 {
            self.a[axis].as_mut_array()[lane] = a[axis] as f32;
            self.ab[axis].as_mut_array()[lane] = (b - a)[axis] as f32;
            self.ac[axis].as_mut_array()[lane] = (c - a)[axis] as f32;
        }
        self.triangles[lane] = if is_thin(corners) { triangle | THIN } else { triangle };
    }

    /// Copies a lane of another packet.
    pub(super) fn copy_lane(&mut self, lane: usize, other: &Self, other_lane: usize) {
        for axis in 0..3 {
            self.a[axis].as_mut_array()[lane] = other.a[axis].as_array()[other_lane];
            self.ab[axis].as_mut_array()[lane] = other.ab[axis].as_array()[other_lane];
            self.ac[axis].as_mut_array()[lane] = other.ac[axis].as_array()[other_lane];
        }
        self.triangles[lane] = other.triangles[other_lane];
    }

    pub(super) fn triangle(&self, lane: usize) -> u32 {
        self.triangles[lane] & !THIN
    }

    /// Lanes of thin triangles, a bit each.
    #[inline(always)]
    pub(super) fn thin_lanes(&self) -> u32 {
        wide::u32x8::new(self.triangles).to_bitmask()
    }

    pub(super) fn triangles(&self) -> impl Iterator<Item = u32> + Clone {
        let used = self.triangles.into_iter().filter(|&triangle| triangle != NO_TRIANGLE);
        used.map(|triangle| triangle & !THIN)
    }

    /// Squared distances to the triangles: the four candidates of
    /// [`closest_point`](super::triangle::closest_point), without the features.
    #[inline(always)]
    pub(super) fn distances_squared(&self, query: Query) -> f32x8 {
        let (ab, ac) = (self.ab, self.ac);
        let ap = minus(query, self.a);

        // Edges. Squared lengths are kept off zero.
        let least = f32x8::splat(f32::MIN_POSITIVE);
        let edge = |from_start: [f32x8; 3], edge: [f32x8; 3]| {
            let along = dot(from_start, edge) / dot(edge, edge).fast_max(least);
            let along = along.fast_max(f32x8::ZERO).fast_min(f32x8::ONE);
            let rest = minus(from_start, times(edge, along));
            dot(rest, rest)
        };
        let boundary = edge(ap, ab).fast_min(edge(ap, ac)).fast_min(edge(minus(ap, ab), minus(ac, ab)));

        // Face, where the projection is inside.
        let normal = cross(ab, ac);
        let across = cross(ap, normal);
        let scale = f32x8::ONE / dot(normal, normal).fast_max(least);
        let along_ab = -dot(ac, across) * scale;
        let along_ac = dot(ab, across) * scale;
        let rest = minus(minus(ap, times(ab, along_ab)), times(ac, along_ac));
        let face = dot(rest, rest);
        let inside = along_ab.simd_ge(f32x8::ZERO)
            & along_ac.simd_ge(f32x8::ZERO)
            & (along_ab + along_ac).simd_le(f32x8::ONE)
            & boundary.simd_gt(face);
        inside.bitselect(face, boundary)
    }
}

#[inline(always)]
pub(super) fn minus(a: [f32x8; 3], b: [f32x8; 3]) -> [f32x8; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn times(a: [f32x8; 3], s: f32x8) -> [f32x8; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

#[inline(always)]
pub(super) fn dot(a: [f32x8; 3], b: [f32x8; 3]) -> f32x8 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
pub(super) fn cross(a: [f32x8; 3], b: [f32x8; 3]) -> [f32x8; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Whether single precision may overstate the distance to a triangle by more than δ/2, for the
/// smallest δ there is. See the head of this file.
fn is_thin([a, b, c]: [DVec3; 3]) -> bool {
    let [ab, bc, ca] = [b - a, c - b, a - c];
    let longest = ab.length().max(bc.length()).max(ca.length());
    let height = ab.cross(ca).length() / longest;
    let slenderness = longest / height;
    let error = 4.0 * f64::from(f32::EPSILON / 2.0) * slenderness * longest;
    height > DELTA && (error > DELTA || slenderness > 512.0)
}
