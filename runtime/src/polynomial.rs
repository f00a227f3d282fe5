//! Polynomials of three variables, of total degree up to 3, and tensor products of quintics.

/// Coefficients of a polynomial.
pub(crate) const TERMS: usize = 20;

/// The axes that each term is a product of; [`NO_AXIS`] fills the rows.
pub(crate) const AXES: [[usize; 3]; TERMS] = {
    const X: usize = 0;
    const Y: usize = 1;
    const Z: usize = 2;
    const N: usize = NO_AXIS;
    [
        [N, N, N],
        [X, N, N],
        [Y, N, N],
        [Z, N, N],
        [X, X, N],
        [Y, Y, N],
        [Z, Z, N],
        [X, Y, N],
        [X, Z, N],
        [Y, Z, N],
        [X, X, X],
        [Y, Y, Y],
        [Z, Z, Z],
        [X, X, Y],
        [X, X, Z],
        [X, Y, Y],
        [X, Z, Z],
        [Y, Y, Z],
        [Y, Z, Z],
        [X, Y, Z],
    ]
};
pub(crate) const NO_AXIS: usize = 3;

/// A polynomial around a sample, by local coordinates: the coefficients of the terms of [`AXES`]. Mesh units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polynomial(pub(crate) [f32; TERMS]);

impl Polynomial {
    /// Value and derivatives at an offset, the terms of each degree multiplied by a factor.
    #[inline]
    pub(crate) fn at(&self, [x, y, z]: [f32; 3], factors: [f32; 4]) -> (f32, [f32; 3]) {
        let [c, a0, a1, a2, xx, yy, zz, xy, xz, yz, xxx, yyy, zzz, xxy, xxz, xyy, xzz, yyz, yzz, xyz] = self.0;
        let [f0, f1, f2, f3] = factors;

        // Each sum by the powers of x, so that a value costs a multiplication a term.
        let first = a0 * x + a1 * y + a2 * z;
        let second = (xx * x + xy * y + xz * z) * x + (yy * y + yz * z) * y + zz * (z * z);
        let third = ((xxx * x + xxy * y + xxz * z) * x + (xyy * y + xyz * z) * y + xzz * (z * z)) * x
            + ((yyy * y + yyz * z) * y + yzz * (z * z)) * y
            + zzz * (z * z * z);
        let value = c * f0 + first * f1 + second * f2 + third * f3;

        let by_x = a0 * f1
            + (2.0 * xx * x + xy * y + xz * z) * f2
            + ((3.0 * xxx * x + 2.0 * (xxy * y + xxz * z)) * x + (xyy * y + xyz * z) * y + xzz * (z * z)) * f3;
        let by_y = a1 * f1
            + (2.0 * yy * y + xy * x + yz * z) * f2
            + ((3.0 * yyy * y + 2.0 * (xyy * x + yyz * z)) * y + (xxy * x + xyz * z) * x + yzz * (z * z)) * f3;
        let by_z = a2 * f1
            + (2.0 * zz * z + xz * x + yz * y) * f2
            + ((3.0 * zzz * z + 2.0 * (xzz * x + yzz * y)) * z + (xxz * x + xyz * y) * x + yyz * (y * y)) * f3;
        (value, [by_x, by_y, by_z])
    }
}

/// Weights of a value, a slope and half a second derivative at the two ends of an axis.
type QuinticWeights = [[f32; 3]; 2];

/// The quintic Hermite basis at `t`.
#[inline(never)]
fn quintic(t: f32) -> QuinticWeights {
    let rest = 1.0 - t;
    let (cube, rest_cube) = (t * t * t, rest * rest * rest);
    let end = cube * (10.0 - t * (15.0 - 6.0 * t));
    [
        [1.0 - end, t * rest_cube * (1.0 + 3.0 * t), t * t * rest_cube],
        [end, -cube * rest * (4.0 - 3.0 * t), cube * (rest * rest)],
    ]
}

/// Its derivative.
#[inline(never)]
fn quintic_derivative(t: f32) -> QuinticWeights {
    let rest = 1.0 - t;
    let (square, rest_square) = (t * t, rest * rest);
    let end = 30.0 * square * rest_square;
    [
        [-end, rest_square * (1.0 + t * (2.0 - 15.0 * t)), t * rest_square * (2.0 - 5.0 * t)],
        [end, square * (t * (28.0 - 15.0 * t) - 12.0), square * rest * (3.0 - 5.0 * t)],
    ]
}

/// Triquintic Hermite value and derivatives at local coordinates, from the polynomials of degree 2 at the
/// corners `4 x + 2 y + z` of a cell; derivatives that they do not have are zero.
pub(crate) fn triquintic(corners: &[Polynomial; 8], [x, y, z]: [f32; 3]) -> (f32, [f32; 3]) {
    let weights = [quintic(x), quintic(y), quintic(z)];
    let derivatives = [quintic_derivative(x), quintic_derivative(y), quintic_derivative(z)];
    let [wx, wy, wz] = weights;
    let [dx, dy, dz] = derivatives;
    let by_x = tensor_sum(corners, [dx, wy, wz]);
    let by_y = tensor_sum(corners, [wx, dy, wz]);
    let by_z = tensor_sum(corners, [wx, wy, dz]);
    (tensor_sum(corners, weights), [by_x, by_y, by_z])
}

fn tensor_sum(corners: &[Polynomial; 8], [x, y, z]: [QuinticWeights; 3]) -> f32 {
    let mut sum = 0.0;
    for (corner, polynomial) in corners.iter().enumerate() {
        let [x0, x1, x2] = x[corner >> 2 & 1];
        let [y0, y1, y2] = y[corner >> 1 & 1];
        let [z0, z1, z2] = z[corner & 1];
        let [c, a0, a1, a2, xx, yy, zz, xy, xz, yz, ..] = polynomial.0;
        sum += ((c * x0 + a0 * x1 + xx * x2) * y0 + (a1 * x0 + xy * x1) * y1 + yy * x0 * y2) * z0
            + ((a2 * x0 + xz * x1) * y0 + yz * x0 * y1) * z1
            + zz * x0 * y0 * z2;
    }
    sum
}
