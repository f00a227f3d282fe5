//! Finds the closest triangle: a coarse search in single precision whose error is bounded, then a
//! decision in double precision among the few triangles that the bound leaves.
//!
//! The frame is that of [`LocalMesh`]: triangles within [−1, 1]³. With Q the largest coordinate of
//! the query (at least 1), u = 2⁻²⁴ and δ = 32 u (1 + Q), for every triangle at distance d:
//!
//! 1. A packet reports √F ≥ d − δ. F is the squared length of a vector from the query to a point
//!    that lies on the triangle up to rounding, whichever branch was taken: its parameters are
//!    clamped or tested in the rounded arithmetic itself. What is left is the rounding of the query,
//!    of corner a and of the edges (√3 u/2 · (Q + 1 + 4)), of the difference and of at most two
//!    products and sums per component (each at most 4 √3 u (Q + 1)) and of the sum of squares
//!    (relative 3 u, on d ≤ √3 (Q + 1)): in all under 16 u (1 + Q).
//! 2. It reports √F ≤ d + δ unless the triangle is *thin*. The parameters along an edge are off by at
//!    most a few u · |q − a| / |edge|, which moves the point by a few u · |q − a| and, as the
//!    distance is stationary there, costs its square. The parameters in the face are off by κ = longest
//!    edge ÷ height times as much; far away this costs a square again, near by it moves the point by
//!    at most 4 u κ L for a longest edge L. A triangle is thin when this could exceed δ/2, unless its
//!    height is below δ: then the closest edge point is as good as the face. See [`is_thin`].
//! 3. A node reports √L ≤ d + δ for its triangles: boxes are rounded outward.
//!
//! So after any triangle reported F, everything with √F' > √F + 2δ or √L > √F + 2δ is farther than
//! that triangle, and is dropped. Thin triangles are kept for the exact decision wherever their packet
//! is reached. The closest triangle, and every triangle that ties with it, survives: the answer is the
//! least (squared distance in f64, triangle) over all triangles, whatever the order of the search.

use super::bvh_build::{Bounds, MAX_DEPTH};
use super::local_mesh::LocalMesh;
use super::triangle::{Closest, closest_point};
use glam::DVec3;
use wide::f32x8;

/// Children of a node, triangles of a packet.
pub(super) const LANES: usize = 8;
/// Every level leaves at most seven siblings behind, and the last has eight entries.
pub(super) const STACK: usize = (LANES - 1) * MAX_DEPTH + LANES;
/// Triangles that await the exact decision.
const CANDIDATES: usize = 32;
/// Largest coordinate of a query that the coarse search takes. Farther out single precision cannot
/// tell the triangles apart, and all are compared exactly.
const FARTHEST: f64 = (1 << 20) as f64;
/// Whether the coarse search and the dipoles take a local point.
pub(super) fn is_within_reach(point: DVec3) -> bool {
    point.abs().max_element() <= FARTHEST
}

/// 32 u.
const DELTA: f64 = 1.0 / (1 << 19) as f64;

/// The tree: node 0 is the root.
pub(super) struct Bvh {
    pub(super) nodes: Vec<Node>,
    pub(super) packets: Vec<Packet>,
}

/// Eight boxes. Unused ones are empty: infinitely far from everything.
#[repr(align(64))]
pub(super) struct Node {
    min: [f32x8; 3],
    max: [f32x8; 3],
    children: [ChildRef; LANES],
}

/// A node or a packet.
#[derive(Clone, Copy)]
pub(super) struct ChildRef(u32);

impl ChildRef {
    const PACKET: u32 = 1 << 31;

    pub(super) fn node(index: usize) -> Self {
        Self(index as u32)
    }

    pub(super) fn packet(index: usize) -> Self {
        Self(index as u32 | Self::PACKET)
    }

    fn child(self) -> Child {
        let index = (self.0 & !Self::PACKET) as usize;
        if self.0 & Self::PACKET == 0 { Child::Node(index) } else { Child::Packet(index) }
    }
}

/// What a [`ChildRef`] refers to, by index.
pub(super) enum Child {
    Node(usize),
    Packet(usize),
}

impl Node {
    pub(super) const EMPTY: Self = Self {
        min: [f32x8::splat(f32::INFINITY); 3],
        max: [f32x8::splat(f32::NEG_INFINITY); 3],
        children: [ChildRef(0); LANES],
    };

    pub(super) fn set_child(&mut self, lane: usize, bounds: Bounds, child: ChildRef) {
        for axis in 0..3 {
            self.min[axis].as_mut_array()[lane] = bounds.min[axis];
            self.max[axis].as_mut_array()[lane] = bounds.max[axis];
        }
        self.children[lane] = child;
    }

