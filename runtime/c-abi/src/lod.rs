//! Levels of detail.

use crate::field::NearfieldField;
use crate::result::NearfieldResult;

/// How many levels of detail there are, the field itself among them: at least 1, but 0 if the handle is not open.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_lod_count(field: Option<&NearfieldField>) -> usize {
    NearfieldField::reader(field).map_or(0, |reader| reader.lod_count())
}

/// Opens a level of detail of an open field: 0 is the field itself, 1 the next coarser, and so on.
///
/// A level is a field of its own, in the same bytes: with every function, its own box and its own errors. Ask for it once,
/// then query it. `lod` and `field` may be the same handle. Unless it succeeds `lod` is not open. NEARFIELD_RESULT_NULL if
/// `lod` is NULL, NEARFIELD_RESULT_NOT_OPEN if `field` is not open, NEARFIELD_RESULT_NO_LOD if there is no such level.
///
/// # Safety
///
/// `lod` points to memory for a handle, and `field` to a handle; either may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn nearfield_lod(
    lod: *mut NearfieldField,
    field: *const NearfieldField,
    level: usize,
) -> NearfieldResult {
    // SAFETY: NULL or a handle, as the caller promises. The level borrows the bytes and not the handle, which may be `lod`.
    let reader = NearfieldField::reader(unsafe { field.as_ref() }).map(|reader| reader.lod(level));
    if lod.is_null() {
        return NearfieldResult::Null;
    }
    let (handle, result) = match reader {
        None => (NearfieldField::CLOSED, NearfieldResult::NotOpen),
        Some(None) => (NearfieldField::CLOSED, NearfieldResult::NoLod),
        Some(Some(reader)) => (NearfieldField::holding(reader), NearfieldResult::Ok),
    };
    // SAFETY: not NULL, and the caller gives memory for a handle.
    unsafe { lod.write(handle) };
    result
}
