//! Where a ray in a fixed direction meets the triangles.
//!
//! In the frame of the ray, whose third axis is its direction, a triangle is met when the query is inside
//! its projection along that axis and behind it. Boxes in that frame make a query a comparison of intervals.
//! The decision is in double precision, and watertight: corners are moved and turned alike for every
//! triangle, each edge is judged alike from both its sides, and a ray through an edge or a corner falls to
//! one of the triangles there. So the crossings of a closed surface sum to its winding number, exactly.

use super::bvh::{Child, LANES, STACK};
use super::bvh_nearest::Finder;
use super::local_mesh::{LocalMesh, round_down, round_up};
use glam::{DMat3, DVec2, DVec3};
use rayon::prelude::*;
use wide::f32x8;

/// What single precision may make of a coordinate of the query, generously: coordinates are below 4.
const SLACK: f64 = 1e-6;
/// Queries farther out than this in any coordinate of the ray's frame meet nothing.
const REACH: f64 = 4.0;

/// Boxes in the frame of a ray, parallel to the nodes and packets of the search tree.
pub(super) struct RayTree {
    /// Rows: across, across, along.
    frame: DMat3,
    nodes: Vec<Boxes>,
    packets: Vec<Boxes>,
}

/// Crossings of the ray with the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Crossings {
    /// Crossings from behind less those from the front.
    pub(super) signed: i32,
    pub(super) count: u32,
}

/// Eight boxes; unused ones are empty.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(super) struct Boxes {
    min: [f32x8; 3],
    max: [f32x8; 3],
}

/// A box in the frame of a ray, rounded outward.
#[derive(Clone, Copy)]
pub(super) struct RayBox {
    min: [f32; 3],
    max: [f32; 3],
}

/// Rays that can be told apart.
pub(super) const DIRECTIONS: usize = 7;

/// The frame of a ray: directions spread over the sphere on a spiral, turned so that none lies in a plane in
/// which meshes like to have their walls.
fn frame_of(number: usize) -> DMat3 {
    const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;
    let height = 1.0 - (2 * number + 1) as f64 / DIRECTIONS as f64;
    let (sine, cosine) = libm::sincos(0.731 + GOLDEN_ANGLE * number as f64);
    let radius = (1.0 - height * height).sqrt();
    let spiral = DVec3::new(radius * cosine, radius * sine, height);

    // Tilted: the spiral's middle lies in the plane z = 0.
    let (sine, cosine) = libm::sincos(0.437);
    let along = DVec3::new(spiral.x * cosine - spiral.z * sine, spiral.y, spiral.x * sine + spiral.z * cosine);
    let (u, v) = along.any_orthonormal_pair();
    DMat3::from_cols(u, v, along).transpose()
}

impl RayTree {
    /// For the ray of a number below [`DIRECTIONS`].
    pub(super) fn new(Finder { mesh, bvh }: &Finder, number: usize) -> Self {
        let frame = frame_of(number);
        let packets: Vec<Boxes> = bvh
            .packets
            .par_iter()
            .map(|packet| {
                let mut boxes = Boxes::EMPTY;
                for (lane, triangle) in packet.triangles().enumerate().filter(|(_, t)| !mesh.is_wall(*t)) {
                    boxes.set(lane, RayBox::around(frame, mesh.corners(triangle)));
                }
                boxes
            })
            .collect();

        // Children come after their parents.
        let mut nodes = vec![Boxes::EMPTY; bvh.nodes.len()];
        for (index, node) in bvh.nodes.iter().enumerate().rev() {
            for lane in 0..LANES {
                let joined = match node.child(lane) {
                    None => continue,
                    Some(Child::Node(child)) => nodes[child].joined(),
                    Some(Child::Packet(packet)) => packets[packet].joined(),
                };
                nodes[index].set(lane, joined);
            }
        }
        Self { frame, nodes, packets }
    }

    /// What the ray from a finite local point meets.
    pub(super) fn crossings(&self, Finder { mesh, bvh }: &Finder, point: DVec3) -> Crossings {
        let mut found = Crossings::default();
        let query = self.frame * point;
        if query.abs().max_element() > REACH {
            return found;
        }
        let query = query.as_vec3().to_array().map(f32x8::splat);
        let mut stack = [0u32; STACK];
        let mut height = 1;
        while height > 0 {
            height -= 1;
            let index = stack[height] as usize;
            let mut ahead = self.nodes[index].ahead_of(query);
            while ahead != 0 {
                let lane = ahead.trailing_zeros() as usize % LANES;
                ahead &= ahead - 1;
                match bvh.nodes[index].children[lane].child() {
                    Child::Node(child) => {
                        stack[height] = child as u32;
                        height += 1;
                    }
                    Child::Packet(packet) => {
                        let mut ahead = self.packets[packet].ahead_of(query);
                        while ahead != 0 {
                            let lane = ahead.trailing_zeros() as usize % LANES;
                            ahead &= ahead - 1;
                            let triangle = bvh.packets[packet].triangle(lane);
                            let crossing = self.crossing(mesh, triangle, point);
                            found.signed += crossing;
                            found.count += crossing.unsigned_abs();
                        }
                    }
                }
            }
        }
        found
    }

