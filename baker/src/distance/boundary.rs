//! The rim of a surface, and what it adds to the crossings of a ray to make a winding number.
//!
//! Close the surface by a cone from its rim to infinity, away from where the ray points. The ray does not
//! meet the cone, so its signed crossings are the winding number of the closed whole; that of the surface
//! is this less the cone's, whose faces are triangles with a corner at infinity. The result is exact for any
//! surface, and the sum is empty for a closed one.

use super::local_mesh::LocalMesh;
use super::solid_angle::SolidAngles;
use crate::mesh::adjacency::{Side, VertexCorners};
use glam::DVec3;
use std::f64::consts::PI;

/// Edges where the triangles on one side are not balanced by those on the other, in the direction of the
/// surplus, as often as it is large.
pub(super) struct Rim {
    pub(super) edges: Vec<[u32; 2]>,
}

impl Rim {
    pub(super) fn of(mesh: &LocalMesh) -> Self {
        let corners = VertexCorners::new(&mesh.triangles, mesh.positions.len());
        let visit = |edges: &mut Vec<[u32; 2]>, vertex: usize, sides: &[Side]| {
            for edge in sides.chunk_by(|a, b| a.other == b.other).filter(|edge| vertex < edge[0].other as usize) {
                let counted = edge.iter().filter(|side| !mesh.is_wall(side.triangle));
                let surplus: i32 = counted.map(|side| if side.outgoing { 1 } else { -1 }).sum();
                let ends = [vertex as u32, edge[0].other];
                let directed = if surplus > 0 { ends } else { [ends[1], ends[0]] };
                edges.extend(std::iter::repeat_n(directed, surplus.unsigned_abs() as usize));
            }
        };
        // Appending keeps the order of the vertices, however the work was shared.
        let edges = corners.sum_over_vertices(&mesh.triangles, visit, |a: Vec<[u32; 2]>, b| [a, b].concat());
        Self { edges }
    }

    /// What the rim adds to the signed crossings of a ray from this point in this direction.
    pub(super) fn turns(&self, mesh: &LocalMesh, point: DVec3, direction: DVec3) -> f64 {
        let mut sum = SolidAngles::ZERO;
        for &[a, b] in &self.edges {
            let [a, b] = [a, b].map(|vertex| mesh.positions[vertex as usize] - point);
            sum.add_with_corner_at_infinity(-direction, a, b);
        }
        sum.total() / (4.0 * PI)
    }
}
