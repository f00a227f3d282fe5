//! The rim of a surface, and what it adds to the crossings of a ray to make a winding number.
//!
//! Close the surface by a cone from its rim to infinity, away from where the ray points. The ray does not
//! meet the cone, so its signed crossings are the winding number of the closed whole; that of the surface
//! is this less the cone's, whose faces are triangles with a corner at infinity. The result is exact for any
//! surface, and the sum is empty for a closed one.
//!
//! A loop of the rim that is far away, and not in the ray's way, counts as a dipole with the area vector of
//! its lid: the cone and the lid bound the same loop, and the ray meets neither.

use super::bvh::{LANES, dot, minus, splat};
use super::local_mesh::LocalMesh;
use super::solid_angle::{CoarseSolidAngles, SolidAngles};
use crate::geometry::Aabb;
use crate::mesh::DisjointSets;
use crate::mesh::adjacency::{Side, VertexCorners};
use glam::DVec3;
use std::f64::consts::PI;
use wide::f32x8;

/// A loop is far from this many of its radii on: its dipole is then off by less than 0.001.
const FAR: f64 = 8.0;

/// Edges where the triangles on one side are not balanced by those on the other.
pub(super) struct Rim {
    /// In the direction of the surplus, as often as it is large.
    pub(super) edges: Vec<[u32; 2]>,
    loops: Vec<Loop>,
    capsules: Vec<Capsules>,
}

/// Edges that are connected.
struct Loop {
    centre: DVec3,
    radius: f64,
    /// Area vector of the lid ÷ 4π.
    moment: DVec3,
    /// Area of the lid whose triangles have a corner at the centre ÷ 4π.
    lid: f64,
    packets: Vec<EdgePacket>,
}

/// Eight edges in single precision, and their ends.
struct EdgePacket {
    from: [f32x8; 3],
    to: [f32x8; 3],
    /// Number of edges, in the first lanes.
    edges: Vec<[u32; 2]>,
}

/// Capsules around eight edges, or around the edges of eight packets. Unused ones are infinitely far away.
struct Capsules {
    from: [f32x8; 3],
    along: [f32x8; 3],
    /// 1 ÷ squared length of the axis; 0 for a ball.
    per_length_squared: f32x8,
    radius: f32x8,
    /// Length of the edges ÷ 4π.
    length: f32x8,
    /// How many there are ÷ 2π.
    count: f32x8,
}

/// Rims of more edges have capsules around packets only: it takes eight times less to look at them.
const MOST_APART: usize = 2048;
/// Added to the radii of capsules: more than single precision makes of a distance near the surface.
const CAPSULE_SLACK: f64 = 1e-5;

impl Rim {
    pub(super) fn of(mesh: &LocalMesh) -> Self {
        let corners = VertexCorners::new(&mesh.triangles, mesh.positions.len());
        let visit = |edges: &mut Vec<[u32; 2]>, vertex: usize, sides: &[Side]| {
            for edge in sides.chunk_by(|a, b| a.other == b.other).filter(|edge| vertex < edge[0].other as usize) {
                let counted = edge.iter().filter(|side| !mesh.is_wall(side.triangle));
                let surplus: i32 = counted.map(|side| if side.outgoing { 1 } else { -1 }).sum();
                let ends = [vertex as u32, edge[0].other];
                let directed = if surplus > 0 { ends } else { [ends[1], ends[0]] };
                edges.extend(std::iter::repeat_n(directed, surplus.unsigned_abs() as usize));
            }
        };
        // Appending keeps the order of the vertices, however the work was shared.
        let edges = corners.sum_over_vertices(&mesh.triangles, visit, |a: Vec<[u32; 2]>, b| [a, b].concat());
        let loops = loops_of(mesh, &edges);
        let together = if edges.len() <= MOST_APART { 1 } else { LANES };
        let groups = loops.iter().flat_map(|rim| &rim.packets).flat_map(|packet| packet.edges.chunks(together));
        let capsules = groups.collect::<Vec<_>>().chunks(LANES).map(|groups| Capsules::around(mesh, groups)).collect();
        Self { edges, loops, capsules }
    }

