//! Signed BC4: eight bytes for 4 x 4 samples of a layer, two ends and sixteen codes of 3 bits.

use glam::UVec3;

/// Samples along the side of a block.
const SIDE: u32 = 4;

/// The layers of a grid, block by block; the last blocks of a row and a column repeat their last samples.
pub(super) struct Blocks {
    blocks: Vec<u64>,
    across: u32,
    down: u32,
}

impl Blocks {
    /// Encodes values from -1 to 1, x fastest.
    pub(super) fn encode(values: &[f32], counts: UVec3) -> Self {
        let (across, down) = (counts.x.div_ceil(SIDE), counts.y.div_ceil(SIDE));
        let block = |index: u32| {
            let (column, row, z) = (index % across, index / across % down, index / (across * down));
            encode(std::array::from_fn(|pixel| {
                let x = (SIDE * column + pixel as u32 % SIDE).min(counts.x - 1);
                let y = (SIDE * row + pixel as u32 / SIDE).min(counts.y - 1);
                values[(x + counts.x * (y + counts.y * z)) as usize]
            }))
        };
        Self { blocks: (0..across * down * counts.z).map(block).collect(), across, down }
    }

    pub(super) fn bytes(&self) -> usize {
        8 * self.blocks.len()
    }

    #[inline]
    pub(super) fn value(&self, [x, y, z]: [u32; 3]) -> f32 {
        let block = self.blocks[(x / SIDE + self.across * (y / SIDE + self.down * z)) as usize];
        let code = block >> (16 + 3 * (x % SIDE + SIDE * (y % SIDE))) & 7;
        palette_value(block as i8, (block >> 8) as i8, code as u8)
    }
}

/// Eight values between the ends if the first is greater; else six, and -1 and 1.
#[inline]
fn palette_value(first: i8, second: i8, code: u8) -> f32 {
    let (a, b) = (f32::from(first) / 127.0, f32::from(second) / 127.0);
    let between = |parts: f32| a + (b - a) * (f32::from(code) - 1.0) / parts;
    match code {
        0 => a,
        1 => b,
        _ if first > second => between(7.0),
        6 => -1.0,
        7 => 1.0,
        _ => between(5.0),
    }
}

/// The better mode, with ends at or a little inside the range of the values.
fn encode(values: [f32; 16]) -> u64 {
    let range = |values: &mut dyn Iterator<Item = f32>| {
        let (low, high) = values.fold((1.0f32, -1.0f32), |(low, high), value| (low.min(value), high.max(value)));
        ((127.0 * low).floor() as i8, (127.0 * high).ceil() as i8)
    };
    let (low, high) = range(&mut values.iter().copied());
    let clamped = 126.5 / 127.0;
    let (inner_low, inner_high) = range(&mut values.iter().copied().filter(|value| value.abs() < clamped));
    let inside = (0..9).map(|pair| (pair % 3, pair / 3));
    let eight = inside.clone().map(|(up, down)| (high.saturating_sub(down), low.saturating_add(up)));
    let six = inside.map(|(up, down)| (inner_low.saturating_add(up), inner_high.saturating_sub(down)));
    // Ends out of order mean the other mode, which is no worse for being tried.
    let coded = eight.chain(six).map(|(first, second)| with_ends(&values, first.max(-127), second.max(-127)));
    coded.min_by(|a, b| a.0.total_cmp(&b.0)).expect("eighteen pairs").1
}

/// The square error and the block.
fn with_ends(values: &[f32; 16], first: i8, second: i8) -> (f32, u64) {
    let palette: [f32; 8] = std::array::from_fn(|code| palette_value(first, second, code as u8));
    let mut block = u64::from(first as u8) | u64::from(second as u8) << 8;
    let mut squares = 0.0;
    for (pixel, value) in values.iter().enumerate() {
        let square = |code: usize| (palette[code] - value) * (palette[code] - value);
        let code = (1..8).fold(0, |best, code| if square(code) < square(best) { code } else { best });
        squares += square(code);
        block |= (code as u64) << (16 + 3 * pixel);
    }
    (squares, block)
}
