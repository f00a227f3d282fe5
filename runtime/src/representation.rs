//! What a field may be made of.

use crate::error::Error;
use crate::grid::Grid;
use crate::header::{self, Aabb, Family};
use crate::octree::Octree;
use crate::polynomial_octree::PolynomialOctree;
use crate::{validate, validate_grid, validate_polynomial};

/// What a [`Field`](crate::Field) is made of: an [`Octree`], a [`PolynomialOctree`], a
/// [`Grid`], or [`Any`] of them, as the file has it.
///
/// A program that reads one family alone says so, and the others are not linked into it.
pub trait Representation<'a>: Shape<'a> {}

/// What fields ask of their representation. Nobody else can implement it: it is not exported.
pub trait Shape<'a>: Copy {
    /// The representation in bytes whose header has been checked.
    fn open(bytes: &'a [u8], bounds: Aabb) -> Result<Self, Error>;

    /// Checks the contents of the sections of the bytes that it was opened from.
    fn validate(&self, bytes: &'a [u8]) -> Result<(), Error>;

    /// Whether a point lies in the box, faces included. False for a NaN.
    fn contains(&self, point: [f32; 3]) -> bool;

    /// Value at a point of the box.
    fn value(&self, point: [f32; 3]) -> f32;

    /// Value and gradient at a point of the box.
    fn evaluate(&self, point: [f32; 3]) -> (f32, [f32; 3]);

    // Batches are inlined everywhere: what nobody calls is then not compiled, and single queries keep one caller and its frame.

    /// Value at each of the points of the box, of which there are no more than `values`, to the bit that of [`value`](Self::value).
    #[inline]
    fn values(&self, points: &[[f32; 3]], values: &mut [f32]) {
        for (&point, value) in points.iter().zip(values) {
            *value = self.value(point);
        }
    }

    /// Value and gradient at each of the points of the box, of which there are no more than of either, to the bit those of [`evaluate`](Self::evaluate).
    #[inline]
    fn evaluate_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        for (&point, (value, gradient)) in points.iter().zip(values.iter_mut().zip(gradients)) {
            (*value, *gradient) = self.evaluate(point);
        }
    }

    /// Which it is, where it lies. Known to the compiler for all but [`Any`].
    fn kind(&self) -> Kind<'_, 'a>;
}

/// Which representation it is.
#[derive(Clone, Copy)]
pub enum Kind<'s, 'a> {
    Grid(&'s Grid<'a>),
    Octree(&'s Octree<'a>),
    Polynomial(&'s PolynomialOctree<'a>),
}

/// Whatever the file has.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Any<'a> {
    /// A uniform lattice of samples.
    Grid(Grid<'a>),
    /// Adaptive cells.
    Octree(Octree<'a>),
    /// Adaptive cells of polynomials.
    Polynomial(PolynomialOctree<'a>),
}

impl<'a> Representation<'a> for Any<'a> {}
impl<'a> Representation<'a> for Grid<'a> {}
impl<'a> Representation<'a> for Octree<'a> {}
impl<'a> Representation<'a> for PolynomialOctree<'a> {}

impl<'a> Shape<'a> for Any<'a> {
    fn open(bytes: &'a [u8], bounds: Aabb) -> Result<Self, Error> {
        match header::family_of(bytes)? {
            Family::Grid => Grid::open(bytes, bounds).map(Self::Grid),
            Family::Octree => Octree::open(bytes, bounds).map(Self::Octree),
            Family::Polynomial => PolynomialOctree::open(bytes, bounds).map(Self::Polynomial),
        }
    }

    fn validate(&self, bytes: &'a [u8]) -> Result<(), Error> {
        match self {
            Self::Grid(grid) => validate_grid::grid(grid),
            Self::Octree(octree) => validate::octree(octree),
            Self::Polynomial(octree) => validate_polynomial::octree(bytes, octree),
        }
    }

    #[inline]
    fn contains(&self, point: [f32; 3]) -> bool {
        match self {
            Self::Grid(grid) => grid.bounds().contains(point),
            Self::Octree(octree) => octree.lattice.contains(point),
            Self::Polynomial(octree) => octree.lattice.contains(point),
        }
    }

    #[inline]
    fn value(&self, point: [f32; 3]) -> f32 {
        match self {
            Self::Grid(grid) => Shape::value(grid, point),
            Self::Octree(octree) => Shape::value(octree, point),
            Self::Polynomial(octree) => Shape::value(octree, point),
        }
    }

    #[inline]
    fn evaluate(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        match self {
            Self::Grid(grid) => Shape::evaluate(grid, point),
            Self::Octree(octree) => Shape::evaluate(octree, point),
            Self::Polynomial(octree) => Shape::evaluate(octree, point),
        }
    }

    #[inline]
    fn values(&self, points: &[[f32; 3]], values: &mut [f32]) {
        match self {
            Self::Grid(grid) => grid.values(points, values),
            Self::Octree(octree) => octree.values(points, values),
            Self::Polynomial(octree) => octree.values(points, values),
        }
    }

    #[inline]
    fn evaluate_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        match self {
            Self::Grid(grid) => grid.evaluate_each(points, values, gradients),
            Self::Octree(octree) => octree.evaluate_each(points, values, gradients),
            Self::Polynomial(octree) => octree.evaluate_each(points, values, gradients),
        }
    }

    #[inline]
    fn kind(&self) -> Kind<'_, 'a> {
        match self {
            Self::Grid(grid) => Kind::Grid(grid),
            Self::Octree(octree) => Kind::Octree(octree),
            Self::Polynomial(octree) => Kind::Polynomial(octree),
        }
    }
}

