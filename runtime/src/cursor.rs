//! Queries that remember a leaf.

use crate::field::Field;
use crate::hermite::Jets;
use crate::lattice::Leaf;
use crate::octree::Octree;
use crate::polynomial_octree::Visit;
use crate::representation::{Any, Kind, Representation};

/// Answers queries that are near one another: a ray's steps, a particle's path, the points of a row.
///
/// It keeps what is in the leaf of the last query, and a query in the same leaf skips the tree and the decoding.
/// A grid has nothing to skip. Every answer has the bits that the field alone would give. Some 900 bytes; make one for
/// each thread.
///
/// ```
/// # fn distances(field: &nearfield::Field<'_>, row: impl Iterator<Item = [f32; 3]>) -> f32 {
/// let mut cursor = field.cursor();
/// row.map(|point| cursor.distance(point)).fold(f32::INFINITY, f32::min)
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Cursor<'a, R = Any<'a>> {
    field: Field<'a, R>,
    leaf: Option<Leaf>,
    jets: Jets,
    visit: Visit,
}

impl<'a, R: Representation<'a>> Cursor<'a, R> {
    pub(crate) fn new(field: Field<'a, R>) -> Self {
        Self { field, leaf: None, jets: Jets::default(), visit: Visit::default() }
    }

    /// [`Field::distance`], to the bit.
    #[inline]
    pub fn distance(&mut self, point: [f32; 3]) -> f32 {
        match self.field.kind() {
            Kind::Octree(octree) if octree.lattice.contains(point) => {
                let (_, local) = move_to(octree, point, &mut self.leaf, &mut self.jets);
                octree.value_between(&self.jets, local)
            }
            Kind::Polynomial(octree) if octree.lattice.contains(point) => {
                octree.query_from(point, false, &mut self.visit).value
            }
            _ => self.field.distance(point),
        }
    }

    /// [`Field::distance_and_gradient`], to the bit.
    #[inline]
    pub fn distance_and_gradient(&mut self, point: [f32; 3]) -> (f32, [f32; 3]) {
        match self.field.kind() {
            Kind::Octree(octree) if octree.lattice.contains(point) => {
                let (leaf, local) = move_to(octree, point, &mut self.leaf, &mut self.jets);
                octree.evaluate_between(&leaf, &self.jets, local)
            }
            Kind::Polynomial(octree) if octree.lattice.contains(point) => {
                octree.query_from(point, true, &mut self.visit).split()
            }
            _ => self.field.distance_and_gradient(point),
        }
    }
}

/// The leaf of a point of the box, whose corners are then in `jets`, and where in it the point is.
#[inline]
fn move_to(octree: &Octree<'_>, point: [f32; 3], last: &mut Option<Leaf>, jets: &mut Jets) -> (Leaf, [f32; 3]) {
    let position = octree.lattice.position(point);
    let leaf = match *last {
        Some(leaf) if octree.lattice.holds(&leaf, position) => leaf,
        _ => {
            let leaf = octree.leaf_in(octree.lattice.cell_of(position));
            octree.read_corners(&leaf, jets);
            *last = Some(leaf);
            leaf
        }
    };
    (leaf, octree.lattice.local(&leaf, position))
}
