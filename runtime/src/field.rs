//! The door: bytes in, distances out.

use crate::cursor::Cursor;
use crate::error::Error;
use crate::grid::Grid;
use crate::header::{self, Aabb, ErrorContract, Family, Header};
use crate::octree::Octree;
use crate::polynomial_octree::PolynomialOctree;
use crate::representation::{Any, Kind, Representation};
use crate::section::{self, Sections};
use crate::{lod, march, math, validate};

/// A signed distance field in borrowed bytes.
///
/// Copying a field copies a few numbers and two references, never the bytes.
///
/// A field reads files of every family. A program that knows which one it has leaves the others out by
/// [`open_octree`](Field::open_octree), [`open_polynomial_octree`](Field::open_polynomial_octree) or
/// [`open_grid`](Field::open_grid).
#[derive(Clone, Copy, Debug)]
pub struct Field<'a, R = Any<'a>> {
    shape: R,
    bytes: &'a [u8],
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
        open(bytes, None)
    }

    /// Opens the finest [level of detail](Field::lod) that is whole in the first bytes of a file, or the field itself once
    /// these are all its bytes: what a program can ask while the rest still arrives.
    ///
    /// # Errors
    ///
    /// [`Error::Truncated`] while there is none yet; otherwise those of [`open`](Self::open).
    pub fn open_prefix(bytes: &'a [u8]) -> Result<Self, Error> {
        if header::whole_length(bytes)? <= bytes.len() {
            return Self::open(bytes);
        }
        header::check_intact(bytes)?;
        lod::levels(bytes).last().map_or(Err(Error::Truncated), Self::open)
    }

    /// The octree, for those who walk its leaves; `None` for another family.
    pub fn octree(&self) -> Option<Octree<'a>> {
        match self.shape {
            Any::Octree(octree) => Some(octree),
            _ => None,
        }
    }

    /// The grid, for those who read its samples; `None` for another family.
    pub fn grid(&self) -> Option<Grid<'a>> {
        match self.shape {
            Any::Grid(grid) => Some(grid),
            _ => None,
        }
    }

    /// The octree of polynomials, for those who walk its leaves; `None` for another family.
    pub fn polynomial_octree(&self) -> Option<PolynomialOctree<'a>> {
        match self.shape {
            Any::Polynomial(octree) => Some(octree),
            _ => None,
        }
    }
}

impl<'a> Field<'a, Octree<'a>> {
    /// Opens an octree, as [`Field::open`] does.
    ///
    /// # Errors
    ///
    /// As there; [`Error::Family`] also for another family.
    pub fn open_octree(bytes: &'a [u8]) -> Result<Self, Error> {
        open(bytes, Some(Family::Octree))
    }
}

impl<'a> Field<'a, PolynomialOctree<'a>> {
    /// Opens an octree of polynomials, as [`Field::open`] does.
    ///
    /// # Errors
    ///
    /// As there; [`Error::Family`] also for another family.
    pub fn open_polynomial_octree(bytes: &'a [u8]) -> Result<Self, Error> {
        open(bytes, Some(Family::Polynomial))
    }
}

impl<'a> Field<'a, Grid<'a>> {
    /// Opens a grid, as [`Field::open`] does.
    ///
    /// # Errors
    ///
    /// As there; [`Error::Family`] also for another family.
    pub fn open_grid(bytes: &'a [u8]) -> Result<Self, Error> {
        open(bytes, Some(Family::Grid))
    }
}

