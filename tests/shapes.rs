//! Meshes whose distance has a formula, and small real ones.

use glam::{DVec3, IVec3};
use nearfield_bake::geometry::Aabb;
use nearfield_bake::import::{self, TriangleSoup};
use nearfield_bake::mesh::CheckedMesh;
use std::collections::HashMap;
use std::path::Path;

/// A mesh of this repository.
pub(crate) fn read(name: &str) -> CheckedMesh {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes").join(name);
    CheckedMesh::new(import::read(&path).expect("the mesh reads")).expect("the mesh has an area")
}

/// An axis-aligned box that is nowhere symmetric.
pub(crate) const CUBOID: Aabb = Aabb { min: DVec3::new(-0.3, 0.1, 1.0), max: DVec3::new(0.9, 0.8, 1.5) };

/// [`CUBOID`] in twelve triangles.
pub(crate) fn cuboid() -> CheckedMesh {
    let positions = (0..8)
        .map(|corner| {
            let pick = |axis: usize| if corner >> axis & 1 == 0 { CUBOID.min[axis] } else { CUBOID.max[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        })
        .collect();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    CheckedMesh::new(TriangleSoup { positions, triangles }).expect("a box has an area")
}

/// The signed distance to [`CUBOID`].
pub(crate) fn distance_to_cuboid(point: DVec3) -> f64 {
    let beyond = (CUBOID.min - point).max(point - CUBOID.max);
    beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
}

/// A unit sphere around the origin: an octahedron whose triangles were split `splits` times, its
/// vertices on the sphere, and how far its triangles are inside of it at most.
pub(crate) fn sphere(splits: u32) -> (CheckedMesh, f64) {
    let steps = 1 << splits;
    let (mut ids, mut soup) = (HashMap::new(), TriangleSoup::default());
    let mut vertex = |place: IVec3, soup: &mut TriangleSoup| {
        *ids.entry(place).or_insert_with(|| {
            soup.positions.push(place.as_dvec3().normalize());
            soup.positions.len() as u32 - 1
        })
    };

    for octant in 0..8 {
        let sign = IVec3::new(1 - 2 * (octant & 1), 1 - (octant & 2), 1 - (octant >> 1 & 2));
        for u in 0..steps {
            for v in 0..steps - u {
                let mut triangle = |corners: [[i32; 2]; 3]| {
                    let corners = corners.map(|[u, v]| vertex(sign * IVec3::new(u, v, steps - u - v), &mut soup));
                    let [a, b, c] = corners;
                    soup.triangles.push(if sign.element_product() > 0 { [a, b, c] } else { [a, c, b] });
                };
                triangle([[u, v], [u + 1, v], [u, v + 1]]);
                if u + v + 1 < steps {
                    triangle([[u + 1, v], [u + 1, v + 1], [u, v + 1]]);
                }
            }
        }
    }

    // A triangle is nowhere deeper than where its plane is closest to the centre.
    let depth = soup.triangles.iter().map(|triangle| {
        let [a, b, c] = triangle.map(|vertex| soup.positions[vertex as usize]);
        1.0 - (b - a).cross(c - a).normalize().dot(a).abs()
    });
    let deepest = depth.fold(0.0, f64::max);
    (CheckedMesh::new(soup).expect("a sphere has an area"), deepest)
}
