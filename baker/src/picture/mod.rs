//! Pictures of fields, for eyes: nothing here is exact.

mod camera;
pub mod chart;
mod colour;
mod image;
mod isosurface;
mod plane;
mod render;
mod scale_bar;
mod slice;
mod viewer;

pub use camera::{Camera, Up};
pub use image::Image;
pub use isosurface::{Isosurface, isosurface};
pub use plane::{Axis, Cut, Position};
pub use render::{Render, Shading, Surface, render};
pub use slice::{Slice, error_map, slice};
pub use viewer::{Viewer, viewer_page};
