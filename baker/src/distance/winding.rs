//! Signs by generalized winding numbers (Jacobson, Kavan and Sorkine-Hornung 2013), summed over a
//! tree whose far nodes count as dipoles (Barill et al. 2018, "Fast winding numbers for soups and
//! clouds", section 3, first order).
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

/// A node is far when the query is beyond this many radii from its centre.
/// Measured on a bumpy sphere, closed and open: 2 errs by up to 0.026, 3 by 0.010 at twice the time.
const FAR: f64 = 2.0;

pub(super) struct WindingTree {
    dipoles: Vec<Dipoles>,
}

/// The dipoles of the eight children of a node.
#[repr(align(32))]
struct Dipoles {
    centre: [f32x8; 3],
    /// Sum of area vectors ÷ 4π.
    moment: [f32x8; 3],
    /// Square of the distance from which on the dipole stands for the child.
    far_squared: f32x8,
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

impl Cluster {
    fn of_triangles(triangles: impl Iterator<Item = [DVec3; 3]> + Clone) -> Self {
        let mut whole = Self::default();
        for corners in triangles.clone() {
            let moment = 0.5 * area_vector(corners);
            whole.area += moment.length();
            whole.area_times_centre += moment.length() * corners.iter().sum::<DVec3>() / 3.0;
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

    /// The winding number of the mesh around a local point: off by some 0.03 where the dipoles do
    /// worst, which moves the surface that closes a hole but no other sign. Zero for points very far
    /// away.
    pub(super) fn at(&self, Finder { mesh, bvh }: &Finder, point: DVec3) -> f64 {
        if !is_within_reach(point) {
            return 0.0;
        }
        let query = splat(point);
        let mut far_sum = 0.0;
        let (mut near_sum, mut near_sums) = (SolidAngles::ZERO, CoarseSolidAngles::ZERO);
        let mut stack = [0u32; STACK];
        let mut height = 1;
        while height > 0 {
            height -= 1;
            let index = stack[height] as usize;
            let (values, far) = self.dipoles[index].at(query);
            for (lane, value) in values.into_iter().enumerate() {
                if far & (1 << lane) != 0 {
                    far_sum += f64::from(value);
                    continue;
                }
                match bvh.nodes[index].child(lane) {
                    None => {}
                    Some(Child::Node(child)) => {
                        stack[height] = child as u32;
                        height += 1;
                    }
                    Some(Child::Packet(packet)) => {
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
        near_sum.join(near_sums.sum());
        far_sum + near_sum.total() / (4.0 * PI)
    }
}

impl Dipoles {
    /// Never far: an unused lane is left to the node, which has no child there.
    const NONE: Self =
        Self { centre: [f32x8::ZERO; 3], moment: [f32x8::ZERO; 3], far_squared: f32x8::splat(f32::INFINITY) };

    fn set(&mut self, lane: usize, cluster: &Cluster) {
        let Cluster { radius, .. } = cluster;
        let centre = cluster.centre();
        for axis in 0..3 {
            self.centre[axis].as_mut_array()[lane] = centre[axis] as f32;
            self.moment[axis].as_mut_array()[lane] = (cluster.moment[axis] / (4.0 * PI)) as f32;
        }
        self.far_squared.as_mut_array()[lane] = (FAR * FAR * radius * radius) as f32;
    }

    /// What each child contributes, and a bit for each that is far.
    #[inline(always)]
    fn at(&self, query: Query) -> ([f32; LANES], u32) {
        let to_centre = minus(self.centre, query);
        let distance_squared = dot(to_centre, to_centre);
        let values = dot(self.moment, to_centre) / (distance_squared * distance_squared.sqrt());
        (values.to_array(), distance_squared.simd_gt(self.far_squared).to_bitmask())
    }
}
