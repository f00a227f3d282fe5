//! What a grid's coefficients contribute to its answers: a product of one polynomial along each axis.

use crate::settings::{GridSettings, Reconstruction};

/// Coefficients of powers of t. The highest degree is that of septic weights times cubic samples.
pub(super) type Polynomial = [f64; 11];

/// How much of its terms of these exponents a sample contributes.
pub(super) fn share(grid: &GridSettings, exponents: [u8; 3]) -> f64 {
    let degree: u8 = exponents.iter().sum();
    match grid.reconstruction {
        Reconstruction::Half => f64::from(grid.order + 1 - degree) / f64::from(grid.order + 1),
        _ => 1.0,
    }
}

/// The value at `t`.
pub(super) fn value(polynomial: &Polynomial, t: f64) -> f64 {
    polynomial.iter().rev().fold(0.0, |value, term| value * t + term)
}

/// What the powers of each end contribute along an axis of a cell, 0 to 1: near end first, powers rising.
pub(super) fn contributions(grid: &GridSettings) -> Vec<Polynomial> {
    let order = usize::from(grid.order);
    let weight: &[f64] = match (grid.reconstruction, order) {
        // The cell of a sample that is the nearest reaches half a spacing to either side.
        (Reconstruction::Nearest, _) => return (0..=order).map(|power| shifted_power(0.5, power)).collect(),
        (Reconstruction::Hermite, 1) => return hermite(&[&[0.0, 0.0, 3.0, -2.0], &[0.0, 0.0, -1.0, 1.0]]),
        (Reconstruction::Hermite, _) => {
            let [value, slope] = [[10.0, -15.0, 6.0], [-4.0, 7.0, -3.0]].map(|[a, b, c]| [0.0, 0.0, 0.0, a, b, c]);
            // Twice the weight of the second derivative: coefficients are halves of that.
            return hermite(&[&value, &slope, &[0.0, 0.0, 0.0, 1.0, -2.0, 1.0]]);
        }
        (Reconstruction::Linear | Reconstruction::Half, _) | (_, 0) => &[0.0, 1.0],
        (Reconstruction::Blend, 1) => &[0.0, 0.0, 3.0, -2.0],
        (Reconstruction::Blend, 2) => &[0.0, 0.0, 0.0, 10.0, -15.0, 6.0],
        (Reconstruction::Blend, _) => &[0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0],
    };
    let far = polynomial(weight);
    let near = std::array::from_fn(|power| f64::from(u8::from(power == 0)) - far[power]);
    let of_end =
        |weight: Polynomial, end: f64| (0..=order).map(move |power| product(&weight, &shifted_power(end, power)));
    of_end(near, 0.0).chain(of_end(far, 1.0)).collect()
}

/// Both ends of a Hermite basis, of whose derivatives the far end's are given: the near end is its mirror image, where
/// odd derivatives change sign.
fn hermite(far: &[&[f64]]) -> Vec<Polynomial> {
    let mirrored = |(power, far): (usize, &&[f64])| {
        let sign = if power % 2 == 0 { 1.0 } else { -1.0 };
        substituted(&polynomial(far), 1.0, -1.0).map(|term| sign * term)
    };
    far.iter().enumerate().map(mirrored).chain(far.iter().map(|far| polynomial(far))).collect()
}

fn polynomial(terms: &[f64]) -> Polynomial {
    std::array::from_fn(|power| terms.get(power).copied().unwrap_or(0.0))
}

/// (t - end) to a power.
fn shifted_power(end: f64, power: usize) -> Polynomial {
    (0..power).fold(polynomial(&[1.0]), |product_so_far, _| product(&product_so_far, &polynomial(&[-end, 1.0])))
}

fn product(a: &Polynomial, b: &Polynomial) -> Polynomial {
    std::array::from_fn(|power| (0..=power).map(|i| a[i] * b[power - i]).sum())
}

pub(super) fn derivative(polynomial: &Polynomial) -> Polynomial {
    std::array::from_fn(|power| polynomial.get(power + 1).map_or(0.0, |term| (power + 1) as f64 * term))
}

/// The polynomial of `start + edge * t`, by Horner's rule.
pub(super) fn substituted(of: &Polynomial, start: f64, edge: f64) -> Polynomial {
    let line = polynomial(&[start, edge]);
    of.iter().rev().fold([0.0; 11], |so_far, &term| {
        let mut next = product(&so_far, &line);
        next[0] += term;
        next
    })
}
