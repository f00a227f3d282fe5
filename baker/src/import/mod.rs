//! Mesh files to a [`TriangleSoup`]: one door, whatever the format.

use glam::DVec3;

/// Triangles as a file gave them: finite positions and indices in range, nothing else is known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleSoup {
    /// Vertex positions, mesh units, mesh frame, all finite.
    pub positions: Vec<DVec3>,
    /// Three indices into `positions` a triangle.
    pub triangles: Vec<[u32; 3]>,
}
