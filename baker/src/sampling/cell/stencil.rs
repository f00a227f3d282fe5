//! The points of a cell at which the function is sampled, and what fits need to know of them.

use super::basis::{self, TERMS};
use super::normal_equations::PAIRS;
use glam::DVec3;

/// Nodes along each axis: multiples of half the outermost.
const NODES: usize = 5;
/// The outermost node of an axis. Nearer to the faces samples see more of the greatest errors, farther from them more of the mean.
const OUTERMOST: f64 = 0.88;
/// Points of a cell: every other one of the lattice of nodes, those whose indices add up to an odd number. In such a
/// face-centred cubic lattice neighbours are farther apart than in a cubic one of as many points, and each tells more.
pub const POINTS: usize = NODES * NODES * NODES / 2;
/// Distance between neighbours.
pub(super) const SPACING: f64 = 0.5 * OUTERMOST * std::f64::consts::SQRT_2;
/// What the square of an error of the gradient counts beside that of the value, by the coordinates of the cube.
pub(super) const GRADIENT_WEIGHT: f64 = 0.01;

/// The same for every cell.
pub struct Stencil {
    /// The points in the cube [-1, 1]³.
    points: Vec<DVec3>,
    /// Pairs of points that are next to each other.
    pub(super) neighbours: Vec<[usize; 2]>,
    /// Every term at every point.
    pub(super) terms: Vec<[f64; TERMS]>,
    /// The gradient of every term at every point.
    pub(super) gradients: Vec<[DVec3; TERMS]>,
    /// Products of all pairs of terms at every point, and of their gradients by their weight.
    pub(super) products: Vec<[f64; PAIRS]>,
    /// Sum of the products over all points.
    pub(super) all_products: [f64; PAIRS],
}

impl Default for Stencil {
    /// Tabulates the basis.
    fn default() -> Self {
        let index = |i: usize| [i % NODES, i / NODES % NODES, i / NODES / NODES];
        let node = |index: usize| OUTERMOST * (0.5 * index as f64 - 1.0);
        let points: Vec<DVec3> = (0..NODES * NODES * NODES)
            .map(index)
            .filter(|index| index.iter().sum::<usize>() % 2 == 1)
            .map(|index| DVec3::from_array(index.map(node)))
            .collect();
        let pairs = (0..POINTS).flat_map(|a| (a + 1..POINTS).map(move |b| [a, b]));
        let neighbours = pairs.filter(|&[a, b]| points[a].distance(points[b]) < 1.1 * SPACING).collect();
        let terms: Vec<[f64; TERMS]> = points.iter().map(|&point| basis::values(point)).collect();
        let gradients: Vec<[DVec3; TERMS]> = points.iter().map(|&point| basis::gradients(point)).collect();
        let products: Vec<[f64; PAIRS]> = terms
            .iter()
            .zip(&gradients)
            .map(|(t, g)| {
                let product = |i: usize, j: usize| t[i] * t[j] + GRADIENT_WEIGHT * g[i].dot(g[j]);
                let mut pairs = (0..TERMS).flat_map(|i| (0..=i).map(move |j| product(i, j)));
                std::array::from_fn(|_| pairs.next().expect("as many pairs"))
            })
            .collect();
        let mut all_products = [0.0; PAIRS];
        for products in &products {
            all_products.iter_mut().zip(products).for_each(|(sum, product)| *sum += product);
        }
        Self { points, neighbours, terms, gradients, products, all_products }
    }
}

impl Stencil {
    /// The points of a cell, mesh units.
    pub fn points_of(&self, centre: DVec3, edge: f64) -> impl Iterator<Item = DVec3> {
        self.points.iter().map(move |&point| centre + 0.5 * edge * point)
    }

    /// The values of a polynomial at the points.
    pub(super) fn values(&self, coefficients: &[f64; TERMS], terms: usize) -> [f64; POINTS] {
        std::array::from_fn(|point| {
            let (terms_here, coefficients) = (&self.terms[point][..terms], &coefficients[..terms]);
            terms_here.iter().zip(coefficients).map(|(term, coefficient)| term * coefficient).sum()
        })
    }

    /// The gradient of a polynomial at a point, by the coordinates of the cube.
    pub(super) fn gradient(&self, point: usize, coefficients: &[f64; TERMS], terms: usize) -> DVec3 {
        let gradients = self.gradients[point][..terms].iter().zip(&coefficients[..terms]);
        gradients.map(|(gradient, &coefficient)| *gradient * coefficient).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_a_face_centred_lattice() {
        let stencil = Stencil::default();
        assert_eq!(stencil.points.len(), POINTS);
        let sum: DVec3 = stencil.points.iter().sum();
        assert!(sum.length() < 1e-12, "as many on either side");
        let beside = |point: usize| stencil.neighbours.iter().flatten().filter(|&&other| other == point).count();
        let is_inside = |point: usize| stencil.points[point].abs().max_element() < 0.9 * OUTERMOST;
        let inside: Vec<usize> = (0..POINTS).filter(|&point| is_inside(point)).collect();
        assert_eq!(inside.len(), 14);
        assert!(inside.into_iter().all(|point| beside(point) == 12), "the kissing number");
    }
}
