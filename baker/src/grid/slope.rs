//! How steep a reconstruction can be.

use super::Domain;
use crate::sampling::{EXPONENTS, monomial, terms};
use crate::settings::{GridSettings, Reconstruction};
use glam::{DVec3, UVec3};

/// Largest derivative of the weight that takes an axis from one sample to the next, by its smoothness.
const STEEPEST_WEIGHT: [f64; 4] = [1.0, 1.5, 1.875, 2.1875];
/// A cubic Hermite interpolant weighs the slopes at both ends of an edge by a quarter at most, in sum;
/// the quintic one by less.
const SLOPE_WEIGHT: f64 = 0.25;

/// Upper bound of the length of the gradient of the reconstruction of `coefficients`.
///
/// Along an axis a cell's slope is at most the steepest weight times the largest difference of the
/// corners' polynomials along an edge, plus the largest slope of the polynomials themselves. Exact
/// differences for planes, sums of magnitudes above.
pub(super) fn bound(coefficients: &[f64], domain: &Domain, grid: &GridSettings) -> f64 {
    let terms = terms(grid.order);
    let cells = domain.resolution - 1;
    let mut squared: f64 = 0.0;
    for cell in domain.vertices().filter(|at| at.cmplt(cells).all()) {
        let corners = std::array::from_fn(|corner| {
            let at = cell + UVec3::new(corner as u32 >> 2 & 1, corner as u32 >> 1 & 1, corner as u32 & 1);
            let start = domain.index(at) * terms;
            local(&coefficients[start..start + terms], domain.spacing, grid)
        });
        let slope = DVec3::from_array(std::array::from_fn(|axis| along(&corners, axis, grid)));
        squared = squared.max((slope / domain.spacing).length_squared());
    }
    squared.sqrt()
}

/// Coefficients by local coordinates, as much of them as the reconstruction takes.
fn local(coefficients: &[f64], spacing: DVec3, grid: &GridSettings) -> [f64; 20] {
    let mut scaled = [0.0; 20];
    for (term, &coefficient) in coefficients.iter().enumerate() {
        let degree: u8 = EXPONENTS[term].iter().sum();
        let share = match grid.reconstruction {
            Reconstruction::Half => f64::from(grid.order + 1 - degree) / f64::from(grid.order + 1),
            _ => 1.0,
        };
        scaled[term] = coefficient * monomial(spacing, EXPONENTS[term]) * share;
    }
    scaled
}

/// Upper bound of the derivative by one local coordinate in a cell.
fn along(corners: &[[f64; 20]; 8], axis: usize, grid: &GridSettings) -> f64 {
    let own_slope = corners
        .iter()
        .map(|corner| (1..20).map(|term| f64::from(EXPONENTS[term][axis]) * corner[term].abs()).sum())
        .fold(0.0, f64::max);
    let smoothness = match grid.reconstruction {
        Reconstruction::Nearest => return own_slope,
        Reconstruction::Linear | Reconstruction::Half => 0,
        Reconstruction::Blend | Reconstruction::Hermite => usize::from(grid.order),
    };

    let bit = 4 >> axis;
    let edges = (0..8).filter(|corner| corner & bit == 0).map(|corner| (corner, corner | bit));
    let difference = edges.map(|(low, high)| edge_difference(corners, low, high, grid)).fold(0.0, f64::max);
    STEEPEST_WEIGHT[smoothness] * difference + own_slope
}

/// Largest difference of two corners' contributions anywhere in the cell.
fn edge_difference(corners: &[[f64; 20]; 8], low: usize, high: usize, grid: &GridSettings) -> f64 {
    let (a, b) = (&corners[low], &corners[high]);
    let size = |corner: &[f64; 20]| corner[1..].iter().map(|coefficient| coefficient.abs()).sum::<f64>();
    match (grid.reconstruction, grid.order) {
        (Reconstruction::Hermite, _) => (b[0] - a[0]).abs() + SLOPE_WEIGHT * (size(a) + size(b)),
        // The difference of two planes is largest at a corner of the cell.
        (_, 0 | 1) => {
            let plane = |plane: &[f64; 20], own: usize, at: usize| {
                let offset = |shift: usize| f64::from((at >> shift & 1) as i8 - (own >> shift & 1) as i8);
                plane[0] + plane[1] * offset(2) + plane[2] * offset(1) + plane[3] * offset(0)
            };
            (0..8).map(|at| (plane(b, high, at) - plane(a, low, at)).abs()).fold(0.0, f64::max)
        }
        _ => (b[0] - a[0]).abs() + size(a) + size(b),
    }
}
