//! Polynomials of three variables, of total degree up to 3, in products of Legendre polynomials on [-1, 1]³.
//!
//! The terms are in cyclic order: a term of each axis, or of its product with the next axis or the one before, fills the
//! lanes of a vector. The fourth lane holds something finite that nobody looks at.

/// A number for each axis, and one more.
pub(crate) type Lanes = [f32; 4];

/// Every lane.
const ALL: [usize; 4] = [0, 1, 2, 3];

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

/// The Legendre polynomials at a point, and their derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Basis {
    /// x y z.
    first: Lanes,
    /// y z x.
    next: Lanes,
    /// z x y.
    previous: Lanes,
    second: Lanes,
    third: Lanes,
    second_slope: Lanes,
    third_slope: Lanes,
    /// x y z multiplied.
    product: f32,
}

/// What the terms of a polynomial but the constant add up to: parts of the value, and the derivatives by x, y and z.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    value: Lanes,
    slope: Lanes,
}

/// Lanes moved to the axis after their own.
#[inline]
fn moved_on([x, y, z, other]: Lanes) -> Lanes {
    [z, x, y, other]
}

/// Lanes moved to the axis before their own.
#[inline]
fn moved_back([x, y, z, other]: Lanes) -> Lanes {
    [y, z, x, other]
}

// The functions that are never inlined stay apart and end in memory, as those of `hermite` do, for the sake of four-wide
// code.

impl Basis {
    /// Makes it the basis at a point, which may lie a little beyond the cube.
    #[inline(never)]
    pub(crate) fn fill(&mut self, point: &Lanes) {
        for lane in ALL {
            let (t, square) = (point[lane], point[lane] * point[lane]);
            self.second[lane] = 1.5 * square - 0.5;
            self.third[lane] = t * (2.5 * square - 1.5);
            self.second_slope[lane] = 3.0 * t;
            self.third_slope[lane] = 7.5 * square - 1.5;
        }
        self.first = *point;
        self.next = moved_back(*point);
        self.previous = moved_on(*point);
        let [x, y, z, _] = *point;
        self.product = x * y * z;
    }
}

impl Coefficients {
    /// Value and derivatives at a point of the basis, in steps.
    #[inline]
    pub(crate) fn evaluate(&self, degree: u32, basis: &Basis) -> (f32, [f32; 3]) {
        let mut sums = Sums::default();
        let mut constant = self.constant;
        match degree {
            0 => return (constant, [0.0; 3]),
            1 => self.add_first(basis, &mut sums),
            2 => self.add_second(basis, &mut sums),
            _ => {
                self.add_third(basis, &mut sums);
                constant += self.product * basis.product;
            }
        }
        let [a, b, c, _] = sums.value;
        let [x, y, z, _] = sums.slope;
        (constant + ((a + b) + c), [x, y, z])
    }

    #[inline]
    fn add_first(&self, basis: &Basis, sums: &mut Sums) {
        for lane in ALL {
            sums.value[lane] = self.linear[lane] * basis.first[lane];
            sums.slope[lane] = self.linear[lane];
        }
    }

    #[inline(never)]
    fn add_second(&self, basis: &Basis, sums: &mut Sums) {
        let cross = moved_on(self.cross);
        for lane in ALL {
            let line = self.linear[lane] + self.cross[lane] * basis.next[lane];
            sums.value[lane] = line * basis.first[lane] + self.square[lane] * basis.second[lane];
            sums.slope[lane] =
                (line + cross[lane] * basis.previous[lane]) + self.square[lane] * basis.second_slope[lane];
        }
    }

    #[inline(never)]
    fn add_third(&self, basis: &Basis, sums: &mut Sums) {
        let cross = moved_on(self.cross);
        let next = moved_on(ALL.map(|lane| self.next[lane] * basis.second[lane]));
        let previous = moved_back(ALL.map(|lane| self.previous[lane] * basis.second[lane]));
        for lane in ALL {
            let line = self.linear[lane] + self.cross[lane] * basis.next[lane];
            let square =
                self.square[lane] + (self.next[lane] * basis.next[lane] + self.previous[lane] * basis.previous[lane]);
            sums.value[lane] =
                (line * basis.first[lane] + square * basis.second[lane]) + self.cube[lane] * basis.third[lane];
            sums.slope[lane] = ((line + cross[lane] * basis.previous[lane]) + square * basis.second_slope[lane])
                + (self.cube[lane] * basis.third_slope[lane] + (next[lane] + previous[lane]))
                + self.product * (basis.next[lane] * basis.previous[lane]);
        }
    }
}
