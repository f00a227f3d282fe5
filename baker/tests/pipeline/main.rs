//! The baker as a step of a pipeline.

/// Baking what has changed of many meshes.
mod batch;
/// The examples for build systems, with the real tools.
mod build_systems;
mod curve;
/// Kills, full disks, folders in the way.
mod faults;
#[path = "../support/mod.rs"]
mod support;
/// Reports, differences, pictures and what packages install.
mod tools;
/// Pages for browsers.
mod viewer;
