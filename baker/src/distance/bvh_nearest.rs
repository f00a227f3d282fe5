//! Finds the closest triangle: a coarse search in single precision whose error is bounded, then a
//! decision in double precision among the few triangles that the bound leaves.
//!
//! With δ as in [`bvh`](super::bvh): after any triangle reported F, everything with
//! √F' > √F + 2δ, or in a box with √L > √F + 2δ, is farther than that triangle, and is dropped. Thin
//! triangles are kept for the exact decision wherever their packet is reached. The closest triangle,
//! and every triangle that ties with it, survives: the answer is the least (squared distance in
//! double precision, triangle) over all triangles, whatever the order of the search.

use super::bvh::{Bvh, Child, ChildRef, LANES, Packet, Query, STACK, coarse_error, is_within_reach, splat};
use super::local_mesh::LocalMesh;
use super::triangle::{Closest, closest_point, distance_squared};
use glam::DVec3;
use wide::f32x8;

/// The closest triangle and the closest point on it, in the frame of the search.
#[derive(Clone, Copy)]
pub(super) struct Nearest {
    pub(super) triangle: u32,
    pub(super) closest: Closest,
}

/// A mesh and its tree.
pub(super) struct Finder {
    pub(super) mesh: LocalMesh,
    pub(super) bvh: Bvh,
}

impl Finder {
    /// Finds the closest triangle to a finite local point. The `seed` is any triangle, best a near
    /// one: it speeds the search up and never bears on the answer.
    pub(super) fn nearest(&self, point: DVec3, seed: u32, scratch: &mut Scratch) -> Nearest {
        let mut decision = Decision::new(&self.mesh, point);
        if !is_within_reach(point) {
            (0..self.mesh.triangles.len() as u32).for_each(|triangle| decision.compare(triangle));
            return decision.best();
        }
        let mut coarse = Coarse::new(point, 0.0);
        coarse.lower_cut(distance_squared(point, self.mesh.corners(seed)) as f32);
        coarse.search(&self.bvh, usize::MAX, scratch);
        coarse.decide(&scratch.candidates, decision)
    }
}

/// Memory of a search, to be used again by the next one. It never bears on the answer.
pub(super) struct Scratch {
    /// Squared distance of a box and what is in it, the nearest on top.
    stack: [(f32, ChildRef); STACK],
    pub(super) candidates: Vec<Candidate>,
}

impl Scratch {
    pub(super) fn new() -> Self {
        Self { stack: [(0.0, ChildRef::ROOT); STACK], candidates: Vec::new() }
    }
}

/// A triangle that may be the closest.
#[derive(Clone, Copy)]
pub(super) struct Candidate {
    /// Squared distance in single precision; of its box if the triangle is thin.
    pub(super) distance_squared: f32,
    /// Eight times its packet, plus its lane.
    pub(super) place: u32,
    triangle: u32,
}

/// The exact decision among triangles.
pub(super) struct Decision<'a> {
    mesh: &'a LocalMesh,
    point: DVec3,
    triangle: u32,
    distance_squared: f64,
}

impl<'a> Decision<'a> {
    pub(super) fn new(mesh: &'a LocalMesh, point: DVec3) -> Self {
        Self { mesh, point, triangle: u32::MAX, distance_squared: f64::INFINITY }
    }

    fn compare(&mut self, triangle: u32) {
        let distance_squared = distance_squared(self.point, self.mesh.corners(triangle));
        let is_tie = distance_squared == self.distance_squared;
        if distance_squared < self.distance_squared || (is_tie && self.is_before(triangle)) {
            (self.triangle, self.distance_squared) = (triangle, distance_squared);
        }
    }

    /// Whether the mesh lists this triangle before the best one.
    fn is_before(&self, triangle: u32) -> bool {
        self.mesh.numbers[triangle as usize] < self.mesh.numbers[self.triangle as usize]
    }

    fn best(&self) -> Nearest {
        let closest = closest_point(self.point, self.mesh.corners(self.triangle));
        Nearest { triangle: self.triangle, closest }
    }
}

