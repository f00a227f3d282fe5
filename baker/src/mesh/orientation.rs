//! Which way the triangles of a dirty mesh should face, and which of them count twice.
//!
//! The file's triangles stay as they are; what is found here is how they are to be *seen* when the
//! sign is computed. Patches of triangles that pairs of sides connect are wound alike, as most of their
//! area already is. A closed patch that no other encloses faces outward then, with all that it encloses:
//! a cavity stays one, whichever way the whole was turned.

use super::adjacency::VertexCorners;
use super::disjoint_sets::DisjointSets;
use crate::geometry::{Aabb, area_vector};
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::PI;

/// How a triangle counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// As it is.
    Kept,
    /// With its corners in the opposite order.
    Turned,
    /// Not at all: an earlier triangle has the same corners.
    Duplicate,
    /// For the distance alone: it has both orientations, and a surface that is closed without it.
    Wall,
}

/// How the triangles of a mesh count.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Orientation {
    /// One a triangle, or none when all are kept.
    roles: Vec<Role>,
}

impl Orientation {
    /// How a triangle counts.
    pub fn role(&self, triangle: usize) -> Role {
        self.roles.get(triangle).copied().unwrap_or(Role::Kept)
    }

    /// How many triangles have a role other than being kept.
    pub fn count(&self, role: Role) -> usize {
        self.roles.iter().filter(|&&found| found == role).count()
    }

    /// Whether all triangles are kept.
    pub fn is_unchanged(&self) -> bool {
        self.roles.is_empty()
    }

    fn new(roles: Vec<Role>) -> Self {
        let is_unchanged = roles.iter().all(|&role| role == Role::Kept);
        Self { roles: if is_unchanged { Vec::new() } else { roles } }
    }

    /// For a mesh whose patches are closed and wound alike: are there others than one that faces outward?
    pub(super) fn of_closed(positions: &[DVec3], triangles: &[[u32; 3]], components: usize) -> Self {
        if components == 1 && volume(positions, triangles.iter().copied()) > 0.0 {
            return Self::default();
        }
        Self::of(positions, triangles)
    }

    pub(super) fn of(positions: &[DVec3], triangles: &[[u32; 3]]) -> Self {
        let mut roles = find_copies(positions.len(), triangles);
        let patches = Patches::connect(positions, triangles, &roles);
        patches.follow_the_majority(&mut roles);
        patches.face_outward(positions, triangles, &mut roles);
        Self::new(roles)
    }
}

/// A triangle as it is to be seen.
pub(super) fn seen([a, b, c]: [u32; 3], role: Role) -> [u32; 3] {
    if role == Role::Turned { [a, c, b] } else { [a, b, c] }
}

/// Finds triangles with the same corners. Of those that all face one way one is kept. Those that face both
/// ways equally often are the surface of a double-sided mesh where they prevail, and walls elsewhere.
fn find_copies(vertices: usize, triangles: &[[u32; 3]]) -> Vec<Role> {
    let mut roles = vec![Role::Kept; triangles.len()];
    let mut keyed: Vec<([u32; 3], u32)> = triangles
        .par_iter()
        .zip(0u32..triangles.len() as u32)
        .map(|(&triangle, number)| (sorted(triangle), number))
        .collect();
    keyed.par_sort_unstable();

    let mut two_sided = Vec::new();
    for group in keyed.chunk_by(|a, b| a.0 == b.0).filter(|group| group.len() > 1) {
        let is_even = |&(corners, number): &([u32; 3], u32)| is_rotation(corners, triangles[number as usize]);
        let even = group.iter().filter(|member| is_even(member)).count();
        let odd = group.len() - even;
        let first = group.iter().position(|member| is_even(member) == (even >= odd)).unwrap_or_default();
        for (place, &(_, number)) in group.iter().enumerate() {
            if place != first {
                roles[number as usize] = Role::Duplicate;
            }
        }
        if even == odd {
            two_sided.push(group[first].1);
        }
    }
    if two_sided.is_empty() {
        return roles;
    }

    // Where they prevail, by piece.
    let mut pieces = DisjointSets::new(vertices);
    for &[a, b, c] in triangles {
        pieces.join(a, b);
        pieces.join(b, c);
    }
    let mut excess = vec![0i64; vertices];
    for (triangle, role) in triangles.iter().zip(&roles) {
        excess[pieces.root(triangle[0]) as usize] -= i64::from(*role == Role::Kept);
    }
    for &triangle in &two_sided {
        excess[pieces.root(triangles[triangle as usize][0]) as usize] += 2;
    }
    for triangle in two_sided {
        if excess[pieces.root(triangles[triangle as usize][0]) as usize] <= 0 {
            roles[triangle as usize] = Role::Wall;
        }
    }
    roles
}

