//! The handle of a field.

use crate::opaque;
use crate::result::NearfieldResult;
use core::ffi::c_void;
use core::mem::MaybeUninit;
use core::slice;
use nearfield::Field;

/// What `is_open` holds while `reader` does: unlikely in memory that was never opened.
const OPEN: u64 = 0x4e46_6965_6c64_0001;

/// A field that is open for queries. 256 bytes, on every machine; the members are the library's.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct NearfieldField {
    is_open: u64,
    reader: [MaybeUninit<u64>; 31],
}

impl NearfieldField {
    /// The reader in a handle, unless there is none.
    #[inline]
    pub(crate) fn reader(handle: Option<&Self>) -> Option<&Field<'_>> {
        let handle = handle.filter(|handle| handle.is_open == OPEN)?;
        // SAFETY: `nearfield_open` alone sets `is_open`, after it has put a field into the room.
        Some(unsafe { opaque::get::<Field<'_>, 31>(&handle.reader) })
    }
}

/// Opens the field in `length` bytes, in constant time, after checking its header and parameters.
///
/// The handle keeps a pointer to the bytes. `bytes` may be NULL if `length` is 0. Unless it succeeds the handle is not
/// open. NEARFIELD_RESULT_NULL if `field` is NULL, or `bytes` is and `length` is not 0.
///
/// # Safety
///
/// `bytes` points to `length` bytes that stay as they are while the handle is in use, and `field` to memory for a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn nearfield_open(
    field: *mut NearfieldField,
    bytes: *const c_void,
    length: usize,
) -> NearfieldResult {
    if field.is_null() || bytes.is_null() && length != 0 {
        return NearfieldResult::Null;
    }
    // SAFETY: not NULL, and the caller gives memory for a handle. It need not hold one yet: it is written before it is read.
    let handle = unsafe {
        field.write(NearfieldField { is_open: 0, reader: [const { MaybeUninit::uninit() }; 31] });
        &mut *field
    };
    // More than the address space holds cannot be a field, nor a slice.
    if length > isize::MAX as usize {
        return NearfieldResult::FileLength;
    }
    let bytes = if length == 0 {
        &[]
    } else {
        // SAFETY: not NULL, and the caller promises that so many bytes are there for as long as the handle is used.
        unsafe { slice::from_raw_parts(bytes.cast::<u8>(), length) }
    };

    match Field::open(bytes) {
        Ok(reader) => {
            opaque::put(&mut handle.reader, reader);
            handle.is_open = OPEN;
            NearfieldResult::Ok
        }
        Err(error) => error.into(),
    }
}

/// Checks every byte of the field against the format, in time proportional to the file and without memory.
///
/// NEARFIELD_RESULT_NOT_OPEN if the handle is not open.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_validate(field: Option<&NearfieldField>) -> NearfieldResult {
    match NearfieldField::reader(field) {
        Some(reader) => reader.validate().map_or_else(NearfieldResult::from, |()| NearfieldResult::Ok),
        None => NearfieldResult::NotOpen,
    }
}
