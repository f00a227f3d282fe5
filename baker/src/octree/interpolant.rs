//! Tensor-product interpolants of a leaf's eight corners (Pujol and Chica 2023, section 4; Lekien
//! and Marsden 2005), in `f64`.
//!
//! A cubic is determined by the eight derivatives {f, fx, fy, fxy, fz, fxz, fyz, fxyz} at each of
//! the eight corners. The coefficients form a 4 x 4 x 4 tensor in the Hermite basis: along each axis
//! value and slope at the near end, then value and slope at the far end. The trilinear interpolant
//! is the same tensor in a basis that ignores the slopes.

use crate::corner::Corner;
use crate::settings::Interpolant;
use glam::DVec3;

/// The weights of value and slope at both ends of an axis.
type Basis = [f64; 4];

fn basis(interpolant: Interpolant, t: f64) -> Basis {
    let s = 1.0 - t;
    match interpolant {
        Interpolant::Trilinear => [s, 0.0, t, 0.0],
        Interpolant::Tricubic => [s * s * (1.0 + 2.0 * t), s * s * t, t * t * (3.0 - 2.0 * t), -t * t * s],
    }
}

fn basis_slope(interpolant: Interpolant, t: f64) -> Basis {
    let s = 1.0 - t;
    match interpolant {
        Interpolant::Trilinear => [-1.0, 0.0, 1.0, 0.0],
        Interpolant::Tricubic => [-6.0 * s * t, s * (1.0 - 3.0 * t), 6.0 * s * t, t * (3.0 * t - 2.0)],
    }
}

/// The control points of value and slope along an axis, both as cubics of the Bernstein basis.
fn bernstein(interpolant: Interpolant) -> (&'static [Basis; 4], &'static [Basis; 4]) {
    const ONE: f64 = 1.0 / 3.0;
    const TWO: f64 = 2.0 / 3.0;
    match interpolant {
        Interpolant::Trilinear => (
            &[[1.0, 0.0, 0.0, 0.0], [TWO, 0.0, ONE, 0.0], [ONE, 0.0, TWO, 0.0], [0.0, 0.0, 1.0, 0.0]],
            &[[-1.0, 0.0, 1.0, 0.0]; 4],
        ),
        Interpolant::Tricubic => (
            &[[1.0, 0.0, 0.0, 0.0], [1.0, ONE, 0.0, 0.0], [0.0, 0.0, 1.0, -ONE], [0.0, 0.0, 1.0, 0.0]],
            // The slope is a quadratic with control points s0, 3 (v1 - v0) - s0 - s1, s1; raised by one degree.
            &[[0.0, 1.0, 0.0, 0.0], [-2.0, -ONE, 2.0, -TWO], [-2.0, -TWO, 2.0, -ONE], [0.0, 0.0, 0.0, 1.0]],
        ),
    }
}

/// The interpolant of one cell, over cell-local coordinates in 0..=1.
#[derive(Clone, Debug)]
pub struct Patch {
    interpolant: Interpolant,
    edge: f64,
    /// `tensor[z][y][x]`, slopes per cell edge.
    tensor: [[[f64; 4]; 4]; 4],
}

impl Patch {
    /// Interpolates eight corners (x fastest) of a cell with this edge, mesh units.
    pub fn new(interpolant: Interpolant, corners: &[Corner; 8], edge: f64) -> Self {
        let scale = [1.0, edge, edge * edge, edge * edge * edge];
        let mut tensor = [[[0.0; 4]; 4]; 4];
        for (corner, derivatives) in corners.iter().enumerate() {
            for (bits, derivative) in derivatives.0.iter().enumerate() {
                let entry = |axis: usize| 2 * (corner >> axis & 1) + (bits >> axis & 1);
                tensor[entry(2)][entry(1)][entry(0)] = derivative * scale[bits.count_ones() as usize];
            }
        }
        Self { interpolant, edge, tensor }
    }

    /// The value at cell-local coordinates.
    pub fn value(&self, local: DVec3) -> f64 {
        let [x, y, z] = local.to_array().map(|t| [basis(self.interpolant, t)]);
        self.contract(&x, &y, &z)[0][0][0]
    }

    /// All eight derivatives at cell-local coordinates, mesh units.
    pub fn derivatives(&self, local: DVec3) -> Corner {
        let [x, y, z] = local.to_array().map(|t| [basis(self.interpolant, t), basis_slope(self.interpolant, t)]);
        let values = self.contract(&x, &y, &z);
        let scale = 1.0 / self.edge;
        let scale = [1.0, scale, scale * scale, scale * scale * scale];
        Corner(std::array::from_fn(|bits| {
            values[bits >> 2 & 1][bits >> 1 & 1][bits & 1] * scale[bits.count_ones() as usize]
        }))
    }