fn sorted(mut triangle: [u32; 3]) -> [u32; 3] {
    triangle.sort_unstable();
    triangle
}

fn is_rotation(a: [u32; 3], b: [u32; 3]) -> bool {
    (0..3).any(|k| a == [b[k], b[(k + 1) % 3], b[(k + 2) % 3]])
}

fn six_volumes([a, b, c]: [DVec3; 3], origin: DVec3) -> f64 {
    (a - origin).dot((b - origin).cross(c - origin))
}

fn volume(positions: &[DVec3], triangles: impl Iterator<Item = [u32; 3]>) -> f64 {
    // About a corner: far from the origin the terms would cancel.
    let origin = positions.first().copied().unwrap_or_default();
    triangles.map(|triangle| six_volumes(triangle.map(|vertex| positions[vertex as usize]), origin)).sum::<f64>() / 6.0
}

/// Volume about its centre from which on an open surface has an inside, where the area is 1: a tenth of what a
/// sphere has.
const LEAST_VOLUME: f64 = 0.01;

fn area(positions: &[DVec3], triangles: impl Iterator<Item = [u32; 3]>) -> f64 {
    0.5 * triangles.map(|triangle| area_vector(triangle.map(|vertex| positions[vertex as usize])).length()).sum::<f64>()
}

/// Triangles connected by edges with exactly two of them.
struct Patches {
    /// Patch of each triangle, by number.
    of_triangle: Vec<u32>,
    /// Whether the triangle is wound unlike the first of its patch.
    is_odd: Vec<bool>,
    /// Twice the area of the triangles that are wound like the first, less that of the others.
    balance: Vec<f64>,
    /// Whether each edge of the patch has two sides.
    is_closed: Vec<bool>,
}

impl Patches {
    fn connect(positions: &[DVec3], triangles: &[[u32; 3]], roles: &[Role]) -> Self {
        let mut sets = DisjointSets::new(triangles.len());
        let mut is_at_rim = vec![false; triangles.len()];
        let corners = VertexCorners::new(triangles, positions.len());
        let mut sides = Vec::new();
        for vertex in 0..positions.len() {
            corners.sides_at(vertex, triangles, &mut sides);
            sides.retain(|side| vertex < side.other as usize && roles[side.triangle as usize] == Role::Kept);
            for edge in sides.chunk_by(|a, b| a.other == b.other) {
                match edge {
                    [a, b] => sets.join_with(a.triangle, b.triangle, a.outgoing == b.outgoing),
                    others => others.iter().for_each(|side| is_at_rim[side.triangle as usize] = true),
                }
            }
        }

        // The root of a set is its first triangle.
        let (mut of_triangle, mut is_odd) = (Vec::with_capacity(triangles.len()), Vec::with_capacity(triangles.len()));
        let (mut balance, mut is_closed) = (Vec::new(), Vec::new());
        for triangle in 0..triangles.len() {
            let (root, odd) = sets.root_and_parity(triangle as u32);
            let patch = if root as usize == triangle {
                balance.push(0.0);
                is_closed.push(roles[triangle] == Role::Kept);
                balance.len() as u32 - 1
            } else {
                of_triangle[root as usize]
            };
            of_triangle.push(patch);
            is_odd.push(odd);
            let area = area_vector(triangles[triangle].map(|vertex| positions[vertex as usize])).length();
            balance[patch as usize] += if odd { -area } else { area };
            is_closed[patch as usize] &= !is_at_rim[triangle];
        }
        Self { of_triangle, is_odd, balance, is_closed }
    }

    /// Winds every patch as most of its area is wound.
    fn follow_the_majority(&self, roles: &mut [Role]) {
        for (triangle, role) in roles.iter_mut().enumerate().filter(|(_, role)| **role == Role::Kept) {
            let is_first_wrong = self.balance[self.of_triangle[triangle] as usize] < 0.0;
            if self.is_odd[triangle] != is_first_wrong {
                *role = Role::Turned;
            }
        }
    }