    /// A radius around this point within which the winding number, but for its steps at the surface, changes by at most
    /// `change`.
    ///
    /// The gradient is the field of Biot and Savart of the rim: that of an edge, as seen from a distance r, is at most its
    /// length ÷ 4πr², and at most 1 ÷ 2πr however long it is. With D from the point to the nearest capsule and G the sum
    /// there, it is at most G ÷ (1 − t)² within tD.
    pub(super) fn reach(&self, point: DVec3, change: f64) -> f64 {
        let query = splat(point);
        let (mut nearest, mut steepness) = (f32x8::splat(f32::INFINITY), f32x8::ZERO);
        for capsules in &self.capsules {
            let gap = capsules.gap(query);
            // Outside a capsule no edge of it is nearer than the slack.
            let per_gap = f32x8::ONE / gap.fast_max(f32x8::splat(CAPSULE_SLACK as f32));
            nearest = nearest.fast_min(gap);
            steepness += per_gap * (capsules.length * per_gap).fast_min(capsules.count);
        }
        let nearest = f64::from(nearest.to_array().into_iter().fold(f32::INFINITY, f32::min));
        if nearest == 0.0 {
            return 0.0;
        }
        let steepness: f64 = steepness.to_array().into_iter().map(f64::from).sum();

        // The lesser root of t D G = change (1 − t)².
        let half = 1.0 + 0.5 * nearest * steepness / change;
        nearest / (half + (half * half - 1.0).sqrt())
    }

    /// What the lids of all loops add up to, at most, as a share of all directions.
    pub(super) fn lids_at_most(&self, point: DVec3) -> f64 {
        let of = |rim: &Loop| {
            let gap = (rim.centre.distance(point) - rim.radius).max(0.0);
            rim.lid / (gap * gap)
        };
        self.loops.iter().map(of).sum()
    }

    /// How much work a point is, in edges: a loop is at least looked at.
    pub(super) fn work(&self) -> usize {
        self.edges.len() / LANES + self.loops.len()
    }

    /// What the rim adds to the signed crossings of a ray from this point in this direction.
    pub(super) fn turns(&self, mesh: &LocalMesh, point: DVec3, direction: DVec3) -> f64 {
        let (mut near, mut near_coarse) = (SolidAngles::ZERO, CoarseSolidAngles::ZERO);
        let mut far = 0.0;
        let (query, apex) = (splat(point), splat(-direction));
        for Loop { centre, radius, moment, packets, .. } in &self.loops {
            let to_centre = *centre - point;
            let distance_squared = to_centre.length_squared();
            let along = to_centre.dot(direction);
            let is_in_the_way = along > 0.0 && distance_squared - along * along <= radius * radius;
            if distance_squared > FAR * FAR * radius * radius && !is_in_the_way {
                far += moment.dot(to_centre) / (distance_squared * distance_squared.sqrt());
                continue;
            }
            for EdgePacket { from, to, edges } in packets {
                let used = (1u32 << edges.len()) - 1;
                let mut unsure =
                    near_coarse.add_with_corner_at_infinity(apex, minus(*from, query), minus(*to, query), used);
                while unsure != 0 {
                    let lane = unsure.trailing_zeros() as usize;
                    unsure &= unsure - 1;
                    let [a, b] = edges[lane].map(|vertex| mesh.positions[vertex as usize] - point);
                    near.add_with_corner_at_infinity(-direction, a, b);
                }
            }
        }
        near.join(near_coarse.sum());
        far + near.total() / (4.0 * PI)
    }
}

