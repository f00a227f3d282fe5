//! Bakes triangle meshes into Nearfield signed distance fields.

mod bake;
pub mod batch;
mod budget;
pub mod corner;
pub mod depfile;
pub mod distance;
pub mod encode;
pub mod field_function;
pub mod geometry;
pub mod grid;
pub mod import;
pub mod inspect;
pub mod lod;
pub mod mesh;
pub mod morton;
pub mod octree;
pub mod output;
pub mod pareto;
pub mod picture;
pub mod polynomial;
pub mod progress;
pub mod quantize;
pub mod random;
pub mod report;
pub mod sampling;
pub mod settings;
mod smallest;
pub mod verify;

pub use bake::{BakeError, Baked, bake, bake_function};
pub use smallest::bake_smallest;
