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

/// A way to open one.
pub(crate) type Open = fn(&'static [u8]) -> Result<Field, Error>;

/// As [`reader::Field::open`] does.
pub(crate) const OPEN: Open = {
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

/// Whether many points are asked at once: faster, by code of its own, which modules that are built for size leave out.
const AT_ONCE: bool = cfg!(not(any(feature = "only-grid", feature = "only-octree", feature = "only-polynomial")));

/// [`Field::distances`](reader::Field::distances), to the bit.
pub(crate) fn distances(field: &Field, points: &[[f32; 3]], distances: &mut [f32]) {
    if AT_ONCE {
        field.distances(points, distances);
    } else {
        for (&point, distance) in points.iter().zip(distances) {
            *distance = field.distance(point);
        }
    }
}

/// [`Field::distances_and_gradients`](reader::Field::distances_and_gradients), to the bit.
pub(crate) fn distances_and_gradients(
    field: &Field,
    points: &[[f32; 3]],
    distances: &mut [f32],
    gradients: &mut [[f32; 3]],
) {
    if AT_ONCE {
        field.distances_and_gradients(points, distances, gradients);
    } else {
        for (&point, (distance, gradient)) in points.iter().zip(distances.iter_mut().zip(gradients)) {
            (*distance, *gradient) = field.distance_and_gradient(point);
        }
    }
}
