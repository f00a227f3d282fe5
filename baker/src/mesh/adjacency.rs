//! Which triangles meet at a vertex, and which share an edge.

use rayon::prelude::*;

/// The corners of the triangles, grouped by vertex and in order within each group. A corner is
/// three times its triangle plus its place there.
pub(crate) struct VertexCorners {
    /// Corners of vertex `v`: `corners[starts[v]..starts[v + 1]]`.
    starts: Vec<u32>,
    corners: Vec<u32>,
}

/// One side of an edge: the triangle that runs along it, seen from one of its two vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Side {
    /// The vertex at the other end.
    pub(crate) other: u32,
    /// The triangle.
    pub(crate) triangle: u32,
    /// Which of the triangle's edges: edge `k` runs from its vertex `k` to the next.
    pub(crate) edge: u8,
    /// Whether the triangle runs toward the other end.
    pub(crate) outgoing: bool,
}

impl VertexCorners {
    pub(crate) fn new(triangles: &[[u32; 3]], vertices: usize) -> Self {
        let vertex_of_corner = triangles.as_flattened();

        // Count, then sum up: where each vertex's group starts.
        let mut starts = vec![0u32; vertices + 1];
        for &vertex in vertex_of_corner {
            starts[vertex as usize + 1] += 1;
        }
        for vertex in 0..vertices {
            starts[vertex + 1] += starts[vertex];
        }

        // Fill the groups.
        let mut next = starts.clone();
        let mut corners = vec![0u32; vertex_of_corner.len()];
        for (corner, &vertex) in (0u32..).zip(vertex_of_corner) {
            let slot = &mut next[vertex as usize];
            corners[*slot as usize] = corner;
            *slot += 1;
        }
        Self { starts, corners }
    }

    pub(crate) fn vertices(&self) -> usize {
        self.starts.len() - 1
    }

    /// Corners at a vertex.
    pub(crate) fn at(&self, vertex: usize) -> &[u32] {
        &self.corners[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }

    /// Replaces `sides` by the sides of all edges at a vertex, those of one edge side by side.
    pub(crate) fn sides_at(&self, vertex: usize, triangles: &[[u32; 3]], sides: &mut Vec<Side>) {
        sides.clear();
        for &corner in self.at(vertex) {
            let (triangle, k) = (corner / 3, (corner % 3) as usize);
            let [next, previous] = [(k + 1) % 3, (k + 2) % 3];
            let vertices = triangles[triangle as usize];
            let side = |other, edge, outgoing| Side { other: vertices[other], triangle, edge: edge as u8, outgoing };
            sides.extend([side(next, k, true), side(previous, previous, false)]);
        }
        sides.sort_unstable();
    }

    /// Visits every vertex with the sides of its edges, in parallel, and adds up what is found.
    pub(crate) fn sum_over_vertices<T: Send + Default>(
        &self,
        triangles: &[[u32; 3]],
        visit: impl Fn(&mut T, usize, &[Side]) + Sync,
        add: impl Fn(T, T) -> T + Sync + Send,
    ) -> T {
        const CHUNK: usize = 4096;
        (0..self.vertices().div_ceil(CHUNK))
            .into_par_iter()
            .map(|chunk| {
                let (mut total, mut sides) = (T::default(), Vec::new());
                for vertex in chunk * CHUNK..self.vertices().min((chunk + 1) * CHUNK) {
                    self.sides_at(vertex, triangles, &mut sides);
                    visit(&mut total, vertex, &sides);
                }
                total
            })
            .reduce(T::default, add)
    }
}
