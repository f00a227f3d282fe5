//! Solid angles of triangles (Van Oosterom and Strackee 1983, "The solid angle of a plane triangle").

use glam::DVec3;
use std::f64::consts::PI;

/// A sum of solid angles, as the argument of a product of complex numbers and the turns it made.
pub(super) struct SolidAngles {
    real: f64,
    imaginary: f64,
    turns: i32,
}

impl Default for SolidAngles {
    fn default() -> Self {
        Self {
            real: 1.0,
            imaginary: 0.0,
            turns: 0,
        }
    }
}

impl SolidAngles {
    /// Adds a triangle seen from the origin (Van Oosterom and Strackee 1983): half its solid angle is
    /// the argument of `real + i·imaginary`.
    pub(super) fn add(&mut self, [a, b, c]: [DVec3; 3]) {
        let [la, lb, lc] = [
            a.length_squared().sqrt(),
            b.length_squared().sqrt(),
            c.length_squared().sqrt(),
        ];
        let imaginary = a.dot(b.cross(c));
        let real = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        if real == 0.0 && imaginary == 0.0 {
            // The query is at the rim of the triangle, where it has no solid angle.
            return;
        }

        let product_real = self.real * real - self.imaginary * imaginary;
        let product_imaginary = self.real * imaginary + self.imaginary * real;
        // Two arguments in [0, π] whose sum passes π, or two in (−π, 0) whose sum passes −π.
        let was_positive = self.imaginary >= 0.0;
        if was_positive == (imaginary >= 0.0) && was_positive != (product_imaginary >= 0.0) {
            self.turns += if was_positive { 1 } else { -1 };
        }

        (self.real, self.imaginary) = (product_real, product_imaginary);

        // Kept within the exponents.
        let size = product_real.abs() + product_imaginary.abs();
        if size < 1e-100 {
            self.real /= size;
            self.imaginary /= size;
        }
    }

    /// The sum, in steradians.
    pub(super) fn total(&self) -> f64 {
        2.0 * (libm::atan2(self.imaginary, self.real) + 2.0 * PI * f64::from(self.turns))
    }
}
