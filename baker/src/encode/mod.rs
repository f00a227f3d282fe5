//! A field to the bytes of a file. Nothing is rounded and no distance is computed here.

mod blocks;
mod container;
mod octree;

pub use container::{Provenance, write_contract};

use crate::octree::Octree;
use thiserror::Error;

/// A field that the format cannot hold.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum EncodeError {
    /// Sections are limited by the offsets of node words, files by 32-bit lengths.
    #[error("the field would need more than 1 GiB: ask for a larger error or a smaller depth")]
    TooLarge,
}

/// The file of an octree, its error contract still blank.
pub fn encode(octree: &Octree, provenance: &Provenance) -> Result<Vec<u8>, EncodeError> {
    let sections = octree::sections(octree)?;
    container::assemble(octree, provenance, &sections)
}
