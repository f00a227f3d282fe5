//! Queries at one point or of one region.

use crate::field::NearfieldField;
use crate::vector::{NearfieldSample, NearfieldVector};
use nearfield::Aabb;

/// Bounds of a field over a box, mesh units.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearfieldRange {
    /// No value in the box is less.
    pub min: f32,
    /// No value in the box is greater.
    pub max: f32,
}

/// Signed distance from a point to the surface: mesh units, negative inside.
///
/// Finite for every finite point. Outside the box of the field it is the distance at the nearest point of the box plus the
/// distance to that point, an upper bound. NaN if a coordinate is NaN, infinite if one is infinite.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_distance(field: Option<&NearfieldField>, point: NearfieldVector) -> f32 {
    NearfieldField::reader(field).map_or(f32::NAN, |reader| reader.distance(point.into()))
}

/// Signed distance, as nearfield_distance to the bit, and gradient.
///
/// Inside the box the gradient is the derivative of the reconstruction, outside it the unit vector from the nearest point of
/// the box. NaN in all components if a coordinate is NaN.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_distance_and_gradient(
    field: Option<&NearfieldField>,
    point: NearfieldVector,
) -> NearfieldSample {
    let answer = |reader: &nearfield::Field<'_>| reader.distance_and_gradient(point.into()).into();
    NearfieldField::reader(field).map_or(NearfieldSample::NAN, answer)
}

/// Unit vector along the gradient at a point, or zero where there is none. NaN if a coordinate is.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_normal(field: Option<&NearfieldField>, point: NearfieldVector) -> NearfieldVector {
    NearfieldField::reader(field).map_or(NearfieldVector::NAN, |reader| reader.normal(point.into()).into())
}

/// How far a point is at least from the true surface, mesh units, as far as the measured errors go: the distance less the
/// largest of them. At most 0 where nothing is known, negative inside, never NaN; -INFINITY if the handle is not open.
///
/// Errors are measured at points when a field is baked: nothing is proved.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_clearance(field: Option<&NearfieldField>, point: NearfieldVector) -> f32 {
    NearfieldField::reader(field).map_or(f32::NEG_INFINITY, |reader| reader.clearance(point.into()))
}

/// Whether the clearance at a point exceeds `radius`, mesh units. False if the handle is not open.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_is_clear(field: Option<&NearfieldField>, centre: NearfieldVector, radius: f32) -> bool {
    NearfieldField::reader(field).is_some_and(|reader| reader.is_clear(centre.into(), radius))
}

/// Bounds of the field over the box from `min` to `max`, mesh units. Takes 64 queries.
///
/// Holds for a continuous field; one without continuity may exceed it by `seam_max`. Infinite both ways unless the corners are
/// finite and in order, and if the handle is not open.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_range(
    field: Option<&NearfieldField>,
    min: NearfieldVector,
    max: NearfieldVector,
) -> NearfieldRange {
    let region = Aabb { min: min.into(), max: max.into() };
    let everything = (f32::NEG_INFINITY, f32::INFINITY);
    let (min, max) = NearfieldField::reader(field).map_or(everything, |reader| reader.range(region));
    NearfieldRange { min, max }
}
