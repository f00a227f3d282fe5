//! Corners to the codes of a sample block.

use super::rounding::{FINE_PER_QUANTUM, Rounding};
use super::sample::{encode_gradient, encode_half};
use crate::corner::Corner;
use crate::settings::Precision;
use half::f16;
use nearfield::layout::{block, packed_sample};

/// How the samples of one block are coded: with the precision asked for where its codes reach, as
/// floats where they do not.
pub struct Codes {
    precision: Precision,
    edge: f64,
    quantum: f64,
    /// In quanta.
    base: f64,
}

impl Codes {
    /// The codes of a block with these corners, of leaves of this level.
    pub fn of<'a>(rounding: &Rounding, level: u8, corners: impl Iterator<Item = &'a Corner> + Clone) -> Self {
        let quantum = rounding.quantum(level);
        let base = corners.clone().map(|corner| (corner.distance() / quantum).floor()).fold(f64::INFINITY, f64::min);
        let codes = Self { precision: rounding.precision(), edge: rounding.edge(level), quantum, base };
        if corners.clone().all(|corner| codes.reach(corner)) {
            codes
        } else {
            Self { precision: Precision::F32, base: 0.0, ..codes }
        }
    }

    /// The precision of the block.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// The base distance, in quanta.
    pub fn base(&self) -> i32 {
        if self.precision == Precision::F32 { 0 } else { self.base as i32 }
    }

    /// The words of a sample, with mixed derivatives if it is full.
    pub fn sample(&self, corner: &Corner, full: bool) -> Vec<u32> {
        let [_, x, y, xy, z, xz, yz, xyz] = corner.0;
        let edge = self.edge;
        let derivatives = [x, y, z, xy * edge, xz * edge, yz * edge, xyz * edge * edge];
        let derivatives = if full { &derivatives[..] } else { &derivatives[..3] };
        match self.precision {
            Precision::Packed32 if !full => {
                let distance = self.above_base(corner).round() as u32;
                vec![encode_gradient(corner.gradient()) | distance << packed_sample::DISTANCE_SHIFT]
            }
            Precision::Packed32 | Precision::F16 => {
                let derivatives = derivatives.iter().map(|&derivative| encode_half(derivative));
                pairs(&[self.fine_distance(corner)].into_iter().chain(derivatives).collect::<Vec<_>>())
            }
            Precision::F32 => [corner.distance()].iter().chain(derivatives).map(|&number| float(number)).collect(),
        }
    }

    /// The words of the distances of a trilinear block.
    pub fn distances<'a>(&self, corners: impl Iterator<Item = &'a Corner>) -> Vec<u32> {
        match self.precision {
            Precision::F32 => corners.map(|corner| float(corner.distance())).collect(),
            _ => pairs(&corners.map(|corner| self.fine_distance(corner)).collect::<Vec<_>>()),
        }
    }

    /// Whether the codes can hold a corner.
    fn reach(&self, corner: &Corner) -> bool {
        let Corner([_, _, _, xy, _, xz, yz, xyz]) = corner;
        let derivatives = [xy, xz, yz].map(|mixed| mixed * self.edge).into_iter().chain([xyz * self.edge * self.edge]);
        let largest = derivatives.chain(corner.gradient().to_array()).map(f64::abs).fold(0.0, f64::max);
        self.above_base(corner) <= f64::from(packed_sample::DISTANCE_MAX)
            && (f64::from(block::MIN_BASE)..=f64::from(block::MAX_BASE)).contains(&self.base)
            && largest <= f16::MAX.to_f64()
    }

    /// Distance above the base, in quanta.
    fn above_base(&self, corner: &Corner) -> f64 {
        corner.distance() / self.quantum - self.base
    }

    /// Distance above the base, in fine quanta.
    fn fine_distance(&self, corner: &Corner) -> u16 {
        (FINE_PER_QUANTUM * self.above_base(corner)).round() as u16
    }
}

fn float(value: f64) -> u32 {
    (value as f32).to_bits()
}

/// Two halves a word, the first one low; the last word may lack its high half.
fn pairs(halves: &[u16]) -> Vec<u32> {
    let word = |pair: &[u16]| u32::from(pair[0]) | u32::from(pair.get(1).copied().unwrap_or(0)) << 16;
    halves.chunks(2).map(word).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Settings;
    use glam::DVec3;

    fn rounding() -> Rounding {
        Rounding::new(&Settings::default(), 1.0)
    }

    fn corner(distance: f64) -> Corner {
        Corner::first_order(distance, DVec3::X)
    }

    #[test]
    fn distances_of_a_block_fit_its_codes() {
        // Two cells of edge 1/4, along their diagonal.
        let corners = [corner(-0.4), corner(-0.4 + 0.5 * 3f64.sqrt())];
        let codes = Codes::of(&rounding(), 2, corners.iter());
        assert_eq!(codes.precision(), Precision::Packed32);
        let [near, far] = [0, 1].map(|i| codes.sample(&corners[i], false)[0] >> packed_sample::DISTANCE_SHIFT);
        assert!(near <= 1, "the base is the least distance, rounded down: {near}");
        assert!((3800..=packed_sample::DISTANCE_MAX).contains(&far), "{far}");
    }

    #[test]
    fn what_codes_cannot_reach_is_stored_as_floats() {
        let far = Codes::of(&rounding(), 2, [corner(0.0), corner(1.0)].iter());
        let steep = Codes::of(&rounding(), 2, [Corner([0.0, 1e6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])].iter());
        let outside = Codes::of(&rounding(), 2, [corner(1e9)].iter());
        for codes in [far, steep, outside] {
            assert_eq!((codes.precision(), codes.base()), (Precision::F32, 0));
            assert_eq!(codes.sample(&corner(0.5), false)[0], 0.5f32.to_bits());
        }
    }

    #[test]
    fn full_samples_hold_mixed_derivatives_by_cell_edges() {
        let full = Corner([0.0, 1.0, 0.5, 2.0, -1.0, 4.0, 8.0, 32.0]);
        let codes = Codes::of(&rounding(), 2, [full].iter());
        let halves = [1.0, 0.5, -1.0, 0.5, 1.0, 2.0, 2.0].map(encode_half);
        let words = codes.sample(&full, true);
        let stored: Vec<u16> = words.iter().flat_map(|word| [*word as u16, (word >> 16) as u16]).skip(1).collect();
        assert_eq!(stored, halves);
    }
}
