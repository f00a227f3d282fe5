//! What is known at the corner of a cell.

use glam::DVec3;

/// The derivatives at a vertex, mesh units; bit 0 of the index counts x, bit 1 y, bit 2 z:
/// `[f, fx, fy, fxy, fz, fxz, fyz, fxyz]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Corner(pub [f64; 8]);

impl Corner {
    /// A corner with no mixed derivatives.
    pub fn first_order(distance: f64, gradient: DVec3) -> Self {
        Self([distance, gradient.x, gradient.y, 0.0, gradient.z, 0.0, 0.0, 0.0])
    }

    /// The value.
    pub fn distance(&self) -> f64 {
        self.0[0]
    }

    /// The gradient.
    pub fn gradient(&self) -> DVec3 {
        DVec3::new(self.0[1], self.0[2], self.0[4])
    }
}
