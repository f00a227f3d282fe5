//! Walks through a field: along a ray, and down to the surface.

use crate::field::NearfieldField;
use crate::vector::NearfieldVector;
use nearfield::Raycast;

/// Where a ray starts, where it goes, and how far.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearfieldRay {
    /// Mesh units, mesh frame.
    pub origin: NearfieldVector,
    /// Of any length but 0.
    pub direction: NearfieldVector,
    /// Mesh units; may be infinite.
    pub length: f32,
    /// The ray ends where the field is at most so much, mesh units: the largest measured error to stop before the true
    /// surface, 0 to stop on that of the field. No less than 2^-20 of the box's longest side counts.
    pub within: f32,
}

/// What became of a ray.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NearfieldRayEnd {
    /// The ray left the box or ended first; or it is not finite, has no direction, or the handle is not open.
    Miss = 0,
    /// It met the surface.
    Hit = 1,
    /// It grazed the surface for longer than its 512 steps: clear up to `distance`.
    OutOfSteps = 2,
}

/// The end of a ray.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearfieldRayHit {
    /// What became of it.
    pub end: NearfieldRayEnd,
    /// Queries that it took, at most 512.
    pub steps: u32,
    /// Along the ray from its origin, mesh units; of a miss 0.
    pub distance: f32,
    /// On the ray, inside the box; of a hit alone, else 0.
    pub point: NearfieldVector,
    /// Unit gradient at the point, or zero where the field has none; of a hit alone, else 0.
    pub normal: NearfieldVector,
}

/// The end of a descent to the surface.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearfieldClosestPoint {
    /// Inside the box; mesh units, mesh frame.
    pub point: NearfieldVector,
    /// The field there, mesh units: how far the descent stayed from the surface.
    pub residual: f32,
    /// Queries that it took, at most 16.
    pub steps: u32,
}

/// Follows a ray to the surface, inside the box of the field, with at most 512 queries.
///
/// No step is longer than the field divided by its stored bound of the slope: on a continuous field the ray passes no wall,
/// however thin, but for the rounding of a coordinate. A field that was baked without continuity has no such guarantee.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_raycast(field: Option<&NearfieldField>, ray: NearfieldRay) -> NearfieldRayHit {
    let NearfieldRay { origin, direction, length, within } = ray;
    let zero = NearfieldVector::from([0.0; 3]);
    let nothing = NearfieldRayHit { end: NearfieldRayEnd::Miss, steps: 0, distance: 0.0, point: zero, normal: zero };
    let Some(reader) = NearfieldField::reader(field) else { return nothing };
    match reader.raycast(origin.into(), direction.into(), length, within) {
        Raycast::Hit(hit) => NearfieldRayHit {
            end: NearfieldRayEnd::Hit,
            steps: hit.steps,
            distance: hit.distance,
            point: hit.point.into(),
            normal: hit.normal.into(),
        },
        Raycast::Miss { steps } => NearfieldRayHit { steps, ..nothing },
        Raycast::OutOfSteps { clear } => {
            NearfieldRayHit { end: NearfieldRayEnd::OutOfSteps, steps: 512, distance: clear, ..nothing }
        }
    }
}

/// Goes down the gradient to the surface, with at most 16 queries.
///
/// The end is inside the box and no farther from the surface than the start. That it is the closest point is not promised.
/// NaN and 0 steps if the handle is not open.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_closest_point(
    field: Option<&NearfieldField>,
    point: NearfieldVector,
) -> NearfieldClosestPoint {
    let Some(reader) = NearfieldField::reader(field) else {
        return NearfieldClosestPoint { point: NearfieldVector::NAN, residual: f32::NAN, steps: 0 };
    };
    let end = reader.closest_point(point.into());
    NearfieldClosestPoint { point: end.point.into(), residual: end.residual, steps: end.steps }
}
