//! A polynomial octree fitted to a union of balls, and what the specification makes of it, summed over all leaves.

use crate::vectors::polynomial::{Cell, Leaf, MAX, MIN, Placed, PolynomialOctree, SINGLE, Shape};
use glam::DVec3;

/// Centres and radii, in root cells.
const BALLS: [(DVec3, f64); 5] = [
    (DVec3::new(0.7, 0.8, 0.6), 0.35),
    (DVec3::new(1.3, 0.7, 0.9), 0.3),
    (DVec3::new(0.9, 1.4, 1.2), 0.4),
    (DVec3::new(1.5, 1.45, 0.5), 0.15),
    (DVec3::new(0.4, 0.5, 1.6), 0.2),
];

/// Root cells along each axis.
pub(crate) const ROOTS: u16 = 2;

/// Nodes and weights of the Gauss and Legendre rule of five points.
const RULE: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// The Legendre polynomial of a degree, and its derivative.
fn legendre(degree: usize, t: f64) -> (f64, f64) {
    match degree {
        0 => (1.0, 0.0),
        1 => (t, 1.0),
        2 => (0.5 * (3.0 * t * t - 1.0), 3.0 * t),
        _ => (0.5 * (5.0 * t * t * t - 3.0 * t), 0.5 * (15.0 * t * t - 3.0)),
    }
}

/// Degrees in x, y and z of each term, in the order of §12.5.
pub(crate) const DEGREES: [[usize; 3]; 20] = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [2, 0, 0],
    [0, 2, 0],
    [0, 0, 2],
    [1, 1, 0],
    [0, 1, 1],
    [1, 0, 1],
    [3, 0, 0],
    [0, 3, 0],
    [0, 0, 3],
    [2, 1, 0],
    [0, 2, 1],
    [1, 0, 2],
    [2, 0, 1],
    [1, 2, 0],
    [0, 1, 2],
    [1, 1, 1],
];

/// Value and derivatives of a sum of terms at a point of [-1, 1]³.
fn sum_of_terms(coefficients: &[f64], point: DVec3) -> (f64, DVec3) {
    let mut value = 0.0;
    let mut slope = DVec3::ZERO;
    for (coefficient, degrees) in coefficients.iter().zip(DEGREES) {
        let [x, y, z] = [0, 1, 2].map(|axis: usize| legendre(degrees[axis], point[axis]));
        value += coefficient * x.0 * y.0 * z.0;
        slope += *coefficient * DVec3::new(x.1 * y.0 * z.0, x.0 * y.1 * z.0, x.0 * y.0 * z.1);
    }
    (value, slope)
}

/// The coefficients, up to a degree, of the polynomial nearest to a function in the mean square over [-1, 1]³.
fn project(function: impl Fn(DVec3) -> f64, degree: u8) -> Vec<f64> {
    let count = [1, 4, 10, 20][usize::from(degree)];
    let mut coefficients = vec![0.0; count];
    for (x, wx) in RULE {
        for (y, wy) in RULE {
            for (z, wz) in RULE {
                let sample = function(DVec3::new(x, y, z)) * wx * wy * wz;
                for (coefficient, degrees) in coefficients.iter_mut().zip(DEGREES) {
                    let basis = [x, y, z].into_iter().zip(degrees).map(|(t, degree)| legendre(degree, t).0);
                    let norm = degrees.iter().map(|&degree| 2.0 / (2 * degree + 1) as f64);
                    *coefficient += sample * basis.product::<f64>() / norm.product::<f64>();
                }
            }
        }
    }
    coefficients
}

/// Quantized fits within a tolerance, in units of root cells.
pub(crate) struct Fit {
    pub(crate) overlap: f32,
    /// Greatest error of a leaf at the points that are looked at.
    pub(crate) tolerance: f64,
    pub(crate) depth: u8,
}

impl Fit {
    pub(crate) fn octree(&self) -> PolynomialOctree {
        let roots = (0..8).map(|root| DVec3::new(f64::from(root & 1), f64::from(root >> 1 & 1), f64::from(root >> 2)));
        let cells = roots.map(|corner| self.cell(corner, 1.0, 0)).collect();
        let mut octree = PolynomialOctree::new([ROOTS; 3], cells, self.overlap);
        octree.quantum = self.quantum() as f32;
        octree
    }

    /// Mesh units: a root cell is 2 wide. A power of two, so that it is a float.
    fn quantum(&self) -> f64 {
        (2.0 * self.tolerance / 8.0).log2().floor().exp2()
    }

    fn cell(&self, corner: DVec3, edge: f64, level: u8) -> Cell {
        let to_point = |local: DVec3| corner + edge * 0.5 * (local + DVec3::ONE);
        let ball =
            |(centre, radius): (DVec3, f64)| move |local: DVec3| 2.0 * (to_point(local).distance(centre) - radius);
        let truth = |local: DVec3| BALLS.map(|each| ball(each)(local)).into_iter().fold(f64::INFINITY, f64::min);
        let mut nearest = BALLS;
        nearest.sort_by(|a, b| ball(*a)(DVec3::ZERO).total_cmp(&ball(*b)(DVec3::ZERO)));

        let mut candidates: Vec<Leaf> = Vec::new();
        for degree in 0..=3 {
            candidates.push(self.quantize(SINGLE, level, [project(truth, degree), Vec::new()]));
            let sides = |other| [project(ball(nearest[0]), degree), project(ball(nearest[1]), other)];
            // Two polynomials of degree 3 take more than a leaf may.
            if degree < 3 {
                candidates.push(self.quantize(MIN, level, sides(degree)));
                candidates.push(self.quantize(MIN, level, sides(degree.max(1) - 1)));
            }
        }
        let fitting = candidates.into_iter().find(|leaf| {
            let error = |point| (self.evaluate(leaf, point).0 - truth(point)).abs();
            let lattice =
                (0..216).map(|index| DVec3::new((index % 6).into(), (index / 6 % 6).into(), (index / 36).into()));
            lattice.map(|index| index / 2.5 - 1.0).all(|point| error(point) <= 2.0 * self.tolerance)
        });
        match fitting {
            Some(leaf) => Cell::Leaf(leaf),
            None if level == self.depth => Cell::Leaf(self.quantize(SINGLE, level, [project(truth, 1), Vec::new()])),
            None => Cell::with_children(|child| {
                let offset = DVec3::new((child & 1) as f64, (child >> 1 & 1) as f64, (child >> 2) as f64);
                self.cell(corner + 0.5 * edge * offset, 0.5 * edge, level + 1)
            }),
        }
    }

