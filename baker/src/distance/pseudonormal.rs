//! Signs by angle-weighted pseudonormals (Bærentzen and Aanæs 2005, "Signed distance computation
//! using the angle weighted pseudonormal", section 3).
//!
//! The sign of (query − closest point) · pseudonormal is right wherever the mesh is closed, its
//! edges are manifold and its triangles agree on the outside.

use super::local_mesh::LocalMesh;
use super::triangle::Feature;
use crate::geometry::area_vector;
use crate::mesh::adjacency::VertexCorners;
use glam::DVec3;
use rayon::prelude::*;

pub(super) struct Pseudonormals {
    /// Sum of unit normals weighted by angle, by vertex.
    vertices: Vec<DVec3>,
    /// The triangle across each edge; across a boundary the triangle itself.
    neighbours: Vec<[u32; 3]>,
}

impl Pseudonormals {
    pub(super) fn new(mesh: &LocalMesh) -> Self {
        let corners = VertexCorners::new(&mesh.triangles, mesh.positions.len());
        let vertices = (0..mesh.positions.len())
            .into_par_iter()
            .map(|vertex| corners.at(vertex).iter().map(|&corner| weighted_normal(mesh, corner)).sum())
            .collect();
        let neighbours = (0..mesh.triangles.len() as u32)
            .into_par_iter()
            .map(|triangle| [0, 1, 2].map(|edge| neighbour(mesh, &corners, triangle, edge)))
            .collect();
        Self { vertices, neighbours }
    }

    /// The pseudonormal of a part of a triangle. Not of unit length.
    pub(super) fn at(&self, mesh: &LocalMesh, triangle: u32, feature: Feature) -> DVec3 {
        match feature {
            Feature::Face => unit_normal(mesh, triangle),
            Feature::Edge(edge) => {
                let neighbour = self.neighbours[triangle as usize][edge as usize];
                unit_normal(mesh, triangle) + unit_normal(mesh, neighbour)
            }
            Feature::Vertex(corner) => self.vertices[mesh.triangles[triangle as usize][corner as usize] as usize],
        }
    }
}

fn unit_normal(mesh: &LocalMesh, triangle: u32) -> DVec3 {
    area_vector(mesh.corners(triangle)).normalize()
}

/// Normal of a corner's triangle times the angle there.
fn weighted_normal(mesh: &LocalMesh, corner: u32) -> DVec3 {
    let (triangle, k) = (corner / 3, (corner % 3) as usize);
    let corners = mesh.corners(triangle);
    let [to_next, to_previous] = [1, 2].map(|step| corners[(k + step) % 3] - corners[k]);
    let angle = libm::atan2(to_next.cross(to_previous).length(), to_next.dot(to_previous));
    unit_normal(mesh, triangle) * angle
}

/// The first other triangle with this edge.
fn neighbour(mesh: &LocalMesh, corners: &VertexCorners, triangle: u32, edge: usize) -> u32 {
    let vertices = mesh.triangles[triangle as usize];
    let (a, b) = (vertices[edge] as usize, vertices[(edge + 1) % 3] as usize);

    // At the end with fewer triangles: the hub of a large fan has very many.
    let (near, far) = if corners.at(a).len() <= corners.at(b).len() { (a, b) } else { (b, a) };
    let others = corners.at(near).iter().map(|corner| corner / 3);
    let mut across =
        others.filter(|&other| other != triangle && mesh.triangles[other as usize].contains(&(far as u32)));
    across.next().unwrap_or(triangle)
}
