//! How steep a reconstruction can be: proved, not sampled.
//!
//! Between samples a reconstruction is a polynomial along each axis. Its gradient, written in the Bernstein basis,
//! lies in the convex hull of its control vectors (Farin, Curves and Surfaces for CAGD, 5th edition, section 4.3),
//! so that the longest of these bounds it. Hulls of parts of a cell are tighter.

use super::Domain;
use super::basis::{Polynomial, contributions, derivative, share, substituted};
use crate::sampling::{EXPONENTS, monomial, terms};
use crate::settings::GridSettings;
use glam::{DVec3, UVec3};
use rayon::prelude::*;
use std::collections::BinaryHeap;

/// How far the bound may be above what is attained.
const CLOSE: f64 = 1.02;
/// How often a cell is halved at most.
const HALVINGS: u32 = 4;

/// Upper bound of the length of the gradient of the reconstruction of `coefficients`, between its jumps if it has any.
pub(super) fn bound(coefficients: &[f64], domain: &Domain, grid: &GridSettings) -> f64 {
    let nets = Nets::new(grid);
    let cells = domain.resolution + 1 - nets.ends;
    let [nx, ny, nz] = cells.to_array().map(|cells| cells as usize);
    let gather = |index: usize| {
        let cell = [index % nx, index / nx % ny, index / nx / ny].map(|place| place as u32);
        nets.gather(coefficients, domain, grid, UVec3::from_array(cell))
    };

    let slopes: Vec<Slopes> =
        (0..nx * ny * nz).into_par_iter().map(|cell| nets.slopes(&gather(cell), domain.spacing, Part::WHOLE)).collect();

    // The part with the greatest bound is halved, until that is close to what is attained: no other can be steeper.
    let mut attained = slopes.iter().map(|slopes| slopes.attained).fold(0.0, f64::max);
    let whole_cells = slopes.iter().enumerate().map(|(cell, slopes)| (slopes.bound.to_bits(), cell, Part::WHOLE));
    let mut parts: BinaryHeap<(u64, usize, Part)> = whole_cells.collect::<Vec<_>>().into();
    while let Some((bits, cell, part)) = parts.pop() {
        let bound = f64::from_bits(bits);
        if bound <= CLOSE * CLOSE * attained || part.halvings == HALVINGS {
            return bound.sqrt();
        }
        let gathered = gather(cell);
        for half in part.halves() {
            let slopes = nets.slopes(&gathered, domain.spacing, half);
            attained = attained.max(slopes.attained);
            parts.push((slopes.bound.to_bits(), cell, half));
        }
    }
    0.0
}

/// Squared lengths of gradients: not negative, so that their bits are in the order of the numbers.
struct Slopes {
    /// The greatest at a corner of the part.
    attained: f64,
    /// The longest control vector: no gradient of the part is longer.
    bound: f64,
}

/// A dyadic part of a cell: `1 / 2^halvings` of its edge, so many parts from its least corner.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Part {
    halvings: u32,
    place: [u32; 3],
}

impl Part {
    const WHOLE: Self = Self { halvings: 0, place: [0; 3] };

    fn halves(self) -> impl Iterator<Item = Self> {
        let place = move |octant: u32| std::array::from_fn(|axis| 2 * self.place[axis] + (octant >> axis & 1));
        (0..8).map(move |octant| Self { halvings: self.halvings + 1, place: place(octant) })
    }
}

/// What the coefficients of a cell's samples add to its control points along an axis.
struct Axis {
    /// By coefficient (see [`Nets`]), then by control point.
    value: Vec<f64>,
    slope: Vec<f64>,
}

/// The control points of a reconstruction. Along an axis the coefficient of power `k` of end `e` is number `e * powers + k`.
struct Nets {
    /// Samples along an axis of a cell.
    ends: u32,
    /// Powers of an axis.
    powers: usize,
    /// Control points along an axis.
    points: usize,
    /// By number of halvings, then by place.
    axes: Vec<Vec<Axis>>,
}