    /// The values on the 3 x 3 x 3 lattice of corners and midpoints, x fastest.
    pub fn lattice_values(&self) -> [f64; 27] {
        let axis = [0.0, 0.5, 1.0].map(|t| basis(self.interpolant, t));
        let values = self.contract(&axis, &axis, &axis);
        std::array::from_fn(|i| values[i / 9][i / 3 % 3][i % 3])
    }

    /// An upper bound of the gradient's length over the cell: the longest control vector of the
    /// gradient in the cubic Bernstein basis, whose hull contains it.
    pub fn slope_bound(&self) -> f64 {
        let (value, slope) = bernstein(self.interpolant);
        let by_x = self.contract(slope, value, value);
        let by_y = self.contract(value, slope, value);
        let by_z = self.contract(value, value, slope);
        let gradients = by_x.as_flattened().as_flattened().iter().zip(by_y.as_flattened().as_flattened());
        let squared = gradients
            .zip(by_z.as_flattened().as_flattened())
            .map(|((x, y), z)| x * x + y * y + z * z)
            .fold(0.0, f64::max);
        squared.sqrt() / self.edge
    }

    /// Applies one basis vector or several along each axis.
    fn contract<const N: usize>(&self, x: &[Basis; N], y: &[Basis; N], z: &[Basis; N]) -> [[[f64; N]; N]; N] {
        let dot = |row: &[f64; 4], basis: &Basis| -> f64 {
            row[0] * basis[0] + row[1] * basis[1] + row[2] * basis[2] + row[3] * basis[3]
        };
        let along_x = self.tensor.map(|plane| plane.map(|row| x.map(|basis| dot(&row, &basis))));
        let along_y: [[[f64; N]; N]; 4] = along_x.map(|plane| {
            y.map(|basis| std::array::from_fn(|i| dot(&[0, 1, 2, 3].map(|j: usize| plane[j][i]), &basis)))
        });
        z.map(|basis| {
            std::array::from_fn(|j| {
                std::array::from_fn(|i| dot(&[0, 1, 2, 3].map(|k: usize| along_y[k][j][i]), &basis))
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (x + 2)(y - 1)(z + 3) plus a cubic of each axis, and all derivatives that a corner holds.
    fn cubic(p: DVec3) -> Corner {
        let own = |t: f64| t * t * t - 0.5 * t * t;
        let slope = |t: f64| 3.0 * t * t - t;
        let (a, b, c) = (p.x + 2.0, p.y - 1.0, p.z + 3.0);
        Corner([
            a * b * c + own(p.x) + own(p.y) + own(p.z),
            b * c + slope(p.x),
            a * c + slope(p.y),
            c,
            a * b + slope(p.z),
            b,
            a,
            1.0,
        ])
    }

    fn patch(edge: f64) -> Patch {
        let corners =
            std::array::from_fn(|i| cubic(edge * DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64)));
        Patch::new(Interpolant::Tricubic, &corners, edge)
    }

    #[test]
    fn a_tricubic_patch_reproduces_a_cubic_and_its_derivatives() {
        let patch = patch(0.7);
        for i in 0..100 {
            let local = DVec3::new((i % 7) as f64 / 6.0, (i % 5) as f64 / 4.0, (i % 11) as f64 / 10.0);
            let (found, wanted) = (patch.derivatives(local), cubic(0.7 * local));
            for (found, wanted) in found.0.iter().zip(wanted.0) {
                assert!((found - wanted).abs() < 1e-12, "{found} instead of {wanted} at {local}");
            }
            assert!((patch.value(local) - wanted.distance()).abs() < 1e-12, "value at {local}");
        }
    }

    #[test]
    fn lattice_values_are_values_at_the_lattice() {
        let patch = patch(0.7);
        for (i, value) in patch.lattice_values().into_iter().enumerate() {
            let local = 0.5 * DVec3::new((i % 3) as f64, (i / 3 % 3) as f64, (i / 9) as f64);
            assert!((value - patch.value(local)).abs() < 1e-12, "lattice sample {i}");
        }
    }

    #[test]
    fn the_slope_bound_holds_and_is_not_idle() {
        for interpolant in [Interpolant::Trilinear, Interpolant::Tricubic] {
            let patch = Patch { interpolant, ..patch(0.7) };
            let bound = patch.slope_bound();
            let steepest = (0..=1000)
                .map(|i| DVec3::new((i % 11) as f64, (i / 11 % 11) as f64, (i / 121) as f64 / 8.3) / 10.0)
                .map(|local| patch.derivatives(local).gradient().length())
                .fold(0.0, f64::max);
            assert!(steepest <= bound * (1.0 + 1e-12), "{interpolant:?}: slope {steepest} above the bound {bound}");
            assert!(bound <= 1.5 * steepest, "{interpolant:?}: bound {bound} far above the slope {steepest}");
        }
    }
}
