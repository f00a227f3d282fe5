//! Queries at many points.

use crate::field::NearfieldField;

/// nearfield_distance at `count` points. Returns how many answers were written: `count`, or 0 if the handle is not open or a
/// pointer is NULL.
///
/// A point is three floats in a row, x, y, z; `point_stride` is the number of bytes from one to the next, 12 where there is
/// nothing between them, and likewise `distance_stride`, 4. No alignment is required. Answers may go into the records of
/// their own points, beside or over them: a point is read before its answer is written, in order.
///
/// # Safety
///
/// There are `count` points and room for as many distances at these strides.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn nearfield_distances(
    field: Option<&NearfieldField>,
    points: *const f32,
    point_stride: usize,
    distances: *mut f32,
    distance_stride: usize,
    count: usize,
) -> usize {
    let Some(reader) = NearfieldField::reader(field) else { return 0 };
    if points.is_null() || distances.is_null() {
        return 0;
    }
    for index in 0..count {
        // SAFETY: not NULL; the caller promises that point and room `index` are where the strides put them.
        unsafe {
            let point = points.byte_add(index * point_stride).cast::<[f32; 3]>().read_unaligned();
            distances.byte_add(index * distance_stride).write_unaligned(reader.distance(point));
        }
    }
    count
}

/// nearfield_distance_and_gradient at `count` points. Returns how many answers were written, as nearfield_distances.
///
/// Strides as there; a gradient is three floats in a row.
///
/// # Safety
///
/// There are `count` points and room for as many distances and gradients at these strides.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn nearfield_distances_and_gradients(
    field: Option<&NearfieldField>,
    points: *const f32,
    point_stride: usize,
    distances: *mut f32,
    distance_stride: usize,
    gradients: *mut f32,
    gradient_stride: usize,
    count: usize,
) -> usize {
    let Some(reader) = NearfieldField::reader(field) else { return 0 };
    if points.is_null() || distances.is_null() || gradients.is_null() {
        return 0;
    }
    for index in 0..count {
        // SAFETY: not NULL; the caller promises that point and rooms `index` are where the strides put them.
        unsafe {
            let point = points.byte_add(index * point_stride).cast::<[f32; 3]>().read_unaligned();
            let (distance, gradient) = reader.distance_and_gradient(point);
            distances.byte_add(index * distance_stride).write_unaligned(distance);
            gradients.byte_add(index * gradient_stride).cast::<[f32; 3]>().write_unaligned(gradient);
        }
    }
    count
}
