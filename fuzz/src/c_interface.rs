//! The C interface answers as the reader does, and touches no byte but those it was given.

use crate::reading::points;
use crate::structure::repair;
use nearfield::{Field, Raycast};
use nearfield_c::*;
use std::mem::MaybeUninit;

/// The last bytes choose strides and offsets, all are the file: what the C interface says of it is what the reader does.
///
/// Under AddressSanitizer a byte read or written beyond what was given shows.
pub fn c_interface(bytes: &[u8]) {
    let mut bytes = bytes.to_vec();
    repair(&mut bytes);
    // Of exactly its length, anywhere in memory.
    let bytes = bytes.into_boxed_slice();

    let mut handle = MaybeUninit::<NearfieldField>::uninit();
    // SAFETY: the bytes outlive the handle, and there is memory for one.
    let result = unsafe { nearfield_open(handle.as_mut_ptr(), bytes.as_ptr().cast(), bytes.len()) };
    // SAFETY: `nearfield_open` writes the handle, whatever it answers.
    let handle = unsafe { handle.assume_init() };
    let field = match Field::open(&bytes) {
        Ok(field) => field,
        Err(error) => {
            assert_eq!(result, error.into());
            assert!(nearfield_distance(Some(&handle), [0.0; 3].into()).is_nan(), "a handle that did not open answers");
            return;
        }
    };
    assert_eq!(result, NearfieldResult::Ok);
    let expected = field.validate().map_or_else(NearfieldResult::from, |()| NearfieldResult::Ok);
    assert_eq!(nearfield_validate(Some(&handle)), expected);
    assert_eq!(nearfield_info(Some(&handle)).lipschitz.to_bits(), field.header().lipschitz.to_bits());

    let points: Vec<[f32; 3]> = points(&field, &bytes).collect();
    one_by_one(&handle, &field, &points);
    levels(&handle, &field, &points);
    in_batches(&handle, &field, &points, &bytes);
}

fn bits(numbers: impl Into<[f32; 3]>) -> [u32; 3] {
    numbers.into().map(f32::to_bits)
}

/// Levels of detail, and one more than there are.
fn levels(handle: &NearfieldField, field: &Field<'_>, points: &[[f32; 3]]) {
    let count = nearfield_lod_count(Some(handle));
    assert_eq!(count, field.lod_count());
    for number in 0..=count {
        let mut level = *handle;
        let place: *mut NearfieldField = &mut level;
        // SAFETY: a handle, and room for one in the same place.
        let result = unsafe { nearfield_lod(place, place, number) };
        match field.lod(number) {
            Some(expected) => one_by_one(&level, &expected, points),
            None => {
                assert_eq!(result, NearfieldResult::NoLod);
                assert!(
                    nearfield_distance(Some(&level), [0.0; 3].into()).is_nan(),
                    "a level that there is not answers"
                );
            }
        }
    }
}

fn one_by_one(handle: &NearfieldField, field: &Field<'_>, points: &[[f32; 3]]) {
    let mut room = MaybeUninit::uninit();
    nearfield_cursor(Some(handle), Some(&mut room));
    // SAFETY: `nearfield_cursor` writes the handle.
    let mut cursor = unsafe { room.assume_init() };
    let handle = Some(handle);
    for &point in points {
        let (distance, gradient) = field.distance_and_gradient(point);
        assert_eq!(nearfield_distance(handle, point.into()).to_bits(), distance.to_bits(), "at {point:?}");
        let sample = nearfield_cursor_distance_and_gradient(Some(&mut cursor), point.into());
        for sample in [nearfield_distance_and_gradient(handle, point.into()), sample] {
            assert_eq!(sample.distance.to_bits(), distance.to_bits(), "at {point:?}");
            assert_eq!(bits(sample.gradient), bits(gradient), "at {point:?}");
        }
        assert_eq!(bits(nearfield_normal(handle, point.into())), bits(field.normal(point)), "at {point:?}");
        assert_eq!(nearfield_clearance(handle, point.into()).to_bits(), field.clearance(point).to_bits());
        assert_eq!(nearfield_is_clear(handle, point.into(), 0.1), field.is_clear(point, 0.1));
    }

    // These take hundreds of queries: one each.
    let (Some(&from), Some(&to)) = (points.first(), points.last()) else { return };
    let end = nearfield_closest_point(handle, from.into());
    let expected = field.closest_point(from);
    assert_eq!((bits(end.point), end.steps), (bits(expected.point), expected.steps), "from {from:?}");
    let ray = NearfieldRay { origin: from.into(), direction: to.into(), length: f32::INFINITY, within: 0.0 };
    let end = nearfield_raycast(handle, ray);
    let agrees = match field.raycast(from, to, f32::INFINITY, 0.0) {
        Raycast::Hit(hit) => end.end == NearfieldRayEnd::Hit && bits(end.point) == bits(hit.point),
        Raycast::Miss { steps } => end.end == NearfieldRayEnd::Miss && end.steps == steps,
        Raycast::OutOfSteps { clear } => {
            end.end == NearfieldRayEnd::OutOfSteps && end.distance.to_bits() == clear.to_bits()
        }
    };
    assert!(agrees, "the ray from {from:?} along {to:?} ends otherwise: {end:?}");
}

/// Records that hold a point, a distance and a gradient in some order, with gaps and without alignment.
fn in_batches(handle: &NearfieldField, field: &Field<'_>, points: &[[f32; 3]], bytes: &[u8]) {
    let choice = |from_end: usize| usize::from(*bytes.iter().nth_back(from_end).unwrap_or(&0)) % 8;
    let (shift, gap) = (choice(0), choice(1));
    // Over the point itself, or after it.
    let gradient_at = if choice(2) == 0 { 0 } else { 12 };
    let distance_at = gradient_at + 12;
    let stride = 28 + gap;
    let mut records = vec![0xA5_u8; shift + points.len() * stride];
    for (record, point) in records[shift..].chunks_exact_mut(stride).zip(points) {
        record[..12].copy_from_slice(bytes_of(point));
    }
    let start: *mut u8 = records[shift..].as_mut_ptr();
    // SAFETY: `shift` and a record for each point fit the buffer, and the parts of a record fit the record.
    let written = unsafe {
        nearfield_distances_and_gradients(
            Some(handle),
            start.cast(),
            stride,
            start.byte_add(distance_at).cast(),
            stride,
            start.byte_add(gradient_at).cast(),
            stride,
            points.len(),
        )
    };
    assert_eq!(written, points.len());
    for (record, &point) in records[shift..].chunks_exact(stride).zip(points) {
        let (distance, gradient) = field.distance_and_gradient(point);
        assert_eq!(record[distance_at..][..4], distance.to_ne_bytes(), "at {point:?}");
        assert_eq!(record[gradient_at..][..12], *bytes_of(&gradient), "at {point:?}");
        assert!(record[28..].iter().all(|&byte| byte == 0xA5), "a gap was written");
    }
    assert!(records[..shift].iter().all(|&byte| byte == 0xA5), "bytes before the records were written");
}

fn bytes_of(numbers: &[f32; 3]) -> &[u8] {
    bytemuck::bytes_of(numbers)
}