fn loops_of(mesh: &LocalMesh, edges: &[[u32; 2]]) -> Vec<Loop> {
    let mut sets = DisjointSets::new(mesh.positions.len());
    edges.iter().for_each(|&[a, b]| sets.join(a, b));
    let mut keyed: Vec<(u32, [u32; 2])> = edges.iter().map(|&edge| (sets.root(edge[0]), edge)).collect();
    keyed.sort_by_key(|(root, _)| *root);
    let position = |vertex: u32| mesh.positions[vertex as usize];
    keyed
        .chunk_by(|a, b| a.0 == b.0)
        .map(|members| {
            let edges: Vec<[u32; 2]> = members.iter().map(|(_, edge)| *edge).collect();
            let ends = || edges.as_flattened().iter().map(|&vertex| position(vertex));
            let centre = ends().sum::<DVec3>() / (2 * edges.len()) as f64;
            let lid = || edges.iter().map(|edge| edge.map(|end| position(end) - centre)).map(|[a, b]| 0.5 * a.cross(b));
            Loop {
                centre,
                radius: ends().map(|end| end.distance(centre)).fold(0.0, f64::max),
                moment: lid().sum::<DVec3>() / (4.0 * PI),
                lid: lid().map(DVec3::length).sum::<f64>() / (4.0 * PI),
                packets: edges.chunks(LANES).map(|chunk| EdgePacket::new(mesh, chunk)).collect(),
            }
        })
        .collect()
}

impl EdgePacket {
    fn new(mesh: &LocalMesh, edges: &[[u32; 2]]) -> Self {
        let mut packet = Self { from: [f32x8::ZERO; 3], to: [f32x8::ZERO; 3], edges: edges.to_vec() };
        for (lane, &[from, to]) in edges.iter().enumerate() {
            for axis in 0..3 {
                packet.from[axis].as_mut_array()[lane] = mesh.positions[from as usize][axis] as f32;
                packet.to[axis].as_mut_array()[lane] = mesh.positions[to as usize][axis] as f32;
            }
        }
        packet
    }
}

impl Capsules {
    /// Takes in at most eight groups of edges.
    fn around(mesh: &LocalMesh, groups: &[&[[u32; 2]]]) -> Self {
        let position = |vertex: u32| mesh.positions[vertex as usize];
        let mut capsules = Self {
            from: [f32x8::splat(1e17); 3],
            along: [f32x8::ZERO; 3],
            per_length_squared: f32x8::ZERO,
            radius: f32x8::ZERO,
            length: f32x8::ZERO,
            count: f32x8::ZERO,
        };
        for (lane, edges) in groups.iter().enumerate() {
            let ends = || edges.as_flattened().iter().map(|&vertex| position(vertex));
            // A single edge is an axis; several have a ball.
            let [from, to] = match edges {
                [[from, to]] => [position(*from), position(*to)],
                _ => [Aabb::around(ends()).centre(); 2],
            };
            let radius = if edges.len() == 1 { 0.0 } else { ends().map(|end| end.distance(from)).fold(0.0, f64::max) };
            let length: f64 = edges.iter().map(|&[a, b]| position(a).distance(position(b))).sum();
            for axis in 0..3 {
                capsules.from[axis].as_mut_array()[lane] = from[axis] as f32;
                capsules.along[axis].as_mut_array()[lane] = (to - from)[axis] as f32;
            }
            let length_squared = from.distance_squared(to) as f32;
            let per_length_squared = if length_squared > f32::MIN_POSITIVE { 1.0 / length_squared } else { 0.0 };
            capsules.per_length_squared.as_mut_array()[lane] = per_length_squared;
            capsules.radius.as_mut_array()[lane] = (radius + CAPSULE_SLACK) as f32;
            capsules.length.as_mut_array()[lane] = (length / (4.0 * PI)) as f32;
            capsules.count.as_mut_array()[lane] = (edges.len() as f64 / (2.0 * PI)) as f32;
        }
        capsules
    }

    /// How far a point is outside of them.
    #[inline(always)]
    fn gap(&self, query: [f32x8; 3]) -> f32x8 {
        let from_start = minus(query, self.from);
        let part = (dot(from_start, self.along) * self.per_length_squared).fast_max(f32x8::ZERO).fast_min(f32x8::ONE);
        let rest = minus(from_start, self.along.map(|along| along * part));
        (dot(rest, rest).sqrt() - self.radius).fast_max(f32x8::ZERO)
    }
}
