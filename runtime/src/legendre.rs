//! Polynomials of three variables, of total degree up to 3, in products of Legendre polynomials on [-1, 1]³.
//!
//! Everything is kept four wide: lanes 0 to 2 belong to the axes, lane 3 to the terms that belong to none. The terms are
//! in cyclic order, so that a term of each axis, and of its product with the next and the one before, fills a vector.

/// A number for each axis, and one more.
pub(crate) type Lanes = [f32; 4];

/// The coefficients of a polynomial, in steps:
/// the linear ones with the constant, of P2(x) P2(y) P2(z), of x y, y z, z x, of P3 with that of x y z, of P2(x) y and
/// so on, and of P2(x) z and so on. Those of degrees that the polynomial does not have are not looked at.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Coefficients {
    pub(crate) linear: Lanes,
    pub(crate) square: Lanes,
    pub(crate) cross: Lanes,
    pub(crate) cube: Lanes,
    pub(crate) next: Lanes,
    pub(crate) previous: Lanes,
}

/// The Legendre polynomials at a point, and their derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Basis {
    /// x y z 1.
    first: Lanes,
    /// y z x 0.
    next: Lanes,
    /// z x y 0.
    previous: Lanes,
    /// P2, and 0.
    second: Lanes,
    /// P3, and x y z.
    third: Lanes,
    /// The derivative of P2.
    second_slope: Lanes,
    /// The derivative of P3.
    third_slope: Lanes,
}

/// What the terms of a polynomial add up to: four parts of the value, and the derivatives by x, y and z.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sums {
    value: Lanes,
    slope: Lanes,
}

/// Every index of a vector.
const ALL: [usize; 4] = [0, 1, 2, 3];

// The functions that follow stay apart and end in memory, as those of `hermite` do, for the sake of four-wide code.

impl Basis {
    /// Makes it the basis at a point, which may lie a little beyond the cube. The last lane of the point is 0.
    #[inline(never)]
    pub(crate) fn fill(&mut self, point: &Lanes) {
        const AXES: Lanes = [1.0, 1.0, 1.0, 0.0];
        const LAST: Lanes = [0.0, 0.0, 0.0, 1.0];
        let [x, y, z, _] = *point;
        let product = [x * y * z; 4];
        for lane in ALL {
            let (t, square) = (point[lane], point[lane] * point[lane]);
            self.first[lane] = t + LAST[lane];
            self.second[lane] = 1.5 * square - 0.5 * AXES[lane];
            self.third[lane] = t * (2.5 * square - 1.5) + product[lane] * LAST[lane];
            self.second_slope[lane] = 3.0 * t;
            self.third_slope[lane] = 7.5 * square - 1.5;
        }
        self.next = [y, z, x, 0.0];
        self.previous = [z, x, y, 0.0];
    }
}

impl Coefficients {
    /// Value and derivatives at a point of the basis, in steps.
    #[inline]
    pub(crate) fn evaluate(&self, degree: u32, basis: &Basis) -> (f32, [f32; 3]) {
        let mut sums = Sums { value: [0.0; 4], slope: self.linear };
        match degree {
            0 | 1 => self.add_first(basis, &mut sums),
            2 => self.add_second(basis, &mut sums),
            _ => self.add_third(basis, &mut sums),
        }
        let [a, b, c, d] = sums.value;
        let [x, y, z, _] = sums.slope;
        ((a + b) + (c + d), [x, y, z])
    }

    #[inline]
    fn add_first(&self, basis: &Basis, sums: &mut Sums) {
        for lane in ALL {
            sums.value[lane] = self.linear[lane] * basis.first[lane];
        }
    }

    #[inline(never)]
    fn add_second(&self, basis: &Basis, sums: &mut Sums) {
        let [xy, yz, zx, _] = self.cross;
        let cross_before = [zx, xy, yz, 0.0];
        for lane in ALL {
            let line = self.linear[lane] + self.cross[lane] * basis.next[lane];
            sums.value[lane] = line * basis.first[lane] + self.square[lane] * basis.second[lane];
            sums.slope[lane] =
                (line + cross_before[lane] * basis.previous[lane]) + self.square[lane] * basis.second_slope[lane];
        }
    }

    #[inline(never)]
    fn add_third(&self, basis: &Basis, sums: &mut Sums) {
        let [xy, yz, zx, _] = self.cross;
        let cross_before = [zx, xy, yz, 0.0];
        let next = ALL.map(|lane| self.next[lane] * basis.second[lane]);
        let previous = ALL.map(|lane| self.previous[lane] * basis.second[lane]);
        let next_before = [next[2], next[0], next[1], 0.0];
        let previous_after = [previous[1], previous[2], previous[0], 0.0];
        let xyz = [self.cube[3]; 4];
        for lane in ALL {
            let line = self.linear[lane] + self.cross[lane] * basis.next[lane];
            let square =
                self.square[lane] + (self.next[lane] * basis.next[lane] + self.previous[lane] * basis.previous[lane]);
            sums.value[lane] =
                (line * basis.first[lane] + square * basis.second[lane]) + self.cube[lane] * basis.third[lane];
            sums.slope[lane] = ((line + cross_before[lane] * basis.previous[lane]) + square * basis.second_slope[lane])
                + (self.cube[lane] * basis.third_slope[lane] + (next_before[lane] + previous_after[lane]))
                + xyz[lane] * (basis.next[lane] * basis.previous[lane]);
        }
    }
}
