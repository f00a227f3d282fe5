//! Many points of a grid at once.
//!
//! A query of a packed grid first waits for memory and then computes for so long that the next one's wait has not begun
//! meanwhile. Of several points the samples are all read first, so that they are waited for together. Between samples of
//! order 0 little is computed: there points are the lanes of vectors.

use crate::grid::{Grid, GridPrecision, Reconstruction};
use crate::grid_sample::{FirstOrder, PackedCorners};
use crate::hermite::{trilinear, trilinear_and_derivatives};

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

/// A number of each point.
type Numbers = [f32; CHUNK];

/// Points between distances, a lane each.
#[derive(Default)]
struct Lanes {
    cell: [[u32; 3]; CHUNK],
    local: [[f32; 3]; CHUNK],
    stored: [[u32; CHUNK]; 8],
    corners: [Numbers; 8],
    value: Numbers,
    slopes: [Numbers; 3],
}

impl Lanes {
    #[inline(never)]
    fn read(&mut self, grid: &Grid<'_>, points: &[[f32; 3]; CHUNK]) {
        grid.locate_each(points, &mut self.cell, &mut self.local);
        for lane in 0..CHUNK {
            let stored = grid.stored_distances(self.cell[lane]);
            for (corner, stored) in self.stored.iter_mut().zip(stored) {
                corner[lane] = stored;
            }
        }
        grid.decode_each(self.stored.as_flattened(), self.corners.as_flattened_mut());
    }

    /// The distances at the corners of a point's cell.
    #[inline(always)]
    fn corners(&self, lane: usize) -> [f32; 8] {
        let [a, b, c, d, e, f, g, h] = &self.corners;
        [a[lane], b[lane], c[lane], d[lane], e[lane], f[lane], g[lane], h[lane]]
    }

    #[inline(never)]
    fn interpolate(&mut self) {
        for lane in 0..CHUNK {
            self.value[lane] = trilinear(&self.corners(lane), self.local[lane]);
        }
    }

    #[inline(never)]
    fn differentiate(&mut self) {
        for lane in 0..CHUNK {
            let (value, slopes) = trilinear_and_derivatives(&self.corners(lane), self.local[lane]);
            self.value[lane] = value;
            for (axis, slope) in self.slopes.iter_mut().zip(slopes) {
                axis[lane] = slope;
            }
        }
    }
}

impl Grid<'_> {
    /// Value at each of the points of the box.
    pub(crate) fn values(&self, points: &[[f32; 3]], values: &mut [f32]) {
        if self.is_trilinear() {
            return self.values_between_distances(points, values);
        }
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
        self.value_of_each(rest, of_rest);
    }

    /// Value at each of the points, one by one.
    fn value_of_each(&self, points: &[[f32; 3]], values: &mut [f32]) {
        for (&point, value) in points.iter().zip(values) {
            let (cell, local) = self.locate(point);
            *value = self.value(cell, local);
        }
    }

    /// Value at each of the points of a grid of order 0.
    fn values_between_distances(&self, points: &[[f32; 3]], values: &mut [f32]) {
        let (chunks, rest) = points.as_chunks();
        let (of_chunks, of_rest) = values.split_at_mut_checked(chunks.as_flattened().len()).unwrap_or_default();
        let mut lanes = Lanes::default();
        for (points, values) in chunks.iter().zip(of_chunks.as_chunks_mut().0) {
            lanes.read(self, points);
            lanes.interpolate();
            *values = lanes.value;
        }
        self.value_of_each(rest, of_rest);
    }

    /// Value and gradient at each of the points of a grid of order 0.
    fn evaluate_each_between_distances(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        let (chunks, rest) = points.as_chunks();
        let count = chunks.as_flattened().len();
        let (of_chunks, of_rest) = values.split_at_mut_checked(count).unwrap_or_default();
        let (slopes_of_chunks, slopes_of_rest) = gradients.split_at_mut_checked(count).unwrap_or_default();
        let mut lanes = Lanes::default();
        let answers = of_chunks.as_chunks_mut().0.iter_mut().zip(slopes_of_chunks.as_chunks_mut::<CHUNK>().0);
        for (points, (values, gradients)) in chunks.iter().zip(answers) {
            lanes.read(self, points);
            lanes.differentiate();
            *values = lanes.value;
            let [x, y, z] = &lanes.slopes;
            for lane in 0..CHUNK {
                gradients[lane] = self.per_unit([x[lane], y[lane], z[lane]]);
            }
        }
        self.evaluate_each_alone(rest, of_rest, slopes_of_rest);
    }

    /// Value and gradient at each of the points, one by one.
    fn evaluate_each_alone(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        for (&point, (value, gradient)) in points.iter().zip(values.iter_mut().zip(gradients)) {
            let (cell, local) = self.locate(point);
            (*value, *gradient) = self.evaluate(cell, local);
        }
    }

    /// Value and gradient at each of the points of the box.
    pub(crate) fn evaluate_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: &mut [[f32; 3]]) {
        if self.is_trilinear() {
            return self.evaluate_each_between_distances(points, values, gradients);
        }
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
        self.evaluate_each_alone(rest, of_rest, slopes_of_rest);
    }

    /// The points in chunks, and those that are left over: all, of a grid for which chunks do not pay.
    fn chunks<'p>(&self, points: &'p [[f32; 3]]) -> (&'p [[[f32; 3]; CHUNK]], &'p [[f32; 3]]) {
        let is_first_order = self.order() == 1 && self.reconstruction() != Reconstruction::Nearest;
        if is_first_order && self.precision == GridPrecision::Packed32 { points.as_chunks() } else { (&[], points) }
    }
}
