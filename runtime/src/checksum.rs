//! CRC-32C (Castagnoli): polynomial 0x1EDC6F41 reflected, as in RFC 3720.
//!
//! A table of sixteen words, half a byte a step: 64 bytes of a microcontroller's flash.

const TABLE: [u32; 16] = table();

const fn table() -> [u32; 16] {
    let mut table = [0; 16];
    let mut nibble = 0;
    while nibble < 16 {
        let mut remainder = nibble as u32;
        let mut bit = 0;
        while bit < 4 {
            let odd = remainder & 1 == 1;
            remainder = (remainder >> 1) ^ if odd { 0x82F6_3B78 } else { 0 };
            bit += 1;
        }
        table[nibble] = remainder;
        nibble += 1;
    }
    table
}

/// A checksum under way.
#[derive(Clone, Copy)]
pub(crate) struct Crc32c(u32);

impl Crc32c {
    pub(crate) const fn new() -> Self {
        Self(!0)
    }

    #[inline(never)]
    pub(crate) fn update(self, bytes: &[u8]) -> Self {
        Self(bytes.iter().fold(self.0, |remainder, &byte| {
            let low = remainder ^ u32::from(byte);
            let high = (low >> 4) ^ TABLE[(low & 15) as usize];
            (high >> 4) ^ TABLE[(high & 15) as usize]
        }))
    }

    pub(crate) const fn finish(self) -> u32 {
        !self.0
    }
}

/// CRC-32C of `bytes`, as stored in the header and in the section table.
pub fn crc32c(bytes: &[u8]) -> u32 {
    Crc32c::new().update(bytes).finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_checksums() {
        assert_eq!(crc32c(b"123456789"), 0xE306_9283, "the check value of the CRC catalogue");

        // RFC 3720, B.4.
        let ascending = core::array::from_fn::<u8, 32, _>(|index| index as u8);
        let descending = core::array::from_fn::<u8, 32, _>(|index| 31 - index as u8);
        assert_eq!(crc32c(&[0; 32]), 0x8A91_36AA);
        assert_eq!(crc32c(&[0xFF; 32]), 0x62A8_AB43);
        assert_eq!(crc32c(&ascending), 0x46DD_794E);
        assert_eq!(crc32c(&descending), 0x113F_DB5C);
    }

    #[test]
    fn pieces_sum_to_the_whole() {
        let whole = b"signed distance fields that ship";
        for at in 0..=whole.len() {
            let (before, after) = whole.split_at(at);
            assert_eq!(Crc32c::new().update(before).update(after).finish(), crc32c(whole));
        }
        assert_eq!(crc32c(b""), 0);
    }
}
