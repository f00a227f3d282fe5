//! The handle of a cursor.

use crate::field::NearfieldField;
use crate::opaque;
use crate::vector::{NearfieldSample, NearfieldVector};
use core::mem::MaybeUninit;
use nearfield::Cursor;

/// What `is_open` holds while `reader` does.
const OPEN: u64 = 0x4e46_6375_7273_0001;

/// Answers queries that are near one another faster: a ray's steps, a particle's path, the points of a row. It remembers the
/// leaf of the last query. 1024 bytes, on every machine; the members are the library's. It borrows the bytes, not the handle
/// of the field.
#[repr(C)]
pub struct NearfieldCursor {
    is_open: u64,
    reader: [MaybeUninit<u64>; 127],
}

impl NearfieldCursor {
    fn reader(handle: Option<&mut Self>) -> Option<&mut Cursor<'_>> {
        let handle = handle.filter(|handle| handle.is_open == OPEN)?;
        // SAFETY: `nearfield_cursor` alone sets `is_open`, after it has put a cursor into the room.
        Some(unsafe { opaque::get_mut::<Cursor<'_>, 127>(&mut handle.reader) })
    }
}

/// Makes a cursor of a field. Nothing happens if `cursor` is NULL; unless the field is open, neither is the cursor.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_cursor(field: Option<&NearfieldField>, cursor: Option<&mut MaybeUninit<NearfieldCursor>>) {
    let Some(cursor) = cursor else { return };
    let cursor = cursor.write(NearfieldCursor { is_open: 0, reader: [const { MaybeUninit::uninit() }; 127] });
    if let Some(reader) = NearfieldField::reader(field) {
        opaque::put(&mut cursor.reader, reader.cursor());
        cursor.is_open = OPEN;
    }
}

/// nearfield_distance, to the bit.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_cursor_distance(cursor: Option<&mut NearfieldCursor>, point: NearfieldVector) -> f32 {
    NearfieldCursor::reader(cursor).map_or(f32::NAN, |reader| reader.distance(point.into()))
}

/// nearfield_distance_and_gradient, to the bit.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_cursor_distance_and_gradient(
    cursor: Option<&mut NearfieldCursor>,
    point: NearfieldVector,
) -> NearfieldSample {
    let answer = |reader: &mut Cursor<'_>| reader.distance_and_gradient(point.into()).into();
    NearfieldCursor::reader(cursor).map_or(NearfieldSample::NAN, answer)
}