    pub(super) fn child(&self, lane: usize) -> Option<Child> {
        let used = self.min[0].as_array()[lane] != f32::INFINITY;
        used.then(|| self.children[lane].child())
    }

    /// Distance from a point to the farthest corner of a child's box.
    pub(super) fn farthest_corner(&self, lane: usize, point: DVec3) -> f64 {
        let [min, max] = [&self.min, &self.max]
            .map(|side| DVec3::from_array([0, 1, 2].map(|k| f64::from(side[k].as_array()[lane]))));
        (point - min).abs().max((max - point).abs()).length()
    }

    /// Squared distances to the boxes.
    #[inline(always)]
    fn distances_squared(&self, query: [f32x8; 3]) -> f32x8 {
        let outside = |k: usize| (self.min[k] - query[k]).fast_max(query[k] - self.max[k]).fast_max(f32x8::ZERO);
        let [x, y, z] = [outside(0), outside(1), outside(2)];
        x * x + y * y + z * z
    }
}

/// Eight triangles in single precision: a corner and the two edges that leave it.
#[repr(align(64))]
pub(super) struct Packet {
    a: [f32x8; 3],
    ab: [f32x8; 3],
    ac: [f32x8; 3],
    /// Triangle of each lane, with [`THIN`] added for thin ones, or [`NO_TRIANGLE`].
    triangles: [u32; LANES],
}

const THIN: u32 = 1 << 31;
const NO_TRIANGLE: u32 = u32::MAX & !THIN;

impl Packet {
    pub(super) fn new(mesh: &LocalMesh, triangles: impl Iterator<Item = u32>) -> Self {
        // Unused lanes hold a point far beyond every query.
        let far = f32x8::splat(1e17);
        let zero = f32x8::ZERO;
        let mut packet = Self { a: [far; 3], ab: [zero; 3], ac: [zero; 3], triangles: [NO_TRIANGLE; LANES] };
        for (lane, triangle) in triangles.enumerate() {
            let corners = mesh.corners(triangle);
            let [a, b, c] = corners;
            for axis in 0..3 {
                packet.a[axis].as_mut_array()[lane] = a[axis] as f32;
                packet.ab[axis].as_mut_array()[lane] = (b - a)[axis] as f32;
                packet.ac[axis].as_mut_array()[lane] = (c - a)[axis] as f32;
            }
            packet.triangles[lane] = if is_thin(corners) { triangle | THIN } else { triangle };
        }
        packet
    }

    pub(super) fn triangles(&self) -> impl Iterator<Item = u32> {
        self.triangles.into_iter().filter(|&triangle| triangle != NO_TRIANGLE).map(|triangle| triangle & !THIN)
    }

