//! The rim of a surface, and the lids that close it.
//!
//! Surface and lids together are closed, so that the crossings of a ray count their winding number, exactly. That of
//! the surface alone is this less that of the lids, and these are few, or far away, almost everywhere: there they hardly
//! count. It does not matter what lids look like.

use super::bvh_build;
use super::bvh_nearest::Finder;
use super::local_mesh::LocalMesh;
use super::ray_tree::RayTree;
use super::winding::{Winding, WindingTree};
use crate::mesh::adjacency::{Side, VertexCorners};
use glam::DVec3;

/// Edges where the triangles on one side are not balanced by those on the other, in loops: each vertex is followed by
/// the next, and the last by the first, in the direction of the surplus.
pub(super) struct Rim {
    pub(super) loops: Vec<Vec<u32>>,
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
        Self { loops: loops_of(edges) }
    }

    /// The edges of a loop.
    pub(super) fn edges_of(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> {
        ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&from, &to)| [from, to])
    }
}

/// Directed edges, of which as many leave each vertex as arrive there, as loops that pass no vertex twice.
fn loops_of(mut edges: Vec<[u32; 2]>) -> Vec<Vec<u32>> {
    edges.sort_unstable();
    let mut vertices: Vec<u32> = edges.iter().map(|[from, _]| *from).collect();
    vertices.dedup();
    let number = |vertex: u32| vertices.binary_search(&vertex).expect("an edge leaves where one arrives");

    // By number: the first edge of each vertex that no loop has yet, where those of the next vertex start, and where it is on
    // the path.
    let mut next: Vec<usize> =
        vertices.iter().map(|&vertex| edges.partition_point(|[from, _]| *from < vertex)).collect();
    let ends: Vec<usize> = next.iter().copied().skip(1).chain([edges.len()]).collect();
    let mut places = vec![None; vertices.len()];
    let (mut path, mut loops): (Vec<usize>, Vec<Vec<u32>>) = (Vec::new(), Vec::new());
    for start in 0..vertices.len() {
        path.push(start);
        places[start] = Some(0);
        while let Some(&last) = path.last().filter(|&&last| next[last] < ends[last]) {
            let to = number(edges[next[last]][1]);
            next[last] += 1;
            match places[to] {
                None => {
                    places[to] = Some(path.len());
                    path.push(to);
                }
                Some(place) => {
                    path[place + 1..].iter().for_each(|&passed| places[passed] = None);
                    loops.push(path.drain(place..).map(|passed| vertices[passed]).collect());
                    path.push(to);
                }
            }
        }
        path.drain(..).for_each(|passed| places[passed] = None);
    }
    loops
}

/// The triangles of a lid: every second vertex is cut off, again and again, so that triangles are small where they are
/// near the rim, and nothing where it is a crack.
fn lid_of(ring: &[u32]) -> Vec<[u32; 3]> {
    let (mut ring, mut triangles) = (ring.to_vec(), Vec::with_capacity(ring.len()));
    while ring.len() > 2 {
        let count = ring.len();
        triangles.extend((0..count - 1).step_by(2).map(|k| [ring[k], ring[(k + 2) % count], ring[k + 1]]));
        ring = ring.into_iter().step_by(2).collect();
    }
    triangles
}

/// Triangles that close a surface.
pub(super) struct Lids {
    finder: Finder,
    rays: RayTree,
    tree: WindingTree,
}

impl Lids {
    pub(super) fn new(mesh: &LocalMesh, rim: &Rim) -> Self {
        let mut vertices = rim.loops.concat();
        vertices.sort_unstable();
        vertices.dedup();
        let number = |vertex: u32| vertices.binary_search(&vertex).expect("a vertex of the rim") as u32;
        let positions = vertices.iter().map(|&vertex| mesh.positions[vertex as usize]).collect();
        let triangles = rim.loops.iter().flat_map(|ring| lid_of(ring)).map(|corners| corners.map(number)).collect();
        let finder = bvh_build::build(&mesh.with_triangles(positions, triangles));
        Self { rays: RayTree::new(&finder, 0), tree: WindingTree::new(&finder), finder }
    }

    /// Signed crossings of ray 0 from a point with the lids.
    pub(super) fn crossings(&self, point: DVec3) -> i32 {
        self.rays.crossings(&self.finder, point).signed
    }

    /// Their winding number.
    pub(super) fn winding(&self, point: DVec3) -> Winding {
        self.tree.at(&self.finder, point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each directed edge less its opposite, by its ends.
    fn surplus(edges: impl IntoIterator<Item = [u32; 2]>) -> std::collections::BTreeMap<[u32; 2], i32> {
        let mut all = std::collections::BTreeMap::new();
        for [from, to] in edges {
            *all.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
        }
        all.retain(|_, count| *count != 0);
        all
    }

    #[test]
    fn loops_pass_each_edge_once_and_no_vertex_twice() {
        // Two that share a vertex, and two that share an edge.
        let rings: [&[u32]; 4] = [&[0, 1, 2], &[2, 3, 4, 5], &[6, 7, 8], &[6, 7, 9]];
        let edges: Vec<[u32; 2]> = rings.into_iter().flat_map(Rim::edges_of).collect();
        let loops = loops_of(edges.clone());
        for ring in &loops {
            let mut vertices = ring.clone();
            vertices.sort_unstable();
            vertices.dedup();
            assert_eq!(vertices.len(), ring.len(), "{ring:?} passes a vertex twice");
        }
        let mut passed: Vec<[u32; 2]> = loops.iter().flat_map(|ring| Rim::edges_of(ring)).collect();
        let mut given = edges;
        passed.sort_unstable();
        given.sort_unstable();
        assert_eq!(passed, given);
    }

    #[test]
    fn lids_close_loops_of_any_length() {
        for length in 3..40 {
            let ring: Vec<u32> = (0..length).collect();
            let lid = lid_of(&ring);
            assert_eq!(lid.len(), ring.len() - 2, "of {length} edges");
            let sides = lid.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
            assert_eq!(surplus(sides.chain(Rim::edges_of(&ring))), surplus([]), "of {length} edges");
        }
    }
}
