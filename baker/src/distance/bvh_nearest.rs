//! Finds the closest triangle: a coarse search in single precision whose error is bounded, then a
//! decision in double precision among the few triangles that the bound leaves.
//!
//! With δ as in [`bvh`](super::bvh): after any triangle reported F, everything with
//! √F' > √F + 2δ, or in a box with √L > √F + 2δ, is farther than that triangle, and is dropped. Thin
//! triangles are kept for the exact decision wherever their packet is reached. The closest triangle,
//! and every triangle that ties with it, survives: the answer is the least (squared distance in
//! double precision, triangle) over all triangles, whatever the order of the search.
//!
//! Neighbouring queries share one search. If all are within ρ of a centre, then only triangles
//! within d + 2ρ of the centre, d away from its closest, can be closest to any of them: it is the
//! same search with 2δ + 2ρ instead of 2δ. Each query then looks at the triangles that it found.

use super::bvh::{Bvh, Child, ChildRef, LANES, Packet, Query, STACK, coarse_error, splat};
use super::local_mesh::LocalMesh;
use super::triangle::{Closest, closest_point};
use glam::DVec3;
use wide::f32x8;

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
    candidates: Vec<Candidate>,
}

impl Scratch {
    pub(super) fn new() -> Self {
        Self {
            stack: [(0.0, ChildRef::ROOT); STACK],
            candidates: Vec::new(),
        }
    }
}

/// A triangle that may be the closest.
#[derive(Clone, Copy)]
struct Candidate {
    /// Squared distance in single precision; of its box if the triangle is thin.
    distance_squared: f32,
    /// The packet's place, and the lane in its three low bits.
    place: u32,
    triangle: u32,
}

/// Finds the closest triangle to a finite local point. The `seed` is any triangle, best a near one:
/// it speeds the search up and never bears on the answer.
pub(super) fn nearest(
    mesh: &LocalMesh,
    bvh: &Bvh,
    point: DVec3,
    seed: u32,
    scratch: &mut Scratch,
) -> Nearest {
    let mut decision = Decision::new(mesh, point);
    decision.compare(seed);
    let Some(error) = coarse_error(point) else {
        (0..mesh.triangles.len() as u32).for_each(|triangle| decision.compare(triangle));
        return decision.best;
    };

    let mut coarse = Coarse::new(point, 2.0 * error);
    coarse.lower_cut(decision.best.closest.distance_squared as f32);
    coarse.search(bvh, usize::MAX, scratch);
    coarse.decide(&scratch.candidates, decision)
}

/// The triangles that a group of neighbouring queries shares.
pub(super) struct Group {
    centre: DVec3,
    /// The nearest to the centre first.
    packets: Vec<Packet>,
    /// Distance of each packet's nearest triangle from the centre, in single precision.
    reaches: Vec<f32>,
}

impl Group {
    pub(super) fn new() -> Self {
        Self {
            centre: DVec3::ZERO,
            packets: Vec::new(),
            reaches: Vec::new(),
        }
    }

    /// Gathers the triangles that may be closest to points within `radius` of `centre` and returns
    /// how many they are. Gives up beyond `limit`.
    pub(super) fn gather(
        &mut self,
        mesh: &LocalMesh,
        bvh: &Bvh,
        (centre, radius): (DVec3, f64),
        seed: u32,
        limit: usize,
        scratch: &mut Scratch,
    ) -> Option<usize> {
        let mut coarse = Coarse::new(centre, 2.0 * (coarse_error(centre)? + radius as f32));
        coarse.lower_cut(closest_point(centre, mesh.corners(seed)).distance_squared as f32);
        coarse.search(bvh, limit, scratch).then_some(())?;

        let candidates = &mut scratch.candidates;
        candidates.retain(|candidate| candidate.distance_squared <= coarse.cut);
        candidates.sort_unstable_by(|a, b| a.distance_squared.total_cmp(&b.distance_squared));
        self.centre = centre;
        self.packets.clear();
        self.reaches.clear();
        for chunk in candidates.chunks(LANES) {
            let mut packet = Packet::EMPTY;
            for (lane, candidate) in chunk.iter().enumerate() {
                let place = candidate.place as usize;
                packet.copy_lane(lane, &bvh.packets[place / LANES], place % LANES);
            }
            self.packets.push(packet);
            self.reaches.push(chunk[0].distance_squared.sqrt());
        }
        Some(candidates.len())
    }

