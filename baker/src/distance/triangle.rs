//! Closest point on a triangle, and the part of the triangle that it lies on.

use glam::DVec3;

/// Part of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// Strictly inside.
    Face,
    /// Edge `k`, from corner `k` to the next, without its ends.
    Edge(u8),
    /// Corner `k`.
    Vertex(u8),
}

/// The point of a triangle that is closest to a query point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closest {
    /// The point, in the frame of the corners.
    pub point: DVec3,
    /// Squared distance to it.
    pub distance_squared: f64,
    /// Part of the triangle that it lies on.
    pub feature: Feature,
}

/// Finds the closest point of a triangle.
///
/// The answer is the best of four: the closest points of the three edges and, where the query
/// projects inside, of the face. Each of the four lies on the triangle whatever rounding did to its
/// parameters, so obtuse, needle-like and fully degenerate triangles (whose corners may coincide)
/// never report less than their distance. They report more by some 1e-16 of the vectors involved, in
/// a sliver times its length ÷ height, and never by more than that height.
pub fn closest_point(query: DVec3, corners: [DVec3; 3]) -> Closest {
    let places = Places::new(query, corners);
    let distance_squared = places.distance_squared();
    let closest = |point, feature| Closest { point, distance_squared, feature };
    let [ab, _, ca] = places.edges;
    match (0..3).find(|&k| places.edge_distances[k] == distance_squared) {
        None => closest(corners[0] + (ab * places.face[0] - ca * places.face[1]), Feature::Face),
        Some(k) => {
            let along = places.along[k];
            if along == 0.0 {
                closest(corners[k], Feature::Vertex(k as u8))
            } else if along == 1.0 {
                let end = (k + 1) % 3;
                closest(corners[end], Feature::Vertex(end as u8))
            } else {
                closest(corners[k] + places.edges[k] * along, Feature::Edge(k as u8))
            }
        }
    }
}

/// The squared distance that [`closest_point`] reports.
#[inline(always)]
pub(super) fn distance_squared(query: DVec3, corners: [DVec3; 3]) -> f64 {
    Places::new(query, corners).distance_squared()
}

/// The four places where the closest point may be. Computed without branches: which place wins
/// cannot be predicted.
struct Places {
    edges: [DVec3; 3],
    /// Parameter of each edge's closest point, 0 to 1.
    along: [f64; 3],
    /// Squared distance to each edge.
    edge_distances: [f64; 3],
    /// Barycentric coordinates of the projection, along ab and ac.
    face: [f64; 2],
    /// Squared distance to the face; infinite where the query does not project inside.
    face_distance: f64,
}

impl Places {
    #[inline(always)]
    fn new(query: DVec3, corners: [DVec3; 3]) -> Self {
        let [a, b, c] = corners;
        let (from_a, from_b, from_c) = (query - a, query - b, query - c);
        let (ab, bc, ca) = (b - a, c - b, a - c);
        let (along_ab, to_ab) = to_edge(from_a, ab);
        let (along_bc, to_bc) = to_edge(from_b, bc);
        let (along_ca, to_ca) = to_edge(from_c, ca);

        // A triangle without area gives NaN or nonsense here; the comparisons or the edges win.
        let normal = ca.cross(ab);
        let across = from_a.cross(normal) * (1.0 / normal.length_squared());
        let (face_ab, face_ac) = (ca.dot(across), ab.dot(across));
        let is_inside = (face_ab > 0.0) & (face_ac > 0.0) & (face_ab + face_ac < 1.0);
        let face_distance = (from_a - (ab * face_ab - ca * face_ac)).length_squared();
        Self {
            edges: [ab, bc, ca],
            along: [along_ab, along_bc, along_ca],
            edge_distances: [to_ab, to_bc, to_ca],
            face: [face_ab, face_ac],
            face_distance: if is_inside { face_distance } else { f64::INFINITY },
        }
    }

    #[inline(always)]
    fn distance_squared(&self) -> f64 {
        let least = |a: f64, b: f64| if a < b { a } else { b };
        let [a, b, c] = self.edge_distances;
        let edge = least(least(a, b), c);
        // The face must win by more than rounding: right beside an edge the edge's pseudonormal is
        // the one that the query cannot graze.
        if self.face_distance < edge * (1.0 - 4.0 * f64::EPSILON) { self.face_distance } else { edge }
    }
}

