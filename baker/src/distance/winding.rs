//! Signs by generalized winding numbers (Jacobson, Kavan and Sorkine-Hornung 2013), summed over a
//! tree whose far nodes count as dipoles (Barill et al. 2018, "Fast winding numbers for soups and
//! clouds", section 3, first order).
//!
//! A triangle contributes its solid angle ÷ 4π; all triangles of a closed surface sum to 1 inside
//! and 0 outside, and a hole blurs the step between them.

use super::bvh::{Child, LANES, STACK, is_within_reach, splat};
use super::bvh_nearest::Finder;
use crate::geometry::area_vector;
use glam::DVec3;
use std::f64::consts::PI;
use wide::f32x8;

/// A node is far when the query is beyond this many radii from its centre.
const FAR: f64 = 3.0;

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
    fn of_triangle(corners: [DVec3; 3]) -> Self {
        let moment = 0.5 * area_vector(corners);
        let area = moment.length();
        let centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        let radius = corners.map(|corner| corner.distance(centre)).into_iter().fold(0.0, f64::max);
        Self { area, area_times_centre: area * centre, moment, radius }
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
                        let corners = triangles.map(|triangle| mesh.corners(triangle));
                        Cluster::of(&corners.map(Cluster::of_triangle).collect::<Vec<_>>())
                    }
                };
                dipoles[index].set(lane, &part);
                parts.push(part);
            }
            sums[index] = Cluster::of(&parts);
        }
        Self { dipoles }
    }

    /// The winding number of the mesh around a local point: off by some 0.01 where the dipoles do
    /// worst. Zero for points very far away.
    pub(super) fn at(&self, Finder { mesh, bvh }: &Finder, point: DVec3) -> f64 {
        if !is_within_reach(point) {
            return 0.0;
        }
        let query = splat(point);
        let mut far_sum = 0.0;
        let mut near_sum = SolidAngles::default();
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
                        for triangle in bvh.packets[packet].triangles() {
                            near_sum.add(mesh.corners(triangle).map(|corner| corner - point));
                        }
                    }
                }
            }
        }
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
    fn at(&self, query: [f32x8; 3]) -> ([f32; LANES], u32) {
        let [x, y, z] = [0, 1, 2].map(|k| self.centre[k] - query[k]);
        let distance_squared = x * x + y * y + z * z;
        let along = self.moment[0] * x + self.moment[1] * y + self.moment[2] * z;
        let values = along / (distance_squared * distance_squared.sqrt());
        (values.to_array(), distance_squared.simd_gt(self.far_squared).to_bitmask())
    }
}

/// A sum of solid angles, as the argument of a product of complex numbers and the turns it made.
struct SolidAngles {
    real: f64,
    imaginary: f64,
    turns: i32,
}

impl Default for SolidAngles {
    fn default() -> Self {
        Self { real: 1.0, imaginary: 0.0, turns: 0 }
    }
}

impl SolidAngles {
    /// Adds a triangle seen from the origin (Van Oosterom and Strackee 1983): half its solid angle is
    /// the argument of `real + i·imaginary`.
    fn add(&mut self, [a, b, c]: [DVec3; 3]) {
        let [la, lb, lc] = [a, b, c].map(DVec3::length);
        let imaginary = a.dot(b.cross(c));
        let real = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        let size = real.abs() + imaginary.abs();
        if size == 0.0 {
            // The query is on the triangle's plane and at its rim: no angle is right.
            return;
        }
        let (real, imaginary) = (real / size, imaginary / size);

        let product_real = self.real * real - self.imaginary * imaginary;
        let product_imaginary = self.real * imaginary + self.imaginary * real;
        // Two arguments in [0, π] whose sum passes π, or two in (−π, 0) whose sum passes −π.
        let was_positive = self.imaginary >= 0.0;
        if was_positive == (imaginary >= 0.0) && was_positive != (product_imaginary >= 0.0) {
            self.turns += if was_positive { 1 } else { -1 };
        }

        // Kept near unit length.
        let size = product_real.abs() + product_imaginary.abs();
        (self.real, self.imaginary) = (product_real / size, product_imaginary / size);
    }

    fn total(&self) -> f64 {
        2.0 * (libm::atan2(self.imaginary, self.real) + 2.0 * PI * f64::from(self.turns))
    }
}
