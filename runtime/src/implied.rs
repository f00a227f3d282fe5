//! Samples that a block leaves out because the corners of the parent cell determine them.
//!
//! Where eight siblings meet a larger leaf, a vertex in the middle of their parent's edge or face must
//! repeat what that leaf interpolates there. The leaf holds the whole edge or face, and the parent's
//! corners on it carry its derivatives, so the cubic between those corners is the same (Pujol and Chica
//! 2023, appendix): the vertex needs no bytes.

use crate::hermite::Corners;

/// The derivatives at eight corners by local coordinates of the leaf, mesh units. Bit 0 of the outer index
/// counts x, bit 1 y, bit 2 z: `[f, fx, fy, fxy, fz, fxz, fyz, fxyz]`.
pub(crate) type Jets = [Corners; 8];

/// All ones for the corners of a leaf that are implied, zero for the others.
pub(crate) type Mask = [u32; 8];

/// Lattice bits of the parent's corners, in the order of [`Corners`].
pub(crate) const PARENT_CORNERS: [u32; 8] = [0, 18, 6, 24, 2, 20, 8, 26];

/// The lattice bits that must be present for this one to be implied; none if it cannot be: the parent's
/// corners and the centre of the block are always stored.
pub(crate) fn corners_around(bit: u32) -> u32 {
    let [x, y, z] = [bit % 3, bit / 3 % 3, bit / 9];
    let ends = |coordinate: u32| if coordinate == 1 { [0, 2] } else { [coordinate; 2] };
    match [x, y, z].into_iter().filter(|&coordinate| coordinate == 1).count() {
        0 | 3 => 0,
        _ => {
            let row = ends(x).into_iter().fold(0, |mask, x| mask | 1 << x);
            let layer = ends(y).into_iter().fold(0, |mask, y| mask | row << (3 * y));
            ends(z).into_iter().fold(0, |mask, z| mask | layer << (9 * z))
        }
    }
}

/// Replaces, at each implied corner of an octant, the jet of the parent's corner on the same side by the
/// jet that the parent's cubic has there.
///
/// An axis at a time, the corners away from the parent's corner move to the middle. A corner in the middle
/// of a face is reached in two steps, through those in the middle of its edges, which are implied too.
#[inline]
pub(crate) fn settle(jets: &mut Jets, implied: &Mask, octant: u32) {
    settle_along::<1>(jets, implied, octant & 1, along_x, back_along_x);
    settle_along::<2>(jets, implied, octant >> 1 & 1, along_y, back_along_y);
    settle_along::<4>(jets, implied, octant >> 2 & 1, along_z, back_along_z);
}

/// The same for the distances of a trilinear leaf.
pub(crate) fn settle_distances(distances: &Corners, implied: &Mask, octant: u32) -> Corners {
    let mut jets = [*distances, [0.0; 8], [0.0; 8], [0.0; 8], [0.0; 8], [0.0; 8], [0.0; 8], [0.0; 8]];
    settle(&mut jets, implied, octant);
    jets[0]
}

/// The ends along an axis, four lines at a time.
type Ends<T> = [[T; 4]; 2];

/// One axis, given how to take corners apart into the ends along it and back.
#[inline]
fn settle_along<const AXIS: usize>(
    jets: &mut Jets,
    implied: &Mask,
    far_half: u32,
    ends: impl Fn(Corners) -> Ends<f32>,
    back: impl Fn(Ends<f32>) -> Corners,
) {
    let implied = ends(implied.map(f32::from_bits));
    for value in (0..8).filter(|index| index & AXIS == 0) {
        // The masks show the compiler that no index can fail.
        let (value, slope) = (value & 7, (value | AXIS) & 7);
        let [near, far] = ends(jets[value]);
        let [near_slope, far_slope] = ends(jets[slope]);

        // The middle of a cubic that spans two leaves.
        let (mut middle, mut middle_slope) = ([0.0; 4], [0.0; 4]);
        for line in 0..4 {
            let rise = far[line] - near[line];
            middle[line] = 0.5 * (near[line] + far[line]) + 0.25 * (near_slope[line] - far_slope[line]);
            middle_slope[line] = 0.75 * rise - 0.25 * (near_slope[line] + far_slope[line]);
        }

        // The parent's corner is near in the near half and far in the far half.
        (jets[value], jets[slope]) = match far_half {
            0 => (
                back([near, select(&implied[1], &middle, &far)]),
                back([near_slope, select(&implied[1], &middle_slope, &far_slope)]),
            ),
            _ => (
                back([select(&implied[0], &middle, &near), far]),
                back([select(&implied[0], &middle_slope, &near_slope), far_slope]),
            ),
        };
    }
}

