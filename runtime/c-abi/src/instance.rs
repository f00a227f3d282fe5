//! The handle of a field that is placed in a world.

use crate::field::NearfieldField;
use crate::opaque;
use crate::result::NearfieldResult;
use crate::vector::{NearfieldSample, NearfieldVector};
use core::mem::MaybeUninit;
use nearfield::Instance;

/// What `is_open` holds while `reader` does.
const OPEN: u64 = 0x4e46_696e_7374_0001;

/// Where a field is in a world: its point (x, y, z) is at x times `x_axis`, y times `y_axis` and z times `z_axis` from `origin`.
///
/// The axes are at right angles and equally long, within 1e-4 of that length: it is the scale, from 2^-20 to 2^20. They may
/// be left-handed, which mirrors the field. No factor turns the distances of a stretched field into the world's: bake the
/// stretched mesh instead.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearfieldPlacement {
    /// Where the x axis of the mesh points.
    pub x_axis: NearfieldVector,
    /// Its y axis.
    pub y_axis: NearfieldVector,
    /// Its z axis.
    pub z_axis: NearfieldVector,
    /// Where its origin is, in the units of the world.
    pub origin: NearfieldVector,
}

/// A field that was moved, turned, mirrored or uniformly scaled. 384 bytes, on every machine; the members are the library's. It
/// borrows the bytes of the field, not its handle.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct NearfieldInstance {
    is_open: u64,
    reader: [MaybeUninit<u64>; 47],
}

impl NearfieldInstance {
    fn reader(handle: Option<&Self>) -> Option<&Instance<'_>> {
        let handle = handle.filter(|handle| handle.is_open == OPEN)?;
        // SAFETY: `nearfield_instance` alone sets `is_open`, after it has put an instance into the room.
        Some(unsafe { opaque::get::<Instance<'_>, 47>(&handle.reader) })
    }
}

/// Places a field in a world. To move it, place it again: it takes a few dozen operations.
///
/// Unless it succeeds the instance is not open. NEARFIELD_RESULT_NULL if `instance` is NULL, NEARFIELD_RESULT_NOT_OPEN if the
/// field is not open, NEARFIELD_RESULT_NOT_A_SIMILARITY if the axes are not as they should be or a number is not finite.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_instance(
    field: Option<&NearfieldField>,
    placement: NearfieldPlacement,
    instance: Option<&mut MaybeUninit<NearfieldInstance>>,
) -> NearfieldResult {
    let Some(instance) = instance else { return NearfieldResult::Null };
    let instance = instance.write(NearfieldInstance { is_open: 0, reader: [const { MaybeUninit::uninit() }; 47] });
    let Some(&reader) = NearfieldField::reader(field) else { return NearfieldResult::NotOpen };
    let NearfieldPlacement { x_axis, y_axis, z_axis, origin } = placement;
    match Instance::new(reader, [x_axis, y_axis, z_axis].map(Into::into), origin.into()) {
        Ok(placed) => {
            opaque::put(&mut instance.reader, placed);
            instance.is_open = OPEN;
            NearfieldResult::Ok
        }
        Err(_) => NearfieldResult::NotASimilarity,
    }
}

/// Signed distance from a point of the world to the surface of an instance, in the units of the world: nearfield_distance times
/// the scale.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_instance_distance(instance: Option<&NearfieldInstance>, point: NearfieldVector) -> f32 {
    NearfieldInstance::reader(instance).map_or(f32::NAN, |reader| reader.distance(point.into()))
}

/// Signed distance, as nearfield_instance_distance to the bit, and gradient in the frame of the world.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_instance_distance_and_gradient(
    instance: Option<&NearfieldInstance>,
    point: NearfieldVector,
) -> NearfieldSample {
    let answer = |reader: &Instance<'_>| reader.distance_and_gradient(point.into()).into();
    NearfieldInstance::reader(instance).map_or(NearfieldSample::NAN, answer)
}
