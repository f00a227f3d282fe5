//! Finds the closest triangles of many points, where neighbours share a search.
//!
//! If a group of points is within ρ of its centre, and the centre is d away from the mesh, then only
//! triangles within d + 2ρ of the centre can be closest to any of them. One search finds these; each
//! point then looks at no others. How points are grouped bears on speed alone.

use super::bvh::{LANES, Packet, is_within_reach};
use super::bvh_nearest::{Coarse, Decision, Finder, Nearest, Scratch};
use super::triangle::distance_squared;
use crate::geometry::Aabb;
use glam::DVec3;

/// Points that a group has at least: fewer are faster alone.
const SMALLEST_GROUP: usize = 8;
const LARGEST_GROUP: usize = 64;
/// Triangles that a group may share, and as many as it is best to share.
const MOST_SHARED: usize = 96;
const BEST_SHARED: usize = 32;
/// Radius of the first group, where the mesh is about 1 in size.
const FIRST_RADIUS: f64 = 0.02;

/// Finds the closest triangle to each of some finite local points, in turn. Best if each point is near
/// the one before.
pub(super) fn nearest_of_each(finder: &Finder, points: &[DVec3], mut found: impl FnMut(usize, Nearest)) {
    let (mut scratch, mut group) = (Scratch::new(), Group::default());
    let (mut start, mut seed, mut radius) = (0, 0, FIRST_RADIUS);
    while start < points.len() {
        let (count, sphere) = leading_group(&points[start..], radius);
        let end = start + count;
        if count < SMALLEST_GROUP {
            for (k, &point) in (start..end).zip(&points[start..end]) {
                let nearest = finder.nearest(point, seed, &mut scratch);
                seed = nearest.triangle;
                found(k, nearest);
                // Where a group was too large a smaller one may do; where the next one might do again
                // it should be tried, but rarely.
                radius *= 1.01;
            }
        } else if group.gather(finder, sphere, seed, &mut scratch) {
            for (k, &point) in (start..end).zip(&points[start..end]) {
                let nearest = group.nearest(finder, point, &mut scratch);
                seed = nearest.triangle;
                found(k, nearest);
            }
            radius *= if group.shared < BEST_SHARED { 1.25 } else { 0.9 };
        } else {
            radius = 0.5 * sphere.1;
            continue;
        }
        start = end;
    }
}

/// How many of the first points fit into a sphere, and the sphere around them.
fn leading_group(points: &[DVec3], radius: f64) -> (usize, (DVec3, f64)) {
    let mut bounds = Aabb::around(points.first().copied());
    let mut count = 1;
    for &point in points.iter().take(LARGEST_GROUP).skip(1) {
        let grown = Aabb::around([bounds.min, bounds.max, point]);
        if grown.diagonal() > 2.0 * radius {
            break;
        }
        bounds = grown;
        count += 1;
    }
    (count, (bounds.centre(), 0.5 * bounds.diagonal()))
}

/// The triangles that a group of points shares.
#[derive(Default)]
struct Group {
    centre: DVec3,
    /// How many triangles.
    shared: usize,
    /// The triangles, the nearest to the centre first.
    packets: Vec<Packet>,
    /// Distance of each packet's nearest triangle from the centre, in single precision.
    reaches: Vec<f32>,
}

impl Group {
    /// Gathers the triangles that may be closest to points in a sphere. Gives up, and returns false,
    /// when they are too many.
    fn gather(&mut self, finder: &Finder, (centre, radius): (DVec3, f64), seed: u32, scratch: &mut Scratch) -> bool {
        if !is_within_reach(centre.abs() + radius) {
            return false;
        }
        let mut coarse = Coarse::new(centre, radius);
        coarse.lower_cut(distance_squared(centre, finder.mesh.corners(seed)) as f32);
        if !coarse.search(&finder.bvh, MOST_SHARED, scratch) {
            return false;
        }

        let candidates = &mut scratch.candidates;
        candidates.retain(|candidate| candidate.distance_squared <= coarse.cut);
        candidates.sort_unstable_by(|a, b| a.distance_squared.total_cmp(&b.distance_squared));
        self.centre = centre;
        self.shared = candidates.len();
        self.packets.clear();
        self.reaches.clear();
        for chunk in candidates.chunks(LANES) {
            let mut packet = Packet::EMPTY;
            for (lane, candidate) in chunk.iter().enumerate() {
                let place = candidate.place as usize;
                packet.copy_lane(lane, &finder.bvh.packets[place / LANES], place % LANES);
            }
            self.packets.push(packet);
            self.reaches.push(chunk[0].distance_squared.sqrt());
        }
        true
    }

    /// Finds the closest triangle to a point of the group.
    fn nearest(&self, finder: &Finder, point: DVec3, scratch: &mut Scratch) -> Nearest {
        let mut coarse = Coarse::new(point, 0.0);
        let off_centre = point.distance(self.centre) as f32;
        scratch.candidates.clear();
        for (place, (packet, reach)) in self.packets.iter().zip(&self.reaches).enumerate() {
            let nearest = (reach - off_centre).max(0.0);
            if nearest * nearest > coarse.cut {
                break;
            }
            coarse.visit_packet(packet, place, nearest * nearest, &mut scratch.candidates);
        }
        coarse.decide(&scratch.candidates, Decision::new(&finder.mesh, point))
    }
}