/// `chosen` where the bits of the mask are set, `other` where they are not.
#[inline]
fn select(mask: &[f32; 4], chosen: &[f32; 4], other: &[f32; 4]) -> [f32; 4] {
    let mut selected = [0.0; 4];
    for (((selected, mask), chosen), other) in selected.iter_mut().zip(mask).zip(chosen).zip(other) {
        let mask = mask.to_bits();
        *selected = f32::from_bits(chosen.to_bits() & mask | other.to_bits() & !mask);
    }
    selected
}

#[inline]
fn along_x([a, b, c, d, e, f, g, h]: Corners) -> Ends<f32> {
    [[a, b, c, d], [e, f, g, h]]
}

#[inline]
fn back_along_x([[a, b, c, d], [e, f, g, h]]: Ends<f32>) -> Corners {
    [a, b, c, d, e, f, g, h]
}

#[inline]
fn along_y([a, b, c, d, e, f, g, h]: Corners) -> Ends<f32> {
    [[a, b, e, f], [c, d, g, h]]
}

#[inline]
fn back_along_y([[a, b, e, f], [c, d, g, h]]: Ends<f32>) -> Corners {
    [a, b, c, d, e, f, g, h]
}

#[inline]
fn along_z([a, b, c, d, e, f, g, h]: Corners) -> Ends<f32> {
    [[a, c, e, g], [b, d, f, h]]
}

#[inline]
fn back_along_z([[a, c, e, g], [b, d, f, h]]: Ends<f32>) -> Corners {
    [a, b, c, d, e, f, g, h]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_and_centre_are_never_implied() {
        for bit in [0, 2, 6, 8, 18, 20, 24, 26, 13] {
            assert_eq!(corners_around(bit), 0, "bit {bit}");
        }
    }

    #[test]
    fn edges_lie_between_two_corners_and_faces_between_four() {
        assert_eq!(corners_around(1), 1 | 1 << 2);
        assert_eq!(corners_around(11), 1 << 2 | 1 << 20);
        assert_eq!(corners_around(4), 1 | 1 << 2 | 1 << 6 | 1 << 8);
        assert_eq!(corners_around(14), 1 << 2 | 1 << 8 | 1 << 20 | 1 << 26);
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
                let at = [
                    f * g * h,
                    fx * g * h,
                    f * gy * h,
                    fx * gy * h,
                    f * g * hz,
                    fx * g * hz,
                    f * gy * hz,
                    fx * gy * hz,
                ];
                for (index, derivative) in at.into_iter().enumerate() {
                    jets[index][corner as usize] = derivative;
                }
            }
            jets
        };
        for octant in 0..8_u32 {
            let least = [octant & 1, octant >> 1 & 1, octant >> 2 & 1];
            let mut settled = jets([0; 3], 2);
            settle(&mut settled, &[u32::MAX; 8], octant);
            assert_eq!(settled, jets(least, 1), "octant {octant}");
        }
    }

    #[test]
    fn stored_corners_stay() {
        let jets: Jets = core::array::from_fn(|index| core::array::from_fn(|corner| (10 * index + corner) as f32));
        for octant in 0..8 {
            let mut settled = jets;
            settle(&mut settled, &[0; 8], octant);
            assert_eq!(settled, jets, "octant {octant}");
        }
    }
}