fn open<'a, R: Representation<'a>>(bytes: &'a [u8], family: Option<Family>) -> Result<Field<'a, R>, Error> {
    header::check(bytes)?;
    let is_other = |family| header::family_of(bytes) != Ok(family);
    if family.is_some_and(is_other) {
        return Err(Error::Family);
    }
    let shape = R::open(bytes, header::bounds_of(bytes))?;
    Ok(Field { shape, bytes })
}

impl<'a, R: Representation<'a>> Field<'a, R> {
    /// What the field is made of.
    pub fn representation(&self) -> R {
        self.shape
    }

    /// Checks every byte against the format, those of levels of detail too, in time proportional to the file and without
    /// memory.
    ///
    /// # Errors
    ///
    /// The first rule of `SPEC.md` §4 to §8, §11 and §12 that the bytes break.
    pub fn validate(&self) -> Result<(), Error> {
        if lod::has_levels(self.bytes) { self.validate_with_levels() } else { self.validate_alone() }
    }

    /// Checks levels of detail too. Apart, so that its stack is taken only where there are some.
    #[cold]
    #[inline(never)]
    fn validate_with_levels(&self) -> Result<(), Error> {
        self.validate_alone()?;
        for level in lod::levels(self.bytes) {
            open::<R>(level, None)?.validate_alone()?;
        }
        lod::check(self.bytes)
    }

    /// Checks all but what is in levels of detail.
    #[inline(never)]
    fn validate_alone(&self) -> Result<(), Error> {
        validate::sections(self.bytes)?;
        self.shape.validate(self.bytes)
    }

    /// The field at a level of detail: 0 is the field itself, 1 the next coarser, and so on.
    ///
    /// A level is a field of its own: of the same shape, in the same frame and units, with every query, and with its own box
    /// and [error contract](Self::contract). It is opened as [`Field::open`] opens a file: ask for it once, then query it.
    ///
    /// `None` if there is no such level, or if it is damaged, which [`validate`](Self::validate) would have told.
    pub fn lod(&self, level: usize) -> Option<Self> {
        if level == 0 {
            return Some(*self);
        }
        let family = header::family_of(self.bytes).ok();
        open(lod::level(self.bytes, level)?, family).ok()
    }

    /// How many levels of detail there are, the field itself among them: at least 1.
    pub fn lod_count(&self) -> usize {
        1 + lod::levels(self.bytes).count()
    }

    /// The coarsest [level of detail](Self::lod) whose largest measured error is at most `max_error`, mesh units; the field
    /// itself if there is none.
    pub fn lod_within(&self, max_error: f32) -> Self {
        let mut levels = (1..self.lod_count()).rev().filter_map(|level| self.lod(level));
        levels.find(|level| level.contract().max_error() <= max_error).unwrap_or(*self)
    }

    /// The bytes of the file; of a level of detail its part of them, which is a file too.
    pub fn bytes(&self) -> &'a [u8] {
        self.bytes
    }

    /// Signed distance from a point to the surface: mesh units, negative inside.
    ///
    /// Finite for every finite point. Outside the box it is the distance at the nearest point of
    /// the box plus the distance to that point, which no distance field exceeds; at most
    /// [`f32::MAX`]. NaN if a coordinate is NaN, infinite if one is infinite.
    #[inline]
    pub fn distance(&self, point: [f32; 3]) -> f32 {
        // One call for points inside and outside: its code is there once.
        let beyond = if self.shape.contains(point) { None } else { Some(self.beyond(point)) };
        let value = self.shape.value(beyond.as_ref().map_or(point, |beyond| beyond.nearest));
        beyond.map_or(value, |beyond| beyond.answer(value).0)
    }

    /// Signed distance, as [`distance`](Self::distance) to the bit, and gradient.
    ///
    /// Inside the box the gradient is the derivative of the reconstruction; its length is near 1
    /// but is not normalized. Outside it is the unit vector from the nearest point of the box. NaN
    /// in all components if a coordinate is NaN; infinite coordinates outweigh all others.
    #[inline]
    pub fn distance_and_gradient(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        let beyond = if self.shape.contains(point) { None } else { Some(self.beyond(point)) };
        let answer = self.shape.evaluate(beyond.as_ref().map_or(point, |beyond| beyond.nearest));
        beyond.map_or(answer, |beyond| beyond.answer(answer.0))
    }

    /// [`distance`](Self::distance) at each point, to the bit. Faster than one by one where points follow one another in a
    /// leaf, as along rows. Stops at the shorter slice; returns how many distances it wrote.
    pub fn distances(&self, points: &[[f32; 3]], distances: &mut [f32]) -> usize {
        let count = points.len().min(distances.len());
        let mut done = 0;
        while let (Some(points), Some(distances)) = (points.get(done..count), distances.get_mut(done..count))
            && let (Some(&first), Some(distance)) = (points.first(), distances.first_mut())
        {
            let inside = self.run_inside(points);
            if inside.is_empty() {
                *distance = self.distance(first);
            } else {
                self.shape.values(inside, distances);
            }
            done += inside.len().max(1);
        }
        count
    }

    /// [`distance_and_gradient`](Self::distance_and_gradient) at each point, to the bit. Faster than one by one where
    /// points follow one another in a leaf, as along rows. Stops at the shortest slice; returns how many answers it wrote.
    pub fn distances_and_gradients(
        &self,
        points: &[[f32; 3]],
        distances: &mut [f32],
        gradients: &mut [[f32; 3]],
    ) -> usize {
        let count = points.len().min(distances.len()).min(gradients.len());
        let mut done = 0;
        while let (Some(points), Some(distances), Some(gradients)) =
            (points.get(done..count), distances.get_mut(done..count), gradients.get_mut(done..count))
            && let (Some(&first), Some(distance), Some(gradient)) =
                (points.first(), distances.first_mut(), gradients.first_mut())
        {
            let inside = self.run_inside(points);
            if inside.is_empty() {
                (*distance, *gradient) = self.distance_and_gradient(first);
            } else {
                self.shape.evaluate_each(inside, distances, gradients);
            }
            done += inside.len().max(1);
        }
        count
    }

    /// The points up to the first that is not in the box.
    fn run_inside<'p>(&self, points: &'p [[f32; 3]]) -> &'p [[f32; 3]] {
        let end = points.iter().position(|&point| !self.shape.contains(point));
        end.and_then(|end| points.get(..end)).unwrap_or(points)
    }

    /// A cursor, which answers queries that are near one another faster.
    pub fn cursor(&self) -> Cursor<'a, R> {
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

    /// The box, and how steep the field is at most: what walks need of the header, which is larger.
    pub(crate) fn bounds_and_steepest(&self) -> (Aabb, f32) {
        (header::bounds_of(self.bytes), header::steepest_of(self.bytes))
    }

    /// What the field is made of, where it lies.
    #[inline]
    pub(crate) fn kind(&self) -> Kind<'_, 'a> {
        self.shape.kind()
    }

    /// How a point that the box does not contain lies to it.
    #[cold]
    #[inline(never)]
    fn beyond(&self, point: [f32; 3]) -> Beyond {
        let bounds = header::bounds_of(self.bytes);
        if point.iter().any(|component| component.is_nan()) {
            return Beyond { nearest: bounds.min, distance: f32::NAN, direction: [f32::NAN; 3] };
        }
        if point.iter().any(|component| component.is_infinite()) {
            let toward = point.map(|x| if x.is_infinite() { 1.0_f32.copysign(x) } else { 0.0 });
            return Beyond {
                nearest: bounds.min,
                distance: f32::INFINITY,
                direction: math::length_and_direction(toward).1,
            };
        }

        let nearest = march::nearest(bounds, point);
        let away = math::each_axis(|axis| point[axis] - nearest[axis]);
        let (distance, direction) = math::length_and_direction(away);
        Beyond { nearest, distance, direction }
    }
}

/// A point outside the box, seen from it.
struct Beyond {
    /// Nearest point of the box.
    nearest: [f32; 3],
    /// From there to the point: at most [`f32::MAX`], or what a point that is not finite makes it.
    distance: f32,
    direction: [f32; 3],
}

impl Beyond {
    /// The answer for the point, from the value at the nearest point of the box.
    fn answer(self, value: f32) -> (f32, [f32; 3]) {
        let is_finite = self.distance <= f32::MAX;
        let distance = if is_finite { (value + self.distance).min(f32::MAX) } else { self.distance };
        (distance, self.direction)
    }
}
