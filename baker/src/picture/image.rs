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

    /// Colour of a pixel, from the top left.
    #[cfg(test)]
    pub(super) fn pixel(&self, x: u32, y: u32) -> Rgb {
        self.pixels[(y * self.width + x) as usize]
    }

    /// Pictures of one height side by side.
    ///
    /// # Panics
    /// Without a picture, or when the heights differ.
    pub fn beside(images: &[Self]) -> Self {
        let height = images.first().expect("a picture").height;
        assert!(images.iter().all(|image| image.height == height), "one height");
        let row = |image: &Self, row: u32| {
            let width = image.width as usize;
            image.pixels[row as usize * width..][..width].to_vec()
        };
        let pixels = (0..height).flat_map(|y| images.iter().flat_map(move |image| row(image, y))).collect();
        Self::new(images.iter().map(|image| image.width).sum(), pixels)
    }

    /// This picture with another of its width below it.
    pub(super) fn above(mut self, other: &Self) -> Self {
        assert_eq!(self.width, other.width, "one width");
        self.pixels.extend_from_slice(&other.pixels);
        Self::new(self.width, self.pixels)
    }

    /// Where two pictures of one size differ: white where they agree, darker by the difference of each channel.
    ///
    /// # Panics
    /// When the sizes differ.
    pub fn difference(&self, other: &Self) -> Self {
        assert_eq!((self.width, self.height), (other.width, other.height), "one size");
        let differ = |(a, b): (&Rgb, &Rgb)| std::array::from_fn(|channel| 255 - a[channel].abs_diff(b[channel]));
        Self::new(self.width, self.pixels.iter().zip(&other.pixels).map(differ).collect())
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_stand_side_by_side_and_differ_where_they_do() {
        let left = Image::new(1, vec![[0; 3], [10, 20, 30]]);
        let right = Image::new(1, vec![[0; 3], [12, 15, 30]]);

        let both = Image::beside(&[left.clone(), right.clone()]);
        assert_eq!(both.pixels, [[0; 3], [0; 3], [10, 20, 30], [12, 15, 30]]);
        assert_eq!(left.difference(&right).pixels, [[255; 3], [253, 250, 255]]);
    }
}