impl<'a> Shape<'a> for Grid<'a> {
    fn open(bytes: &'a [u8], bounds: Aabb) -> Result<Self, Error> {
        Self::open(bytes, bounds)
    }

    fn validate(&self, _: &'a [u8]) -> Result<(), Error> {
        validate_grid::grid(self)
    }

    #[inline]
    fn contains(&self, point: [f32; 3]) -> bool {
        self.bounds().contains(point)
    }

    #[inline]
    fn value(&self, point: [f32; 3]) -> f32 {
        let (cell, local) = self.locate(point);
        self.value(cell, local)
    }

    #[inline]
    fn evaluate(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        let (cell, local) = self.locate(point);
        self.evaluate(cell, local)
    }

    fn values(&self, points: &[[f32; 3]], values: &mut [f32]) {
        self.values(points, values);
    }

    fn evaluate_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        self.evaluate_each(points, values, gradients);
    }

    #[inline]
    fn kind(&self) -> Kind<'_, 'a> {
        Kind::Grid(self)
    }
}

impl<'a> Shape<'a> for Octree<'a> {
    fn open(bytes: &'a [u8], bounds: Aabb) -> Result<Self, Error> {
        Self::open(bytes, bounds)
    }

    fn validate(&self, _: &'a [u8]) -> Result<(), Error> {
        validate::octree(self)
    }

    #[inline]
    fn contains(&self, point: [f32; 3]) -> bool {
        self.lattice.contains(point)
    }

    #[inline]
    fn value(&self, point: [f32; 3]) -> f32 {
        // Not taken apart: a copy would be waited for.
        let located = self.locate(point);
        self.value(&located.0, located.1)
    }

    #[inline]
    fn evaluate(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        let located = self.locate(point);
        self.evaluate(&located.0, located.1)
    }

    fn values(&self, points: &[[f32; 3]], values: &mut [f32]) {
        self.values(points, values);
    }

    fn evaluate_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        self.evaluate_each(points, values, gradients);
    }

    #[inline]
    fn kind(&self) -> Kind<'_, 'a> {
        Kind::Octree(self)
    }
}

impl<'a> Shape<'a> for PolynomialOctree<'a> {
    fn open(bytes: &'a [u8], bounds: Aabb) -> Result<Self, Error> {
        Self::open(bytes, bounds)
    }

    fn validate(&self, bytes: &'a [u8]) -> Result<(), Error> {
        validate_polynomial::octree(bytes, self)
    }

    #[inline]
    fn contains(&self, point: [f32; 3]) -> bool {
        self.lattice.contains(point)
    }

    #[inline]
    fn value(&self, point: [f32; 3]) -> f32 {
        self.query(point, false).value
    }

    #[inline]
    fn evaluate(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        self.query(point, true).split()
    }

    #[inline]
    fn values(&self, points: &[[f32; 3]], values: &mut [f32]) {
        self.query_each(points, values, None);
    }

    #[inline]
    fn evaluate_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        self.query_each(points, values, Some(gradients));
    }

    #[inline]
    fn kind(&self) -> Kind<'_, 'a> {
        Kind::Polynomial(self)
    }
}
