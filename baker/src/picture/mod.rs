//! Pictures of fields, for eyes: nothing here is exact.

mod colour;
mod image;
mod slice;

pub use image::Image;
pub use slice::{Axis, Position, Slice, slice};
