//! A bar of colours with three numbers, to stand below a picture.

use super::image::{Image, Rgb};

const PAPER: Rgb = [255; 3];
const INK: Rgb = [12, 12, 14];

/// Rows of three pixels, the left one in the highest bit.
const GLYPHS: [(char, [u8; 5]); 13] = [
    ('0', [7, 5, 5, 5, 7]),
    ('1', [2, 6, 2, 2, 7]),
    ('2', [7, 1, 7, 4, 7]),
    ('3', [7, 1, 7, 1, 7]),
    ('4', [5, 5, 7, 1, 1]),
    ('5', [7, 4, 7, 1, 7]),
    ('6', [7, 4, 7, 5, 7]),
    ('7', [7, 1, 1, 1, 1]),
    ('8', [7, 5, 7, 5, 7]),
    ('9', [7, 5, 7, 1, 7]),
    ('.', [0, 0, 0, 0, 2]),
    ('-', [0, 0, 7, 0, 0]),
    ('e', [0, 7, 7, 4, 3]),
];
/// Pixels of the picture for each of a glyph.
const ENLARGED: u32 = 2;
/// From one glyph to the next.
const ADVANCE: u32 = 4 * ENLARGED;
/// Space around the bar, its height, and the height of the numbers below it.
const MARGIN: u32 = 8;
const BAR: u32 = 14;
const TEXT: u32 = 5 * ENLARGED;

/// The picture with a bar below it, from 0 to `greatest`; `colour` is that of a share of it.
pub(super) fn below(image: Image, greatest: f64, colour: impl Fn(f64) -> Rgb) -> Image {
    let width = image.width();
    let mut bar = Canvas { width, pixels: vec![PAPER; (width * (3 * MARGIN + BAR + TEXT)) as usize] };

    let last = width.saturating_sub(2 * MARGIN).max(2) - 1;
    for column in 0..=last {
        let is_edge = column == 0 || column == last;
        for row in 0..BAR {
            let ink = is_edge || row == 0 || row == BAR - 1;
            bar.set(MARGIN + column, MARGIN + row, if ink { INK } else { colour(f64::from(column) / f64::from(last)) });
        }
    }

    // The numbers: at the left end, in the middle, at the right end.
    for (place, number) in [(0, 0.0), (1, 0.5 * greatest), (2, greatest)] {
        let text = if number == 0.0 { "0".to_owned() } else { format!("{number:e}") };
        let length = text.len() as u32 * ADVANCE;
        let free = (last + 1).saturating_sub(length);
        bar.write(&text, MARGIN + free * place / 2, 2 * MARGIN + BAR);
    }
    image.above(&Image::new(width, bar.pixels))
}

struct Canvas {
    width: u32,
    pixels: Vec<Rgb>,
}

impl Canvas {
    /// Pixels beyond the right side, of narrow pictures, are lost.
    fn set(&mut self, column: u32, row: u32, colour: Rgb) {
        if column < self.width {
            self.pixels[(row * self.width + column) as usize] = colour;
        }
    }

    fn write(&mut self, text: &str, left: u32, top: u32) {
        for (place, letter) in (0u32..).zip(text.chars()) {
            let glyph = GLYPHS.iter().find(|(other, _)| *other == letter).map_or([7; 5], |(_, rows)| *rows);
            for (y, x) in (0..TEXT).flat_map(|y| (0..3 * ENLARGED).map(move |x| (y, x))) {
                if glyph[(y / ENLARGED) as usize] >> (2 - x / ENLARGED) & 1 == 1 {
                    self.set(left + place * ADVANCE + x, top + y, INK);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_goes_from_the_first_colour_to_the_last_and_fits_any_width() {
        for width in [1, 7, 40, 300] {
            let image =
                below(Image::new(width, vec![[9; 3]; width as usize]), 2e-3, |share| [(share * 255.0) as u8; 3]);
            assert_eq!((image.width(), image.height()), (width, 1 + 3 * MARGIN + BAR + TEXT));
        }
        let image = below(Image::new(300, vec![[9; 3]; 300]), 2e-3, |share| [0, (share * 255.0) as u8, 0]);
        let at = |x: u32| image.pixel(x, 1 + MARGIN + BAR / 2);
        assert!(at(MARGIN + 1)[1] < 4 && at(300 - MARGIN - 2)[1] > 250);
    }

    #[test]
    fn every_letter_of_a_number_has_a_glyph() {
        for number in [1e-5, 2.5e-12, 6e7, 38e-1, 4.9e0, 7.8e1] {
            assert!(format!("{number:e}").chars().all(|letter| GLYPHS.iter().any(|(other, _)| *other == letter)));
        }
    }
}
