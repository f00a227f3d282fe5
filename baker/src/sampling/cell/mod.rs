//! A field function to polynomials over cells: the leaves of a polynomial octree before rounding.

pub mod basis;
mod fit;
mod kink;
mod normal_equations;
mod piece;
mod stencil;

pub use fit::{Errors, Fit, doubt, errors, fits};
pub use piece::{Kind, Piece};
pub use stencil::{OUTERMOST, POINTS, Stencil, jumps};