/// Parameter of the closest point of an edge, from 0 to 1, and the squared distance to it.
#[inline(always)]
fn to_edge(from_start: DVec3, edge: DVec3) -> (f64, f64) {
    // A parameter that is not a number, on an edge without length, becomes zero.
    let along = from_start.dot(edge) / edge.length_squared();
    let along = if along > 0.0 { along } else { 0.0 };
    let along = if along < 1.0 { along } else { 1.0 };
    (along, (from_start - edge * along).length_squared())
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: DVec3 = DVec3::ZERO;
    const B: DVec3 = DVec3::new(4.0, 0.0, 0.0);
    const C: DVec3 = DVec3::new(0.0, 3.0, 0.0);

    #[track_caller]
    fn expect(query: DVec3, corners: [DVec3; 3], point: DVec3, feature: Feature) {
        let closest = closest_point(query, corners);
        assert_eq!(closest.feature, feature, "feature for {query}");
        assert!(closest.point.distance(point) < 1e-15, "{} is not {point}", closest.point);
        let distance_squared = query.distance_squared(point);
        assert!((closest.distance_squared - distance_squared).abs() < 1e-14, "distance for {query}");
    }

    #[test]
    fn every_feature_of_a_triangle_is_found() {
        let triangle = [A, B, C];
        expect(DVec3::new(1.0, 1.0, 5.0), triangle, DVec3::new(1.0, 1.0, 0.0), Feature::Face);
        expect(DVec3::new(2.0, -1.0, 1.0), triangle, DVec3::new(2.0, 0.0, 0.0), Feature::Edge(0));
        expect(DVec3::new(5.0, 5.5, 2.0), triangle, DVec3::new(2.0, 1.5, 0.0), Feature::Edge(1));
        expect(DVec3::new(-1.0, 1.0, 0.0), triangle, DVec3::new(0.0, 1.0, 0.0), Feature::Edge(2));
        expect(DVec3::new(-1.0, -1.0, 1.0), triangle, A, Feature::Vertex(0));
        expect(DVec3::new(6.0, 0.0, 1.0), triangle, B, Feature::Vertex(1));
        expect(DVec3::new(0.0, 6.0, 1.0), triangle, C, Feature::Vertex(2));
    }

    #[test]
    fn a_query_on_the_triangle_is_at_distance_zero() {
        for corner in [A, B, C] {
            assert_eq!(closest_point(corner, [A, B, C]).distance_squared, 0.0, "corner {corner}");
        }
        expect(DVec3::new(1.0, 1.0, 0.0), [A, B, C], DVec3::new(1.0, 1.0, 0.0), Feature::Face);
        expect(DVec3::new(2.0, 0.0, 0.0), [A, B, C], DVec3::new(2.0, 0.0, 0.0), Feature::Edge(0));
    }

    #[test]
    fn an_obtuse_triangle_does_not_skip_its_far_edge() {
        // Beyond the corner a by both of its edges' parameters, yet closest to the edge bc.
        let obtuse = [A, DVec3::new(10.0, 1.0, 0.0), DVec3::new(-10.0, 1.0, 0.0)];
        expect(DVec3::new(0.0, 2.0, 0.0), obtuse, DVec3::new(0.0, 1.0, 0.0), Feature::Edge(1));
        expect(DVec3::new(-7.0, 9.0, 0.0), obtuse, DVec3::new(-7.0, 1.0, 0.0), Feature::Edge(1));
        expect(DVec3::new(0.0, -2.0, 0.0), obtuse, A, Feature::Vertex(0));
    }

    #[test]
    fn a_needle_is_as_good_as_its_long_edges() {
        let needle = [A, DVec3::new(1.0, 1e-13, 0.0), DVec3::new(1.0, 0.0, 0.0)];
        for x in [0.1, 0.5, 0.9] {
            let closest = closest_point(DVec3::new(x, 0.0, 0.25), needle);
            assert!((closest.distance_squared - 0.0625).abs() < 1e-16, "at {x}");
        }
    }

    #[test]
    fn a_equals_b_leaves_the_segment_ac() {
        expect(DVec3::new(1.0, 2.0, 0.0), [A, A, C], DVec3::new(0.0, 2.0, 0.0), Feature::Edge(1));
    }

    #[test]
    fn b_equals_c_leaves_the_segment_ab() {
        expect(DVec3::new(2.0, 2.0, 0.0), [A, B, B], DVec3::new(2.0, 0.0, 0.0), Feature::Edge(0));
    }

    #[test]
    fn a_equals_c_leaves_the_segment_ab() {
        expect(DVec3::new(2.0, 2.0, 0.0), [A, B, A], DVec3::new(2.0, 0.0, 0.0), Feature::Edge(0));
    }

    #[test]
    fn all_equal_leaves_a_point() {
        expect(DVec3::new(2.0, 2.0, 1.0), [C, C, C], C, Feature::Vertex(0));
        assert_eq!(closest_point(C, [C, C, C]).distance_squared, 0.0);
    }

    #[test]
    fn collinear_corners_leave_the_longest_segment() {
        let end = DVec3::new(9.0, 0.0, 0.0);
        for corners in [[A, B, end], [B, end, A], [end, A, B]] {
            let closest = closest_point(DVec3::new(6.0, 2.0, 0.0), corners);
            assert_eq!(closest.point, DVec3::new(6.0, 0.0, 0.0), "for {corners:?}");
            let beyond = closest_point(DVec3::new(12.0, 4.0, 0.0), corners);
            assert_eq!((beyond.point, beyond.distance_squared), (end, 25.0), "for {corners:?}");
        }
    }
}
