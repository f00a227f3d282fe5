//! Queries that remember a leaf.

use crate::field::Field;
use crate::hermite::Jets;
use crate::octree::{Leaf, Octree};

/// Answers queries that are near one another: a ray's steps, a particle's path, the points of a row.
///
/// It keeps the corners of the leaf of the last query, and a query in the same leaf skips the tree and the decoding. Every
/// answer has the bits that the field alone would give. Some 300 bytes; make one for each thread.
///
/// ```
/// # fn distances(field: &nearfield::Field<'_>, row: impl Iterator<Item = [f32; 3]>) -> f32 {
/// let mut cursor = field.cursor();
/// row.map(|point| cursor.distance(point)).fold(f32::INFINITY, f32::min)
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Cursor<'a> {
    field: Field<'a>,
    octree: Octree<'a>,
    leaf: Option<Leaf>,
    jets: Jets,
}

impl<'a> Cursor<'a> {
    pub(crate) fn new(field: Field<'a>) -> Self {
        Self { field, octree: field.octree(), leaf: None, jets: Jets::default() }
    }

    /// [`Field::distance`], to the bit.
    #[inline]
    pub fn distance(&mut self, point: [f32; 3]) -> f32 {
        if !self.octree.contains(point) {
            return self.field.distance(point);
        }
        let (_, local) = self.move_to(point);
        self.octree.value_between(&self.jets, local)
    }

    /// [`Field::distance_and_gradient`], to the bit.
    #[inline]
    pub fn distance_and_gradient(&mut self, point: [f32; 3]) -> (f32, [f32; 3]) {
        if !self.octree.contains(point) {
            return self.field.distance_and_gradient(point);
        }
        let (leaf, local) = self.move_to(point);
        self.octree.evaluate_between(&leaf, &self.jets, local)
    }

    /// The leaf of a point of the box, whose corners are then at hand, and where in it the point is.
    #[inline]
    fn move_to(&mut self, point: [f32; 3]) -> (Leaf, [f32; 3]) {
        let position = self.octree.position(point);
        let leaf = match self.leaf {
            Some(leaf) if self.octree.holds(&leaf, position) => leaf,
            _ => {
                let leaf = self.octree.leaf_at(position.map(|cells| cells as u32));
                self.octree.read_corners(&leaf, &mut self.jets);
                self.leaf = Some(leaf);
                leaf
            }
        };
        (leaf, self.octree.local(&leaf, position))
    }
}
