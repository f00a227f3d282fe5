//! Products of Legendre polynomials of total degree up to 3 on the cube [-1, 1]³.
//!
//! They are orthogonal there, so that a coefficient means the same whatever the degree of the rest, and
//! rounding errors of coefficients add up like independent errors of the value.

use glam::DVec3;

/// Highest total degree.
pub const MAX_DEGREE: u8 = 3;
/// Terms of a polynomial of the highest degree.
pub const TERMS: usize = 20;

/// Terms up to a total degree; the terms of each degree follow those of the one below.
pub const TERMS_UP_TO: [usize; 4] = [1, 4, 10, TERMS];

/// Mean square of each term over the cube.
pub const MEAN_SQUARE: [f64; TERMS] = {
    const L: f64 = 1.0 / 3.0;
    const Q: f64 = 1.0 / 5.0;
    const C: f64 = 1.0 / 7.0;
    [1.0, L, L, L, Q, Q, Q, L * L, L * L, L * L, C, C, C, Q * L, Q * L, Q * L, Q * L, Q * L, Q * L, L * L * L]
};

/// The total degree of a term.
pub fn degree_of(term: usize) -> u8 {
    (term >= 1) as u8 + (term >= 4) as u8 + (term >= 10) as u8
}

/// Every term at a point of the cube, in the order of the file format: 1; x, y, z; x², y², z², xy, yz, zx; x³, y³,
/// z³, x²y, y²z, z²x, x²z, y²x, z²y, xyz, where powers stand for Legendre polynomials of that degree.
pub fn values(point: DVec3) -> [f64; TERMS] {
    let [x, y, z] = point.to_array();
    let second = |t: f64| 1.5 * t * t - 0.5;
    let third = |t: f64| (2.5 * t * t - 1.5) * t;
    let [xx, yy, zz] = [x, y, z].map(second);
    let [xxx, yyy, zzz] = [x, y, z].map(third);
    [
        1.0,
        x,
        y,
        z,
        xx,
        yy,
        zz,
        x * y,
        y * z,
        z * x,
        xxx,
        yyy,
        zzz,
        xx * y,
        yy * z,
        zz * x,
        xx * z,
        yy * x,
        zz * y,
        x * y * z,
    ]
}

/// The gradient of every term at a point of the cube, by the coordinates of the cube.
pub fn gradients(point: DVec3) -> [DVec3; TERMS] {
    let [x, y, z] = point.to_array();
    let second = |t: f64| 1.5 * t * t - 0.5;
    let third_slope = |t: f64| 7.5 * t * t - 1.5;
    let [xx, yy, zz] = [x, y, z].map(second);
    let vector = DVec3::new;
    [
        DVec3::ZERO,
        DVec3::X,
        DVec3::Y,
        DVec3::Z,
        vector(3.0 * x, 0.0, 0.0),
        vector(0.0, 3.0 * y, 0.0),
        vector(0.0, 0.0, 3.0 * z),
        vector(y, x, 0.0),
        vector(0.0, z, y),
        vector(z, 0.0, x),
        vector(third_slope(x), 0.0, 0.0),
        vector(0.0, third_slope(y), 0.0),
        vector(0.0, 0.0, third_slope(z)),
        vector(3.0 * x * y, xx, 0.0),
        vector(0.0, 3.0 * y * z, yy),
        vector(zz, 0.0, 3.0 * x * z),
        vector(3.0 * x * z, 0.0, xx),
        vector(yy, 3.0 * x * y, 0.0),
        vector(0.0, zz, 3.0 * y * z),
        vector(y * z, x * z, x * y),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_are_orthogonal_and_their_mean_squares_are_as_stated() {
        // Four Gauss points an axis are exact for products of two terms, of degree 6 at most.
        const NODES: [(f64, f64); 4] = [
            (-0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
            (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
            (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
            (0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
        ];
        for i in 0..TERMS {
            for j in 0..TERMS {
                let mut mean = 0.0;
                for (x, wx) in NODES {
                    for (y, wy) in NODES {
                        for (z, wz) in NODES {
                            let terms = values(DVec3::new(x, y, z));
                            mean += terms[i] * terms[j] * wx * wy * wz / 8.0;
                        }
                    }
                }
                let wanted = if i == j { MEAN_SQUARE[i] } else { 0.0 };
                assert!((mean - wanted).abs() < 1e-12, "terms {i} and {j}: {mean}");
            }
        }
    }

    #[test]
    fn gradients_are_differences_of_values() {
        let point = DVec3::new(0.3, -0.7, 0.45);
        let step = 1e-5;
        for (term, gradient) in gradients(point).into_iter().enumerate() {
            for (axis, unit) in DVec3::AXES.into_iter().enumerate() {
                let slope = (values(point + step * unit)[term] - values(point - step * unit)[term]) / (2.0 * step);
                assert!((slope - gradient[axis]).abs() < 1e-9, "term {term} along axis {axis}");
            }
        }
    }
}
