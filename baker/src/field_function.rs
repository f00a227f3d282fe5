//! The door between what is sampled (a mesh, a formula) and what samples it.

use glam::DVec3;
use rayon::prelude::*;

/// Signed distance and gradient at one point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Signed distance, mesh units, negative inside.
    pub distance: f64,
    /// Gradient of the distance, a unit vector for an exact distance field. Fields are fitted to it, too: it has to be the
    /// slope of `distance`.
    pub gradient: DVec3,
}

/// A signed distance field that can be sampled anywhere.
///
/// The answer at a point must depend on the point alone, never on the order of the questions:
/// the bytes of a baked field rest on it.
pub trait FieldFunction: Sync {
    /// Samples one point.
    fn sample(&self, point: DVec3) -> Sample;

    /// Samples many points in parallel. Neighbours in the slice should be neighbours in space.
    fn sample_all(&self, points: &[DVec3]) -> Vec<Sample> {
        points.par_iter().map(|&point| self.sample(point)).collect()
    }

    /// Whether the sign at this point is a guess.
    fn sign_is_doubtful(&self, _point: DVec3) -> bool {
        false
    }
}

/// A signed distance function made of a closure that gives the distance at a point, mesh units.
///
/// The gradient is a central difference over `step` in each direction, six more calls a sample: about 1e-5
/// of the shape's size loses least to the curvature on one side and to rounding on the other.
#[derive(Clone, Copy, Debug)]
pub struct Closure<F> {
    /// The distance.
    pub distance: F,
    /// Half the width of the differences, mesh units, positive.
    pub step: f64,
}

impl<F: Fn(DVec3) -> f64 + Sync> FieldFunction for Closure<F> {
    fn sample(&self, point: DVec3) -> Sample {
        let slope = |axis: DVec3| {
            let offset = axis * self.step;
            ((self.distance)(point + offset) - (self.distance)(point - offset)) / (2.0 * self.step)
        };
        let gradient = DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z));
        Sample { distance: (self.distance)(point), gradient }
    }
}

/// A closure that gives distance and gradient.
#[derive(Clone, Copy, Debug)]
pub struct SampleClosure<F>(pub F);

impl<F: Fn(DVec3) -> Sample + Sync> FieldFunction for SampleClosure<F> {
    fn sample(&self, point: DVec3) -> Sample {
        (self.0)(point)
    }
}
