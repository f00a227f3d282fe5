//! Solid angles of triangles (Van Oosterom and Strackee 1983, "The solid angle of a plane triangle").
//!
//! Half the solid angle of a triangle whose corners are a, b, c, seen from the origin, is the
//! argument of a complex number z with |z| ≤ 4 |a||b||c|. A sum of angles is the argument of a
//! product, so that a single arctangent serves for many triangles, as long as the turns are counted.

use super::bvh::{LANES, Packet, Query, cross, dot, minus};
use glam::DVec3;
use std::f64::consts::PI;
use wide::{f32x8, u32x8};

/// A sum of solid angles.
#[derive(Clone, Copy)]
pub(super) struct SolidAngles {
    real: f64,
    imaginary: f64,
    /// Full turns that the argument has made besides.
    turns: f64,
}

impl SolidAngles {
    pub(super) const ZERO: Self = Self { real: 1.0, imaginary: 0.0, turns: 0.0 };

    /// Adds a triangle seen from the origin.
    pub(super) fn add(&mut self, [a, b, c]: [DVec3; 3]) {
        let [la, lb, lc] = [a.length_squared().sqrt(), b.length_squared().sqrt(), c.length_squared().sqrt()];
        let imaginary = a.dot(b.cross(c));
        let real = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        // Nothing at the rim of the triangle, where it has no solid angle.
        if real != 0.0 || imaginary != 0.0 {
            self.join(Self { real, imaginary, turns: 0.0 });
        }
    }

    /// Adds another sum.
    pub(super) fn join(&mut self, other: Self) {
        let real = self.real * other.real - self.imaginary * other.imaginary;
        let imaginary = self.real * other.imaginary + self.imaginary * other.real;

        // Two arguments in [0, π] whose sum passes π, or two in (−π, 0) whose sum passes −π.
        let (was_up, is_up) = (self.imaginary >= 0.0, imaginary >= 0.0);
        let turns = match (was_up == (other.imaginary >= 0.0), was_up, is_up) {
            (true, true, false) => 1.0,
            (true, false, true) => -1.0,
            _ => 0.0,
        };

        // Kept at unit size.
        let size = real.abs() + imaginary.abs();
        let turns = self.turns + other.turns + turns;
        *self = Self { real: real / size, imaginary: imaginary / size, turns };
    }

    /// The sum, in steradians.
    pub(super) fn total(&self) -> f64 {
        2.0 * libm::atan2(self.imaginary, self.real) + 4.0 * PI * self.turns
    }
}

/// All bits of the lanes in a mask.
#[inline(always)]
fn lanes(mask: u32) -> f32x8 {
    let bits = u32x8::new([1, 2, 4, 8, 16, 32, 64, 128]);
    let set = (u32x8::splat(mask) & bits).simd_eq(bits);
    bytemuck::cast(set)
}

/// Eight sums of solid angles in single precision.
pub(super) struct CoarseSolidAngles {
    real: f32x8,
    imaginary: f32x8,
    turns: f32x8,
}

impl CoarseSolidAngles {
    pub(super) const ZERO: Self = Self { real: f32x8::ONE, imaginary: f32x8::ZERO, turns: f32x8::ZERO };

    /// Adds the triangles of a packet, seen from the query, except some that need double precision:
    /// a bit for each of these is returned.
    ///
    /// With P = |a||b||c| the parts of z are off by some 1e-6 P. Excepted are triangles where this
    /// bears on the angle (a small z) or on its sign (near −π), and where the corners themselves are
    /// off: angles of the others are right to some 0.01.
    #[inline(always)]
    pub(super) fn add(&mut self, packet: &Packet, query: Query) -> u32 {
        let Packet { a, ab, ac, .. } = packet;
        let is_used = dot(*ab, *ab).simd_gt(f32x8::ZERO);
        let a = minus(*a, query);
        let [b, c] = [ab, ac].map(|edge| [a[0] + edge[0], a[1] + edge[1], a[2] + edge[2]]);
        let [la, lb, lc] = [a, b, c].map(|corner| dot(corner, corner).sqrt());
        let product = la * lb * lc;
        let imaginary = dot(a, cross(*ab, *ac));
        let real = product + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;

        let nearest = la.fast_min(lb).fast_min(lc);
        let unsure = self.join_sure(real, imaginary, product, nearest, is_used.to_bitmask());
        unsure & is_used.to_bitmask()
    }

    /// Joins the lanes in `used` whose angle single precision knows; the others of them are returned.
    #[inline(always)]
    fn join_sure(&mut self, real: f32x8, imaginary: f32x8, product: f32x8, nearest: f32x8, used: u32) -> u32 {
        let size = real.abs() + imaginary.abs();
        let is_unsure = size.simd_lt(product * f32x8::splat(1e-4))
            | (real.simd_lt(f32x8::ZERO) & imaginary.abs().simd_lt(product * f32x8::splat(1e-4)))
            | nearest.simd_lt(f32x8::splat(1e-4));
        let unsure = is_unsure.to_bitmask();
        let counted = lanes(used & !unsure);
        let real = counted.bitselect(real, f32x8::ONE);
        let imaginary = counted.bitselect(imaginary, f32x8::ZERO);
        self.join(real, imaginary);
        used & unsure
    }

    /// As [`SolidAngles::join`].
    #[inline(always)]
    fn join(&mut self, other_real: f32x8, other_imaginary: f32x8) {
        let real = self.real * other_real - self.imaginary * other_imaginary;
        let imaginary = self.real * other_imaginary + self.imaginary * other_real;
        let [was_up, other_up, is_up] =
            [self.imaginary, other_imaginary, imaginary].map(|imaginary| imaginary.simd_ge(f32x8::ZERO));
        let more = was_up & other_up & !is_up;
        let fewer = !was_up & !other_up & is_up;
        self.turns = self.turns + (more & f32x8::ONE) - (fewer & f32x8::ONE);

        let scale = f32x8::ONE / (real.abs() + imaginary.abs());
        (self.real, self.imaginary) = (real * scale, imaginary * scale);
    }

    /// The eight sums together.
    pub(super) fn sum(&self) -> SolidAngles {
        let mut sum = SolidAngles::ZERO;
        let (real, imaginary) = (self.real.to_array(), self.imaginary.to_array());
        let turns = self.turns.to_array();
        for lane in 0..LANES {
            sum.join(SolidAngles {
                real: real[lane].into(),
                imaginary: imaginary[lane].into(),
                turns: turns[lane].into(),
            });
        }
        sum
    }
}
