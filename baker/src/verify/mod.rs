//! What a finished field is worth: the shipping reader's answers beside the truth.

mod contradiction;
mod difference;
mod distribution;
mod points;
mod seams;

pub use contradiction::{Contradiction, MIN_FRESH_SAMPLES, exceeds, refutes};
pub use difference::{FieldDifference, compare};
pub use distribution::ErrorDistribution;
pub use seams::{SeamBound, SeamStatistics};

use crate::field_function::{FieldFunction, Sample};
use crate::geometry::Aabb;
use crate::mesh::CheckedMesh;
use crate::settings::Profile;
use glam::DVec3;
use nearfield::{ErrorContract, ErrorStatistics, Field};
use rayon::prelude::*;

/// The band: points whose distance is at most this fraction of the diagonal.
pub const BAND: f64 = 0.01;
/// Seed of the points behind the contract in a file's header.
pub const CONTRACT_SEED: u64 = 0;

/// Doubtful places that a measurement lists.
const PLACES: usize = 64;

/// What was measured. Lengths in mesh units.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// Over points uniform in the mesh's box.
    pub uniform: ErrorDistribution,
    /// Over points near the surface: evenly by area, moved by up to [`BAND`] of the diagonal in a random
    /// direction; those outside the field's box are left out.
    pub band: ErrorDistribution,
    /// Across the faces between leaves.
    pub seams: SeamStatistics,
    /// Points asked for, uniform and again in the band.
    pub samples: u32,
    /// Length of the longest gradient met at any of the points and on either side of the faces.
    pub steepest: f64,
    /// Points, of both sets, whose true sign is a guess.
    pub doubtful_signs: usize,
    /// The first of these, mesh frame.
    pub doubtful_places: Vec<[f32; 3]>,
}

/// Measures a field against the truth at random points that depend on the mesh, `samples` and `seed`
/// alone, never on threads or the machine.
///
/// The field should be valid ([`Field::validate`]) and baked from this mesh.
pub fn measure(
    field: &Field<'_>,
    truth: &dyn FieldFunction,
    mesh: &CheckedMesh,
    samples: u32,
    seed: u64,
) -> Measurement {
    let reach = BAND * mesh.bounds.diagonal();
    let near = points::near_surface(mesh, reach, samples as usize, seed);
    measure_at(field, truth, &mesh.bounds, near, samples, seed)
}

/// Measures a field against a function, as [`measure`] does against a mesh, in this box.
///
/// The points of the band come from points of the box that were moved along the gradient until they met
/// the function's zero set; those that did not are left out.
pub fn measure_function(
    field: &Field<'_>,
    truth: &dyn FieldFunction,
    bounds: &Aabb,
    samples: u32,
    seed: u64,
) -> Measurement {
    let near = points::near_zero(truth, bounds, BAND * bounds.diagonal(), samples as usize, seed);
    measure_at(field, truth, bounds, near, samples, seed)
}

fn measure_at(
    field: &Field<'_>,
    truth: &dyn FieldFunction,
    bounds: &Aabb,
    near: Vec<[f32; 3]>,
    samples: u32,
    seed: u64,
) -> Measurement {
    // Uniform in the box.
    let points = points::uniform(bounds, samples as usize, seed);
    let exact = sample(truth, &points);
    let found = answers(field, &points);
    let uniform = ErrorDistribution::of(&found, &exact);
    let mut steepest = steepest_of(&found);
    let mut doubtful = find_doubtful(truth, &points);

    // In the band.
    let mut points = near;
    let domain = field_box(field);
    points.retain(|&point| contains(&domain, points::to_dvec3(point)));
    let exact = sample(truth, &points);
    let found = answers(field, &points);
    let band = ErrorDistribution::of(&found, &exact);
    steepest = steepest.max(steepest_of(&found));
    doubtful.extend(find_doubtful(truth, &points));

    // Across the faces.
    let seams = seams::measure(field, seed);
    steepest = steepest.max(seams.steepest);

    let doubtful_signs = doubtful.len();
    doubtful.truncate(PLACES);
    Measurement { uniform, band, seams, samples, steepest, doubtful_signs, doubtful_places: doubtful }
}

impl Measurement {
    /// The largest error where a profile bounds it, mesh units.
    pub fn greatest(&self, profile: Profile) -> f64 {
        match profile {
            Profile::Uniform => self.uniform.max().max(self.band.max()),
            Profile::Surface => self.band.max(),
        }
    }

    /// The figures as a file's header stores them.
    pub fn contract(&self) -> ErrorContract {
        let figures = |errors: &ErrorDistribution| ErrorStatistics {
            rmse: errors.rmse as f32,
            p99: errors.p99() as f32,
            max: errors.max() as f32,
        };
        ErrorContract {
            uniform: figures(&self.uniform),
            band: figures(&self.band),
            seam_max: self.seams.largest() as f32,
            sample_count: self.samples,
            doubtful_signs: u32::try_from(self.doubtful_signs).unwrap_or(u32::MAX),
        }
    }
}

fn sample(truth: &dyn FieldFunction, points: &[[f32; 3]]) -> Vec<Sample> {
    let points: Vec<DVec3> = points.iter().map(|&point| points::to_dvec3(point)).collect();
    truth.sample_all(&points)
}

fn answers(field: &Field<'_>, points: &[[f32; 3]]) -> Vec<(f32, [f32; 3])> {
    points.par_iter().map(|&point| field.distance_and_gradient(point)).collect()
}

/// Length of the longest gradient.
fn steepest_of(answers: &[(f32, [f32; 3])]) -> f64 {
    answers.par_iter().map(|(_, gradient)| points::to_dvec3(*gradient).length()).reduce(|| 0.0, f64::max)
}

fn find_doubtful(truth: &dyn FieldFunction, points: &[[f32; 3]]) -> Vec<[f32; 3]> {
    points.par_iter().copied().filter(|&point| truth.sign_is_doubtful(points::to_dvec3(point))).collect()
}

fn field_box(field: &Field<'_>) -> Aabb {
    let bounds = field.header().bounds;
    Aabb { min: points::to_dvec3(bounds.min), max: points::to_dvec3(bounds.max) }
}

fn contains(bounds: &Aabb, point: DVec3) -> bool {
    point.cmpge(bounds.min).all() && point.cmple(bounds.max).all()
}
