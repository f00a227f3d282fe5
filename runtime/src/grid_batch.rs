//! Many points of a grid at once.
//!
//! A query of a packed grid first waits for memory and then computes for so long that the next one's wait has not begun
//! meanwhile. Of several points the samples are all read first, so that they are waited for together.

use crate::grid::{Grid, GridPrecision, Reconstruction};
use crate::grid_sample::{FirstOrder, PackedCorners};

/// Points whose samples are read together.
const CHUNK: usize = 16;

/// The cells of points, where in them these are, and the samples.
#[derive(Default)]
struct Chunk {
    cell: [[u32; 3]; CHUNK],
    local: [[f32; 3]; CHUNK],
    corners: [PackedCorners; CHUNK],
}

impl Chunk {
    #[inline(never)]
    fn read(&mut self, grid: &Grid<'_>, points: &[[f32; 3]; CHUNK]) {
        grid.locate_each(points, &mut self.cell, &mut self.local);
        for (&cell, corners) in self.cell.iter().zip(&mut self.corners) {
            grid.read_packed(cell, corners);
        }
    }
}

impl Grid<'_> {
    /// Value at each of the points of the box.
    pub(crate) fn values(&self, points: &[[f32; 3]], values: &mut [f32]) {
        let (chunks, rest) = self.chunks(points);
        let (of_chunks, of_rest) = values.split_at_mut_checked(chunks.as_flattened().len()).unwrap_or_default();
        let (mut chunk, mut corners) = (Chunk::default(), FirstOrder::ZERO);
        for (points, values) in chunks.iter().zip(of_chunks.as_chunks_mut::<CHUNK>().0) {
            chunk.read(self, points);
            for ((&local, packed), value) in chunk.local.iter().zip(&chunk.corners).zip(values) {
                self.decode(packed, &mut corners);
                *value = self.value_between(&corners, local);
            }
        }
        for (&point, value) in rest.iter().zip(of_rest) {
            let (cell, local) = self.locate(point);
            *value = self.value(cell, local);
        }
    }

    /// Value and gradient at each of the points of the box.
    pub(crate) fn evaluate_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        let (chunks, rest) = self.chunks(points);
        let count = chunks.as_flattened().len();
        let (of_chunks, of_rest) = values.split_at_mut_checked(count).unwrap_or_default();
        let (slopes_of_chunks, slopes_of_rest) = gradients.split_at_mut_checked(count).unwrap_or_default();
        let (mut chunk, mut corners) = (Chunk::default(), FirstOrder::ZERO);
        let answers = of_chunks.as_chunks_mut::<CHUNK>().0.iter_mut().zip(slopes_of_chunks.as_chunks_mut::<CHUNK>().0);
        for (points, (values, gradients)) in chunks.iter().zip(answers) {
            chunk.read(self, points);
            let answers = values.iter_mut().zip(gradients);
            for ((&local, packed), (value, gradient)) in chunk.local.iter().zip(&chunk.corners).zip(answers) {
                self.decode(packed, &mut corners);
                let (distance, slopes) = self.value_and_slopes_between(&corners, local);
                (*value, *gradient) = (distance, self.per_unit(slopes));
            }
        }
        for (&point, (value, gradient)) in rest.iter().zip(of_rest.iter_mut().zip(slopes_of_rest)) {
            let (cell, local) = self.locate(point);
            (*value, *gradient) = self.evaluate(cell, local);
        }
    }

    /// The points in chunks, and those that are left over: all, of a grid for which chunks do not pay.
    fn chunks<'p>(&self, points: &'p [[f32; 3]]) -> (&'p [[[f32; 3]; CHUNK]], &'p [[f32; 3]]) {
        let is_first_order = self.order() == 1 && self.reconstruction() != Reconstruction::Nearest;
        if is_first_order && self.precision == GridPrecision::Packed32 { points.as_chunks() } else { (&[], points) }
    }
}
