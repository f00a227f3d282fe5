//! The door: bytes in, distances out.

use crate::cursor::Cursor;
use crate::error::Error;
use crate::header::{self, Aabb, ErrorContract, Header};
use crate::octree::Octree;
use crate::section::{self, Sections};
use crate::{math, validate};

/// A signed distance field in borrowed bytes.
///
/// Copying a field copies a few numbers and two references, never the bytes.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    octree: Octree<'a>,
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
    /// The first rule of `SPEC.md` §3 to §5 that the bytes break.
    pub fn open(bytes: &'a [u8]) -> Result<Self, Error> {
        header::check(bytes)?;
        let octree = Octree::open(bytes, header::bounds_of(bytes))?;
        Ok(Self { octree, bytes })
    }

    /// Checks every byte against the format, in time proportional to the file and without memory.
    ///
    /// # Errors
    ///
    /// The first rule of `SPEC.md` §4 to §8 that the bytes break.
    pub fn validate(&self) -> Result<(), Error> {
        validate::sections(self.bytes)?;
        validate::octree(&self.octree)
    }

    /// Signed distance from a point to the surface: mesh units, negative inside.
    ///
    /// Finite for every finite point. Outside the box it is the distance at the nearest point of
    /// the box plus the distance to that point, which no distance field exceeds; at most
    /// [`f32::MAX`]. NaN if a coordinate is NaN, infinite if one is infinite.
    #[inline]
    pub fn distance(&self, point: [f32; 3]) -> f32 {
        if self.octree.contains(point) {
            let (leaf, local) = self.octree.locate(point);
            self.octree.value(&leaf, local)
        } else {
            self.outside(point).0
        }
    }

    /// Signed distance, as [`distance`](Self::distance) to the bit, and gradient.
    ///
    /// Inside the box the gradient is the derivative of the reconstruction; its length is near 1
    /// but is not normalized. Outside it is the unit vector from the nearest point of the box. NaN
    /// in all components if a coordinate is NaN; infinite coordinates outweigh all others.
    #[inline]
    pub fn distance_and_gradient(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        if self.octree.contains(point) {
            let (leaf, local) = self.octree.locate(point);
            self.octree.evaluate(&leaf, local)
        } else {
            self.outside(point)
        }
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

    /// The octree, for those who walk its leaves.
    pub fn octree(&self) -> Octree<'a> {
        self.octree
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

        let Aabb { min, max } = self.octree.bounds();
        let nearest = [0, 1, 2].map(|axis: usize| point[axis].max(min[axis]).min(max[axis]));
        let away = [0, 1, 2].map(|axis: usize| point[axis] - nearest[axis]);
        let (distance_to_box, direction) = math::length_and_direction(away);

        let (leaf, local) = self.octree.locate(nearest);
        let distance = self.octree.value(&leaf, local) + distance_to_box;
        (distance.min(f32::MAX), direction)
    }
}
