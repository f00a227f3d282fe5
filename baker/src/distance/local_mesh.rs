//! The triangles in the frame of the search: centred, and scaled by a power of two to fit
//! [−1, 1]³, so that single precision is worth the same for every mesh.

use super::bvh_build::Bounds;
use crate::mesh::CheckedMesh;
use glam::DVec3;
use rayon::prelude::*;

/// The frame of the search: `local = (point − origin) · scale`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    origin: DVec3,
    scale: f64,
}

impl Frame {
    fn around(mesh: &CheckedMesh) -> Self {
        let half = 0.5 * mesh.bounds.size().max_element();
        let (_, exponent) = libm::frexp(half);
        // Within the exponents whose reciprocal is finite too.
        Self { origin: mesh.bounds.centre(), scale: libm::ldexp(1.0, -exponent.clamp(-1000, 1000)) }
    }

    pub(super) fn to_local(self, point: DVec3) -> DVec3 {
        (point - self.origin) * self.scale
    }

    /// A local length in mesh units.
    pub(super) fn length_from_local(self, length: f64) -> f64 {
        length / self.scale
    }
}

/// A mesh in the frame of the search.
pub(super) struct LocalMesh {
    pub(super) frame: Frame,
    pub(super) positions: Vec<DVec3>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl LocalMesh {
    pub(super) fn new(mesh: &CheckedMesh) -> Self {
        let frame = Frame::around(mesh);
        let positions = mesh.positions.par_iter().map(|&position| frame.to_local(position)).collect();
        Self { frame, positions, triangles: mesh.triangles.clone() }
    }

    pub(super) fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles[triangle as usize].map(|vertex| self.positions[vertex as usize])
    }

    /// Box around a triangle, rounded outward.
    pub(super) fn bounds(&self, triangle: u32) -> Bounds {
        let [a, b, c] = self.corners(triangle);
        Bounds { min: a.min(b).min(c).to_array().map(round_down), max: a.max(b).max(c).to_array().map(round_up) }
    }
}

fn round_down(value: f64) -> f32 {
    let nearest = value as f32;
    if f64::from(nearest) > value { nearest.next_down() } else { nearest }
}

fn round_up(value: f64) -> f32 {
    -round_down(-value)
}
