//! The command line as its users meet it: text, exit codes, and files that are whole or absent.

/// What goes wrong, and how it is said.
mod failures;
/// From a mesh to a field, and what a field is worth.
mod fields;
/// Levels of detail: baked, listed, and asked one by one.
mod levels;
/// What becomes of nodes, axes, thickness and doubt.
mod meshes;
/// Points and rays, in and out.
mod questions;
#[path = "../support/mod.rs"]
mod support;
