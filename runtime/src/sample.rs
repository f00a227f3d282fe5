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
    let fold = if z < 0.0 { -z } else { 0.0 };
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
