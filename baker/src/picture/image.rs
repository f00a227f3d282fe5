//! Pixels, and their PNG.

/// One opaque sRGB colour.
pub(super) type Rgb = [u8; 3];

/// A picture: rows from the top, pixels from the left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    width: u32,
    height: u32,
    pixels: Vec<Rgb>,
}

impl Image {
    /// A picture of `pixels`, `width` of them a row.
    pub(super) fn new(width: u32, pixels: Vec<Rgb>) -> Self {
        let height = u32::try_from(pixels.len()).expect("a picture has fewer than 2^32 pixels") / width.max(1);
        assert_eq!(pixels.len(), width as usize * height as usize, "rows are complete");
        Self { width, height, pixels }
    }

    /// Pixels along x.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels along y.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The bytes of a PNG file.
    pub fn to_png(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);

        encoder
            .write_header()
            .and_then(|mut writer| writer.write_image_data(self.pixels.as_flattened()))
            .expect("memory takes every write, and the rows are complete");
        bytes
    }
}
