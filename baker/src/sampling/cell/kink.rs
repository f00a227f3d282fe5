//! Pairs of polynomials whose lesser or greater is the field: the medial axis and creases in one leaf.
//!
//! The samples are split in two by their gradients (two-means on the sphere), each side is fitted, and each
//! sample goes over to the side that the lesser (or greater) of both fits selects there; this is repeated.

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
/// Rounds of fitting and going over, at degree 1 and again at degree 2.
const SPLIT_ROUNDS: usize = 3;
/// Mean gradients of the two sides closer than this are one side.
const LEAST_ANGLE: f64 = 0.05;
/// Degrees of the pairs that are offered, the first side's and the second's.
const PAIRS: [[u8; 2]; 9] = [[1, 1], [1, 2], [2, 1], [2, 2], [1, 3], [3, 1], [2, 3], [3, 2], [3, 3]];

/// Samples that a side has at least for each of its coefficients: with fewer, a side is free to go astray between
/// its samples and beyond the cell. One tells four numbers, its value and its gradient.
const SAMPLES_PER_TERM: usize = 1;

/// The best pair of each combination of degrees; none where the samples have one side only.
pub(super) fn fits(cell: &CellSamples<'_>, equations: &Equations<'_>) -> Vec<Fit> {
    let (stencil, samples) = (cell.stencil, cell.samples);
    let Some(clustered) = cluster(samples) else {
        return Vec::new();
    };

    // The lesser or the greater, from planes.
    let planes = [Kind::Min, Kind::Max].map(|kind| improve(cell, equations, kind, 1, clustered));
    let (kind, side) = match planes {
        [Some((min, side)), Some((max, _))] if min <= max => (Kind::Min, side),
        [Some((_, side)), None] => (Kind::Min, side),
        [_, Some((_, side))] => (Kind::Max, side),
        [None, None] => return Vec::new(),
    };

    // The split, from quadrics.
    let side = improve(cell, equations, kind, 2, side).map_or(side, |(_, side)| side);

    // Every combination of degrees on that split.
    if !is_split(&side) {
        return Vec::new();
    }
    let sides = equations.both_sides(3, &side);
    let coefficients = [1, 2, 3].map(|degree| [&sides[0], &sides[1]].map(|side| side.solve(degree)));
    // Not in an array, which would be moved.
    let values: Vec<[[f64; POINTS]; 2]> = coefficients
        .iter()
        .zip(&TERMS_UP_TO[1..])
        .map(|([first, second], &terms)| [stencil.values(first, terms), stencil.values(second, terms)])
        .collect();
    let first_count = side.iter().filter(|&&first| first).count();
    let counts = [first_count, POINTS - first_count];
    PAIRS
        .into_iter()
        .filter(|degrees| (0..2).all(|i| counts[i] >= SAMPLES_PER_TERM * TERMS_UP_TO[usize::from(degrees[i])]))
        .map(|degrees| {
            let [first, second] = degrees.map(|degree| usize::from(degree) - 1);
            let pairs = values[first][0].iter().zip(&values[second][1]);
            let chosen = pairs.map(|(&a, &b)| if kind.takes_first(a, b) { a } else { b });
            let errors = Errors::of(chosen, samples);
            let coefficients = [coefficients[first][0], coefficients[second][1]];
            Fit { piece: Piece { kind, degrees, coefficients }, errors }
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

/// Fits both sides and lets samples go over, a few times; the best split met and its mean square error.
fn improve(
    cell: &CellSamples<'_>,
    equations: &Equations<'_>,
    kind: Kind,
    degree: u8,
    mut side: Side,
) -> Option<(f64, Side)> {
    let terms = TERMS_UP_TO[usize::from(degree)];
    let mut best: Option<(f64, Side)> = None;
    for _ in 0..SPLIT_ROUNDS {
        if !is_split(&side) {
            break;
        }
        let [first, second] = equations.both_sides(degree, &side);
        let [first, second] = [&first, &second].map(|equations| equations.solve(degree));
        let (first, second) = (cell.stencil.values(&first, terms), cell.stencil.values(&second, terms));
        let chosen = first.iter().zip(&second).map(|(&a, &b)| if kind.takes_first(a, b) { a } else { b });
        let error = Errors::of(chosen, cell.samples).mean_square;
        if best.is_none_or(|(least, _)| error < least) {
            best = Some((error, side));
        }
        let crossed: Side = std::array::from_fn(|point| kind.takes_first(first[point], second[point]));
        if crossed == side {
            break;
        }
        side = crossed;
    }
    best
}

fn is_split(side: &Side) -> bool {
    side.contains(&true) && side.contains(&false)
}
