//! When a cell is good enough (Pujol and Chica 2023, section 5).
//!
//! The error of its interpolant is estimated from the 3 x 3 x 3 lattice of corners and midpoints, since
//! the children would need these samples anyway.

use crate::settings::{NEAR, Settings, Termination};

/// A rule and what it asks for.
#[derive(Clone, Copy, Debug)]
pub struct Criterion {
    rule: Termination,
    /// Mesh units.
    target: f64,
    /// Farther from the surface than this the error by distance may grow; mesh units.
    near: f64,
}

/// The error of an interpolant at a point, and how far from the surface the point is. Mesh units.
#[derive(Clone, Copy, Debug)]
pub struct PointError {
    /// Interpolant less sample.
    pub error: f64,
    /// The sample's distance, of either sign.
    pub distance: f64,
}

impl Criterion {
    /// The rule of the settings for a target and a diagonal, mesh units.
    pub fn new(settings: &Settings, target: f64, diagonal: f64) -> Self {
        Self { rule: settings.termination, target, near: NEAR * diagonal }
    }

    /// Whether a cell with these errors on its lattice, x fastest, need not be split.
    pub fn is_met(&self, errors: &[PointError; 27]) -> bool {
        let shares = errors.map(|point| (point.error / self.tolerance(point.distance)).abs());
        match self.rule {
            Termination::Trapezoid | Termination::ByDistance => mean_square(&shares, [0.25, 0.5, 0.25]) <= 1.0,
            Termination::Simpson => mean_square(&shares, [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]) <= 1.0,
            Termination::MaxError => shares.into_iter().all(|share| share <= 1.0),
        }
    }

    /// The error that may be made at this distance from the surface, mesh units.
    pub fn tolerance(&self, distance: f64) -> f64 {
        match self.rule {
            Termination::ByDistance => self.target * (distance.abs() / self.near).max(1.0),
            Termination::Trapezoid | Termination::Simpson | Termination::MaxError => self.target,
        }
    }
}

/// The mean of squares over a cell by a quadrature with these weights along every axis.
fn mean_square(values: &[f64; 27], weights: [f64; 3]) -> f64 {
    let weight = |i: usize| weights[i % 3] * weights[i / 3 % 3] * weights[i / 9];
    values.iter().enumerate().map(|(i, value)| weight(i) * value * value).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn criterion(rule: Termination) -> Criterion {
        Criterion::new(&Settings { termination: rule, ..Settings::default() }, 1.0, 1.0 / NEAR)
    }

    /// Errors of `at_centre` in the middle of the cell and nowhere else, so far from the surface.
    fn peak(at_centre: f64, distance: f64) -> [PointError; 27] {
        std::array::from_fn(|i| PointError { error: if i == 13 { at_centre } else { 0.0 }, distance })
    }

    /// The largest peak that a rule lets pass.
    fn greatest_peak(rule: Termination, distance: f64) -> f64 {
        let steps = (1..=4000).map(|step| f64::from(step) / 1000.0);
        steps.filter(|&error| criterion(rule).is_met(&peak(error, distance))).fold(0.0, f64::max)
    }

    #[test]
    fn each_rule_weighs_the_centre_as_its_quadrature_does() {
        // 1/8, 8/27 and 1 of its square.
        assert_eq!(greatest_peak(Termination::Trapezoid, 0.0), 2.828);
        assert_eq!(greatest_peak(Termination::Simpson, 0.0), 1.837);
        assert_eq!(greatest_peak(Termination::MaxError, 0.0), 1.0);
    }

    #[test]
    fn quadratures_of_a_constant_are_its_square() {
        for weights in [[0.25, 0.5, 0.25], [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]] {
            assert!((mean_square(&[3.0; 27], weights) - 9.0).abs() < 1e-12);
        }
    }

    #[test]
    fn simpson_is_exact_for_cubics_and_the_trapezoid_rule_is_not() {
        // The square root of a cubic along x, so that its square is one: the integral of x³ over 0..1 is 1/4.
        let values = std::array::from_fn(|i| (0.5 * (i % 3) as f64).powf(1.5));
        assert!((mean_square(&values, [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]) - 0.25).abs() < 1e-12);
        assert_eq!(mean_square(&values, [0.25, 0.5, 0.25]), 0.3125);
    }

    #[test]
    fn only_the_rule_by_distance_looks_at_the_distance() {
        for rule in [Termination::Trapezoid, Termination::Simpson, Termination::MaxError] {
            assert_eq!(greatest_peak(rule, 0.0), greatest_peak(rule, -9.0), "{rule:?}");
        }
        // One is near enough; beyond, twice as far is twice as much.
        assert_eq!(greatest_peak(Termination::ByDistance, 1.0), greatest_peak(Termination::Trapezoid, 1.0));
        assert_eq!(criterion(Termination::ByDistance).tolerance(-2.0), 2.0);
        assert!(criterion(Termination::ByDistance).is_met(&peak(5.6, 2.0)));
        assert!(!criterion(Termination::ByDistance).is_met(&peak(5.7, -2.0)));
    }
}
