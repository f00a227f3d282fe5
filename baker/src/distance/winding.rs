//! Generalized winding numbers (Jacobson, Kavan and Sorkine-Hornung 2013), summed over a tree whose far nodes count as
//! dipoles (Barill et al. 2018, "Fast winding numbers for soups and clouds", section 3, first order).
//!
//! A triangle contributes its solid angle ÷ 4π; all triangles of a closed surface sum to 1 inside
//! and 0 outside, and a hole blurs the step between them.

use super::bvh::{Child, LANES, Query, STACK, dot, is_within_reach, minus, splat};
use super::bvh_nearest::Finder;
use super::solid_angle::{CoarseSolidAngles, SolidAngles};
use crate::geometry::area_vector;
use glam::DVec3;
use std::f64::consts::PI;
use wide::f32x8;

/// A node counts as a dipole where that is estimated to be off by less: by the number that its triangles have at most, times
/// the square of radius over distance. The sum over the lids of the tests' surfaces is then off by up to 0.0061.
const DIPOLE_ERROR: f32 = 0.01;
/// More than single precision makes of a distance near the surface.
const GAP_ERROR: f64 = 1e-5;

pub(super) struct WindingTree {
    dipoles: Vec<Dipoles>,
}

/// A winding number, and what is known of it nearby.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Winding {
    /// The number.
    pub(super) number: f64,
    /// Its size, at most.
    pub(super) at_most: f64,
    /// No triangle is nearer.
    pub(super) gap: f64,
}

impl Winding {
    /// A radius around the point within which its size does not exceed a limit: what is D away at least is seen from t D
    /// nearer by as an angle at most 1 ÷ (1 − t)² times as large. So is what stands for it, for a dipole is no more than all
    /// its area at its nearest point.
    pub(super) fn radius_within(&self, limit: f64) -> f64 {
        if self.at_most < limit { self.gap * (1.0 - (self.at_most / limit).sqrt()) - GAP_ERROR } else { 0.0 }
    }
}

/// The dipoles of the eight children of a node.
#[repr(align(32))]
struct Dipoles {
    centre: [f32x8; 3],
    /// Sum of area vectors ÷ 4π.
    moment: [f32x8; 3],
    /// Sum of areas ÷ 4π.
    area: f32x8,
    /// Distance of the farthest corner from the centre.
    radius: f32x8,
}

/// Sums over the triangles of a child.
#[derive(Clone, Copy, Default)]
struct Cluster {
    area: f64,
    area_times_centre: DVec3,
    /// Sum of area vectors.
    moment: DVec3,
    /// Distance of the farthest corner from the centre, at most.
    radius: f64,
}

/// Area of a triangle that has none: there is a centre even so.
const LEAST_AREA: f64 = 1e-100;

impl Cluster {
    fn of_triangles(triangles: impl Iterator<Item = [DVec3; 3]> + Clone) -> Self {
        let mut whole = Self::default();
        for corners in triangles.clone() {
            let moment = 0.5 * area_vector(corners);
            let area = moment.length().max(LEAST_AREA);
            whole.area += area;
            whole.area_times_centre += area * corners.iter().sum::<DVec3>() / 3.0;
            whole.moment += moment;
        }
        for corner in triangles.flatten() {
            whole.radius = whole.radius.max(corner.distance(whole.centre()));
        }
        whole
    }

    fn of(parts: &[Self]) -> Self {
        let mut whole = Self {
            area: parts.iter().map(|part| part.area).sum(),
            area_times_centre: parts.iter().map(|part| part.area_times_centre).sum(),
            moment: parts.iter().map(|part| part.moment).sum(),
            radius: 0.0,
        };
        for part in parts {
            whole.radius = whole.radius.max(part.centre().distance(whole.centre()) + part.radius);
        }
        whole
    }

    fn centre(&self) -> DVec3 {
        self.area_times_centre / self.area
    }
}

impl WindingTree {
    pub(super) fn new(Finder { mesh, bvh }: &Finder) -> Self {
        // Children come after their parents: from the last node to the first, each finds its
        // children's sums ready.
        let mut sums = vec![Cluster::default(); bvh.nodes.len()];
        let mut dipoles: Vec<Dipoles> = bvh.nodes.iter().map(|_| Dipoles::NONE).collect();
        for (index, node) in bvh.nodes.iter().enumerate().rev() {
            let mut parts = Vec::with_capacity(LANES);
            for lane in 0..LANES {
                let part = match node.child(lane) {
                    None => continue,
                    Some(Child::Node(child)) => sums[child],
                    Some(Child::Packet(packet)) => {
                        let triangles = bvh.packets[packet].triangles();
                        Cluster::of_triangles(triangles.map(|triangle| mesh.corners(triangle)))
                    }
                };
                dipoles[index].set(lane, &part);
                parts.push(part);
            }
            sums[index] = Cluster::of(&parts);
        }
        Self { dipoles }
    }