    fn quantize(&self, kind: u8, level: u8, polynomials: [Vec<f64>; 2]) -> Leaf {
        // Of every kind some: the maximum of the negatives is the same field upside down.
        let exponent = level % 2;
        let step = self.quantum() * f64::from(exponent).exp2();
        let degrees = polynomials
            .each_ref()
            .map(|terms| [1, 4, 10, 20].iter().position(|&n| n >= terms.len()).unwrap_or(0) as u8);
        let coefficients: Vec<i32> = polynomials.concat().iter().map(|term| (term / step).round() as i32).collect();
        let mut widths = [0; 4];
        let terms = polynomials.iter().flat_map(|terms| &DEGREES[..terms.len()]);
        for (degrees, &number) in terms.zip(&coefficients) {
            let bits = if number == 0 { 0 } else { 33 - (number ^ number >> 31).leading_zeros() as u8 };
            let degree: usize = degrees.iter().sum();
            widths[degree] = bits.next_multiple_of(3).max(widths[degree]);
        }
        Leaf { shape: Shape { kind, degrees, exponent, widths }, coefficients }
    }

    /// Value in mesh units and derivatives at local coordinates.
    fn evaluate(&self, leaf: &Leaf, local: DVec3) -> (f64, DVec3) {
        let step = self.quantum() * f64::from(leaf.shape.exponent).exp2();
        let terms: Vec<f64> = leaf.coefficients.iter().map(|&number| f64::from(number) * step).collect();
        let (first, second) = terms.split_at([1, 4, 10, 20][usize::from(leaf.shape.degrees[0])]);
        let (first, second) = (sum_of_terms(first, local), sum_of_terms(second, local));
        match leaf.shape.kind {
            MIN if second.0 < first.0 => second,
            MAX if second.0 > first.0 => second,
            _ => first,
        }
    }

    /// §12.6 and §12.7, over all leaves: value in mesh units and gradient at a position in finest cells, and how many
    /// leaves have a say.
    pub(crate) fn naive(&self, octree: &PolynomialOctree, position: DVec3) -> (f64, DVec3, usize) {
        let per_cell = f64::from(octree.root_edge) / f64::from(1_u32 << octree.depth);
        let (mut count, mut weights, mut weight_slopes) = (0, 0.0, DVec3::ZERO);
        let (mut values, mut slopes) = (0.0, DVec3::ZERO);
        for placed in &octree.leaves {
            let corner = DVec3::from_array(placed.cell.map(|cell| cell as f64));
            let half = 0.5 * placed.edge as f64;
            let local = (position - corner) / half - 1.0;
            let (weight, weight_slope) = weight(octree, placed, local, half);
            if weight > 0.0 {
                let (value, slope) = self.evaluate(&placed.leaf, local);
                (count, weights, weight_slopes) = (count + 1, weights + weight, weight_slopes + weight_slope);
                values += weight * value;
                slopes += weight * slope / half + weight_slope * value;
            }
        }
        let value = values / weights;
        (value, (slopes - value * weight_slopes) / weights / per_cell, count)
    }

    /// Value of the leaf that holds a position, without its neighbours.
    pub(crate) fn alone(&self, octree: &PolynomialOctree, position: DVec3) -> f64 {
        let is_in = |placed: &&Placed| {
            (0..3).all(|axis| {
                let low = placed.cell[axis] as f64;
                (low..low + placed.edge as f64).contains(&position[axis])
            })
        };
        let placed = octree.leaves.iter().find(is_in).expect("a leaf");
        let corner = DVec3::from_array(placed.cell.map(|cell| cell as f64));
        self.evaluate(&placed.leaf, (position - corner) / (0.5 * placed.edge as f64) - 1.0).0
    }
}

/// The weight of a leaf, and its derivatives by finest cells.
fn weight(octree: &PolynomialOctree, placed: &Placed, local: DVec3, half: f64) -> (f64, DVec3) {
    let beyond = f64::from(octree.overlap) * placed.edge as f64 * 0.5_f64.powi(placed.support as i32);
    let parts = [0, 1, 2].map(|axis: usize| {
        let inside = half * (1.0 - local[axis].abs());
        if octree.overlap == 0.0 {
            return (f64::from(u8::from(inside >= 0.0)), 0.0);
        }
        let s = (0.5 + inside / (2.0 * beyond)).clamp(0.0, 1.0);
        (s * s * (3.0 - 2.0 * s), -6.0 * s * (1.0 - s) * local[axis].signum() / (2.0 * beyond))
    });
    let [x, y, z] = parts;
    (x.0 * y.0 * z.0, DVec3::new(x.1 * y.0 * z.0, x.0 * y.1 * z.0, x.0 * y.0 * z.1))
}
