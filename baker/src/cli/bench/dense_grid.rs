//! What a field is measured beside: the plainest fast thing, a dense grid of floats.

use glam::{IVec3, Vec3};
use nearfield::Field;

/// Distances at the vertices of a uniform lattice over the field's box, interpolated trilinearly.
pub(super) struct DenseGrid {
    min: Vec3,
    cells_per_unit: f32,
    /// Vertices along each axis, and the largest cell index.
    vertices: [usize; 3],
    last_cell: IVec3,
    distances: Vec<f32>,
}

impl DenseGrid {
    /// Samples the field, `cells` cells along the longest side.
    pub(super) fn of(field: &Field<'_>, cells: u32) -> Self {
        let bounds = field.header().bounds;
        let (min, size) = (Vec3::from(bounds.min), Vec3::from(bounds.max) - Vec3::from(bounds.min));
        let edge = size.max_element() / cells as f32;
        let last_cell = ((size / edge).ceil().as_ivec3() - 1).max(IVec3::ZERO);
        let vertices = (last_cell + 2).to_array().map(|vertices| vertices as usize);

        let mut points = Vec::with_capacity(vertices.iter().product());
        for z in 0..vertices[2] {
            for y in 0..vertices[1] {
                for x in 0..vertices[0] {
                    points.push((min + edge * Vec3::new(x as f32, y as f32, z as f32)).to_array());
                }
            }
        }
        let mut distances = vec![0.0; points.len()];
        field.distances(&points, &mut distances);

        Self { min, cells_per_unit: 1.0 / edge, vertices, last_cell, distances }
    }

    /// Edge of a cell, mesh units.
    pub(super) fn edge(&self) -> f32 {
        1.0 / self.cells_per_unit
    }

    /// Bytes of the samples.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.distances.as_slice())
    }

    /// Distance at a point; beyond the box, by extrapolation of its nearest cell.
    #[inline]
    pub(super) fn distance(&self, point: [f32; 3]) -> f32 {
        let (corners, t) = self.cell(point);
        let along_x = |pair: usize| corners[pair] + t.x * (corners[pair + 1] - corners[pair]);
        let (low, high) = (along_x(0) + t.y * (along_x(2) - along_x(0)), along_x(4) + t.y * (along_x(6) - along_x(4)));
        low + t.z * (high - low)
    }

    /// Distance and the gradient of the interpolant at a point, as [`distance`](Self::distance).
    #[inline]
    pub(super) fn distance_and_gradient(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        let (c, t) = self.cell(point);
        let mix = |low: f32, high: f32, t: f32| low + t * (high - low);

        let x = [0, 2, 4, 6].map(|pair| mix(c[pair], c[pair + 1], t.x));
        let y = [mix(x[0], x[1], t.y), mix(x[2], x[3], t.y)];
        let slope_x = [0, 2, 4, 6].map(|pair| c[pair + 1] - c[pair]);
        let gradient = [
            mix(mix(slope_x[0], slope_x[1], t.y), mix(slope_x[2], slope_x[3], t.y), t.z),
            mix(x[1] - x[0], x[3] - x[2], t.z),
            y[1] - y[0],
        ];
        (mix(y[0], y[1], t.z), gradient.map(|slope| slope * self.cells_per_unit))
    }

    /// The eight corners of the cell that holds a point, x fastest, and the place in the cell.
    #[inline]
    fn cell(&self, point: [f32; 3]) -> ([f32; 8], Vec3) {
        let place = (Vec3::from(point) - self.min) * self.cells_per_unit;
        let cell = place.as_ivec3().clamp(IVec3::ZERO, self.last_cell);
        let [row, layer] = [self.vertices[0], self.vertices[0] * self.vertices[1]];
        let first = cell.x as usize + row * cell.y as usize + layer * cell.z as usize;

        let corners = [0, 1, row, row + 1, layer, layer + 1, layer + row, layer + row + 1]
            .map(|offset| self.distances[first + offset]);
        (corners, place - cell.as_vec3())
    }
}
