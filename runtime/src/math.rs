//! The little arithmetic that `core` lacks, with a fixed order of operations.
//!
//! Nothing here calls a platform's mathematics: addition, multiplication and division of `f32` are
//! correctly rounded everywhere, so every answer has the same bits on every machine.

/// 1/√x for x in [⅓, 1], relative error below 1.2e-7, exact at 1.
///
/// A cubic minimax seed (relative error 2.9e-3) and two steps of Newton and Raphson (1.3e-5, then
/// 2.4e-10 and rounding). The last step adds a small correction, which is what makes 1 exact.
#[inline]
pub(crate) fn reciprocal_sqrt(x: f32) -> f32 {
    let seed = 2.889_865_6 - x * (4.849_578_6 - x * (4.646_499 - x * 1.689_681_2));
    let half = 0.5 * x;

    let coarse = seed * (1.5 - half * (seed * seed));
    coarse + coarse * (0.5 - half * (coarse * coarse))
}

/// A number of each axis. A loop in its place would, in code that is built to be small, check the index of every axis.
#[inline(always)]
pub(crate) fn each_axis<T>(of: impl Fn(usize) -> T) -> [T; 3] {
    [of(0), of(1), of(2)]
}

/// The same of each of four lanes.
#[inline(always)]
pub(crate) fn each_lane<T>(of: impl Fn(usize) -> T) -> [T; 4] {
    [of(0), of(1), of(2), of(3)]
}

#[inline]
pub(crate) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Length and unit direction of a vector with finite components that are not all zero.
///
/// Relative error below 4e-7; the length saturates at [`f32::MAX`] and cannot underflow.
pub(crate) fn length_and_direction(vector: [f32; 3]) -> (f32, [f32; 3]) {
    let largest = vector.map(f32::abs).into_iter().fold(0.0, f32::max);
    let scaled = vector.map(|component| component / largest);

    // On the octahedron |x| + |y| + |z| = 1 the squared length lies in [⅓, 1].
    let taxicab = scaled[0].abs() + scaled[1].abs() + scaled[2].abs();
    let point = scaled.map(|component| component / taxicab);
    let squared = dot(point, point);
    let reciprocal = reciprocal_sqrt(squared);

    let length = taxicab * (squared * reciprocal) * largest;
    (length.min(f32::MAX), point.map(|component| component * reciprocal))
}

/// 2^-`exponent`, for exponents up to 126.
#[inline]
pub(crate) fn power_of_half(exponent: u8) -> f32 {
    f32::from_bits((127 - u32::from(exponent).min(126)) << 23)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg_attr(miri, ignore = "millions of numbers")]
    fn reciprocal_sqrt_is_as_accurate_as_documented() {
        // Every number of the interval.
        let (first, last) = ((1.0_f32 / 3.0).to_bits(), 1.0_f32.to_bits());
        let mut largest: f64 = 0.0;
        for bits in first..=last {
            let x = f32::from_bits(bits);
            let error = f64::from(reciprocal_sqrt(x)) * f64::from(x).sqrt() - 1.0;
            largest = largest.max(error.abs());
        }
        assert!(largest < 1.2e-7, "{largest}");
        assert_eq!(reciprocal_sqrt(1.0), 1.0);
    }

    #[test]
    fn lengths_neither_overflow_nor_underflow() {
        assert_eq!(length_and_direction([0.0, -3.5, 0.0]), (3.5, [0.0, -1.0, 0.0]));
        assert_eq!(length_and_direction([f32::MAX; 3]).0, f32::MAX);
        let least = f32::from_bits(1);
        assert_eq!(length_and_direction([0.0, 0.0, least]), (least, [0.0, 0.0, 1.0]));

        let vector = [3e37, -4e37, 12e37];
        let (length, direction) = length_and_direction(vector);
        assert!((length / 13e37 - 1.0).abs() < 4e-7);
        for (component, whole) in direction.into_iter().zip(vector) {
            assert!((component * 13e37 / whole - 1.0).abs() < 6e-7);
        }
    }

    #[test]
    fn powers_of_half_are_exact() {
        for exponent in 0..=126 {
            assert_eq!(power_of_half(exponent), 1.0 / (1_u128 << exponent) as f32);
        }
        assert_eq!(power_of_half(255), power_of_half(126), "saturated");
    }
}
