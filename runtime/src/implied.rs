//! Samples that a block leaves out because the corners of the parent cell determine them.
//!
//! Where eight siblings meet a larger leaf, a vertex in the middle of their parent's edge or face must
//! repeat what that leaf interpolates there. The leaf holds the whole edge or face, and the parent's
//! corners on it carry its derivatives, so the cubic between those corners is the same (Pujol and Chica
//! 2023, appendix): the vertex needs no bytes.

use crate::hermite::{Jet, Jets};
use core::array::from_fn;

/// Whether a block that leaves a lattice bit out implies it: the parent's corners around it are stored and,
/// for the middle of a face, the middles of that face's edges are not. The parent's own corners and the
/// centre of the block are never implied.
pub(crate) fn is_implied(bit: u32, present: u32) -> bool {
    let halfway = [(1, bit % 3), (3, bit / 3 % 3), (9, bit / 9 % 3)];
    let ends = |mask: u32, step: u32| mask >> step | mask << step;
    let all = |mask: u32| present & mask == mask;
    let middle = 1 << bit;
    match halfway.map(|(step, digit)| (digit == 1).then_some(step)) {
        [Some(step), None, None] | [None, Some(step), None] | [None, None, Some(step)] => all(ends(middle, step)),
        [Some(a), Some(b), None] | [Some(a), None, Some(b)] | [None, Some(a), Some(b)] => {
            let edges = ends(middle, a) | ends(middle, b);
            all(ends(ends(middle, a), b)) && present & edges == 0
        }
        _ => false,
    }
}

/// Replaces, at each implied corner of an octant, the jet of the parent's corner on the same side by the
/// jet that the parent's cubic has there. `implied` has a bit for each corner, `4 x + 2 y + z`.
///
/// An axis at a time, the corners away from the parent's own corner move to the middle. A corner in the
/// middle of a face is reached in two steps, through those in the middle of its edges, which are implied too.
pub(crate) fn settle(jets: &mut Jets, implied: u32, octant: u32) {
    settle_along::<4>(jets, implied, octant & 1);
    settle_along::<2>(jets, implied, octant >> 1 & 1);
    settle_along::<1>(jets, implied, octant >> 2 & 1);
}

/// One axis, by its bit in the indices of corners and derivatives.
#[inline]
fn settle_along<const AXIS: usize>(jets: &mut Jets, implied: u32, far_half: u32) {
    // The parent's own corner is near in the near half and far in the far half; its opposite moves.
    let moves = [0xAA_u32, 0xCC, 0xF0][AXIS / 2] ^ far_half.wrapping_neg();
    let mut moving = implied & moves & 0xFF;
    while moving != 0 {
        // The masks show the compiler that no index can fail.
        let corner = moving.trailing_zeros() as usize & 7;
        moving &= moving - 1;
        jets[corner] = middle::<AXIS>(&jets[corner & !AXIS], &jets[corner | AXIS]);
    }
}

/// The jet in the middle of a cubic that spans two leaves, from those at its ends.
#[inline]
fn middle<const AXIS: usize>(near: &Jet, far: &Jet) -> Jet {
    let is_slope = |index: usize| index & AXIS != 0;
    let sum: Jet = from_fn(|index| near[index] + far[index]);
    let difference: Jet = from_fn(|index| near[index] - far[index]);
    from_fn(|index| {
        let [by_sum, by_difference] = if is_slope(index) { [-0.25, -0.75] } else { [0.5, 0.25] };
        by_sum * sum[index] + by_difference * difference[index ^ AXIS]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_and_centre_are_never_implied() {
        for bit in [0, 2, 6, 8, 18, 20, 24, 26, 13] {
            assert!(!is_implied(bit, !(1 << bit)), "bit {bit}");
        }
    }

    #[test]
    fn middles_are_implied_by_the_corners_around_them() {
        let corners = [0, 2, 6, 8, 18, 20, 24, 26].iter().fold(0, |mask, bit| mask | 1 << bit);
        for bit in (0..27).filter(|&bit| corners >> bit & 1 == 0 && bit != 13) {
            assert!(is_implied(bit, corners), "bit {bit}");
        }
        for (edge, corner) in [(1, 0), (1, 2), (11, 2), (11, 20), (15, 6), (15, 24)] {
            assert!(!is_implied(edge, corners & !(1 << corner)), "edge {edge} without corner {corner}");
        }
        for (face, missing) in [(4, 0), (4, 8), (14, 26), (10, 18)] {
            assert!(!is_implied(face, corners & !(1 << missing)), "face {face} without corner {missing}");
        }
        for (face, edge) in [(4, 1), (4, 3), (14, 5), (14, 17), (22, 21)] {
            assert!(!is_implied(face, corners | 1 << edge), "face {face} beside a stored edge {edge}");
        }
    }

    #[test]
    fn octants_of_a_cubic_are_the_cubic() {
        // Over local coordinates of the leaf: the lattice spans 0 to 2. Small dyadic numbers are exact.
        let jets = |least: [u32; 3], edge: u32| {
            let mut jets: Jets = Default::default();
            for corner in 0..8 {
                let [x, y, z] = [corner >> 2, corner >> 1 & 1, corner & 1];
                let point = [least[0] + edge * x, least[1] + edge * y, least[2] + edge * z];
                let [x, y, z] = point.map(|coordinate| coordinate as f32);
                let along = |t: f32| t * t * t - 2.0 * t * t + 0.5;
                let slope = |t: f32| 3.0 * t * t - 4.0 * t;
                let (f, g, h) = (along(x), along(y) + 1.0, along(z) - 2.0);
                let (fx, gy, hz) = (slope(x), slope(y), slope(z));
                jets[corner as usize] = [
                    f * g * h,
                    f * g * hz,
                    f * gy * h,
                    f * gy * hz,
                    fx * g * h,
                    fx * g * hz,
                    fx * gy * h,
                    fx * gy * hz,
                ];
            }
            jets
        };
        for octant in 0..8_u32 {
            let least = [octant & 1, octant >> 1 & 1, octant >> 2 & 1];
            let mut settled = jets([0; 3], 2);
            settle(&mut settled, 0xFF, octant);
            assert_eq!(settled, jets(least, 1), "octant {octant}");
        }
    }

    #[test]
    fn stored_corners_stay() {
        let jets: Jets = core::array::from_fn(|index| core::array::from_fn(|corner| (10 * index + corner) as f32));
        for octant in 0..8 {
            let mut settled = jets;
            settle(&mut settled, 0, octant);
            assert_eq!(settled, jets, "octant {octant}");
        }
    }
}