    /// Squared distances to the triangles: the four candidates of
    /// [`closest_point`](super::triangle::closest_point), without the features.
    #[inline(always)]
    fn distances_squared(&self, query: [f32x8; 3]) -> f32x8 {
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
fn minus(a: [f32x8; 3], b: [f32x8; 3]) -> [f32x8; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn times(a: [f32x8; 3], s: f32x8) -> [f32x8; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

#[inline(always)]
fn dot(a: [f32x8; 3], b: [f32x8; 3]) -> f32x8 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross(a: [f32x8; 3], b: [f32x8; 3]) -> [f32x8; 3] {
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

/// The closest triangle and the closest point on it, in the frame of the search.
#[derive(Clone, Copy)]
pub(super) struct Nearest {
    pub(super) triangle: u32,
    pub(super) closest: Closest,
}

/// Memory of a search, to be used again by the next one. It never bears on the answer.
pub(super) struct Scratch {
    /// Squared distance of a box and what is in it, the nearest on top.
    stack: [(f32, ChildRef); STACK],
    /// Squared distance in single precision and the triangle.
    candidates: [(f32, u32); CANDIDATES],
    candidate_count: usize,
}

impl Scratch {
    pub(super) fn new() -> Self {
        Self { stack: [(0.0, ChildRef(0)); STACK], candidates: [(0.0, 0); CANDIDATES], candidate_count: 0 }
    }
}

impl Bvh {
    /// Finds the closest triangle to a finite local point. A `seed` is any triangle, best a near one:
    /// it speeds the search up and never bears on the answer.
    pub(super) fn nearest(&self, mesh: &LocalMesh, point: DVec3, seed: Option<u32>, scratch: &mut Scratch) -> Nearest {
        let first = seed.unwrap_or(0);
        let mut search = Search {
            mesh,
            point,
            best: Nearest { triangle: first, closest: closest_point(point, mesh.corners(first)) },
            margin: 0.0,
            cut: f32::INFINITY,
            scratch,
        };
        if is_within_reach(point) {
            let largest = point.abs().max_element().max(1.0);
            search.margin = (2.0 * DELTA * (1.0 + largest)) as f32;
            search.lower_cut(search.best.closest.distance_squared as f32);
            search.descend(self);
        } else {
            (0..mesh.triangles.len() as u32).for_each(|triangle| search.compare(triangle));
        }
        search.best
    }
}

struct Search<'a> {
    mesh: &'a LocalMesh,
    point: DVec3,
    best: Nearest,
    /// 2δ.
    margin: f32,
    /// What is beyond this squared distance is not the closest.
    cut: f32,
    scratch: &'a mut Scratch,
}

impl Search<'_> {
    fn descend(&mut self, bvh: &Bvh) {
        let query = self.point.as_vec3().to_array().map(f32x8::splat);
        let mut height = 1;
        self.scratch.stack[0] = (0.0, ChildRef::node(0));
        while height > 0 {
            height -= 1;
            let (distance_squared, child) = self.scratch.stack[height];
            if distance_squared > self.cut {
                continue;
            }
            match child.child() {
                Child::Node(node) => height = self.visit_node(&bvh.nodes[node], query, height),
                Child::Packet(packet) => self.visit_packet(&bvh.packets[packet], query, distance_squared),
            }
        }
        self.settle();
    }

    /// Pushes the children that are near enough, the nearest last.
    #[inline(always)]
    fn visit_node(&mut self, node: &Node, query: [f32x8; 3], base: usize) -> usize {
        let distances = node.distances_squared(query);
        let mut near = distances.simd_le(f32x8::splat(self.cut)).to_bitmask();
        let distances = distances.to_array();
        let mut height = base;
        while near != 0 {
            let lane = near.trailing_zeros() as usize & (LANES - 1);
            near &= near - 1;
            let distance = distances[lane];
            let mut place = height;
            while place > base && self.scratch.stack[place - 1].0 < distance {
                self.scratch.stack[place] = self.scratch.stack[place - 1];
                place -= 1;
            }
            self.scratch.stack[place] = (distance, node.children[lane]);
            height += 1;
        }
        height
    }

    #[inline(always)]
    fn visit_packet(&mut self, packet: &Packet, query: [f32x8; 3], box_distance_squared: f32) {
        let distances = packet.distances_squared(query);
        let least = distances.to_array().into_iter().fold(f32::INFINITY, |a, b| if b < a { b } else { a });
        self.lower_cut(least);

        let mut near = distances.simd_le(f32x8::splat(self.cut)).to_bitmask();
        while near != 0 {
            let lane = near.trailing_zeros() as usize & (LANES - 1);
            near &= near - 1;
            if packet.triangles[lane] & THIN == 0 {
                self.keep(distances.to_array()[lane], packet.triangles[lane]);
            }
        }
        for triangle in packet.triangles {
            if triangle & THIN != 0 {
                self.keep(box_distance_squared, triangle & !THIN);
            }
        }
    }

    /// Takes in that some triangle is at this squared distance in single precision.
    #[inline(always)]
    fn lower_cut(&mut self, distance_squared: f32) {
        let reach = distance_squared.sqrt() + self.margin;
        let cut = reach * reach;
        if cut < self.cut {
            self.cut = cut;
        }
    }

    #[inline(always)]
    fn keep(&mut self, distance_squared: f32, triangle: u32) {
        if self.scratch.candidate_count == CANDIDATES {
            self.settle();
        }
        self.scratch.candidates[self.scratch.candidate_count] = (distance_squared, triangle);
        self.scratch.candidate_count += 1;
    }

    /// Decides among the triangles kept so far.
    fn settle(&mut self) {
        for k in 0..self.scratch.candidate_count {
            let (distance_squared, triangle) = self.scratch.candidates[k];
            if distance_squared <= self.cut {
                self.compare(triangle);
            }
        }
        self.scratch.candidate_count = 0;
    }

    fn compare(&mut self, triangle: u32) {
        let closest = closest_point(self.point, self.mesh.corners(triangle));
        let (old, new) = (self.best.closest.distance_squared, closest.distance_squared);
        if new < old || (new == old && triangle < self.best.triangle) {
            self.best = Nearest { triangle, closest };
        }
    }
}