    /// Turns closed patches that face inward and that no other encloses, with what they enclose. The open ones
    /// are turned together, or not at all: alone a part of a surface does not tell where its inside is.
    fn face_outward(&self, positions: &[DVec3], triangles: &[[u32; 3]], roles: &mut [Role]) {
        let mut members: Vec<Vec<u32>> = vec![Vec::new(); self.is_closed.len()];
        for triangle in (0..triangles.len()).filter(|&triangle| matches!(roles[triangle], Role::Kept | Role::Turned)) {
            members[self.of_triangle[triangle] as usize].push(triangle as u32);
        }
        let of_patch = |patch: usize, roles: &[Role]| -> Vec<[u32; 3]> {
            members[patch].iter().map(|&t| seen(triangles[t as usize], roles[t as usize])).collect()
        };
        let volumes: Vec<f64> =
            (0..members.len()).map(|patch| volume(positions, of_patch(patch, roles).into_iter())).collect();

        // Open ones. The origin matters for them: the centre of what they are.
        let open: Vec<usize> = (0..members.len()).filter(|&patch| !self.is_closed[patch]).collect();
        let vertices = || open.iter().flat_map(|&patch| of_patch(patch, roles)).flatten();
        let centre = Aabb::around(vertices().map(|vertex| positions[vertex as usize])).centre();
        let total: f64 = open
            .iter()
            .flat_map(|&patch| of_patch(patch, roles))
            .map(|triangle| six_volumes(triangle.map(|vertex| positions[vertex as usize]), centre))
            .sum();
        let area = area(positions, open.iter().flat_map(|&patch| of_patch(patch, roles)));
        let mut is_wrong = vec![false; members.len()];
        // A surface that encloses next to nothing has no inside to face away from.
        if total / 6.0 < -LEAST_VOLUME * area * area.sqrt() {
            open.iter().for_each(|&patch| is_wrong[patch] = true);
        }

        // Closed ones: those that none encloses decide.
        let closed: Vec<usize> =
            (0..members.len()).filter(|&patch| self.is_closed[patch] && !members[patch].is_empty()).collect();
        if closed.iter().any(|&patch| volumes[patch] < 0.0) {
            let surfaces: Vec<ClosedSurface> =
                closed.iter().map(|&patch| ClosedSurface::new(positions, of_patch(patch, roles))).collect();
            let verdicts: Vec<bool> = (0..closed.len())
                .into_par_iter()
                .map(|k| {
                    let mut outermost = k;
                    for (other, surface) in surfaces.iter().enumerate() {
                        if surface.is_larger_than(&surfaces[outermost]) && surface.encloses(positions, &surfaces[k]) {
                            outermost = other;
                        }
                    }
                    volumes[closed[outermost]] < 0.0
                })
                .collect();
            closed.iter().zip(verdicts).for_each(|(&patch, verdict)| is_wrong[patch] = verdict);
        }

        for (triangle, role) in roles.iter_mut().enumerate() {
            if is_wrong[self.of_triangle[triangle] as usize] {
                *role = match *role {
                    Role::Kept => Role::Turned,
                    Role::Turned => Role::Kept,
                    other => other,
                };
            }
        }
    }
}

/// A closed patch.
struct ClosedSurface {
    triangles: Vec<[u32; 3]>,
    bounds: Aabb,
}

impl ClosedSurface {
    fn new(positions: &[DVec3], triangles: Vec<[u32; 3]>) -> Self {
        let bounds = Aabb::around(triangles.as_flattened().iter().map(|&vertex| positions[vertex as usize]));
        Self { triangles, bounds }
    }

    fn is_larger_than(&self, other: &Self) -> bool {
        self.bounds.diagonal() > other.bounds.diagonal()
    }

    /// Whether a vertex of the other is inside: its winding number is not zero there.
    fn encloses(&self, positions: &[DVec3], other: &Self) -> bool {
        let [inner, outer] = [&other.bounds, &self.bounds];
        if inner.min.cmplt(outer.min).any() || inner.max.cmpgt(outer.max).any() {
            return false;
        }
        let point = positions[other.triangles[0][0] as usize];
        let solid_angle: f64 = self
            .triangles
            .iter()
            .map(|triangle| solid_angle(triangle.map(|vertex| positions[vertex as usize] - point)))
            .sum();
        solid_angle.abs() > 2.0 * PI
    }
}

/// Of a triangle seen from the origin (Van Oosterom and Strackee 1983).
fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let [la, lb, lc] = [a.length(), b.length(), c.length()];
    let real = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * libm::atan2(a.dot(b.cross(c)), real)
}