    /// The winding number of the triangles around a local point. Zero for points very far away.
    pub(super) fn at(&self, Finder { mesh, bvh }: &Finder, point: DVec3) -> Winding {
        if !is_within_reach(point) {
            return Winding::default();
        }
        let query = splat(point);
        let (mut far_sum, mut at_most, mut gap) = (f32x8::ZERO, f32x8::ZERO, f32x8::splat(f32::INFINITY));
        let (mut near_sum, mut near_sums) = (SolidAngles::ZERO, CoarseSolidAngles::ZERO);
        let mut is_near = false;
        let mut stack = [0u32; STACK];
        let mut height = 1;
        while height > 0 {
            height -= 1;
            let index = stack[height] as usize;
            let dipoles = &self.dipoles[index];
            let seen = dipoles.seen(query);
            far_sum += seen.is_far & seen.value;
            at_most += seen.is_far & seen.at_most;
            gap = gap.fast_min(seen.is_far.bitselect(seen.gap, gap));
            let mut near = !seen.is_far.to_bitmask() & ((1 << LANES) - 1);
            while near != 0 {
                let lane = near.trailing_zeros() as usize % LANES;
                near &= near - 1;
                match bvh.nodes[index].children[lane].child() {
                    Child::Node(child) => {
                        stack[height] = child as u32;
                        height += 1;
                    }
                    Child::Packet(packet) => {
                        is_near = true;
                        let packet = &bvh.packets[packet];
                        let mut unsure = near_sums.add(packet, query);
                        while unsure != 0 {
                            let lane = unsure.trailing_zeros() as usize;
                            unsure &= unsure - 1;
                            let corners = mesh.corners(packet.triangle(lane));
                            near_sum.add(corners.map(|corner| corner - point));
                        }
                    }
                }
            }
        }
        let total = |sums: f32x8| sums.to_array().into_iter().map(f64::from).sum::<f64>();
        if !is_near {
            let gap = gap.to_array().into_iter().fold(f32::INFINITY, f32::min);
            return Winding { number: total(far_sum), at_most: total(at_most), gap: gap.into() };
        }
        near_sum.join(near_sums.sum());
        Winding { number: total(far_sum) + near_sum.total() / (4.0 * PI), at_most: f64::INFINITY, gap: 0.0 }
    }
}

impl Dipoles {
    /// Always far, and nothing.
    const NONE: Self =
        Self { centre: [f32x8::splat(1e17); 3], moment: [f32x8::ZERO; 3], area: f32x8::ZERO, radius: f32x8::ZERO };

    fn set(&mut self, lane: usize, cluster: &Cluster) {
        let centre = cluster.centre();
        for axis in 0..3 {
            self.centre[axis].as_mut_array()[lane] = centre[axis] as f32;
            self.moment[axis].as_mut_array()[lane] = (cluster.moment[axis] / (4.0 * PI)) as f32;
        }
        self.area.as_mut_array()[lane] = (cluster.area / (4.0 * PI)) as f32;
        self.radius.as_mut_array()[lane] = cluster.radius as f32;
    }

    #[inline(always)]
    fn seen(&self, query: Query) -> Seen {
        let to_centre = minus(self.centre, query);
        let distance = dot(to_centre, to_centre).sqrt();
        let gap = distance - self.radius;
        let cubed = distance * distance * distance;
        let at_most = self.area / (gap * gap);
        let nearness = self.radius / distance;
        let error = at_most * nearness * nearness;
        Seen {
            // Nothing where the centre is met: what has no area may be no larger than rounding.
            value: dot(self.moment, to_centre) / cubed.fast_max(f32x8::splat(f32::MIN_POSITIVE)),
            at_most,
            gap,
            is_far: gap.simd_gt(f32x8::ZERO) & error.simd_lt(f32x8::splat(DIPOLE_ERROR)),
        }
    }
}

/// What the children of a node look like from a query.
struct Seen {
    /// Winding number of the dipole.
    value: f32x8,
    /// Greatest winding number of its triangles, however they lie.
    at_most: f32x8,
    /// Distance of the nearest triangle, at least.
    gap: f32x8,
    /// Whether the dipole stands for the child.
    is_far: f32x8,
}
