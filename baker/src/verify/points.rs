//! Where a field is compared with the truth.
//!
//! Points are rounded to `f32` once, before either side sees them, and ordered along a Morton curve so
//! that neighbours in the slice are neighbours in space.

use crate::field_function::{FieldFunction, Sample};
use crate::geometry::Aabb;
use crate::mesh::CheckedMesh;
use crate::morton;
use crate::random::Draws;
use glam::{DVec3, UVec3};
use rayon::prelude::*;

const UNIFORM_STREAM: u64 = 1;
const BAND_STREAM: u64 = 2;

/// Points spread evenly over a box, mesh units, mesh frame.
pub(super) fn uniform(bounds: &Aabb, count: usize, seed: u64) -> Vec<[f32; 3]> {
    let points = (0..count as u64).into_par_iter().map(|index| {
        let mut draws = Draws::new(seed, UNIFORM_STREAM, index);
        let unit = DVec3::new(draws.unit(), draws.unit(), draws.unit());
        (bounds.min + bounds.size() * unit).as_vec3().to_array()
    });

    in_morton_order(points.collect())
}

/// Points near a mesh: points of its surface, evenly by area, each moved by up to `reach` in a random
/// direction. No point is farther from the mesh than `reach`, but for the rounding to `f32`.
pub(super) fn near_surface(mesh: &CheckedMesh, reach: f64, count: usize, seed: u64) -> Vec<[f32; 3]> {
    let areas_up_to = cumulative_areas(mesh);
    let Some(&total_area) = areas_up_to.last() else {
        return Vec::new();
    };

    let points = (0..count as u64).into_par_iter().map(|index| {
        let mut draws = Draws::new(seed, BAND_STREAM, index);
        let target = draws.unit() * total_area;
        let triangle = areas_up_to.partition_point(|&area| area <= target);
        let corners = mesh.corners(triangle.min(areas_up_to.len() - 1));
        let point = point_of_triangle(corners, &mut draws) + draws.direction() * (reach * draws.unit());
        point.as_vec3().to_array()
    });

    in_morton_order(points.collect())
}

/// Points near the zero set of a function: points of the box, projected along the gradient, each moved by
/// up to `reach` in a random direction. Points whose projection does not meet the zero set are left out.
pub(super) fn near_zero(
    function: &dyn FieldFunction,
    bounds: &Aabb,
    reach: f64,
    count: usize,
    seed: u64,
) -> Vec<[f32; 3]> {
    const STEPS: usize = 8;
    let points = (0..count as u64).into_par_iter().filter_map(|index| {
        let mut draws = Draws::new(seed, BAND_STREAM, index);
        let unit = DVec3::new(draws.unit(), draws.unit(), draws.unit());
        let mut point = bounds.min + bounds.size() * unit;
        for _ in 0..STEPS {
            let Sample { distance, gradient } = function.sample(point);
            point -= gradient * (distance / gradient.length_squared().max(0.25));
        }
        let met = function.sample(point).distance.abs() <= 0.01 * reach;
        let moved = point + draws.direction() * (reach * draws.unit());
        met.then(|| moved.as_vec3().to_array())
    });

    in_morton_order(points.collect())
}

/// Area of all triangles up to and including each.
fn cumulative_areas(mesh: &CheckedMesh) -> Vec<f64> {
    let areas = (0..mesh.triangles.len()).map(|triangle| {
        let [a, b, c] = mesh.corners(triangle);
        0.5 * (b - a).cross(c - a).length()
    });

    areas
        .scan(0.0, |total, area| {
            *total += area;
            Some(*total)
        })
        .collect()
}

/// Evenly over the triangle: a parallelogram folded along its diagonal.
fn point_of_triangle([a, b, c]: [DVec3; 3], draws: &mut Draws) -> DVec3 {
    let (mut u, mut v) = (draws.unit(), draws.unit());
    if u + v > 1.0 {
        (u, v) = (1.0 - u, 1.0 - v);
    }
    a + (b - a) * u + (c - a) * v
}

/// Ties keep their order, so the result depends on the points alone.
fn in_morton_order(mut points: Vec<[f32; 3]>) -> Vec<[f32; 3]> {
    let bounds = Aabb::around(points.iter().map(|&point| to_dvec3(point)));
    points.par_sort_by_cached_key(|&point| morton_code(&bounds, to_dvec3(point)));
    points
}

/// Position along the Morton curve through a lattice of 2²¹ cells a side.
fn morton_code(bounds: &Aabb, point: DVec3) -> u64 {
    const CELLS: f64 = (1u64 << morton::BITS) as f64;
    let cells = (point - bounds.min) * (CELLS / bounds.size().max_element().max(f64::MIN_POSITIVE));
    morton::encode(cells.as_uvec3().min(UVec3::splat((1 << morton::BITS) - 1)))
}

/// The same point for the side that computes in `f64`: exact.
pub(super) fn to_dvec3(point: [f32; 3]) -> DVec3 {
    glam::Vec3::from_array(point).as_dvec3()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Topology;

    /// Two triangles in the plane z = 0, one of 8 times the area of the other.
    fn two_triangles() -> CheckedMesh {
        let positions = vec![
            DVec3::new(0.0, 0.0, 0.0),
            DVec3::new(4.0, 0.0, 0.0),
            DVec3::new(0.0, 4.0, 0.0),
            DVec3::new(-1.0, 0.0, 0.0),
            DVec3::new(0.0, -2.0, 0.0),
        ];
        CheckedMesh {
            bounds: Aabb::around(positions.iter().copied()),
            positions,
            triangles: vec![[0, 1, 2], [0, 3, 4]],
            topology: Topology::default(),
            orientation: crate::mesh::Orientation::default(),
            oriented: crate::mesh::Topology::default(),
        }
    }

    #[test]
    fn near_points_are_near_and_follow_the_area() {
        let points = near_surface(&two_triangles(), 0.01, 20_000, 3);

        let on_large = points.iter().filter(|point| point[0] + point[1] > 0.0).count();
        // 8/9 of the area, four standard deviations of a binomial, and the 1 % that leaks over the shared corner.
        let share = on_large as f64 / points.len() as f64;
        assert!((share - 8.0 / 9.0).abs() < 0.02, "share {share}");
        assert!(points.iter().all(|point| f64::from(point[2]).abs() <= 0.01 + 1e-9));
        assert!(points.iter().any(|point| f64::from(point[2]).abs() > 0.009));
    }

    #[test]
    fn uniform_points_fill_the_box_in_morton_order() {
        let bounds = Aabb { min: DVec3::new(-1.0, 0.0, 5.0), max: DVec3::new(1.0, 1.0, 6.0) };
        let points = uniform(&bounds, 10_000, 1);

        let found = Aabb::around(points.iter().map(|&point| to_dvec3(point)));
        assert!((found.min - bounds.min).length() < 0.01 && (found.max - bounds.max).length() < 0.01);
        assert!(points.is_sorted_by_key(|&point| morton_code(&found, to_dvec3(point))));
    }

    #[test]
    fn the_points_do_not_depend_on_the_threads() {
        let with_threads = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| near_surface(&two_triangles(), 0.1, 5_000, 9))
        };

        assert_eq!(with_threads(1), with_threads(3));
    }
}
