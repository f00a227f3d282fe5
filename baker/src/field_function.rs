//! The door between what is sampled (a mesh, a formula) and what samples it.

use glam::DVec3;
use rayon::prelude::*;

/// Signed distance and gradient at one point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Signed distance, mesh units, negative inside.
    pub distance: f64,
    /// Gradient of the distance: a unit vector for an exact distance field.
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
