//! Reads Nearfield signed distance fields: from the bytes of a `.nfd` file to the distance and the
//! gradient at a point.
//!
//! ```
//! use nearfield::{Error, Field};
//!
//! /// How far a robot may move at `point` without touching the shape, in mesh units.
//! fn clearance(file: &[u8], point: [f32; 3]) -> Result<f32, Error> {
//!     let field = Field::open(file)?;
//!     let (distance, gradient) = field.distance_and_gradient(point);
//!     if distance < 0.0 {
//!         // Inside: the way out is along the gradient.
//!         let _way_out = gradient;
//!         return Ok(0.0);
//!     }
//!     Ok((distance - field.contract().max_error()).max(0.0))
//! }
//!
//! assert_eq!(clearance(b"solid cube", [0.0; 3]), Err(Error::Magic));
//! ```
//!
//! # Promises
//!
//! - No dependency, no heap, no `unsafe`, no recursion; `no_std`.
//! - No panic, whatever the bytes and whatever the point.
//! - [`Field::open`] takes constant time and says whether the header and the parameters are sound;
//!   [`Field::validate`] takes time proportional to the file and says whether all of it is.
//! - Every finite point has a finite answer, on a damaged file too once it opens. Inside the box the
//!   answer is the reconstruction, outside it an upper bound that keeps growing with the distance.
//! - The same bytes and the same point give the same bits on every machine: only additions,
//!   subtractions, multiplications, divisions and comparisons of `f32`, in a fixed order.
//! - [`Field`] is `Copy`, `Send` and `Sync`, and borrows the bytes.
//!
//! # What it does not do
//!
//! It does not read files, bake fields or know meshes: the package `nearfield-bake` bakes. Errors
//! in [`ErrorContract`] were measured at points when the field was baked; no bound is proved.
//!
//! The format is described in `format-spec/SPEC.md`, its numbers in [`layout`].
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

mod blend;
/// The programs of the guide.
#[cfg(doctest)]
#[doc = include_str!("../../docs/reader.md")]
struct Guide;

mod bytes;
mod checksum;
mod coefficient_code;
mod cursor;
mod error;
mod field;
mod grid;
mod grid_batch;
mod grid_sample;
mod header;
mod hermite;
mod implied;
mod instance;
mod lattice;
pub mod layout;
mod leaf;
mod legendre;
mod lod;
mod march;
mod math;
mod octree;
mod octree_batch;
mod polynomial;
mod polynomial_batch;
mod polynomial_leaf;
mod polynomial_octree;
mod polynomial_rows;
mod range;
mod reconstruct;
mod region;
mod representation;
pub mod sample;
mod section;
#[cfg(test)]
mod tests;
mod validate;
mod validate_grid;
mod validate_polynomial;

pub use checksum::crc32c;
pub use cursor::Cursor;
pub use error::Error;
pub use field::Field;
pub use grid::{Grid, GridPrecision, Reconstruction};
pub use header::{Aabb, ErrorContract, ErrorStatistics, Family, Header, SignMethod};
pub use instance::{Instance, NotASimilarity};
pub use lattice::Leaf;
pub use march::{ClosestPoint, RayHit, Raycast};
pub use octree::{Continuity, Interpolant, Leaves, Octree};
pub use polynomial_octree::PolynomialOctree;
pub use representation::{Any, Representation};
pub use section::{Section, Sections};
