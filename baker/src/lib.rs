//! Bakes triangle meshes into Nearfield signed distance fields.

pub mod distance;
pub mod field_function;
pub mod geometry;
pub mod import;
pub mod mesh;
