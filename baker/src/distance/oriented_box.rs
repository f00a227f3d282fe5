//! Boxes that follow the surface.
//!
//! A patch of a few triangles is nearly flat. From far away its axis-aligned box is closer than the
//! patch by a part of its *size*, a box along its normal only by its *thickness*, and a search opens
//! every box that looks closer than the closest triangle (Gottschalk, Lin and Manocha 1996, "OBBTree").

use super::bvh_fold::Tree;
use super::local_mesh::{LocalMesh, round_up};
use crate::geometry::area_vector;
use glam::{DMat3, DVec3};

/// Larger subtrees are not flat, and get axis-aligned boxes.
const LARGEST_PATCH: usize = 512;

/// All x with |axes[k] · x − centre[k]| ≤ half[k]. The axes are rows of a rotation, in single
/// precision.
///
/// Their rounding stretches no vector by more than 2 u, and `half` is taken along the rounded axes and
/// rounded up. In single precision each coordinate of a query is off by at most 4 √3 u Q more, so that
/// the distance in these coordinates exceeds the true one by less than 16 u (1 + Q).
pub(super) struct OrientedBox {
    pub(super) axes: [[f32; 3]; 3],
    pub(super) centre: [f32; 3],
    pub(super) half: [f32; 3],
}

impl OrientedBox {
    /// The smaller, by surface, of the box along the axes and the box along the patch.
    pub(super) fn around(mesh: &LocalMesh, tree: &Tree) -> Self {
        let triangles = &mesh.triangles[tree.range.clone()];
        let vertices = || triangles.as_flattened().iter().map(|&vertex| mesh.positions[vertex as usize]);
        if triangles.len() > LARGEST_PATCH {
            let [min, max] = [tree.bounds.min, tree.bounds.max].map(|corner| DVec3::from_array(corner.map(f64::from)));
            return Self::with_axes(DMat3::IDENTITY, [min, max].into_iter());
        }

        // Across the patch its mean normal, along it the direction in which it is longest.
        let area: DVec3 = tree.range.clone().map(|triangle| area_vector(mesh.corners(triangle as u32))).sum();
        let normal = area.try_normalize().unwrap_or(DVec3::Z);
        let (u, v) = normal.any_orthonormal_pair();
        let first = vertices().next().unwrap_or_default();
        let [mut uu, mut uv, mut vv, mut su, mut sv, mut count] = [0.0; 6];
        for vertex in vertices() {
            let (x, y) = ((vertex - first).dot(u), (vertex - first).dot(v));
            uu += x * x;
            uv += x * y;
            vv += y * y;
            su += x;
            sv += y;
            count += 1.0;
        }
        let (uu, uv, vv) = (uu - su * su / count, uv - su * sv / count, vv - sv * sv / count);
        // Larger eigenvector of the covariance.
        let half_difference = 0.5 * (uu - vv);
        let root = (half_difference * half_difference + uv * uv).sqrt();
        let long = if half_difference >= 0.0 {
            u * (half_difference + root) + v * uv
        } else {
            u * uv + v * (root - half_difference)
        };
        let long = long.try_normalize().unwrap_or(u);
        let along_patch = Self::with_axes(DMat3::from_cols(normal, long, normal.cross(long)).transpose(), vertices());

        let along_axes = Self::with_axes(DMat3::IDENTITY, vertices());
        if along_patch.half_area() < along_axes.half_area() { along_patch } else { along_axes }
    }

    /// The smallest box around points whose sides are along the rows of a rotation.
    fn with_axes(rotation: DMat3, points: impl Iterator<Item = DVec3>) -> Self {
        let axes = [0, 1, 2].map(|k| rotation.row(k).as_vec3());
        let rounded = DMat3::from_cols_array_2d(&axes.map(|axis| axis.as_dvec3().to_array())).transpose();
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for point in points {
            let along = rounded * point;
            (min, max) = (min.min(along), max.max(along));
        }
        let centre = (0.5 * (min + max)).as_vec3();
        let half = (max - centre.as_dvec3()).max(centre.as_dvec3() - min);
        Self { axes: axes.map(|axis| axis.to_array()), centre: centre.to_array(), half: half.to_array().map(round_up) }
    }

    fn half_area(&self) -> f32 {
        let [x, y, z] = self.half;
        x * y + y * z + z * x
    }
}
