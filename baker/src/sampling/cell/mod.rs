//! A field function to polynomials over cells: the leaves of a polynomial octree before rounding.

pub mod basis;
mod equations;
mod fit;
mod kink;
mod normal_equations;
mod piece;
mod samples;
mod stencil;

pub use fit::{Errors, Fit};
pub use piece::{Kind, Piece};
pub use samples::CellSamples;
pub use stencil::{POINTS, Stencil};
