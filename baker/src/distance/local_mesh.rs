//! The triangles in the frame of the search: centred, and scaled by a power of two to fit
//! [−1, 1]³, so that single precision is worth the same for every mesh.

use crate::mesh::{CheckedMesh, Role};
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
    /// Number of each triangle in the mesh.
    pub(super) numbers: Vec<u32>,
    /// Whether each triangle is there for the distance alone; none if all count for the sign too.
    walls: Vec<bool>,
}

impl LocalMesh {
    pub(super) fn new(mesh: &CheckedMesh) -> Self {
        let frame = Frame::around(mesh);
        let positions = mesh.positions.par_iter().map(|&position| frame.to_local(position)).collect();
        let (numbers, triangles): (Vec<u32>, Vec<[u32; 3]>) = mesh.seen_triangles().unzip();
        let is_wall = |&number: &u32| mesh.orientation.role(number as usize) == Role::Wall;
        let has_walls = mesh.orientation.count(Role::Wall) > 0;
        let walls = if has_walls { numbers.iter().map(is_wall).collect() } else { Vec::new() };
        Self { frame, positions, triangles, numbers, walls }
    }

    /// Other triangles in the same frame.
    pub(super) fn with_triangles(&self, positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Self {
        let numbers = (0..triangles.len() as u32).collect();
        Self { frame: self.frame, positions, triangles, numbers, walls: Vec::new() }
    }

    /// The same mesh with its triangles in this order and its vertices in the order of their use, so
    /// that what is near in space is near in memory.
    pub(super) fn reordered(&self, order: &[u32]) -> Self {
        let mut triangles: Vec<[u32; 3]> = order.iter().map(|&triangle| self.triangles[triangle as usize]).collect();
        let mut renumbered = vec![u32::MAX; self.positions.len()];
        let mut positions = Vec::with_capacity(self.positions.len());
        for vertex in triangles.as_flattened_mut() {
            let number = &mut renumbered[*vertex as usize];
            if *number == u32::MAX {
                *number = positions.len() as u32;
                positions.push(self.positions[*vertex as usize]);
            }
            *vertex = *number;
        }
        let numbers = order.iter().map(|&triangle| self.numbers[triangle as usize]).collect();
        let walls = if self.walls.is_empty() { Vec::new() } else { order.iter().map(|&t| self.is_wall(t)).collect() };
        Self { frame: self.frame, positions, triangles, numbers, walls }
    }

    /// Whether a triangle is there for the distance alone.
    pub(super) fn is_wall(&self, triangle: u32) -> bool {
        self.walls.get(triangle as usize).copied().unwrap_or(false)
    }

    #[inline(always)]
    pub(super) fn corners(&self, triangle: u32) -> [DVec3; 3] {
        let [a, b, c] = self.triangles[triangle as usize];
        [self.positions[a as usize], self.positions[b as usize], self.positions[c as usize]]
    }

    /// Box around a triangle, rounded outward.
    pub(super) fn bounds(&self, triangle: u32) -> Bounds {
        let [a, b, c] = self.corners(triangle);
        Bounds { min: a.min(b).min(c).to_array().map(round_down), max: a.max(b).max(c).to_array().map(round_up) }
    }
}

pub(super) fn round_down(value: f64) -> f32 {
    let nearest = value as f32;
    if f64::from(nearest) > value { nearest.next_down() } else { nearest }
}

pub(super) fn round_up(value: f64) -> f32 {
    -round_down(-value)
}

/// A box in single precision.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    pub(super) min: [f32; 3],
    pub(super) max: [f32; 3],
}

impl Bounds {
    pub(super) const EMPTY: Self = Self { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };

    pub(super) fn joined(self, other: Self) -> Self {
        let min = |k: usize| {
            if other.min[k] < self.min[k] { other.min[k] } else { self.min[k] }
        };
        let max = |k: usize| {
            if other.max[k] > self.max[k] { other.max[k] } else { self.max[k] }
        };
        Self { min: [min(0), min(1), min(2)], max: [max(0), max(1), max(2)] }
    }

    /// Half the surface area; zero for an empty box.
    pub(super) fn half_area(&self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|k| (self.max[k] - self.min[k]).max(0.0));
        x * y + y * z + z * x
    }
}
