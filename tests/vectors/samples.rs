//! Sample blocks (§7, §8) of numbers without pattern.

use super::writer::TRICUBIC;
use half::f16;

pub(crate) const PACKED32: u32 = 0;
pub(crate) const F16: u32 = 1;
pub(crate) const F32: u32 = 2;

/// All samples of a block, and the corners of the parent among them.
pub(crate) const ALL: u32 = (1 << 27) - 1;
pub(crate) const PARENT_CORNERS: u32 = 0b101_000_101 | 0b101_000_101 << 18;
/// The sample in the middle, which nothing implies.
pub(crate) const CENTRE: u32 = 1 << 13;

/// What a block is made of.
#[derive(Clone, Copy)]
pub(crate) struct Block {
    pub(crate) interpolant: u8,
    pub(crate) precision: u32,
    pub(crate) present: u32,
    pub(crate) full: u32,
    pub(crate) base: i32,
}

/// Numbers without pattern: xorshift (Marsaglia 2003).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed << 1 | 1)
    }

    pub(crate) fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) as u32
    }

    /// A multiple of 2⁻⁸ from −1 up to 1, which every precision holds.
    pub(crate) fn number(&mut self) -> f32 {
        (self.word() % 512) as f32 / 256.0 - 1.0
    }

    /// The words of a block.
    pub(crate) fn block(&mut self, block: Block) -> Vec<u32> {
        let base = if block.precision == F32 { 0 } else { block.base };
        let mut words = vec![block.present | block.precision << 27, block.full, base.cast_unsigned()];
        let bits = (0..27).filter(|bit| block.present >> bit & 1 == 1);
        if block.interpolant == TRICUBIC {
            words.extend(bits.flat_map(|bit| self.sample(block.precision, block.full >> bit & 1 == 1)));
        } else if block.precision == F32 {
            words.extend(bits.map(|_| self.number().to_bits()));
        } else {
            let codes: Vec<u32> = bits.map(|_| self.word() & 0xFFFF).collect();
            words.extend(codes.chunks(2).map(|pair| pair[0] | pair.get(1).unwrap_or(&0) << 16));
        }
        words
    }

    /// The words of a tricubic sample.
    pub(crate) fn sample(&mut self, precision: u32, is_full: bool) -> Vec<u32> {
        let derivatives = if is_full { 7 } else { 3 };
        match (precision, is_full) {
            (PACKED32, false) => {
                let (x, y, distance) = (self.word() % 1023, self.word() % 1023, self.word() & 0xFFF);
                vec![x | y << 10 | distance << 20]
            }
            (F32, _) => (0..=derivatives).map(|_| self.number().to_bits()).collect(),
            _ => {
                let mut halves = vec![self.word() & 0xFFFF];
                halves.extend((0..derivatives).map(|_| u32::from(f16::from_f32(self.number()).to_bits())));
                halves.chunks(2).map(|pair| pair[0] | pair[1] << 16).collect()
            }
        }
    }
}
