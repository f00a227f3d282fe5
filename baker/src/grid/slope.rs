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

/// How often a cell whose bound is above what is attained elsewhere is halved.
const HALVINGS: u32 = 2;

/// Upper bound of the length of the gradient of the reconstruction of `coefficients`, between its jumps if it has any.
pub(super) fn bound(coefficients: &[f64], domain: &Domain, grid: &GridSettings) -> f64 {
    let nets = Nets::new(grid);
    let cells = domain.resolution + 1 - nets.ends;
    let [nx, ny, nz] = cells.to_array().map(|cells| cells as usize);
    let gather = |index: usize| {
        let cell = [index % nx, index / nx % ny, index / nx / ny].map(|place| place as u32);
        nets.gather(coefficients, domain, grid, UVec3::from_array(cell))
    };

    // What all cells are at first sight; then those that may be steeper than any corner, closer.
    let slopes: Vec<Slopes> = (0..nx * ny * nz)
        .into_par_iter()
        .map(|index| nets.slopes(&gather(index), domain.spacing, Part::WHOLE))
        .collect();
    let attained = slopes.iter().map(|cell| cell.attained).fold(0.0, f64::max);
    let refined = |(index, _)| nets.refined(&gather(index), domain.spacing, Part::WHOLE, attained);
    let doubtful = slopes.par_iter().enumerate().filter(|(_, cell)| cell.bound > attained);
    doubtful.map(refined).reduce(|| attained, f64::max).sqrt()
}

/// A dyadic part of a cell: `1 / 2^halvings` of its edge, so many parts from its least corner.
#[derive(Clone, Copy)]
struct Part {
    halvings: u32,
    place: UVec3,
}

impl Part {
    const WHOLE: Self = Self { halvings: 0, place: UVec3::ZERO };

    fn halves(self) -> impl Iterator<Item = Self> {
        let octant = |index: u32| UVec3::new(index & 1, index >> 1 & 1, index >> 2);
        (0..8).map(move |index| Self { halvings: self.halvings + 1, place: 2 * self.place + octant(index) })
    }
}

/// Squared lengths of gradients.
struct Slopes {
    /// The greatest at a corner of the part.
    attained: f64,
    /// No gradient of the part is longer.
    bound: f64,
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

    /// The greatest bound of the parts of a part that may go beyond what is attained, both squared.
    fn refined(&self, gathered: &[f64], spacing: DVec3, part: Part, attained: f64) -> f64 {
        let Slopes { bound, .. } = self.slopes(gathered, spacing, part);
        if bound <= attained || part.halvings == HALVINGS {
            return bound;
        }
        part.halves().map(|half| self.refined(gathered, spacing, half, attained)).fold(0.0, f64::max)
    }

    fn slopes(&self, gathered: &[f64], spacing: DVec3, part: Part) -> Slopes {
        let axes = part.place.to_array().map(|place| &self.axes[part.halvings as usize][place as usize]);
        let of = |derived: usize| {
            let basis = |axis: usize| if axis == derived { &axes[axis].slope } else { &axes[axis].value };
            self.contract(&self.contract(&self.contract(gathered, basis(0)), basis(1)), basis(2))
        };
        let [by_x, by_y, by_z] = [of(0), of(1), of(2)];
        let squared = |index: usize| (DVec3::new(by_x[index], by_y[index], by_z[index]) / spacing).length_squared();

        let last = self.points - 1;
        let end = |corner: usize, bit: usize| last * (corner >> bit & 1);
        let corner = |corner: usize| (end(corner, 2) * self.points + end(corner, 1)) * self.points + end(corner, 0);
        Slopes {
            attained: (0..8).map(|index| squared(corner(index))).fold(0.0, f64::max),
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
    // Each power adds its coefficient times C(at, power) / C(degree, power).
    let mut ratio = 1.0;
    let mut sum = 0.0;
    for power in 0..=at {
        sum += ratio * polynomial[power];
        if power < at {
            ratio *= (at - power) as f64 / (degree - power) as f64;
        }
    }
    sum
}
