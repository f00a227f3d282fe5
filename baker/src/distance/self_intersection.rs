//! Whether triangles of a surface cross each other.
//!
//! The answer errs on the safe side: triangles that only touch, up to rounding, may count as crossing, but
//! none that cross is missed. Neighbours may share corners and edges.

use super::bvh_nearest::Finder;
use super::ray_tree::RayTree;
use glam::DVec3;
use rayon::prelude::*;

/// Touching by less than this part of their size is no crossing: some thousand roundings.
const TOUCH: f64 = 1e-12;

/// How many pairs of triangles cross; walls cross nothing.
pub(super) fn count(finder: &Finder, tree: &RayTree) -> usize {
    (0..finder.bvh.packets.len())
        .into_par_iter()
        .map(|packet| {
            let mut count = 0;
            for (lane, triangle) in finder.bvh.packets[packet].triangles().enumerate() {
                if finder.mesh.is_wall(triangle) {
                    continue;
                }
                let corners = finder.mesh.corners(triangle);
                tree.overlapping(finder, packet, lane, |other| {
                    count += usize::from(cross(corners, finder.mesh.corners(other)));
                });
            }
            count
        })
        .sum()
}

/// Whether no plane separates two triangles (Gottschalk, Lin and Manocha 1996, the theorem of the separating
/// axis): its normal would be that of a triangle, or across two edges, or, for triangles in one plane,
/// across an edge within it.
fn cross(a: [DVec3; 3], b: [DVec3; 3]) -> bool {
    // From a corner of one of them on, so that small triangles keep their digits.
    let origin = a[0];
    let (a, b) = (a.map(|corner| corner - origin), b.map(|corner| corner - origin));
    let edges = |[p, q, r]: [DVec3; 3]| [q - p, r - q, p - r];
    let (edges_a, edges_b) = (edges(a), edges(b));
    let size = [edges_a, edges_b].as_flattened().iter().map(|edge| edge.length_squared()).fold(0.0, f64::max).sqrt();

    let separates = |axis: DVec3| {
        let length = axis.length();
        let extent = |corners: [DVec3; 3]| {
            let along = corners.map(|corner| corner.dot(axis));
            (along[0].min(along[1]).min(along[2]), along[0].max(along[1]).max(along[2]))
        };
        let ((min_a, max_a), (min_b, max_b)) = (extent(a), extent(b));
        let touch = TOUCH * size * length;
        // An axis without a direction separates nothing, nor does one across a plane that holds both.
        let is_axis = length > TOUCH * size * size && max_a.max(max_b) - min_a.min(min_b) > 2.0 * touch;
        is_axis && (max_a <= min_b + touch || max_b <= min_a + touch)
    };
    let normals = [edges_a[0].cross(edges_a[1]), edges_b[0].cross(edges_b[1])];
    let in_plane =
        |edges: [DVec3; 3], normal: DVec3| edges.into_iter().any(|edge| separates(edge.cross(normal) / size));
    let is_separate = normals.into_iter().any(separates)
        || in_plane(edges_a, normals[0])
        || in_plane(edges_b, normals[1])
        || edges_a.iter().any(|&edge| edges_b.iter().any(|&other| separates(edge.cross(other))));
    !is_separate
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLAT: [DVec3; 3] = [DVec3::ZERO, DVec3::X, DVec3::Y];

    #[test]
    fn neighbours_do_not_cross() {
        let folded = DVec3::new(1.0, 1.0, 1e-9);
        for other in [
            [DVec3::X, folded, DVec3::Y],
            [DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y],
            [DVec3::ZERO, -DVec3::X, -DVec3::Y],
            [DVec3::ZERO, DVec3::new(1.0, 1.0, 1.0), DVec3::Z],
            FLAT.map(|corner| corner + 1e-6 * DVec3::Z),
        ] {
            assert!(!cross(FLAT, other), "{other:?}");
            assert!(!cross(other, FLAT), "{other:?}");
        }
    }

    #[test]
    fn crossing_triangles_cross() {
        let middle = DVec3::new(0.25, 0.25, 0.0);
        for other in [
            [middle - DVec3::Z, middle + DVec3::Z, DVec3::ONE],
            [DVec3::ZERO, middle + DVec3::Z, middle - DVec3::Z],
            FLAT.map(|corner| corner + 0.1 * DVec3::X),
            [DVec3::X, middle, DVec3::Y],
        ] {
            assert!(cross(FLAT, other), "{other:?}");
            assert!(cross(other, FLAT), "{other:?}");
        }
    }
}
