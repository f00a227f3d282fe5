//! Which pieces of an open surface were meant to be closed.
//!
//! At a small hole the surface is best thought to go on as it is bent there, and the pseudonormals of the
//! rim say how. Half a sphere, or a leaf, is no surface with a hole, and is closed by what is flat.

use super::boundary::Rim;
use super::local_mesh::LocalMesh;
use crate::geometry::area_vector;
use crate::mesh::DisjointSets;
use glam::DVec3;

/// A loop of the rim is a hole if its flat lid is at most this part of the area of its piece. On a sphere: a
/// hole of 20 % of its area.
const LARGEST_LID: f64 = 0.2;

/// For each triangle, whether all loops of its piece's rim are holes.
pub(super) fn continued_triangles(mesh: &LocalMesh, rim: &Rim) -> Vec<bool> {
    let vertices = mesh.positions.len();
    let mut pieces = DisjointSets::new(vertices);
    for &[a, b, c] in &mesh.triangles {
        pieces.join(a, b);
        pieces.join(b, c);
    }
    let mut area = vec![0.0; vertices];
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        area[pieces.root(corners[0]) as usize] += 0.5 * area_vector(mesh.corners(triangle as u32)).length();
    }

    let mut is_open = vec![false; vertices];
    for ring in &rim.loops {
        let position = |vertex: u32| mesh.positions[vertex as usize] - mesh.positions[ring[0] as usize];
        let lid: DVec3 = Rim::edges_of(ring).map(|[from, to]| 0.5 * position(from).cross(position(to))).sum();
        let piece = pieces.root(ring[0]) as usize;
        is_open[piece] |= lid.length() > LARGEST_LID * area[piece];
    }
    mesh.triangles.iter().map(|corners| !is_open[pieces.root(corners[0]) as usize]).collect()
}
