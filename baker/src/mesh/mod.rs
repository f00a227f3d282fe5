//! A soup to a [`CheckedMesh`]: welded, without degenerate triangles, its topology known.

use crate::geometry::Aabb;
use glam::DVec3;

/// A welded mesh without degenerate triangles.
#[derive(Clone, Debug)]
pub struct CheckedMesh {
    /// Distinct vertex positions, mesh units, mesh frame.
    pub positions: Vec<DVec3>,
    /// Three distinct vertices a triangle; every triangle has an area.
    pub triangles: Vec<[u32; 3]>,
    /// Smallest box around the triangles.
    pub bounds: Aabb,
    /// What was found on the way.
    pub topology: Topology,
}

/// What a mesh turned out to be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Topology {
    /// Vertices that shared a position with an earlier one.
    pub welded_vertices: usize,
    /// Triangles dropped for having no area.
    pub degenerate_triangles: usize,
    /// Edges with one triangle.
    pub boundary_edges: usize,
    /// Edges with more than two triangles.
    pub non_manifold_edges: usize,
    /// Edges that two triangles traverse in the same direction.
    pub inconsistent_edges: usize,
    /// Vertices whose triangles form more than one fan.
    pub non_manifold_vertices: usize,
    /// Pieces connected by shared vertices.
    pub components: usize,
}

impl Topology {
    /// Whether angle-weighted pseudonormals give the right sign: closed, manifold along edges, consistently wound.
    pub fn is_closed_and_oriented(&self) -> bool {
        self.boundary_edges == 0 && self.non_manifold_edges == 0 && self.inconsistent_edges == 0
    }
}