/// The search in single precision.
pub(super) struct Coarse {
    query: Query,
    /// 2δ, and twice the radius.
    margin: f32,
    /// What is beyond this squared distance is not the closest.
    pub(super) cut: f32,
}

impl Coarse {
    /// A search for the triangles that may be closest to any point within `radius` of this one.
    pub(super) fn new(point: DVec3, radius: f64) -> Self {
        let margin = 2.0 * (coarse_error(point) + radius) as f32;
        Self { query: splat(point), margin, cut: f32::INFINITY }
    }

    /// Takes in that some triangle is at this squared distance in single precision.
    #[inline(always)]
    pub(super) fn lower_cut(&mut self, distance_squared: f32) {
        let reach = distance_squared.sqrt() + self.margin;
        self.cut = self.cut.min(reach * reach);
    }

    /// Leaves in `scratch` all triangles that may be closest. Gives up, and returns false, when they
    /// stay above `limit`.
    pub(super) fn search(&mut self, bvh: &Bvh, limit: usize, scratch: &mut Scratch) -> bool {
        let Scratch { stack, candidates } = scratch;
        candidates.clear();
        let mut height = 1;
        stack[0] = (0.0, ChildRef::ROOT);
        while height > 0 {
            height -= 1;
            let (distance_squared, child) = stack[height];
            if distance_squared > self.cut {
                continue;
            }
            match child.child() {
                Child::Node(index) => {
                    // The children that are near enough, the nearest last.
                    let node = &bvh.nodes[index];
                    let distances = node.distances_squared(self.query);
                    let mut near = self.near(distances);
                    let distances = distances.to_array();
                    let base = height;
                    while near != 0 {
                        let lane = near.trailing_zeros() as usize % LANES;
                        near &= near - 1;
                        let mut place = height;
                        while place > base && stack[place - 1].0 < distances[lane] {
                            stack[place] = stack[place - 1];
                            place -= 1;
                        }
                        stack[place] = (distances[lane], node.children[lane]);
                        height += 1;
                    }
                }
                Child::Packet(index) => {
                    self.visit_packet(&bvh.packets[index], index, distance_squared, candidates);
                    if candidates.len() > limit {
                        candidates.retain(|candidate| candidate.distance_squared <= self.cut);
                        if candidates.len() > limit {
                            return false;
                        }
                    }
                }
            }
        }
        true
    }

    /// Keeps the triangles of a packet that may be closest.
    #[inline(always)]
    pub(super) fn visit_packet(
        &mut self,
        packet: &Packet,
        place: usize,
        box_distance_squared: f32,
        candidates: &mut Vec<Candidate>,
    ) {
        let distances = packet.distances_squared(self.query);
        let thin = packet.thin_lanes();
        let mut near = self.near(distances) | thin;
        if near == 0 {
            return;
        }
        let distances = distances.to_array();
        self.lower_cut(distances.into_iter().fold(f32::INFINITY, f32::min));
        while near != 0 {
            let lane = near.trailing_zeros() as usize % LANES;
            near &= near - 1;
            let is_thin = thin & (1 << lane) != 0;
            let distance_squared = if is_thin { box_distance_squared } else { distances[lane] };
            if distance_squared <= self.cut {
                let place = (place * LANES + lane) as u32;
                candidates.push(Candidate { distance_squared, place, triangle: packet.triangle(lane) });
            }
        }
    }

    /// Lanes within the cut, a bit each.
    #[inline(always)]
    fn near(&self, distances_squared: f32x8) -> u32 {
        distances_squared.simd_le(f32x8::splat(self.cut)).to_bitmask()
    }

    /// Decides among the candidates that the final cut leaves.
    pub(super) fn decide(&self, candidates: &[Candidate], mut decision: Decision) -> Nearest {
        let mut left = candidates
            .iter()
            .filter(|candidate| candidate.distance_squared <= self.cut)
            .map(|candidate| candidate.triangle);
        match (left.next(), left.next()) {
            (Some(only), None) => decision.triangle = only,
            (first, second) => {
                first.into_iter().chain(second).chain(left).for_each(|triangle| decision.compare(triangle));
            }
        }
        decision.best()
    }
}
