//! The C interface of the reader. The manual is `include/nearfield.h`, which is generated from this source.
//!
//! Values cross by value: a point is a struct of three floats and an answer a struct of its parts, so most functions take no
//! pointer but the handle. What is left of `unsafe` is in three places: the room of a handle (`opaque`), the bytes of a field
//! (`field`) and the arrays of a batch (`batch`).
#![cfg_attr(target_os = "none", no_std)]
#![expect(unsafe_code, reason = "C gives pointers; each block says why it is sound")]

// In the order of the header.
mod result;

mod vector;

mod field;

mod lod;

mod info;

mod query;

mod batch;

mod cursor;

mod march;

mod instance;

// Not in it.
mod opaque;

pub use batch::{nearfield_distances, nearfield_distances_and_gradients};
pub use cursor::{
    NearfieldCursor, nearfield_cursor, nearfield_cursor_distance, nearfield_cursor_distance_and_gradient,
};
pub use field::{NearfieldField, nearfield_open, nearfield_open_prefix, nearfield_validate};
pub use info::{
    NEARFIELD_ABI_VERSION, NearfieldErrors, NearfieldFormat, NearfieldInfo, nearfield_abi_version, nearfield_format,
    nearfield_info,
};
pub use instance::{
    NearfieldInstance, NearfieldPlacement, nearfield_instance, nearfield_instance_distance,
    nearfield_instance_distance_and_gradient,
};
pub use lod::{nearfield_lod, nearfield_lod_count};
pub use march::{
    NearfieldClosestPoint, NearfieldRay, NearfieldRayEnd, NearfieldRayHit, nearfield_closest_point, nearfield_raycast,
};
pub use query::{
    NearfieldRange, nearfield_clearance, nearfield_distance, nearfield_distance_and_gradient, nearfield_is_clear,
    nearfield_normal, nearfield_range,
};
pub use result::{NearfieldResult, nearfield_result_text};
pub use vector::{NearfieldSample, NearfieldVector};

/// Where there is no operating system the library brings the handler that every Rust program needs. Nothing calls it: the
/// reader cannot panic.
#[cfg(all(target_os = "none", not(test)))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
