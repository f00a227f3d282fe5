//! Numbers that look random and are the same on every machine.

use glam::DVec3;

/// A linear congruential sequence (Knuth's MMIX constants).
pub(crate) struct Numbers(u64);

impl Numbers {
    /// Another seed, another sequence.
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// From 0 to 1, 1 excluded.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// In a box.
    pub(crate) fn point(&mut self, min: DVec3, max: DVec3) -> DVec3 {
        min + (max - min) * DVec3::new(self.unit(), self.unit(), self.unit())
    }
}
