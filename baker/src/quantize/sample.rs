//! The sample codec, encoding; [`nearfield::sample`] decodes.

use glam::{DVec3, Vec3};
use half::f16;
use nearfield::layout::packed_sample as packed;
use nearfield::sample::decode_gradient;

/// The 20-bit octahedral code `x | y << 10` nearest to the direction of `gradient`.
///
/// The decoded direction is off by at most √2/511 rad = 0.159°, 0.084° in the root mean square over
/// all directions, and exact for the six axes. A direction that does not exist (zero, or not
/// finite) becomes +z.
///
/// Rounding each coordinate to its nearest code can miss the nearest direction (up to 0.238°): the
/// four codes around the exact coordinates are tried with the reader's own decoder (Cigolle et al.
/// 2014, "A survey of efficient representations for independent unit vectors"). At the centre of a
/// face of the octahedron, where the map stretches most, the codes are a hexagonal lattice, and the
/// bound is the circumradius of its cells.
pub fn encode_gradient(gradient: DVec3) -> u32 {
    let direction = (gradient / gradient.abs().max_element()).normalize_or(DVec3::Z);

    // Onto the octahedron, and its lower half unfolded over the edges of the square.
    let point = direction / direction.abs().element_sum();
    let (mut x, mut y) = (point.x, point.y);
    if point.z < 0.0 {
        x = (1.0 - point.y.abs()).copysign(point.x);
        y = (1.0 - point.x.abs()).copysign(point.y);
    }

    let centre = f64::from(packed::GRADIENT_CENTRE);
    let below = |coordinate: f64| ((coordinate + 1.0) * centre) as u32;
    let candidates = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(right, up)| {
        let x = (below(x) + right).min(packed::GRADIENT_MAX);
        let y = (below(y) + up).min(packed::GRADIENT_MAX);
        x | y << packed::GRADIENT_BITS
    });
    let with_error = candidates.map(|code| {
        let decoded = Vec3::from_array(decode_gradient(code)).as_dvec3();
        (decoded.distance_squared(direction), code)
    });
    let nearest = with_error.into_iter().min_by(|(a, _), (b, _)| a.total_cmp(b));
    nearest.map_or(0, |(_, code)| code)
}

/// The half float nearest to `value`, ties to even; the largest finite one beyond its range, and 0
/// for a NaN. Computed in software, so that no machine's own conversion shows in the bytes.
pub fn encode_half(value: f64) -> u16 {
    let largest = f64::from(f16::MAX);
    let value = if value.is_nan() { 0.0 } else { value.clamp(-largest, largest) };
    f16::from_f64_const(value).to_bits()
}

#[cfg(test)]
mod tests {
    use nearfield::sample::decode_half;

    use super::*;

    /// Points that cover the sphere evenly: a spiral by the golden angle.
    fn directions(count: u32) -> impl Iterator<Item = DVec3> {
        const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;
        (0..count).map(move |index| {
            let z = 1.0 - (2.0 * f64::from(index) + 1.0) / f64::from(count);
            let (sin, cos) = libm::sincos(GOLDEN_ANGLE * f64::from(index));
            let radius = libm::sqrt(1.0 - z * z);
            DVec3::new(radius * cos, radius * sin, z)
        })
    }

    fn decoded(code: u32) -> DVec3 {
        Vec3::from_array(decode_gradient(code)).as_dvec3()
    }

    #[test]
    fn angular_error_is_as_documented() {
        const COUNT: u32 = 400_000;
        let mut largest: f64 = 0.0;
        let mut sum = 0.0;
        for direction in directions(COUNT) {
            let angle = direction.angle_between(decoded(encode_gradient(direction))).to_degrees();
            largest = largest.max(angle);
            sum += angle * angle;
        }
        let rms = libm::sqrt(sum / f64::from(COUNT));
        let bound = (core::f64::consts::SQRT_2 / 511.0).to_degrees();
        assert!(largest > 0.98 * bound && largest <= 1.001 * bound, "largest error {largest}°");
        assert!((rms - 0.084_02).abs() < 5e-5, "root mean square error {rms}°");
    }

    #[test]
    fn no_code_is_nearer() {
        for direction in directions(20) {
            let error = |code| decoded(code).distance_squared(direction);
            let codes = (0..=packed::GRADIENT_MAX).flat_map(|y| (0..=packed::GRADIENT_MAX).map(move |x| x | y << 10));
            let nearest = codes.map(error).fold(f64::INFINITY, f64::min);
            assert_eq!(error(encode_gradient(direction)), nearest, "{direction}");
        }
    }

    #[test]
    fn axes_are_exact_at_any_length() {
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            for length in [1.0, -1.0, 1e-300, -1e300, f64::MAX, -5e-324] {
                let code = encode_gradient(axis * length);
                assert_eq!(decoded(code), axis * length.signum(), "{axis} {length}");
            }
        }
    }

    #[test]
    fn codes_survive_a_round_trip() {
        // Every direction of the square's interior has one code; its border has two for each.
        for y in (1..packed::GRADIENT_MAX).step_by(7) {
            for x in 1..packed::GRADIENT_MAX {
                let code = x | y << packed::GRADIENT_BITS;
                assert_eq!(encode_gradient(decoded(code)), code, "({x}, {y})");
            }
        }
    }

    #[test]
    fn directions_that_do_not_exist_become_z() {
        let nan = f64::NAN;
        let cases = [DVec3::ZERO, DVec3::splat(nan), DVec3::new(1.0, nan, 0.0), DVec3::INFINITY];
        for gradient in cases {
            assert_eq!(decoded(encode_gradient(gradient)), DVec3::Z, "{gradient}");
        }
    }

    #[test]
    fn the_reader_decodes_every_half() {
        for bits in 0..=u16::MAX {
            let half = f16::from_bits(bits);
            let expected = if half.is_finite() { half.to_f32_const() } else { 0.0 };
            let decoded = decode_half(bits);
            assert_eq!(decoded.abs().to_bits(), expected.abs().to_bits(), "{bits:#06x}");
            assert_eq!(decoded, expected, "{bits:#06x}");
        }
    }

    #[test]
    fn halves_are_nearest_and_finite() {
        assert_eq!(encode_half(1.0), 0x3C00);
        assert_eq!(encode_half(-2.0), 0xC000);
        assert_eq!(encode_half(1.0 + 1.0 / 2048.0), 0x3C00, "a tie goes to the even code");
        assert_eq!(encode_half(1e300), 0x7BFF);
        assert_eq!(encode_half(f64::NEG_INFINITY), 0xFBFF);
        assert_eq!(encode_half(f64::NAN), 0);
    }
}
