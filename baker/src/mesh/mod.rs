//! A soup to a [`CheckedMesh`]: welded, without degenerate triangles, its topology known.

pub(crate) mod adjacency;
mod disjoint_sets;
mod orientation;
mod pieces;
#[cfg(test)]
mod tests;
mod topology;
mod weld;

pub(crate) use disjoint_sets::DisjointSets;
pub use orientation::{Orientation, Role};
pub use pieces::Piece;
pub use topology::Topology;

use crate::geometry::Aabb;
use crate::import::TriangleSoup;
use glam::DVec3;
use thiserror::Error;

/// A welded mesh without degenerate triangles.
#[derive(Clone, Debug)]
pub struct CheckedMesh {
    /// Distinct vertex positions, mesh units, mesh frame; each is used by a triangle.
    pub positions: Vec<DVec3>,
    /// Three distinct vertices a triangle; every triangle has an area. In the order of the file.
    pub triangles: Vec<[u32; 3]>,
    /// Smallest box around the triangles.
    pub bounds: Aabb,
    /// What was found on the way.
    pub topology: Topology,
    /// How the triangles count for the sign.
    pub orientation: Orientation,
    /// What the triangles are once they are seen so: without copies and walls, and turned.
    pub oriented: Topology,
}

/// Why a soup is no mesh.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum MeshError {
    /// No triangle has an area.
    #[error("none of its {triangles} triangles has an area; check the scale and the export")]
    NoArea {
        /// Triangles of the soup.
        triangles: usize,
    },
}

impl CheckedMesh {
    /// Welds bit-equal positions (−0 equals 0), drops degenerate triangles and examines the rest.
    ///
    /// A triangle is degenerate when it repeats a position or when its height is lost in the
    /// rounding of its own edges (see [`geometry::has_area`](crate::geometry::has_area)). The
    /// result depends on the soup alone, not on threads.
    ///
    /// # Errors
    /// [`MeshError::NoArea`] when nothing is left.
    ///
    /// # Panics
    /// When an index of the soup is out of range.
    pub fn new(soup: TriangleSoup) -> Result<Self, MeshError> {
        let welded = weld::weld(&soup);
        if welded.triangles.is_empty() {
            return Err(MeshError::NoArea { triangles: soup.triangles.len() });
        }
        let found = Topology::examine(&welded.triangles, welded.positions.len());
        let orientation = if found.is_closed_and_oriented() {
            Orientation::of_closed(&welded.positions, &welded.triangles, found.components)
        } else {
            Orientation::of(&welded.positions, &welded.triangles)
        };
        let oriented = if orientation.is_unchanged() {
            found
        } else {
            let counts = |&(number, _): &(u32, _)| orientation.role(number as usize) != Role::Wall;
            let seen = seen(&welded.triangles, &orientation).filter(counts);
            Topology::examine(&seen.map(|(_, triangle)| triangle).collect::<Vec<_>>(), welded.positions.len())
        };
        Ok(Self {
            bounds: Aabb::around(welded.positions.iter().copied()),
            topology: Topology {
                welded_vertices: welded.duplicates,
                degenerate_triangles: soup.triangles.len() - welded.triangles.len(),
                ..found
            },
            orientation,
            oriented,
            positions: welded.positions,
            triangles: welded.triangles,
        })
    }

    /// The triangles without copies, wound as they are to be seen, each with its number.
    pub fn seen_triangles(&self) -> impl Iterator<Item = (u32, [u32; 3])> {
        seen(&self.triangles, &self.orientation)
    }

    /// Positions of the corners of a triangle, in the order in which they are to be seen.
    pub fn seen_corners(&self, triangle: usize) -> [DVec3; 3] {
        let seen = orientation::seen(self.triangles[triangle], self.orientation.role(triangle));
        seen.map(|vertex| self.positions[vertex as usize])
    }

    /// Positions of the corners of a triangle.
    pub fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|vertex| self.positions[vertex as usize])
    }

    /// Volume inside, cubed mesh units: negative when a closed mesh is inside out, meaningless
    /// for an open one.
    pub fn signed_volume(&self) -> f64 {
        // About the centre of the box: far from the origin the terms would cancel.
        let centre = self.bounds.centre();
        let six_volumes = (0..self.triangles.len()).map(|triangle| {
            let [a, b, c] = self.corners(triangle).map(|corner| corner - centre);
            a.dot(b.cross(c))
        });
        six_volumes.sum::<f64>() / 6.0
    }

    /// Names this mesh: BLAKE3 over the little-endian bits of the positions and the indices of the
    /// triangles, cut to 16 bytes.
    pub fn hash(&self) -> [u8; 16] {
        let mut hasher = blake3::Hasher::new();
        for position in &self.positions {
            for coordinate in position.to_array() {
                hasher.update(&coordinate.to_le_bytes());
            }
        }
        for triangle in &self.triangles {
            for vertex in triangle {
                hasher.update(&vertex.to_le_bytes());
            }
        }
        let mut hash = [0; 16];
        hasher.finalize_xof().fill(&mut hash);
        hash
    }
}

fn seen(triangles: &[[u32; 3]], orientation: &Orientation) -> impl Iterator<Item = (u32, [u32; 3])> {
    (0u32..).zip(triangles).filter_map(|(number, &triangle)| {
        let role = orientation.role(number as usize);
        (role != Role::Duplicate).then(|| (number, orientation::seen(triangle, role)))
    })
}
