//! What the module reads: whatever a file has, or the one family that it is built for, without the code of the others.

use reader::Error;

#[cfg(not(any(feature = "only-grid", feature = "only-octree", feature = "only-polynomial")))]
type Family = reader::Any<'static>;
#[cfg(feature = "only-grid")]
type Family = reader::Grid<'static>;
#[cfg(feature = "only-octree")]
type Family = reader::Octree<'static>;
#[cfg(feature = "only-polynomial")]
type Family = reader::PolynomialOctree<'static>;

/// A field that the module reads.
pub type Field = reader::Field<'static, Family>;

/// Opens one, as [`reader::Field::open`] does.
pub(crate) const OPEN: fn(&'static [u8]) -> Result<Field, Error> = {
    #[cfg(not(any(feature = "only-grid", feature = "only-octree", feature = "only-polynomial")))]
    let open = reader::Field::open;
    #[cfg(feature = "only-grid")]
    let open = reader::Field::open_grid;
    #[cfg(feature = "only-octree")]
    let open = reader::Field::open_octree;
    #[cfg(feature = "only-polynomial")]
    let open = reader::Field::open_polynomial_octree;
    open
};
