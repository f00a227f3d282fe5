//! Distance to a mesh by looking at every triangle, too simple to be wrong.

use glam::DVec3;
use nearfield_bake::mesh::CheckedMesh;

/// Unsigned distance.
pub(crate) fn distance(mesh: &CheckedMesh, point: DVec3) -> f64 {
    (0..mesh.triangles.len())
        .map(|triangle| distance_to_triangle(point, mesh.corners(triangle)))
        .fold(f64::INFINITY, f64::min)
}

/// Distance to the nearest of the three sides, or to the plane if the point is above the triangle.
pub(crate) fn distance_to_triangle(point: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let sides = [(a, b), (b, c), (c, a)];
    let nearest_side =
        sides.map(|(start, end)| distance_to_segment(point, start, end)).into_iter().fold(f64::INFINITY, f64::min);

    let normal = (b - a).cross(c - a).normalize();
    let is_above = sides.iter().all(|&(start, end)| (end - start).cross(point - start).dot(normal) > 0.0);
    if is_above { nearest_side.min((point - a).dot(normal).abs()) } else { nearest_side }
}

fn distance_to_segment(point: DVec3, start: DVec3, end: DVec3) -> f64 {
    let along = ((point - start).dot(end - start) / (end - start).length_squared()).clamp(0.0, 1.0);
    point.distance(start + (end - start) * along)
}