    /// Finds the closest triangle to a point of the group.
    pub(super) fn nearest(
        &self,
        mesh: &LocalMesh,
        point: DVec3,
        scratch: &mut Scratch,
    ) -> Option<Nearest> {
        let mut coarse = Coarse::new(point, 2.0 * coarse_error(point)?);
        let off_centre = point.distance(self.centre) as f32;
        scratch.candidates.clear();
        for (place, (packet, reach)) in self.packets.iter().zip(&self.reaches).enumerate() {
            let nearer = (reach - off_centre).max(0.0);
            if nearer * nearer > coarse.cut {
                break;
            }
            coarse.visit_packet(packet, place, nearer * nearer, &mut scratch.candidates);
        }
        Some(coarse.decide(&scratch.candidates, Decision::new(mesh, point)))
    }
}

/// The exact decision among triangles.
struct Decision<'a> {
    mesh: &'a LocalMesh,
    point: DVec3,
    best: Nearest,
}

impl<'a> Decision<'a> {
    fn new(mesh: &'a LocalMesh, point: DVec3) -> Self {
        Self {
            mesh,
            point,
            best: Nearest {
                triangle: u32::MAX,
                closest: Closest::NOWHERE,
            },
        }
    }

    fn compare(&mut self, triangle: u32) {
        let closest = closest_point(self.point, self.mesh.corners(triangle));
        let (old, new) = (self.best.closest.distance_squared, closest.distance_squared);
        if new < old || (new == old && self.is_before(triangle)) {
            self.best = Nearest { triangle, closest };
        }
    }

    /// Whether the mesh lists this triangle before the best one.
    fn is_before(&self, triangle: u32) -> bool {
        self.mesh.numbers[triangle as usize] < self.mesh.numbers[self.best.triangle as usize]
    }
}

/// The search in single precision.
struct Coarse {
    query: Query,
    /// 2δ, or 2δ + 2ρ.
    margin: f32,
    /// What is beyond this squared distance is not the closest.
    cut: f32,
}

impl Coarse {
    fn new(point: DVec3, margin: f32) -> Self {
        Self {
            query: splat(point),
            margin,
            cut: f32::INFINITY,
        }
    }

    /// Takes in that some triangle is at this squared distance in single precision.
    #[inline(always)]
    fn lower_cut(&mut self, distance_squared: f32) {
        let reach = distance_squared.sqrt() + self.margin;
        self.cut = self.cut.min(reach * reach);
    }

    /// Leaves in `scratch` all triangles that may be closest. Gives up, and returns false, when they
    /// stay above `limit`.
    fn search(&mut self, bvh: &Bvh, limit: usize, scratch: &mut Scratch) -> bool {
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
    fn visit_packet(
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
            let distance_squared = if is_thin {
                box_distance_squared
            } else {
                distances[lane]
            };
            if distance_squared <= self.cut {
                let place = (place * LANES + lane) as u32;
                candidates.push(Candidate {
                    distance_squared,
                    place,
                    triangle: packet.triangle(lane),
                });
            }
        }
    }

    /// Lanes within the cut, a bit each.
    #[inline(always)]
    fn near(&self, distances_squared: f32x8) -> u32 {
        distances_squared
            .simd_le(f32x8::splat(self.cut))
            .to_bitmask()
    }

    fn decide(&self, candidates: &[Candidate], mut decision: Decision) -> Nearest {
        for candidate in candidates
            .iter()
            .filter(|candidate| candidate.distance_squared <= self.cut)
        {
            decision.compare(candidate.triangle);
        }
        decision.best
    }
}
