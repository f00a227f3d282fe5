//! The door: bytes in, distances out.

use crate::cursor::Cursor;
use crate::error::Error;
use crate::grid::Grid;
use crate::header::{self, Aabb, ErrorContract, Family, Header};
use crate::octree::Octree;
use crate::polynomial_octree::PolynomialOctree;
use crate::section::{self, Sections};
use crate::{math, validate, validate_grid, validate_polynomial};

/// A signed distance field in borrowed bytes.
///
/// Copying a field copies a few numbers and two references, never the bytes.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    shape: Shape<'a>,
    bytes: &'a [u8],
}

/// What a field's family makes of its sections.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape<'a> {
    Grid(Grid<'a>),
    Octree(Octree<'a>),
    Polynomial(PolynomialOctree<'a>),
}

impl Shape<'_> {
    #[inline]
    fn contains(&self, point: [f32; 3]) -> bool {
        match self {
            Self::Grid(grid) => grid.contains(point),
            Self::Octree(octree) => octree.lattice.contains(point),
            Self::Polynomial(octree) => octree.lattice.contains(point),
        }
    }

    /// Value at a point of the box.
    #[inline]
    fn value(&self, point: [f32; 3]) -> f32 {
        match self {
            Self::Grid(grid) => {
                let (cell, local) = grid.locate(point);
                grid.value(cell, local)
            }
            Self::Octree(octree) => {
                let (leaf, local) = octree.locate(point);
                octree.value(&leaf, local)
            }
            Self::Polynomial(octree) => octree.query(point).0,
        }
    }

    /// Value and gradient at a point of the box.
    #[inline]
    fn evaluate(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        match self {
            Self::Grid(grid) => {
                let (cell, local) = grid.locate(point);
                grid.evaluate(cell, local)
            }
            Self::Octree(octree) => {
                let (leaf, local) = octree.locate(point);
                octree.evaluate(&leaf, local)
            }
            Self::Polynomial(octree) => octree.query(point),
        }
    }
}

impl<'a> Field<'a> {
    /// Opens a field after checking its header and parameters, in constant time.
    ///
    /// A field that opens answers every query with a finite number, even if its sections are
    /// damaged; [`validate`](Self::validate) tells whether they are.
    ///
    /// # Errors
    ///
    /// The first rule of `SPEC.md` §3 to §5, §11 and §12 that the bytes break.
    pub fn open(bytes: &'a [u8]) -> Result<Self, Error> {
        header::check(bytes)?;
        let bounds = header::bounds_of(bytes);
        let shape = match header::family_of(bytes)? {
            Family::Grid => Shape::Grid(Grid::open(bytes, bounds)?),
            Family::Octree => Shape::Octree(Octree::open(bytes, bounds)?),
            Family::Polynomial => Shape::Polynomial(PolynomialOctree::open(bytes, bounds)?),
        };
        Ok(Self { shape, bytes })
    }

    /// Checks every byte against the format, in time proportional to the file and without memory.
    ///
    /// # Errors
    ///
    /// The first rule of `SPEC.md` §4 to §8, §11 and §12 that the bytes break.
    pub fn validate(&self) -> Result<(), Error> {
        validate::sections(self.bytes)?;
        match &self.shape {
            Shape::Grid(grid) => validate_grid::grid(grid),
            Shape::Octree(octree) => validate::octree(octree),
            Shape::Polynomial(octree) => validate_polynomial::octree(self.bytes, octree),
        }
    }

    /// Signed distance from a point to the surface: mesh units, negative inside.
    ///
    /// Finite for every finite point. Outside the box it is the distance at the nearest point of
    /// the box plus the distance to that point, which no distance field exceeds; at most
    /// [`f32::MAX`]. NaN if a coordinate is NaN, infinite if one is infinite.
    #[inline]
    pub fn distance(&self, point: [f32; 3]) -> f32 {
        if self.shape.contains(point) { self.shape.value(point) } else { self.outside(point).0 }
    }

    /// Signed distance, as [`distance`](Self::distance) to the bit, and gradient.
    ///
    /// Inside the box the gradient is the derivative of the reconstruction; its length is near 1
    /// but is not normalized. Outside it is the unit vector from the nearest point of the box. NaN
    /// in all components if a coordinate is NaN; infinite coordinates outweigh all others.
    #[inline]
    pub fn distance_and_gradient(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        if self.shape.contains(point) { self.shape.evaluate(point) } else { self.outside(point) }
    }

    /// [`distance`](Self::distance) at each point. Stops at the shorter slice; returns how many
    /// distances it wrote.
    pub fn distances(&self, points: &[[f32; 3]], distances: &mut [f32]) -> usize {
        for (&point, distance) in points.iter().zip(&mut *distances) {
            *distance = self.distance(point);
        }
        points.len().min(distances.len())
    }

    /// [`distance_and_gradient`](Self::distance_and_gradient) at each point. Stops at the shortest
    /// slice; returns how many answers it wrote.
    pub fn distances_and_gradients(
        &self,
        points: &[[f32; 3]],
        distances: &mut [f32],
        gradients: &mut [[f32; 3]],
    ) -> usize {
        let answers = distances.iter_mut().zip(&mut *gradients);
        for (&point, (distance, gradient)) in points.iter().zip(answers) {
            (*distance, *gradient) = self.distance_and_gradient(point);
        }
        points.len().min(distances.len()).min(gradients.len())
    }

    /// A cursor, which answers queries that are near one another faster.
    pub fn cursor(&self) -> Cursor<'a> {
        Cursor::new(*self)
    }

    /// What the field is and where it came from.
    pub fn header(&self) -> Header {
        header::header_of(self.bytes)
    }

    /// How wrong the field was found to be at bake time.
    pub fn contract(&self) -> ErrorContract {
        header::contract_of(self.bytes)
    }

    /// The sections of the file, in its order.
    pub fn sections(&self) -> Sections<'a> {
        section::sections(self.bytes)
    }

    /// The octree, for those who walk its leaves; `None` for another family.
    pub fn octree(&self) -> Option<Octree<'a>> {
        match self.shape {
            Shape::Octree(octree) => Some(octree),
            _ => None,
        }
    }

    /// The field where it lies.
    #[inline]
    pub(crate) fn shape(&self) -> &Shape<'a> {
        &self.shape
    }

    /// The octree of polynomials, for those who walk its leaves; `None` for another family.
    pub fn polynomial_octree(&self) -> Option<PolynomialOctree<'a>> {
        match self.shape {
            Shape::Polynomial(octree) => Some(octree),
            _ => None,
        }
    }

    /// The grid, for those who read its samples; `None` for another family.
    pub fn grid(&self) -> Option<Grid<'a>> {
        match self.shape {
            Shape::Grid(grid) => Some(grid),
            _ => None,
        }
    }

    /// The answer for a point that the box does not contain.
    #[cold]
    fn outside(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        if point.iter().any(|component| component.is_nan()) {
            return (f32::NAN, [f32::NAN; 3]);
        }
        if point.iter().any(|component| component.is_infinite()) {
            let toward = point.map(|x| if x.is_infinite() { 1.0_f32.copysign(x) } else { 0.0 });
            return (f32::INFINITY, math::length_and_direction(toward).1);
        }

        let Aabb { min, max } = header::bounds_of(self.bytes);
        let nearest = [0, 1, 2].map(|axis: usize| point[axis].max(min[axis]).min(max[axis]));
        let away = [0, 1, 2].map(|axis: usize| point[axis] - nearest[axis]);
        let (distance_to_box, direction) = math::length_and_direction(away);

        let distance = self.shape.value(nearest) + distance_to_box;
        (distance.min(f32::MAX), direction)
    }
}
