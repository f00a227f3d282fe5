//! One field beside another.

use super::distribution::ErrorDistribution;
use super::{BAND, CONTRACT_SEED, answers, field_box, points};
use crate::field_function::Sample;
use crate::geometry::Aabb;
use crate::random::Draws;
use glam::DVec3;
use nearfield::Field;
use rayon::prelude::*;

/// How far a second field is from a first one. Lengths in mesh units.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldDifference {
    /// Over points uniform in the box that both share.
    pub uniform: ErrorDistribution,
    /// Over points of that box moved toward the first field's surface, to within the band of it as far as one step of
    /// its distance and gradient leads there.
    pub near_surface: ErrorDistribution,
}

/// Compares field `b` with field `a` at points that depend on the fields and `samples` alone, or at none when their
/// boxes share nothing.
pub fn compare(a: &Field<'_>, b: &Field<'_>, samples: u32) -> Option<FieldDifference> {
    let (a_box, b_box) = (field_box(a), field_box(b));
    let shared = Aabb { min: a_box.min.max(b_box.min), max: a_box.max.min(b_box.max) };
    if shared.min.cmpge(shared.max).any() {
        return None;
    }
    let everywhere = points::uniform(&shared, samples as usize, CONTRACT_SEED);

    let reach = BAND * f64::from(a.header().diagonal);
    let near = everywhere.par_iter().enumerate().map(|(index, &point)| {
        let (distance, gradient) = a.distance_and_gradient(point);
        let gradient = to_dvec3(gradient);
        let onto = to_dvec3(point) - gradient * (f64::from(distance) / gradient.length_squared().max(0.25));
        let aside = Draws::new(CONTRACT_SEED, NEAR, index as u64).direction() * reach;
        (onto + aside).clamp(shared.min, shared.max).as_vec3().to_array()
    });
    let near: Vec<[f32; 3]> = near.collect();

    Some(FieldDifference { uniform: distribution(a, b, &everywhere), near_surface: distribution(a, b, &near) })
}

/// Stream of the random directions: any that the points of the contract do not use.
const NEAR: u64 = 0x6e65_6172;

fn distribution(a: &Field<'_>, b: &Field<'_>, points: &[[f32; 3]]) -> ErrorDistribution {
    let reference: Vec<Sample> = answers(a, points)
        .into_iter()
        .map(|(distance, gradient)| Sample { distance: f64::from(distance), gradient: to_dvec3(gradient) })
        .collect();
    ErrorDistribution::of(&answers(b, points), &reference)
}

fn to_dvec3(vector: [f32; 3]) -> DVec3 {
    glam::Vec3::from_array(vector).as_dvec3()
}
