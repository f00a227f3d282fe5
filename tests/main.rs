//! The promises of Nearfield, one module a promise.

/// The error of a field is what was asked for, and what its header says.
mod accuracy;
/// Whatever the bytes and the points, answers are numbers, and every door gives the same.
mod any_bytes;
/// Data flows one way through the baker, and the reader stands alone.
mod architecture;
/// Octrees of polynomials keep to their targets in error and in bytes.
mod baked_polynomials;
/// The reader accepts what the specification says, answers it so, and refuses the rest by name.
mod conformance;
/// Leaves meet as the file says they do.
mod continuity;
/// The same mesh and settings give the same bytes on any number of threads.
mod determinism;
/// The distance engine agrees with every triangle and with formulas.
mod distance;
/// A reader of one family is the reader of all, less the others; what errors, trees and instances say of themselves is so.
mod families;
/// Grids answer as the papers say, whatever their order, reconstruction and precision.
mod grids;
/// Levels of detail are fields, cost little, and are there before the rest of the file.
mod lods;
/// An octree of polynomials is the blend of its leaves, which has no seams.
mod polynomials;
/// The gradient is the derivative of the value, and the Lipschitz bound holds.
mod properties;
/// A reader in another language, written from the specification alone, agrees.
mod python_reader;
/// Rays, regions, descents and moved fields keep what they promise.
mod queries;
/// What fuzzers found stays fixed.
mod regressions;
/// What was baked is what is read.
mod round_trip;
/// Meshes that the other modules bake.
mod shapes;
/// Broken meshes keep their inside.
mod signs;
/// Shapes with known distances, and an oracle too simple to be wrong.
mod support;
/// A file that is not whole is refused.
mod truncation;
/// Small files that the baker would never write.
mod vectors;
