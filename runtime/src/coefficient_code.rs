//! From bits to the coefficients of polynomials (SPEC.md §12.5).

use crate::layout::leaf;
use crate::legendre::Lanes;

/// The bytes that a leaf may take, and enough after them to load eight from any.
pub(crate) type Window = [u8; leaf::PADDING];

/// Most bits of coefficients that are read by [`Codes`]: three of degree 1 fit in 32 bits, six of degree 2 and ten of degree 3 in
/// what is loaded at once.
const NARROW: [u8; 4] = [127, 10, 9, 5];

/// Whether the coefficients of degree 1 to 3 of these widths are read by [`Codes`]. Never on machines of 32 bits, where
/// that would not be faster.
#[inline]
pub(crate) fn are_narrow(widths: [u8; 4]) -> bool {
    // What is added to a byte carries into its highest bit if the width is too great.
    const ROOM: u32 = u32::from_le_bytes([0, 127 - NARROW[1], 127 - NARROW[2], 127 - NARROW[3]]);
    const HIGHEST: u32 = u32::from_le_bytes([0, 128, 128, 128]);
    let widths = u32::from_le_bytes(widths);
    cfg!(target_pointer_width = "64") && (widths | widths.wrapping_add(ROOM)) & HIGHEST == 0
}

/// At least 57 bits from a bit on.
#[inline]
pub(crate) fn load(window: &Window, bit: u32) -> u64 {
    // The mask shows the compiler that no index can fail.
    let byte = (bit >> 3) as usize & 63;
    let bytes = window.get(byte..).and_then(<[u8]>::first_chunk).copied().unwrap_or_default();
    u64::from_le_bytes(bytes) >> (bit & 7)
}

/// The number whose code is in the lowest bits.
#[inline]
pub(crate) fn number(width: u32, bits: u64) -> f32 {
    let code = bits as u32 & ((1 << width) - 1);
    (code.cast_signed() - (1_u32 << width >> 1).cast_signed()) as f32
}

/// How three codes of a width that together fit in 32 bits become numbers where they are. A power of two makes the numbers
/// those that the codes would have in the lowest bits.
#[repr(C, align(16))]
pub(crate) struct Codes {
    mask: [u32; 4],
    /// The codes of 0.
    zero: [u32; 4],
    scale: Lanes,
}

impl Codes {
    const fn new(width: u32) -> Self {
        let mut codes = Self { mask: [0; 4], zero: [0; 4], scale: [0.0; 4] };
        let mut lane = 0;
        while lane < 4 && width > 0 {
            let shift = width * if lane < 3 { lane as u32 } else { 2 };
            codes.mask[lane] = ((1 << width) - 1) << shift;
            codes.zero[lane] = 1 << (width - 1) << shift;
            codes.scale[lane] = f32::from_bits((127 - shift) << 23);
            lane += 1;
        }
        codes
    }

    #[inline]
    pub(crate) fn of(width: u32) -> &'static Self {
        &CODES[width as usize & 15]
    }

    /// The number whose code is in the lowest bits.
    #[inline]
    pub(crate) fn one(&self, bits: u64) -> f32 {
        (bits as u32 & self.mask[0]).wrapping_sub(self.zero[0]).cast_signed() as f32
    }

    /// Three numbers whose codes are in the lowest bits. The last lane is not of use: four alike make better code.
    #[inline]
    pub(crate) fn three(&self, bits: u64, numbers: &mut Lanes) {
        for (lane, number) in numbers.iter_mut().enumerate() {
            let code = (bits as u32 & self.mask[lane]).wrapping_sub(self.zero[lane]);
            *number = code.cast_signed() as f32 * self.scale[lane];
        }
    }
}

/// By width.
static CODES: [Codes; 16] = {
    let mut all = [const { Codes::new(0) }; 16];
    let mut width = 0;
    while width <= 10 {
        all[width] = Codes::new(width as u32);
        width += 1;
    }
    all
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_up_to_the_limits_are_narrow() {
        for degree in 1..4 {
            for width in 0..=32 {
                let mut widths = [32, 0, 0, 0];
                widths[degree] = width;
                let expected = cfg!(target_pointer_width = "64") && width <= NARROW[degree];
                assert_eq!(are_narrow(widths), expected, "{width} bits of degree {degree}");
            }
        }
    }

    #[test]
    fn codes_in_place_are_the_numbers_of_codes_alone() {
        for width in 1..=10 {
            let codes = Codes::of(width);
            for code in 0..1_u64 << width {
                let expected = code as f32 - (1_u32 << (width - 1)) as f32;
                let others = [code * 7 + 1, code * 5 + 3].map(|other| other & ((1 << width) - 1));
                let bits = code | others[0] << width | others[1] << (2 * width) | u64::MAX << (3 * width);
                assert_eq!(number(width, bits), expected, "{code} of {width} bits");
                assert_eq!(codes.one(bits), expected, "{code} of {width} bits");
                let mut three = [0.0; 4];
                codes.three(bits, &mut three);
                let alone = [code, others[0], others[1]].map(|code| number(width, code));
                assert_eq!(three[..3], alone, "{code} and others of {width} bits");
            }
        }
        assert_eq!(number(0, u64::MAX), 0.0, "no bits are no number but 0");
    }

    #[test]
    fn at_least_57_bits_are_loaded_from_any_bit_of_a_leaf() {
        let window: Window = core::array::from_fn(|byte| (byte * 37 + 11) as u8);
        let bit_at = |bit: usize| u64::from(window[bit / 8] >> (bit % 8) & 1);
        for bit in 0..(window.len() - 8) * 8 {
            let expected = (0..57).fold(0, |bits, place| bits | bit_at(bit + place) << place);
            assert_eq!(load(&window, bit as u32) & ((1 << 57) - 1), expected, "from bit {bit}");
        }
    }
}
