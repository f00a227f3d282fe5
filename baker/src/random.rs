//! Random numbers that depend on a seed and a position alone.
//!
//! Every item of every stream owns its draws, so items may be made in any order, on any number of
//! threads, on any machine, and are the same.

use glam::DVec3;

/// Increment of the counter: the odd integer closest to 2⁶⁴ divided by the golden ratio.
const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// The draws of one item: SplitMix64 (Steele, Lea and Flood, *Fast splittable pseudorandom number
/// generators*, OOPSLA 2014), a counter with a bijective mixer.
#[derive(Clone, Debug)]
pub struct Draws {
    counter: u64,
}

impl Draws {
    /// The draws of item `index` of `stream`.
    pub fn new(seed: u64, stream: u64, index: u64) -> Self {
        let stream_counter = mix(seed).wrapping_add(mix(stream.wrapping_add(GAMMA)));
        Self { counter: mix(stream_counter.wrapping_add(index.wrapping_mul(GAMMA))) }
    }

    /// A unit vector, evenly over the sphere: height and longitude (Archimedes).
    pub fn direction(&mut self) -> DVec3 {
        let height = 2.0 * self.unit() - 1.0;
        let (sine, cosine) = libm::sincos(core::f64::consts::TAU * self.unit());
        let radius = (1.0 - height * height).max(0.0).sqrt();
        DVec3::new(radius * cosine, radius * sine, height)
    }

    /// A number in [0, 1), a multiple of 2⁻⁵³.
    pub fn unit(&mut self) -> f64 {
        const SCALE: f64 = 1.0 / (1u64 << 53) as f64;
        (self.next() >> 11) as f64 * SCALE
    }

    fn next(&mut self) -> u64 {
        self.counter = self.counter.wrapping_add(GAMMA);
        mix(self.counter)
    }
}

fn mix(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_generator_is_splitmix64() {
        let mut draws = Draws { counter: 1_234_567 };

        // First outputs of the authors' reference code for this seed.
        assert_eq!(draws.next(), 6_457_827_717_110_365_317);
        assert_eq!(draws.next(), 3_203_168_211_198_807_973);
        assert_eq!(draws.next(), 9_817_491_932_198_370_423);
    }

    #[test]
    fn items_and_streams_are_uniform_and_distinct() {
        let first = |stream, index| Draws::new(7, stream, index).unit();
        let mean = (0..100_000).map(|index| first(1, index)).sum::<f64>() / 100_000.0;

        // Four standard deviations of the mean: 4 / √(12 · 100 000).
        assert!((mean - 0.5).abs() < 3.7e-3, "mean {mean}");
        assert_ne!(first(1, 0), first(1, 1));
        assert_ne!(first(1, 0), first(2, 0));
    }
}
