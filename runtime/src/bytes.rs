//! The only raw access to bytes. A read outside the bytes is zero: nothing here can fail.
//!
//! Queries read [`Words`]; the functions before them are for what is read once, and stay apart to be there once.

use core::ops::Range;

/// `N` bytes from the start of `range`.
fn array<const N: usize>(bytes: &[u8], range: Range<usize>) -> [u8; N] {
    let tail = bytes.get(range.start..);
    tail.and_then(<[u8]>::first_chunk).copied().unwrap_or([0; N])
}

pub(crate) fn u8_at(bytes: &[u8], at: usize) -> u8 {
    bytes.get(at).copied().unwrap_or(0)
}

pub(crate) fn u16_at(bytes: &[u8], range: Range<usize>) -> u16 {
    u16::from_le_bytes(array(bytes, range))
}

#[inline(never)]
pub(crate) fn u32_at(bytes: &[u8], range: Range<usize>) -> u32 {
    u32::from_le_bytes(array(bytes, range))
}

pub(crate) fn f32_at(bytes: &[u8], range: Range<usize>) -> f32 {
    f32::from_bits(u32_at(bytes, range))
}

/// Three `u16`.
pub(crate) fn u16x3_at(bytes: &[u8], range: Range<usize>) -> [u16; 3] {
    let [a, b, c, d, e, f] = array(bytes, range);
    [[a, b], [c, d], [e, f]].map(u16::from_le_bytes)
}

/// Three `f32`.
pub(crate) fn f32x3_at(bytes: &[u8], range: Range<usize>) -> [f32; 3] {
    [0, 4, 8].map(|step| f32_at(bytes, range.start + step..range.end))
}

/// Bytes copied as they are.
pub(crate) fn bytes_at<const N: usize>(bytes: &[u8], range: Range<usize>) -> [u8; N] {
    array(bytes, range)
}

/// Little-endian 32-bit words.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Words<'a>(&'a [[u8; 4]]);

impl<'a> Words<'a> {
    /// The whole words of `bytes`.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self(bytes.as_chunks().0)
    }

    pub(crate) fn len(self) -> usize {
        self.0.len()
    }

    /// The first `count` words, if there are so many.
    pub(crate) fn head(self, count: usize) -> Option<Self> {
        self.0.get(..count).map(Self)
    }

    pub(crate) fn iter(self) -> impl Iterator<Item = u32> {
        self.0.iter().map(|&word| u32::from_le_bytes(word))
    }

    /// The words from `start` on.
    #[inline]
    pub(crate) fn tail(self, start: usize) -> Self {
        Self(self.0.get(start..).unwrap_or(&[]))
    }

    #[inline]
    pub(crate) fn word(self, at: usize) -> u32 {
        self.0.get(at).map_or(0, |&word| u32::from_le_bytes(word))
    }

    /// The 16 bits of half `at` of a word.
    #[inline]
    pub(crate) fn half(self, at: usize) -> u32 {
        self.0.as_flattened().as_chunks().0.get(at).map_or(0, |&half| u16::from_le_bytes(half).into())
    }

    /// The first `N` words, each little-endian, if there are so many.
    #[inline]
    pub(crate) fn window<const N: usize>(self) -> Option<&'a [[u8; 4]; N]> {
        self.0.first_chunk()
    }

    /// `N` words from `at`; all zero unless all lie inside.
    #[inline]
    pub(crate) fn words<const N: usize>(self, at: usize) -> [u32; N] {
        let tail = self.0.get(at..);
        let words: Option<&[[u8; 4]; N]> = tail.and_then(<[_]>::first_chunk);
        words.map_or([0; N], |words| words.map(u32::from_le_bytes))
    }
}
