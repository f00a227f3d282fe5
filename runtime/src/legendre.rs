//! Polynomials of three variables, of total degree up to 3, in products of Legendre polynomials on [-1, 1]³.
//!
//! The terms are in cyclic order: a term of each axis, or of its product with the next axis or the one before, fills the
//! lanes of a vector. The fourth lane holds something finite that nobody looks at.

use crate::math::each_lane;

/// A number for each axis, and one more.
pub(crate) type Lanes = [f32; 4];

/// The coefficients of a polynomial, in steps. Those of degrees that it does not have are not looked at.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Coefficients {
    pub(crate) constant: f32,
    /// Of x y z.
    pub(crate) product: f32,
    /// Of x, y, z.
    pub(crate) linear: Lanes,
    /// Of P2(x) and so on.
    pub(crate) square: Lanes,
    /// Of x y, y z, z x.
    pub(crate) cross: Lanes,
    /// Of P3(x) and so on.
    pub(crate) cube: Lanes,
    /// Of P2(x) y and so on.
    pub(crate) next: Lanes,
    /// Of P2(x) z and so on.
    pub(crate) previous: Lanes,
}

/// Lanes moved to the axis after their own.
#[inline]
pub(crate) fn moved_on([x, y, z, other]: Lanes) -> Lanes {
    [z, x, y, other]
}

/// Lanes moved to the axis before their own.
#[inline]
pub(crate) fn moved_back([x, y, z, other]: Lanes) -> Lanes {
    [y, z, x, other]
}

impl Coefficients {
    /// Value at a point, which may lie a little beyond the cube, in steps; and the derivatives by x, y and z if they are
    /// asked for. Asking changes no bit of the value.
    #[inline]
    pub(crate) fn evaluate(
        &self,
        degree: u32,
        point: &Lanes,
        with_slope: bool,
        parts: &mut Lanes,
        slope: &mut Lanes,
    ) -> f32 {
        let mut constant = self.constant;
        match degree {
            0 => (*parts, *slope) = ([0.0; 4], [0.0; 4]),
            1 => self.first(point, parts, slope),
            2 => self.second(point, with_slope, parts, slope),
            _ => {
                self.third(point, with_slope, parts, slope);
                constant += self.product * (point[0] * point[1] * point[2]);
            }
        }
        let [a, b, c, _] = *parts;
        constant + ((a + b) + c)
    }

    // What the terms but the constant and the product add up to: parts of the value, and derivatives. The functions that
    // are never inlined stay apart and end in memory, as those of `hermite` do, for the sake of four-wide code.

    #[inline(never)]
    fn first(&self, point: &Lanes, parts: &mut Lanes, slope: &mut Lanes) {
        for lane in 0..4 {
            parts[lane] = self.linear[lane] * point[lane];
        }
        *slope = self.linear;
    }

    #[inline(never)]
    fn second(&self, first: &Lanes, with_slope: bool, parts: &mut Lanes, slope: &mut Lanes) {
        let next = moved_back(*first);
        let line = each_lane(|lane| self.linear[lane] + self.cross[lane] * next[lane]);
        for lane in 0..4 {
            let second = 1.5 * (first[lane] * first[lane]) - 0.5;
            parts[lane] = line[lane] * first[lane] + self.square[lane] * second;
        }
        if with_slope {
            let (previous, cross) = (moved_on(*first), moved_on(self.cross));
            for lane in 0..4 {
                slope[lane] = (line[lane] + cross[lane] * previous[lane]) + self.square[lane] * (3.0 * first[lane]);
            }
        }
    }

    #[inline(never)]
    fn third(&self, first: &Lanes, with_slope: bool, parts: &mut Lanes, slope: &mut Lanes) {
        let (next, previous) = (moved_back(*first), moved_on(*first));
        let squared = each_lane(|lane| first[lane] * first[lane]);
        let second = each_lane(|lane| 1.5 * squared[lane] - 0.5);
        let line = each_lane(|lane| self.linear[lane] + self.cross[lane] * next[lane]);
        let square =
            each_lane(|lane| self.square[lane] + (self.next[lane] * next[lane] + self.previous[lane] * previous[lane]));
        for lane in 0..4 {
            let third = first[lane] * (2.5 * squared[lane] - 1.5);
            parts[lane] = (line[lane] * first[lane] + square[lane] * second[lane]) + self.cube[lane] * third;
        }
        if with_slope {
            let cross = moved_on(self.cross);
            let by_next = moved_on(each_lane(|lane| self.next[lane] * second[lane]));
            let by_previous = moved_back(each_lane(|lane| self.previous[lane] * second[lane]));
            for lane in 0..4 {
                let third_slope = 7.5 * squared[lane] - 1.5;
                slope[lane] = ((line[lane] + cross[lane] * previous[lane]) + square[lane] * (3.0 * first[lane]))
                    + (self.cube[lane] * third_slope + (by_next[lane] + by_previous[lane]))
                    + self.product * (next[lane] * previous[lane]);
            }
        }
    }
}
