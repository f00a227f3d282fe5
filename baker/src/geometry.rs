//! Shapes that every room uses.

use glam::DVec3;

/// An axis-aligned box, mesh units, mesh frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Smallest corner.
    pub min: DVec3,
    /// Largest corner.
    pub max: DVec3,
}

impl Aabb {
    /// The box that holds nothing; joining it with a point gives that point.
    pub const EMPTY: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    /// The smallest box around the points.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |aabb, point| Self { min: aabb.min.min(point), max: aabb.max.max(point) })
    }

    /// Extent along each axis.
    pub fn size(&self) -> DVec3 {
        self.max - self.min
    }

    /// Length of the diagonal.
    pub fn diagonal(&self) -> f64 {
        self.size().length()
    }

    /// Point in the middle.
    pub fn centre(&self) -> DVec3 {
        // Halved first: the sum of two huge coordinates may overflow.
        0.5 * self.min + 0.5 * self.max
    }

    /// This box with `by` added on every side.
    pub fn grown(&self, by: f64) -> Self {
        Self { min: self.min - by, max: self.max + by }
    }
}

/// Vector whose direction is the triangle's normal (right-hand rule) and whose length is twice its
/// area, in squared units of the corners.
///
/// It is taken from the two shortest edges, which loses least to rounding: needles keep a good
/// normal, only caps (two short edges, almost in line) do not.
pub fn area_vector([a, b, c]: [DVec3; 3]) -> DVec3 {
    let [ab, bc, ca] = [b - a, c - b, a - c];
    let [ab_ab, bc_bc, ca_ca] = [ab, bc, ca].map(DVec3::length_squared);
    if ab_ab >= bc_bc && ab_ab >= ca_ca {
        bc.cross(ca)
    } else if bc_bc >= ca_ca {
        ca.cross(ab)
    } else {
        ab.cross(bc)
    }
}

/// Whether a triangle has an area that its coordinates can tell from none: the height over its
/// longest edge exceeds 8 ulp of the edges that span it, which is what rounding them may cost.
pub fn has_area(corners: [DVec3; 3]) -> bool {
    let [a, b, c] = corners;
    let [ab, bc, ca] = [b - a, c - b, a - c];
    let longest = ab.abs().max(bc.abs()).max(ca.abs()).max_element();
    if longest == 0.0 || !longest.is_finite() {
        return false;
    }

    // In units of the longest edge nothing overflows or vanishes before it is lost anyway.
    let mut lengths = [ab, bc, ca].map(|edge| (edge / longest).length());
    lengths.sort_unstable_by(f64::total_cmp);
    let [shortest, middle, _] = lengths;
    area_vector([DVec3::ZERO, ab / longest, -ca / longest]).length() > 8.0 * f64::EPSILON * shortest * middle
}
