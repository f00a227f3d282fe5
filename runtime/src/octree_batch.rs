//! Many points of an octree at once.
//!
//! Their leaves are all found, and the blocks of these begun to be read, before the first is decoded: so the waits for memory of
//! several points overlap. Points that follow one another in a leaf decode it once.

use crate::hermite::Jets;
use crate::lattice::Leaf;
use crate::leaf::Block;
use crate::octree::Octree;

/// Points whose leaves are found together.
const CHUNK: usize = 16;

/// The leaf of a point, where in it the point is, and the leaf's block.
type Place<'a> = (Leaf, [f32; 3], Block<'a>);

impl<'a> Octree<'a> {
    /// Value at each of the points of the box.
    pub(crate) fn values(&self, points: &[[f32; 3]], values: &mut [f32]) {
        let mut jets = Jets::default();
        self.each_place(points, values.iter_mut(), &mut jets, |value, _, jets, local| {
            *value = self.value_between(jets, local);
        });
    }

    /// Value and gradient at each of the points of the box.
    pub(crate) fn evaluate_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        let mut jets = Jets::default();
        self.each_place(points, values.iter_mut().zip(gradients), &mut jets, |(value, gradient), leaf, jets, local| {
            (*value, *gradient) = self.evaluate_between(leaf, jets, local);
        });
    }

    /// Calls for each point and answer with the leaf, its corners and where in it the point is.
    #[inline]
    fn each_place<T>(
        &self,
        points: &[[f32; 3]],
        mut answers: impl Iterator<Item = T>,
        jets: &mut Jets,
        mut answer: impl FnMut(T, &Leaf, &Jets, [f32; 3]),
    ) {
        let mut last = None;
        for points in points.chunks(CHUNK) {
            let mut places: [Option<Place<'a>>; CHUNK] = [None; CHUNK];
            for (place, &point) in places.iter_mut().zip(points) {
                let (leaf, local) = self.locate(point);
                *place = Some((leaf, local, self.block(&leaf)));
            }
            for ((leaf, local, block), part) in places.iter().flatten().zip(&mut answers) {
                if last != Some(*leaf) {
                    self.read_block(leaf, block, jets);
                    last = Some(*leaf);
                }
                answer(part, leaf, jets, *local);
            }
        }
    }
}
