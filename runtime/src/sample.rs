//! The sample codec, decoding: octahedral gradients, half floats and integer distances.
//!
//! Format specification, "Sample codec". Every step is an addition, a multiplication or a
//! comparison of `f32`, so all readers agree on every bit.

use crate::layout::packed_sample as packed;
use crate::math;

/// Unit gradient of a 20-bit octahedral code, `x | y << 10`; bits above are ignored.
///
/// The six axis directions are exact; any other length is 1 within 3e-7. Octahedral mapping: Meyer,
/// Süßmuth, Sußner, Stamminger and Greiner 2010, "On floating-point normal vectors".
#[inline]
pub fn decode_gradient(code: u32) -> [f32; 3] {
    let x = octahedral_coordinate(code);
    let y = octahedral_coordinate(code >> packed::GRADIENT_BITS);

    // The lower half of the octahedron is folded over the edges of the square.
    let z = 1.0 - x.abs() - y.abs();
    let fold = 0.5 * (z.abs() - z);
    let x = x - fold.copysign(x);
    let y = y - fold.copysign(y);

    // From the octahedron onto the sphere.
    let reciprocal = math::reciprocal_sqrt(x * x + y * y + z * z);
    [x * reciprocal, y * reciprocal, z * reciprocal]
}

/// The low ten bits of `code` as a coordinate: -1 at code 0, exactly 0 at 511, 1 at 1022.
#[inline]
fn octahedral_coordinate(code: u32) -> f32 {
    const STEP: f32 = 1.0 / packed::GRADIENT_CENTRE as f32;
    let code = code & ((1 << packed::GRADIENT_BITS) - 1);
    (code as i32 - packed::GRADIENT_CENTRE as i32) as f32 * STEP
}

/// Exact value of an IEEE 754 half float; 0 for an infinity or a NaN.
#[inline]
pub fn decode_half(bits: u16) -> f32 {
    const SUBNORMAL_STEP: f32 = 1.0 / (1 << 24) as f32;
    let sign = u32::from(bits & 0x8000) << 16;
    let exponent = u32::from(bits >> 10) & 31;
    let fraction = u32::from(bits & 0x3FF);

    let magnitude = match exponent {
        0 => (fraction as f32 * SUBNORMAL_STEP).to_bits(),
        31 => 0,
        _ => ((exponent + 112) << 23) | (fraction << 13),
    };
    f32::from_bits(sign | magnitude)
}

/// Distance of a code: `(base + code) · quantum`, the sum wrapping.
#[inline]
pub(crate) fn decode_distance(base: i32, code: u32, quantum: f32) -> f32 {
    base.wrapping_add(code as i32) as f32 * quantum
}

/// A stored `f32` of a sample; 0 for what a valid file does not hold.
#[inline]
pub(crate) fn decode_single(bits: u32) -> f32 {
    let value = f32::from_bits(bits);
    if is_sample(value) { value } else { 0.0 }
}

/// Whether a sample may hold this value.
pub(crate) fn is_sample(value: f32) -> bool {
    value.abs() <= crate::layout::limit::MAX_MAGNITUDE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_exact() {
        let code = |x: u32, y: u32| x | y << packed::GRADIENT_BITS;
        assert_eq!(decode_gradient(code(1022, 511)), [1.0, 0.0, 0.0]);
        assert_eq!(decode_gradient(code(0, 511)), [-1.0, 0.0, 0.0]);
        assert_eq!(decode_gradient(code(511, 1022)), [0.0, 1.0, 0.0]);
        assert_eq!(decode_gradient(code(511, 0)), [0.0, -1.0, 0.0]);
        assert_eq!(decode_gradient(code(511, 511)), [0.0, 0.0, 1.0]);
        for corner in [code(0, 0), code(1022, 0), code(0, 1022), code(1022, 1022)] {
            assert_eq!(decode_gradient(corner), [0.0, 0.0, -1.0]);
        }
        assert_eq!(decode_gradient(0xABC << 20 | code(0, 511)), [-1.0, 0.0, 0.0], "bits above");
    }

    #[test]
    #[cfg_attr(miri, ignore = "a million codes")]
    fn every_code_decodes_to_a_unit_vector() {
        for code in 0..1 << 20 {
            let [x, y, z] = decode_gradient(code).map(f64::from);
            let error = ((x * x + y * y + z * z).sqrt() - 1.0).abs();
            // The codes that no writer may write have finite answers too.
            let largest = (code & 1023).max(code >> 10);
            let tolerance = if largest <= packed::GRADIENT_MAX { 3e-7 } else { 1e-3 };
            assert!(error < tolerance, "{code:#x}: {error}");
        }
    }

    #[test]
    fn halves_of_note() {
        let cases = [
            (0x0000, 0.0),
            (0x3C00, 1.0),
            (0xC000, -2.0),
            (0x7BFF, 65504.0),
            (0x0001, 5.960_464_5e-8),
            (0x03FF, 6.097_555e-5),
            (0x0400, 6.103_515_6e-5),
            (0x3555, 0.333_251_95),
            (0x7C00, 0.0),
            (0xFC00, 0.0),
            (0x7E00, 0.0),
        ];
        for (bits, value) in cases {
            assert_eq!(decode_half(bits), value, "{bits:#06x}");
        }
        assert!(decode_half(0x8000).is_sign_negative());
    }

    #[test]
    fn distances_wrap_instead_of_panicking() {
        assert_eq!(decode_distance(-3, 5, 0.25), 0.5);
        assert_eq!(decode_distance(i32::MAX, 1, 1.0), i32::MIN as f32);
    }

    #[test]
    fn singles_that_no_writer_may_write_are_zero() {
        for value in [f32::NAN, f32::INFINITY, -1e30] {
            assert_eq!(decode_single(value.to_bits()), 0.0);
        }
        assert_eq!(decode_single((-3.5_f32).to_bits()), -3.5);
    }
}
