//! The handle of a field.

use crate::opaque;
use crate::result::NearfieldResult;
use core::ffi::c_void;
use core::mem::MaybeUninit;
use core::slice;
use nearfield::{Error, Field};

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
    /// A handle without a reader.
    pub(crate) const CLOSED: Self = Self { is_open: 0, reader: [const { MaybeUninit::uninit() }; 31] };

    /// A handle with a reader.
    pub(crate) fn holding(reader: Field<'_>) -> Self {
        let mut handle = Self::CLOSED;
        opaque::put(&mut handle.reader, reader);
        Self { is_open: OPEN, ..handle }
    }

    /// The reader in a handle, unless there is none.
    #[inline]
    pub(crate) fn reader(handle: Option<&Self>) -> Option<&Field<'_>> {
        let handle = handle.filter(|handle| handle.is_open == OPEN)?;
        // SAFETY: `holding` alone sets `is_open`, after it has put a field into the room.
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
    // SAFETY: the caller's promises are the same.
    unsafe { open_with(Field::open, field, bytes, length) }
}

/// Opens the finest level of detail that is whole in the first `length` bytes of a file, or the field itself once these are
/// all its bytes: what a program can ask while the rest still arrives.
///
/// As nearfield_open; NEARFIELD_RESULT_TRUNCATED while there is none yet.
///
/// # Safety
///
/// As of nearfield_open.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn nearfield_open_prefix(
    field: *mut NearfieldField,
    bytes: *const c_void,
    length: usize,
) -> NearfieldResult {
    // SAFETY: the caller's promises are the same.
    unsafe { open_with(Field::open_prefix, field, bytes, length) }
}

/// Opens a field in one way or another.
///
/// # Safety
///
/// As of [`nearfield_open`].
unsafe fn open_with(
    open: impl FnOnce(&'static [u8]) -> Result<Field<'static>, Error>,
    field: *mut NearfieldField,
    bytes: *const c_void,
    length: usize,
) -> NearfieldResult {
    if field.is_null() || bytes.is_null() && length != 0 {
        return NearfieldResult::Null;
    }
    // SAFETY: not NULL, and the caller gives memory for a handle. It need not hold one yet: it is written before it is read.
    let handle = unsafe {
        field.write(NearfieldField::CLOSED);
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

    match open(bytes) {
        Ok(reader) => {
            *handle = NearfieldField::holding(reader);
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
