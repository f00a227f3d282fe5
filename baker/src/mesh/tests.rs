//! What welding and examining find on small meshes whose flaws are known.

use super::*;

fn soup(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> TriangleSoup {
    let positions = positions.iter().map(|&position| DVec3::from_array(position)).collect();
    TriangleSoup { positions, triangles: triangles.to_vec() }
}

const TETRAHEDRON: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const SIDES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

/// A second tetrahedron, mirrored through the first vertex.
fn two_tetrahedra() -> TriangleSoup {
    let mut positions = TETRAHEDRON.to_vec();
    positions.extend(TETRAHEDRON.map(|position| position.map(|x| -x)));
    let mut triangles = SIDES.to_vec();
    triangles.extend(SIDES.map(|[a, b, c]| [a + 4, c + 4, b + 4]));
    soup(&positions, &triangles)
}

#[test]
fn a_tetrahedron_is_closed_and_has_its_volume() {
    let mesh = CheckedMesh::new(soup(&TETRAHEDRON, &SIDES)).unwrap();
    assert_eq!(mesh.topology, Topology { components: 1, ..Topology::default() });
    assert!(mesh.topology.is_closed_and_oriented());
    assert_eq!(mesh.topology.pseudonormal_obstacle(), None);
    assert!((mesh.signed_volume() - 1.0 / 6.0).abs() < 1e-15);

    let inside_out = SIDES.map(|[a, b, c]| [a, c, b]);
    let mesh = CheckedMesh::new(soup(&TETRAHEDRON, &inside_out)).unwrap();
    assert!((mesh.signed_volume() + 1.0 / 6.0).abs() < 1e-15);
}

#[test]
fn bit_equal_positions_are_welded_and_minus_zero_is_zero() {
    let mesh = CheckedMesh::new(two_tetrahedra()).unwrap();
    // The corner that both share: 0 in one, −0 in the other.
    assert_eq!(mesh.topology.welded_vertices, 1);
    assert_eq!(mesh.positions.len(), 7);
    assert_eq!(mesh.topology.non_manifold_vertices, 1);
    assert_eq!(mesh.topology.components, 1);
    assert!(mesh.topology.is_closed_and_oriented());
    assert!(mesh.positions.iter().all(|p| { p.to_array().iter().all(|x| x.to_bits() != (-0.0f64).to_bits()) }));
}

#[test]
fn separate_pieces_are_counted() {
    let mut pieces = two_tetrahedra();
    pieces.positions[4..].iter_mut().for_each(|position| *position -= DVec3::ONE);
    let mesh = CheckedMesh::new(pieces).unwrap();
    assert_eq!(mesh.topology, Topology { components: 2, ..Topology::default() });
}

#[test]
fn degenerate_triangles_are_dropped_and_unused_vertices_with_them() {
    let mut positions = TETRAHEDRON.to_vec();
    positions.extend([[2.0, 0.0, 0.0], [7.0, 7.0, 7.0], [0.0, 0.0, 0.0], [0.1, 0.3, 0.7], [0.2, 0.6, 1.4]]);
    let mut triangles = SIDES.to_vec();
    // A repeated index, a repeated position, collinear corners, collinear up to rounding.
    triangles.extend([[1, 1, 2], [0, 6, 2], [0, 1, 4], [0, 7, 8]]);
    let mesh = CheckedMesh::new(soup(&positions, &triangles)).unwrap();
    assert_eq!(mesh.triangles, SIDES);
    assert_eq!(mesh.topology.degenerate_triangles, 4);
    assert_eq!(mesh.topology.welded_vertices, 1);
    assert_eq!(mesh.bounds, Aabb { min: DVec3::ZERO, max: DVec3::ONE });
}

#[test]
fn slender_and_minute_triangles_are_kept() {
    for size in [1e-200, 1e-9, 1.0, 1e150] {
        for height in [1.0, 1e-9, 1e-14] {
            let corners = [[0.0, 0.0, 0.0], [size, 0.0, 0.0], [0.5 * size, height * size, 0.0]];
            let mesh = CheckedMesh::new(soup(&corners, &[[0, 1, 2]]));
            assert!(mesh.is_ok(), "size {size}, height {height}");
        }
    }
}

#[test]
fn nothing_left_is_an_error() {
    let flat = soup(&[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], &[[0, 1, 2]]);
    assert_eq!(CheckedMesh::new(flat).unwrap_err(), MeshError::NoArea { triangles: 1 });
    assert!(CheckedMesh::new(TriangleSoup::default()).is_err());
}

#[test]
fn a_hole_has_a_rim() {
    let mesh = CheckedMesh::new(soup(&TETRAHEDRON, &SIDES[..3])).unwrap();
    assert_eq!(mesh.topology.boundary_edges, 3);
    let said = mesh.topology.pseudonormal_obstacle().unwrap();
    assert!(said.contains("3 edges at the rim of a hole"), "{said}");
}

#[test]
fn a_flipped_triangle_disagrees_with_its_neighbours() {
    let mut sides = SIDES;
    sides[3].swap(0, 1);
    let mesh = CheckedMesh::new(soup(&TETRAHEDRON, &sides)).unwrap();
    assert_eq!(mesh.topology, Topology { inconsistent_edges: 3, components: 1, ..Topology::default() });
}

#[test]
fn three_pages_share_a_non_manifold_edge() {
    let positions = [[0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]];
    let book = soup(&positions, &[[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
    let mesh = CheckedMesh::new(book).unwrap();
    let expected = Topology { boundary_edges: 6, non_manifold_edges: 1, components: 1, ..Topology::default() };
    assert_eq!(mesh.topology, expected);
    let said = mesh.topology.pseudonormal_obstacle().unwrap();
    assert!(said.contains("6 edges at the rim of a hole and 1 edge shared by more than two"), "{said}");
}

#[test]
fn the_hash_names_positions_and_triangles() {
    let mesh = |soup| CheckedMesh::new(soup).unwrap().hash();
    let hash = mesh(soup(&TETRAHEDRON, &SIDES));
    assert_eq!(hash, mesh(soup(&TETRAHEDRON, &SIDES)));
    let mut moved = TETRAHEDRON;
    moved[3][2] = 1.0f64.next_up();
    assert_ne!(hash, mesh(soup(&moved, &SIDES)));
    let mut turned = SIDES;
    turned[0].rotate_left(1);
    assert_ne!(hash, mesh(soup(&TETRAHEDRON, &turned)));
}
