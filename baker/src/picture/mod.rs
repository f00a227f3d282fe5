//! Pictures of fields, for eyes: nothing here is exact.

mod camera;
pub mod chart;
mod colour;
mod image;
mod isosurface;
mod render;
mod slice;
mod viewer;

pub use camera::{Camera, Up};
pub use image::Image;
pub use isosurface::{Isosurface, isosurface};
pub use render::{Render, Shading, Surface, render};
pub use slice::{Axis, Position, Slice, slice};
pub use viewer::{Viewer, viewer_page};
