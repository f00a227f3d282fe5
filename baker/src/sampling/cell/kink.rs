//! Pairs of polynomials whose lesser or greater is the field: the medial axis and creases in one leaf.
//!
//! The samples are split in two by their gradients (two-means on the sphere), each side is fitted, and each sample goes over
//! to the side whose fit is nearer to it, in value and gradient; this is repeated.

use super::basis::TERMS_UP_TO;
use super::equations::{Equations, Side};
use super::fit::{Errors, Fit};
use super::piece::{Kind, Piece};
use super::samples::CellSamples;
use super::stencil::POINTS;
use crate::field_function::Sample;
use glam::DVec3;

/// Rounds of two-means.
const CLUSTER_ROUNDS: usize = 4;
/// Rounds of fitting quadrics and going over.
const SPLIT_ROUNDS: usize = 3;
/// What the square of a difference of gradients, by the coordinates of the cube, counts beside one of values where samples
/// choose their side: near a kink both sides have the value, and one the gradient.
const SLOPE_WEIGHT: f64 = 0.05;
/// Mean gradients of the two sides closer than this are one side.
const LEAST_ANGLE: f64 = 0.05;
/// Degrees of the pairs that are offered, the first side's and the second's.
const PAIRS: [[u8; 2]; 9] = [[1, 1], [1, 2], [2, 1], [2, 2], [1, 3], [3, 1], [2, 3], [3, 2], [3, 3]];

/// Coefficients that a side has at most for each of its samples, of which each tells four numbers: with more, a side is free
/// to go astray between its samples and beyond the cell.
const COEFFICIENTS_PER_SAMPLE: usize = 2;

/// The best pair of each combination of degrees; none where the samples have one side only.
pub(super) fn fits(cell: &CellSamples<'_>, equations: &Equations<'_>) -> Vec<Fit> {
    let Some(side) = cluster(cell.samples) else {
        return Vec::new();
    };
    let side = go_over(cell, equations, side);
    if !is_split(&side) {
        return Vec::new();
    }
    let sides = equations.both_sides(3, &side);
    let coefficients = [1, 2, 3].map(|degree| [&sides[0], &sides[1]].map(|side| side.solve(degree)));
    // Not in an array, which would be moved.
    let values: Vec<[[f64; POINTS]; 2]> = coefficients
        .iter()
        .zip(&TERMS_UP_TO[1..])
        .map(|([first, second], &terms)| [cell.stencil.values(first, terms), cell.stencil.values(second, terms)])
        .collect();
    let first_count = side.iter().filter(|&&first| first).count();
    let counts = [first_count, POINTS - first_count];
    PAIRS
        .into_iter()
        .filter(|degrees| (0..2).all(|i| TERMS_UP_TO[usize::from(degrees[i])] <= COEFFICIENTS_PER_SAMPLE * counts[i]))
        .map(|degrees| {
            let [first, second] = degrees.map(|degree| usize::from(degree) - 1);
            let fit = |kind: Kind| {
                let pairs = values[first][0].iter().zip(&values[second][1]);
                let chosen = pairs.map(|(&a, &b)| if kind.takes_first(a, b) { a } else { b });
                let coefficients = [coefficients[first][0], coefficients[second][1]];
                Fit { piece: Piece { kind, degrees, coefficients }, errors: Errors::of(chosen, cell.samples) }
            };
            let [min, max] = [Kind::Min, Kind::Max].map(fit);
            if min.errors.mean_square <= max.errors.mean_square { min } else { max }
        })
        .collect()
}

/// Two-means of the gradients, from the pair that is farthest apart as seen from the mean.
fn cluster(samples: &[Sample]) -> Option<Side> {
    let mean: DVec3 = samples.iter().map(|sample| sample.gradient).sum::<DVec3>() / POINTS as f64;
    let farthest_from = |point: DVec3| {
        samples.iter().map(|sample| sample.gradient).fold((point, 0.0), |farthest, gradient| {
            let squared = gradient.distance_squared(point);
            if squared > farthest.1 { (gradient, squared) } else { farthest }
        })
    };
    let (mut first, _) = farthest_from(mean);
    let (mut second, _) = farthest_from(first);

    let mut side = [false; POINTS];
    for _ in 0..CLUSTER_ROUNDS {
        let mut sums = [(DVec3::ZERO, 0.0); 2];
        for (side, sample) in side.iter_mut().zip(samples) {
            *side = sample.gradient.distance_squared(first) <= sample.gradient.distance_squared(second);
            let (sum, count) = &mut sums[usize::from(!*side)];
            *sum += sample.gradient;
            *count += 1.0;
        }
        if sums[0].1 == 0.0 || sums[1].1 == 0.0 {
            return None;
        }
        (first, second) = (sums[0].0 / sums[0].1, sums[1].0 / sums[1].1);
    }
    (first.distance(second) >= LEAST_ANGLE).then_some(side)
}

/// Fits quadrics to both sides and lets samples go over, a few times.
fn go_over(cell: &CellSamples<'_>, equations: &Equations<'_>, mut side: Side) -> Side {
    const DEGREE: u8 = 2;
    const TERMS: usize = TERMS_UP_TO[DEGREE as usize];
    for _ in 0..SPLIT_ROUNDS {
        if !is_split(&side) {
            break;
        }
        let [first, second] = equations.both_sides(DEGREE, &side).map(|side| {
            let coefficients = side.solve(DEGREE);
            (coefficients, cell.stencil.values(&coefficients, TERMS))
        });
        let crossed: Side = std::array::from_fn(|point| {
            let (distance, wanted) = (cell.samples[point].distance, cell.slope(point));
            let [first, second] = [&first, &second].map(|(coefficients, values)| {
                let slope = cell.stencil.gradient(point, coefficients, TERMS);
                (values[point] - distance).powi(2) + SLOPE_WEIGHT * slope.distance_squared(wanted)
            });
            first <= second
        });
        if crossed == side {
            break;
        }
        side = crossed;
    }
    side
}

fn is_split(side: &Side) -> bool {
    side.contains(&true) && side.contains(&false)
}