impl Nets {
    fn new(grid: &GridSettings) -> Self {
        let contributions = contributions(grid);
        let powers = usize::from(grid.order) + 1;
        let degree = |polynomial: &Polynomial| polynomial.iter().rposition(|&term| term != 0.0).unwrap_or(0);
        let points = contributions.iter().map(degree).max().unwrap_or(0) + 1;
        let axis = |halvings: u32, place: u32| {
            let edge = 1.0 / f64::from(1_u32 << halvings);
            let of_part: Vec<Polynomial> =
                contributions.iter().map(|whole| substituted(whole, f64::from(place) * edge, edge)).collect();
            let control =
                |polynomial: &Polynomial| (0..points).map(|at| control_point(polynomial, points - 1, at)).collect();
            Axis {
                value: of_part.iter().flat_map(|polynomial| -> Vec<f64> { control(polynomial) }).collect(),
                slope: of_part
                    .iter()
                    .flat_map(|polynomial| -> Vec<f64> { control(&derivative(polynomial).map(|term| term / edge)) })
                    .collect(),
            }
        };
        let axes = (0..=HALVINGS).map(|halvings| (0..1 << halvings).map(|place| axis(halvings, place)).collect());
        Self { ends: (contributions.len() / powers) as u32, powers, points, axes: axes.collect() }
    }

    /// Coefficients along an axis.
    fn numbers(&self) -> usize {
        self.ends as usize * self.powers
    }

    /// The coefficients of a cell's samples by local coordinates, as much of them as the reconstruction takes: z
    /// fastest by number along each axis.
    fn gather(&self, coefficients: &[f64], domain: &Domain, grid: &GridSettings, cell: UVec3) -> Vec<f64> {
        let (numbers, terms) = (self.numbers(), terms(grid.order));
        let mut gathered = vec![0.0; numbers * numbers * numbers];
        let ends = || 0..self.ends;
        for (x, y, z) in ends().flat_map(|x| ends().flat_map(move |y| ends().map(move |z| (x, y, z)))) {
            let start = domain.index(cell + UVec3::new(x, y, z)) * terms;
            for (&coefficient, exponents) in coefficients[start..start + terms].iter().zip(EXPONENTS) {
                let number = |end: u32, axis: usize| end as usize * self.powers + usize::from(exponents[axis]);
                let place = (number(x, 0) * numbers + number(y, 1)) * numbers + number(z, 2);
                gathered[place] = coefficient * monomial(domain.spacing, exponents) * share(grid, exponents);
            }
        }
        gathered
    }

    fn slopes(&self, gathered: &[f64], spacing: DVec3, part: Part) -> Slopes {
        let axes = part.place.map(|place| &self.axes[part.halvings as usize][place as usize]);
        let of = |derived: usize| {
            let basis = |axis: usize| if axis == derived { &axes[axis].slope } else { &axes[axis].value };
            self.contract(&self.contract(&self.contract(gathered, basis(0)), basis(1)), basis(2))
        };
        let [by_x, by_y, by_z] = [of(0), of(1), of(2)];
        let squared = |index: usize| (DVec3::new(by_x[index], by_y[index], by_z[index]) / spacing).length_squared();

        let last = self.points - 1;
        let end = |corner: usize, bit: usize| last * (corner >> bit & 1);
        let at = |corner: usize| (end(corner, 2) * self.points + end(corner, 1)) * self.points + end(corner, 0);
        Slopes {
            attained: (0..8).map(|corner| squared(at(corner))).fold(0.0, f64::max),
            bound: (0..by_x.len()).map(squared).fold(0.0, f64::max),
        }
    }

    /// Takes the slowest axis of a tensor from coefficients to control points, and makes it the fastest.
    fn contract(&self, tensor: &[f64], basis: &[f64]) -> Vec<f64> {
        let rest = tensor.len() / self.numbers();
        let mut out = vec![0.0; rest * self.points];
        for (row, control) in tensor.chunks(rest).zip(basis.chunks(self.points)) {
            for (&coefficient, out) in
                row.iter().zip(out.chunks_mut(self.points)).filter(|(coefficient, _)| **coefficient != 0.0)
            {
                for (out, control) in out.iter_mut().zip(control) {
                    *out += coefficient * control;
                }
            }
        }
        out
    }
}

/// Control point `at` of a polynomial in the Bernstein basis of a degree over 0 to 1.
fn control_point(polynomial: &Polynomial, degree: usize, at: usize) -> f64 {
    // Each power adds its coefficient times C(at, power) / C(degree, power), which is 1 for the first.
    let mut ratio = 1.0;
    let mut sum = 0.0;
    for (power, term) in polynomial.iter().enumerate().take(at + 1) {
        sum += ratio * term;
        ratio *= (at - power) as f64 / (degree - power).max(1) as f64;
    }
    sum
}
