//! Samples that a block leaves out because the corners of the parent cell determine them.
//!
//! Where eight siblings meet a larger leaf, a vertex in the middle of their parent's edge or face must
//! repeat what that leaf interpolates there. The leaf holds the whole edge or face, and the parent's
//! corners on it carry its derivatives, so the cubic between those corners is the same (Pujol and Chica
//! 2023, appendix): the vertex needs no bytes.

/// The derivatives at a lattice sample by local coordinates of the leaf, mesh units; bit 0 of the index
/// counts x, bit 1 y, bit 2 z: `[f, fx, fy, fxy, fz, fxz, fyz, fxyz]`.
pub(crate) type Jet = [f32; 8];

/// The parent's corners around a lattice bit, and the axes along which it lies between them.
struct Between {
    /// Lattice bit with every coordinate 1 lowered to 0.
    least: u32,
    /// Index of the axis in a [`Jet`] and the way to the corner at its other end, as lattice bits.
    axes: [Option<(usize, u32)>; 2],
}

/// None for a corner of the parent and for the centre of the block, which are never implied.
fn between(bit: u32) -> Option<Between> {
    let mut found = Between { least: bit, axes: [None; 2] };
    for (axis, step) in [(1, 1), (2, 3), (4, 9)] {
        if bit / step % 3 == 1 {
            found.least -= step;
            let slot = found.axes.iter_mut().find(|slot| slot.is_none())?;
            *slot = Some((axis, 2 * step));
        }
    }
    found.axes[0].map(|_| found)
}

/// The lattice bits that must be present for this one to be implied; none if it cannot be.
pub(crate) fn corners_around(bit: u32) -> u32 {
    let Some(Between { least, axes }) = between(bit) else {
        return 0;
    };
    axes.into_iter().flatten().fold(1 << least, |mask, (_, step)| mask | mask << step)
}

/// The sample at a lattice bit, read or implied.
pub(crate) fn jet(bit: u32, present: u32, read: impl Fn(u32) -> Jet) -> Jet {
    if present >> bit & 1 == 1 {
        return read(bit);
    }
    match between(bit) {
        Some(Between { least, axes: [Some((first, step)), None] }) => middle(first, &read(least), &read(least + step)),
        Some(Between { least, axes: [Some((first, step)), Some((second, stride))] }) => {
            let near = middle(first, &read(least), &read(least + step));
            let far = middle(first, &read(least + stride), &read(least + stride + step));
            middle(second, &near, &far)
        }
        _ => [0.0; 8],
    }
}

/// The middle of a cubic that spans two leaves along an axis.
fn middle(axis: usize, near: &Jet, far: &Jet) -> Jet {
    let mut middle = [0.0; 8];
    for value in (0..8).filter(|index| index & axis == 0) {
        // The masks show the compiler that no index can fail.
        let (value, slope) = (value & 7, (value | axis) & 7);
        middle[value] = 0.5 * (near[value] + far[value]) + 0.25 * (near[slope] - far[slope]);
        middle[slope] = 0.75 * (far[value] - near[value]) - 0.25 * (near[slope] + far[slope]);
    }
    middle
}

/// The distance at a lattice bit of a trilinear block, read or implied.
pub(crate) fn distance(bit: u32, present: u32, read: impl Fn(u32) -> f32) -> f32 {
    jet(bit, present, |bit| [read(bit), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])[0]
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
    fn implied_samples_are_those_of_a_cubic() {
        // Over local coordinates of the leaf: the lattice spans 0 to 2.
        let cubic = |bit: u32| -> Jet {
            let [x, y, z] = [bit % 3, bit / 3 % 3, bit / 9].map(|coordinate| coordinate as f32);
            let along = |t: f32| t * t * t - 2.0 * t * t + 0.5;
            let slope = |t: f32| 3.0 * t * t - 4.0 * t;
            let (f, g, h) = (along(x), along(y) + 1.0, along(z) - 2.0);
            let (fx, gy, hz) = (slope(x), slope(y), slope(z));
            [f * g * h, fx * g * h, f * gy * h, fx * gy * h, f * g * hz, fx * g * hz, f * gy * hz, fx * gy * hz]
        };
        let parent_corners = (0..27).filter(|&bit| corners_around(bit) == 0).fold(0, |mask, bit| mask | 1 << bit);
        for bit in (0..27).filter(|&bit| corners_around(bit) != 0) {
            assert_eq!(jet(bit, parent_corners, cubic), cubic(bit), "bit {bit}: small dyadic numbers are exact");
        }
    }
}
