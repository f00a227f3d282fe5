//! The pieces of a mesh that shared vertices connect, and the loops of its rim.

use super::adjacency::{Side, VertexCorners};
use super::disjoint_sets::DisjointSets;
use super::{CheckedMesh, Role};
use crate::geometry::area_vector;

/// A piece that shared vertices connect. Lengths in mesh units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Its first triangle.
    pub first: usize,
    /// Area of its triangles.
    pub area: f64,
    /// Volume inside, as its triangles are to be seen: negative for a cavity, meaningless if it is open.
    pub volume: f64,
    /// Whether no edge has a single triangle.
    pub is_closed: bool,
}

impl CheckedMesh {
    /// The pieces that shared vertices connect, by their first triangles.
    pub fn pieces(&self) -> Vec<Piece> {
        let mut sets = DisjointSets::new(self.positions.len());
        for &[a, b, c] in &self.triangles {
            sets.join(a, b);
            sets.join(b, c);
        }
        let centre = self.bounds.centre();
        let mut number_of = vec![u32::MAX; self.positions.len()];
        let mut pieces: Vec<Piece> = Vec::new();
        for triangle in 0..self.triangles.len() {
            let number = &mut number_of[sets.root(self.triangles[triangle][0]) as usize];
            if *number == u32::MAX {
                *number = pieces.len() as u32;
                pieces.push(Piece { first: triangle, area: 0.0, volume: 0.0, is_closed: true });
            }
            let piece = &mut pieces[*number as usize];
            let corners = self.seen_corners(triangle);
            if matches!(self.orientation.role(triangle), Role::Kept | Role::Turned) {
                let [a, b, c] = corners.map(|corner| corner - centre);
                piece.volume += a.dot(b.cross(c)) / 6.0;
            }
            piece.area += 0.5 * area_vector(corners).length();
        }
        for [a, _] in self.rim_edges() {
            pieces[number_of[sets.root(a) as usize] as usize].is_closed = false;
        }
        pieces
    }

    /// Loops of edges with a single triangle; loops that share a vertex are one.
    pub fn rims(&self) -> usize {
        let edges = self.rim_edges();
        let mut loops = DisjointSets::new(self.positions.len());
        edges.iter().for_each(|&[a, b]| loops.join(a, b));
        let mut roots: Vec<u32> = edges.iter().map(|&[a, _]| loops.root(a)).collect();
        roots.sort_unstable();
        roots.dedup();
        roots.len()
    }

    fn rim_edges(&self) -> Vec<[u32; 2]> {
        let corners = VertexCorners::new(&self.triangles, self.positions.len());
        let visit = |edges: &mut Vec<[u32; 2]>, vertex: usize, sides: &[Side]| {
            let single = sides.chunk_by(|a, b| a.other == b.other).filter(|edge| edge.len() == 1);
            edges.extend(
                single.filter(|edge| vertex < edge[0].other as usize).map(|edge| [vertex as u32, edge[0].other]),
            );
        };
        corners.sum_over_vertices(&self.triangles, visit, |a: Vec<[u32; 2]>, b| [a, b].concat())
    }
}
