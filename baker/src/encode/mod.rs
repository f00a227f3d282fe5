//! A field to the bytes of a file. Nothing is rounded and no distance is computed here.

mod blocks;
mod container;
mod grid;
mod octree;
mod polynomial;
mod shapes;

pub use container::{Provenance, with_levels, write_contract, write_lipschitz};

use crate::geometry::Aabb;
use crate::grid::Grid;
use crate::octree::Octree;
use crate::polynomial::PolynomialOctree;
use container::Shape;
use nearfield::layout::family;
use thiserror::Error;

/// A field that the format cannot hold.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum EncodeError {
    /// Sections are limited by the offsets of node words, files by 32-bit lengths.
    #[error("the field would need more than 1 GiB: ask for a larger error, a smaller depth or a lower resolution")]
    TooLarge,
}

/// The file of an octree, its error contract still blank.
pub fn encode(octree: &Octree, provenance: &Provenance) -> Result<Vec<u8>, EncodeError> {
    let domain = &octree.tree.domain;
    let max = domain.origin + domain.root_cells.as_dvec3() * domain.root_edge;
    let bounds = Aabb { min: domain.origin, max };
    let shape = Shape { family: family::OCTREE, bounds, lipschitz: octree.lipschitz };
    container::assemble(&shape, provenance, &octree::sections(octree)?)
}

/// The file of a polynomial octree, its error contract and its Lipschitz bound still blank: what blending adds to the
/// slopes of the leaves is measured, on the finished field.
pub fn encode_polynomial(octree: &PolynomialOctree, provenance: &Provenance) -> Result<Vec<u8>, EncodeError> {
    let domain = &octree.cells.domain;
    let max = domain.origin + domain.root_cells.as_dvec3() * domain.root_edge;
    let bounds = Aabb { min: domain.origin, max };
    let shape = Shape { family: family::POLYNOMIAL, bounds, lipschitz: 0.0 };
    container::assemble(&shape, provenance, &polynomial::sections(octree)?)
}

/// The file of a grid, its error contract still blank.
pub fn encode_grid(grid: &Grid, provenance: &Provenance) -> Result<Vec<u8>, EncodeError> {
    let shape = Shape { family: family::GRID, bounds: grid.domain.bounds(), lipschitz: grid.lipschitz };
    container::assemble(&shape, provenance, &grid::sections(grid))
}
