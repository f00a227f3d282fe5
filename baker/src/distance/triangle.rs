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

impl Closest {
    /// Infinitely far from every query.
    pub(crate) const NOWHERE: Self = Self {
        point: DVec3::INFINITY,
        distance_squared: f64::INFINITY,
        feature: Feature::Face,
    };
}

/// Finds the closest point of a triangle.
///
/// The answer is the best of four: the closest points of the three edges, and, where the query
/// projects inside, of the face. Each of the four lies on the triangle whatever rounding did to its
/// parameters, so obtuse, needle-like and fully degenerate triangles (whose corners may coincide)
/// never report less than their distance, and more only by the rounding of one vector.
pub fn closest_point(query: DVec3, corners: [DVec3; 3]) -> Closest {
    let [a, b, c] = corners;
    let [ab, ac] = [b - a, c - a];
    let to_query = query - a;

    // The closest edge point; a tie goes to a corner.
    let mut closest = closest_on_edge(query, corners, 0);
    for edge in [1, 2] {
        let candidate = closest_on_edge(query, corners, edge);
        if candidate.distance_squared < closest.distance_squared {
            closest = candidate;
        }
    }

    // Barycentric coordinates of the projection; a triangle without area gives NaN or nonsense
    // here, and the comparisons or the edges above win.
    let normal = ab.cross(ac);
    let across = to_query.cross(normal);
    let area_squared = normal.length_squared();
    let along_ab = -ac.dot(across) / area_squared;
    let along_ac = ab.dot(across) / area_squared;
    if along_ab > 0.0 && along_ac > 0.0 && along_ab + along_ac < 1.0 {
        let offset = along_ab * ab + along_ac * ac;
        let distance_squared = (to_query - offset).length_squared();
        // The face must win by more than rounding: next to an edge, the edge's pseudonormal is the
        // one that cannot be grazed.
        if distance_squared < closest.distance_squared * (1.0 - 4.0 * f64::EPSILON) {
            closest = Closest {
                point: a + offset,
                distance_squared,
                feature: Feature::Face,
            };
        }
    }
    closest
}

fn closest_on_edge(query: DVec3, corners: [DVec3; 3], edge: u8) -> Closest {
    let next = (edge + 1) % 3;
    let (start, end) = (corners[edge as usize], corners[next as usize]);
    let direction = end - start;
    let along = (query - start).dot(direction);
    let length_squared = direction.length_squared();

    let (point, feature) = if along >= length_squared && length_squared > 0.0 {
        (end, Feature::Vertex(next))
    } else if along > 0.0 {
        (
            start + direction * (along / length_squared),
            Feature::Edge(edge),
        )
    } else {
        (start, Feature::Vertex(edge))
    };
    Closest {
        point,
        distance_squared: (query - point).length_squared(),
        feature,
    }
}
