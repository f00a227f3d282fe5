//! The reader as a WebAssembly module: no imports, no allocator, one linear memory that its user divides.
//!
//! From `__heap_base` on the memory belongs to the user (`src/memory.ts`), who puts the bytes of a file there, room for a
//! [`Field`] of [`field_size`] bytes, and points and answers, and grows the memory when it is too small. Coordinates are
//! `f32`; points are triples of them.
//!
//! # Safety
//!
//! Of every function: pointers are aligned to 4 bytes and point to as much memory as is named, of which no two parts that
//! are written overlap others; `field` was filled by an [`open`] that returned 0, and its file has not changed since.
#![no_std]

use core::slice;
use reader::{Aabb, ErrorStatistics, Raycast};

mod family;
use family::Field;

/// What happens when nothing can: the reader cannot panic, and this file does not.
#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}

/// Bytes that a field takes beside its file.
#[unsafe(no_mangle)]
pub extern "C" fn field_size() -> usize {
    size_of::<Field>()
}

/// Opens and validates the field of `length` bytes at `file`, and puts it at `field`.
///
/// Returns 0, or the number of the rule that they break, from 1 in the order of [`reader::Error::ALL`]: `ts/rules.ts` has the
/// words, for which there is no room here.
///
/// # Safety
/// See the module; the file stays where it is for as long as the field is used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn open(file: *const u8, length: usize, field: *mut Field) -> u32 {
    // SAFETY: as the caller says.
    unsafe { open_by(family::OPEN, file, length, field) }
}

/// [`Field::open_prefix`](reader::Field::open_prefix), otherwise as [`open`]. Only in the module of every family.
///
/// # Safety
/// As for [`open`].
#[cfg(not(any(feature = "only-grid", feature = "only-octree", feature = "only-polynomial")))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn open_prefix(file: *const u8, length: usize, field: *mut Field) -> u32 {
    // SAFETY: as the caller says.
    unsafe { open_by(reader::Field::open_prefix, file, length, field) }
}

/// Opens in one way or another.
///
/// # Safety
/// As for [`open`].
unsafe fn open_by(open: family::Open, file: *const u8, length: usize, field: *mut Field) -> u32 {
    // SAFETY: the caller says that so many bytes are there, and that they stay.
    let bytes: &'static [u8] = unsafe { slice::from_raw_parts(file, length) };
    match open(bytes).and_then(|field| field.validate().map(|()| field)) {
        Ok(opened) => {
            // SAFETY: the caller says that the field fits here.
            unsafe { field.write(opened) };
            0
        }
        Err(error) => 1 + error as u32,
    }
}

/// [`Field::lod`]: puts the level at `lod`, which shares the file. Returns whether there is one.
///
/// # Safety
/// See the module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn lod(field: &Field, level: usize, lod: *mut Field) -> bool {
    let found = field.lod(level);
    if let Some(found) = found {
        // SAFETY: the caller says that the field fits here.
        unsafe { lod.write(found) };
    }
    found.is_some()
}

/// What a field is, as [`describe`] writes it: 19 numbers of 4 bytes.
#[repr(C)]
pub struct Description {
    bounds: [[f32; 3]; 2],
    diagonal: f32,
    target_error: f32,
    lipschitz: f32,
    uniform: [f32; 3],
    band: [f32; 3],
    seam_max: f32,
    max_error: f32,
    sample_count: u32,
    doubtful_signs: u32,
}

/// Writes what a field is.
///
/// # Safety
/// See the module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn describe(field: &Field, description: *mut Description) {
    let header = field.header();
    let contract = field.contract();
    let Aabb { min, max } = header.bounds;
    let statistics = |ErrorStatistics { rmse, p99, max }: ErrorStatistics| [rmse, p99, max];
    let filled = Description {
        bounds: [min, max],
        diagonal: header.diagonal,
        target_error: header.target_error,
        lipschitz: header.lipschitz,
        uniform: statistics(contract.uniform),
        band: statistics(contract.band),
        seam_max: contract.seam_max,
        max_error: contract.max_error(),
        sample_count: contract.sample_count,
        doubtful_signs: contract.doubtful_signs,
    };
    // SAFETY: the caller says that it fits here.
    unsafe { description.write(filled) };
}

/// [`Field::distance`].
#[unsafe(no_mangle)]
pub extern "C" fn distance(field: &Field, x: f32, y: f32, z: f32) -> f32 {
    field.distance([x, y, z])
}

/// [`Field::clearance`].
#[unsafe(no_mangle)]
pub extern "C" fn clearance(field: &Field, x: f32, y: f32, z: f32) -> f32 {
    field.clearance([x, y, z])
}

/// [`Field::distances`] of `count` points.
///
/// # Safety
/// See the module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn distances(field: &Field, points: *const [f32; 3], distances: *mut f32, count: usize) {
    // SAFETY: the caller says that so many points are there, and room for as many distances.
    let (points, distances) =
        unsafe { (slice::from_raw_parts(points, count), slice::from_raw_parts_mut(distances, count)) };
    family::distances(field, points, distances);
}

/// [`Field::distances_and_gradients`] of `count` points.
///
/// # Safety
/// See the module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn distances_and_gradients(
    field: &Field,
    points: *const [f32; 3],
    distances: *mut f32,
    gradients: *mut [f32; 3],
    count: usize,
) {
    // SAFETY: the caller says that so many points are there, and room for as many distances and gradients.
    let (points, distances, gradients) = unsafe {
        (
            slice::from_raw_parts(points, count),
            slice::from_raw_parts_mut(distances, count),
            slice::from_raw_parts_mut(gradients, count),
        )
    };
    family::distances_and_gradients(field, points, distances, gradients);
}

/// [`Field::raycast`] of a `ray`: origin, direction, length, within. Writes to `hit`: distance, point, normal.
///
/// Returns 1 for a hit, 0 for a miss, and 2 when the steps ran out, with how far the ray is clear as the distance.
///
/// # Safety
/// See the module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn raycast(field: &Field, ray: &[f32; 8], hit: *mut [f32; 7]) -> u32 {
    let [x, y, z, along_x, along_y, along_z, length, within] = *ray;
    let (kind, numbers) = match field.raycast([x, y, z], [along_x, along_y, along_z], length, within) {
        Raycast::Miss { .. } => (0, [0.0; 7]),
        Raycast::Hit(hit) => {
            let ([x, y, z], [normal_x, normal_y, normal_z]) = (hit.point, hit.normal);
            (1, [hit.distance, x, y, z, normal_x, normal_y, normal_z])
        }
        Raycast::OutOfSteps { clear } => (2, [clear, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
    };
    // SAFETY: the caller says that the numbers fit here.
    unsafe { hit.write(numbers) };
    kind
}

/// [`Field::closest_point`]: writes the point to `end`, and returns the residual.
///
/// # Safety
/// See the module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn closest_point(field: &Field, x: f32, y: f32, z: f32, end: *mut [f32; 3]) -> f32 {
    let closest = field.closest_point([x, y, z]);
    // SAFETY: the caller says that the point fits here.
    unsafe { end.write(closest.point) };
    closest.residual
}