    /// 1 if the ray meets the triangle from behind, −1 if from the front, 0 if not at all.
    fn crossing(&self, mesh: &LocalMesh, triangle: u32, point: DVec3) -> i32 {
        let corners = mesh.corners(triangle).map(|corner| self.frame * (corner - point));
        let [a, b, c] = corners.map(DVec3::truncate);
        let turns = turns_past(a, b) + turns_past(b, c) + turns_past(c, a);
        if turns == 0 {
            return 0;
        }
        let is_ahead = match corners.map(|corner| corner.z > 0.0) {
            [true, true, true] => true,
            [false, false, false] => false,
            _ => {
                let [a, b, c] = corners;
                a.dot(b.cross(c)) * f64::from(turns) > 0.0
            }
        };
        if is_ahead { turns } else { 0 }
    }

    /// Calls `visit` for triangles whose boxes overlap that of a packet's lane, but only for those of later packets or
    /// later lanes of the same.
    pub(super) fn overlapping(&self, finder: &Finder, packet: usize, lane: usize, mut visit: impl FnMut(u32)) {
        let bounds = self.packets[packet].lane(lane);
        let (min, max) = (bounds.min.map(f32x8::splat), bounds.max.map(f32x8::splat));
        let mut stack = [0u32; STACK];
        let mut height = 1;
        while height > 0 {
            height -= 1;
            let index = stack[height] as usize;
            let mut near = self.nodes[index].overlapping(min, max);
            while near != 0 {
                let child_lane = near.trailing_zeros() as usize % LANES;
                near &= near - 1;
                match finder.bvh.nodes[index].children[child_lane].child() {
                    Child::Node(child) => {
                        stack[height] = child as u32;
                        height += 1;
                    }
                    Child::Packet(other) if other >= packet => {
                        let mut near = self.packets[other].overlapping(min, max);
                        if other == packet {
                            near &= !0 << (lane + 1);
                        }
                        while near != 0 {
                            let lane = near.trailing_zeros() as usize % LANES;
                            near &= near - 1;
                            visit(finder.bvh.packets[other].triangle(lane));
                        }
                    }
                    Child::Packet(_) => {}
                }
            }
        }
    }
}

/// How an edge passes the first axis from the origin on: 1 upward, −1 downward, 0 not at all.
fn turns_past(a: DVec2, b: DVec2) -> i32 {
    let (below, above, turn) = match (a.y > 0.0, b.y > 0.0) {
        (false, true) => (a, b, 1),
        (true, false) => (b, a, -1),
        _ => return 0,
    };
    if below.x * above.y > above.x * below.y { turn } else { 0 }
}

impl RayBox {
    fn around(frame: DMat3, corners: [DVec3; 3]) -> Self {
        let [a, b, c] = corners.map(|corner| frame * corner);
        let (min, max) = (a.min(b).min(c) - SLACK, a.max(b).max(c) + SLACK);
        Self { min: min.to_array().map(round_down), max: max.to_array().map(round_up) }
    }
}

impl Boxes {
    const EMPTY: Self = Self { min: [f32x8::splat(f32::INFINITY); 3], max: [f32x8::splat(f32::NEG_INFINITY); 3] };

    fn set(&mut self, lane: usize, bounds: RayBox) {
        for axis in 0..3 {
            self.min[axis].as_mut_array()[lane] = bounds.min[axis];
            self.max[axis].as_mut_array()[lane] = bounds.max[axis];
        }
    }

    fn lane(&self, lane: usize) -> RayBox {
        let of = |side: &[f32x8; 3]| std::array::from_fn(|axis| side[axis].as_array()[lane]);
        RayBox { min: of(&self.min), max: of(&self.max) }
    }

    /// The box around all eight.
    fn joined(&self) -> RayBox {
        let fold =
            |side: f32x8, pick: fn(f32, f32) -> f32| side.to_array().into_iter().reduce(pick).unwrap_or_default();
        RayBox { min: self.min.map(|side| fold(side, f32::min)), max: self.max.map(|side| fold(side, f32::max)) }
    }

    /// Boxes that the ray from the query may meet, a bit each.
    #[inline(always)]
    fn ahead_of(&self, [u, v, t]: [f32x8; 3]) -> u32 {
        let across = self.min[0].simd_le(u) & self.max[0].simd_ge(u) & self.min[1].simd_le(v) & self.max[1].simd_ge(v);
        (across & self.max[2].simd_ge(t)).to_bitmask()
    }

    #[inline(always)]
    fn overlapping(&self, min: [f32x8; 3], max: [f32x8; 3]) -> u32 {
        let along = |axis: usize| self.min[axis].simd_le(max[axis]) & self.max[axis].simd_ge(min[axis]);
        (along(0) & along(1) & along(2)).to_bitmask()
    }
}
