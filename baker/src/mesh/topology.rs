//! What a mesh turned out to be.

use super::adjacency::{Side, VertexCorners};
use super::disjoint_sets::DisjointSets;

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
    /// Examines welded triangles whose corners are distinct.
    pub(super) fn examine(triangles: &[[u32; 3]], vertices: usize) -> Self {
        let corners = VertexCorners::new(triangles, vertices);
        let found = corners.sum_over_vertices(triangles, Self::visit_vertex, Self::plus);
        Self { components: count_components(triangles, vertices), ..found }
    }

    /// Whether angle-weighted pseudonormals give the right sign: closed, manifold along edges,
    /// consistently wound.
    pub fn is_closed_and_oriented(&self) -> bool {
        self.boundary_edges == 0 && self.non_manifold_edges == 0 && self.inconsistent_edges == 0
    }

    /// Why pseudonormals cannot sign this mesh, in one sentence; nothing when they can.
    pub fn pseudonormal_obstacle(&self) -> Option<String> {
        let flaws: Vec<String> = [
            (self.boundary_edges, "at the rim of a hole"),
            (self.non_manifold_edges, "shared by more than two triangles"),
            (self.inconsistent_edges, "whose triangles disagree on the outside"),
        ]
        .into_iter()
        .filter(|&(count, _)| count > 0)
        .map(|(count, flaw)| format!("{count} {} {flaw}", if count == 1 { "edge" } else { "edges" }))
        .collect();
        let (last, others) = flaws.split_last()?;
        let list = if others.is_empty() { last.clone() } else { format!("{} and {last}", others.join(", ")) };
        Some(format!("pseudonormals cannot tell inside from outside: the mesh has {list}"))
    }

    fn visit_vertex(&mut self, vertex: usize, sides: &[Side]) {
        for edge in sides.chunk_by(|a, b| a.other == b.other) {
            // Each edge counts at its smaller vertex.
            if vertex < edge[0].other as usize {
                match edge {
                    [_] => self.boundary_edges += 1,
                    [a, b] => self.inconsistent_edges += usize::from(a.outgoing == b.outgoing),
                    _ => self.non_manifold_edges += 1,
                }
            }
        }
        self.non_manifold_vertices += usize::from(count_fans(sides) > 1);
    }

    fn plus(self, other: Self) -> Self {
        Self {
            boundary_edges: self.boundary_edges + other.boundary_edges,
            non_manifold_edges: self.non_manifold_edges + other.non_manifold_edges,
            inconsistent_edges: self.inconsistent_edges + other.inconsistent_edges,
            non_manifold_vertices: self.non_manifold_vertices + other.non_manifold_vertices,
            ..self
        }
    }
}

/// Groups of triangles around a vertex that edges at this vertex connect.
fn count_fans(sides: &[Side]) -> usize {
    let mut triangles: Vec<u32> = sides.iter().map(|side| side.triangle).collect();
    triangles.sort_unstable();
    triangles.dedup();

    let place = |side: &Side| triangles.binary_search(&side.triangle).unwrap_or_default() as u32;
    let mut groups = DisjointSets::new(triangles.len());
    for edge in sides.chunk_by(|a, b| a.other == b.other) {
        for side in &edge[1..] {
            groups.join(place(&edge[0]), place(side));
        }
    }
    groups.count
}

fn count_components(triangles: &[[u32; 3]], vertices: usize) -> usize {
    let mut pieces = DisjointSets::new(vertices);
    for &[a, b, c] in triangles {
        pieces.join(a, b);
        pieces.join(b, c);
    }
    pieces.count
}
