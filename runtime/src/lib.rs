//! Reads Nearfield signed distance fields.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

mod bytes;
mod checksum;
mod error;
mod field;
mod header;
mod hermite;
pub mod layout;
mod leaf;
mod math;
mod octree;
pub mod sample;
mod section;
#[cfg(test)]
mod tests;
mod validate;

pub use checksum::crc32c;
pub use error::Error;
pub use field::Field;
pub use header::{Aabb, ErrorContract, ErrorStatistics, Family, Header, SignMethod};
pub use octree::{Continuity, Interpolant, Leaf, Leaves, Octree};
pub use section::{Section, Sections};
