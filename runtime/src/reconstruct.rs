//! What a grid answers between its samples (SPEC.md §11.4).

use crate::grid::{Grid, Reconstruction};
use crate::grid_sample::FirstOrder;
use crate::hermite::{self, Corners, Weights as Basis, trilinear, trilinear_and_derivatives, trilinear_sum};
use crate::math::{each_axis, each_lane};
use crate::polynomial::triquintic;

/// Every term of a polynomial as it is.
const WHOLE: [f32; 4] = [1.0; 4];

/// Weights of the two ends of an axis, and their derivatives.
#[derive(Clone, Copy)]
struct Weights {
    value: [f32; 2],
    derivative: [f32; 2],
}

impl Weights {
    /// Weights whose derivatives vanish at both ends, up to the `smoothness`-th.
    #[inline]
    fn new(smoothness: u8, t: f32) -> Self {
        if smoothness == 0 {
            Self { value: [1.0 - t, t], derivative: [-1.0, 1.0] }
        } else {
            Self::smooth(smoothness, t)
        }
    }

    /// The same of smoothness 2 and 3: samples of first order have a [`Basis`].
    #[inline(never)]
    fn smooth(smoothness: u8, t: f32) -> Self {
        let rest = 1.0 - t;
        let (end, slope) = match smoothness {
            2 => (t * t * t * (10.0 - t * (15.0 - 6.0 * t)), 30.0 * (t * t) * (rest * rest)),
            _ => {
                let (square, cube) = (t * t, t * rest * (t * rest) * (t * rest));
                (square * square * (35.0 - t * (84.0 - t * (70.0 - 20.0 * t))), 140.0 * cube)
            }
        };
        Self { value: [1.0 - end, end], derivative: [-slope, slope] }
    }
}

/// A number for each end y and z of a cell, at `2 y + z`.
type Face = [f32; 4];

// As in `hermite`, these functions stay apart, take coordinates in registers and end in memory.

/// The weights of the far ends where those of a grid are smooth (SPEC.md §11.4).
#[inline(always)]
fn smooth(t: &[f32; 4]) -> [f32; 4] {
    each_lane(|axis| t[axis] * t[axis] * (3.0 - 2.0 * t[axis]))
}

/// The basis of polynomials weighted linearly or smoothly, of whose slopes a share counts: that share times the spacing is
/// `slope`.
#[inline(never)]
fn weighted_basis(x: f32, y: f32, z: f32, is_smooth: bool, slope: &[f32; 4], basis: &mut Basis) {
    let t = [x, y, z, 0.0];
    let far = if is_smooth { smooth(&t) } else { t };
    for axis in 0..4 {
        let near = 1.0 - far[axis];
        basis[0][axis] = near;
        basis[1][axis] = far[axis];
        basis[2][axis] = slope[axis] * (t[axis] * near);
        basis[3][axis] = slope[axis] * ((t[axis] - 1.0) * far[axis]);
    }
}

/// Its derivative.
#[inline(never)]
fn weighted_basis_derivative(x: f32, y: f32, z: f32, is_smooth: bool, slope: &[f32; 4], basis: &mut Basis) {
    let t = [x, y, z, 0.0];
    let (mut far, mut change) = (t, [1.0; 4]);
    if is_smooth {
        far = smooth(&t);
        change = each_lane(|axis| 6.0 * t[axis] * (1.0 - t[axis]));
    }
    for axis in 0..4 {
        basis[0][axis] = -change[axis];
        basis[1][axis] = change[axis];
        basis[2][axis] = slope[axis] * ((1.0 - far[axis]) - t[axis] * change[axis]);
        basis[3][axis] = slope[axis] * (far[axis] + (t[axis] - 1.0) * change[axis]);
    }
}

/// Slopes by mesh units instead of by the spacing.
#[inline(never)]
fn scale_slopes(basis: &mut Basis, spacing: &[f32; 4]) {
    for (axis, spacing) in spacing.iter().enumerate() {
        basis[2][axis] *= spacing;
        basis[3][axis] *= spacing;
    }
}

// Every reconstruction of first-order samples is the tensor product of a basis along the three axes, without the mixed
// derivatives; they differ in nothing but the basis. Corners beyond a face of the cell weigh exactly nothing on it, and sums
// pair the ends of one axis after another: both cells at a face have the same bits there.

/// The samples weighed by a basis, the ends y and z still apart: so compilers find the four-wide form.
#[inline(never)]
fn weigh(corners: &FirstOrder, basis: &Basis, face: &mut Face) {
    let [x, y, z] = axes(basis);
    let across = Across::new(y, z);
    for (lane, sum) in face.iter_mut().enumerate() {
        *sum = across.weigh(corners.along_x(x, lane), lane);
    }
}

/// The same, and with the basis of one axis after another replaced by its derivative.
#[inline(never)]
fn weigh_each(corners: &FirstOrder, basis: &Basis, derivative: &Basis, faces: &mut [Face; 4]) {
    let ([x, y, z], [by_x, by_y, by_z]) = (axes(basis), axes(derivative));
    let (across, across_by_y, across_by_z) = (Across::new(y, z), Across::new(by_y, z), Across::new(y, by_z));
    let [value, slope_x, slope_y, slope_z] = faces;
    for lane in 0..4 {
        let edge = corners.along_x(x, lane);
        value[lane] = across.weigh(edge, lane);
        slope_x[lane] = across.weigh(corners.along_x(by_x, lane), lane);
        slope_y[lane] = across_by_y.weigh(edge, lane);
        slope_z[lane] = across_by_z.weigh(edge, lane);
    }
}

/// The basis of each axis: values near and far, slopes near and far.
#[inline]
fn axes(basis: &Basis) -> [[f32; 4]; 3] {
    [basis.map(|row| row[0]), basis.map(|row| row[1]), basis.map(|row| row[2])]
}

impl FirstOrder {
    /// Value and derivatives by y and z of one of the edges along x.
    #[inline]
    fn along_x(&self, [near, far, near_slope, far_slope]: [f32; 4], lane: usize) -> [f32; 3] {
        let Self { distance, gradient: [by_x, by_y, by_z] } = self;
        let [start, end] = [lane & 3, lane & 3 | 4];
        let mix = |at_near: f32, at_far: f32| near * at_near + far * at_far;
        let value = (near * distance[start] + near_slope * by_x[start]) + (far * distance[end] + far_slope * by_x[end]);
        [value, mix(by_y[start], by_y[end]), mix(by_z[start], by_z[end])]
    }
}

/// Products of the basis of y and that of z: of both values, and of the slope of either with the value of the other.
struct Across {
    values: Face,
    slope_y: Face,
    slope_z: Face,
}

impl Across {
    #[inline]
    fn new([y, far_y, slope_y, far_slope_y]: [f32; 4], [z, far_z, slope_z, far_slope_z]: [f32; 4]) -> Self {
        Self {
            values: [y * z, y * far_z, far_y * z, far_y * far_z],
            slope_y: [slope_y * z, slope_y * far_z, far_slope_y * z, far_slope_y * far_z],
            slope_z: [y * slope_z, y * far_slope_z, far_y * slope_z, far_y * far_slope_z],
        }
    }

    #[inline]
    fn weigh(&self, [value, by_y, by_z]: [f32; 3], lane: usize) -> f32 {
        let lane = lane & 3;
        value * self.values[lane] + (by_y * self.slope_y[lane] + by_z * self.slope_z[lane])
    }
}

#[inline]
fn sum([a, b, c, d]: Face) -> f32 {
    (a + c) + (b + d)
}

/// The polynomials of the corners at one point: mesh units, slopes by local coordinates.
struct Answers {
    value: Corners,
    slope: [Corners; 3],
}

impl Grid<'_> {
    /// Value at local coordinates of a cell, 0 to 1 along each axis; mesh units.
    #[inline(never)]
    pub(crate) fn value(&self, cell: [u32; 3], local: [f32; 3]) -> f32 {
        match (self.order(), self.reconstruction()) {
            (0, Reconstruction::Linear) => trilinear(&self.distances(cell), local),
            (1, Reconstruction::Nearest) => self.rare(cell, local).0,
            (1, _) => {
                let mut corners = FirstOrder::ZERO;
                self.read_first_order(cell, &mut corners);
                self.value_between(&corners, local)
            }
            _ => self.rare(cell, local).0,
        }
    }

    /// Value and gradient at local coordinates, 0 to 1 along each axis, of the cell above a sample.
    ///
    /// The value is in mesh units, the gradient without unit. Cells beyond the last count as it.
    #[inline(never)]
    pub fn evaluate(&self, cell: [u32; 3], local: [f32; 3]) -> (f32, [f32; 3]) {
        let last = self.resolution();
        let cell = each_axis(|axis| cell[axis].min(last[axis] - 2));
        // Apart from the others, which leave their answers in memory: read again together, these would be waited for.
        if self.is_trilinear() {
            let (value, slopes) = trilinear_and_derivatives(&self.distances(cell), local);
            return (value, self.per_unit(slopes));
        }
        let (value, slopes) = match (self.order(), self.reconstruction()) {
            (1, Reconstruction::Nearest) => self.rare(cell, local),
            (1, _) => {
                let mut corners = FirstOrder::ZERO;
                self.read_first_order(cell, &mut corners);
                self.value_and_slopes_between(&corners, local)
            }
            _ => self.rare(cell, local),
        };
        (value, self.per_unit(slopes))
    }

    /// Value between first-order samples.
    #[inline]
    pub(crate) fn value_between(&self, corners: &FirstOrder, local: [f32; 3]) -> f32 {
        let (mut basis, mut face) = (Basis::default(), Face::default());
        self.basis(local, &mut basis, None);
        weigh(corners, &basis, &mut face);
        sum(face)
    }

    /// Value, with the bits of [`Self::value_between`], and derivatives by local coordinates.
    #[inline]
    pub(crate) fn value_and_slopes_between(&self, corners: &FirstOrder, local: [f32; 3]) -> (f32, [f32; 3]) {
        let (mut basis, mut derivative, mut faces) = (Basis::default(), Basis::default(), [Face::default(); 4]);
        self.basis(local, &mut basis, Some(&mut derivative));
        weigh_each(corners, &basis, &derivative, &mut faces);
        let [value, by_x, by_y, by_z] = faces.map(sum);
        (value, [by_x, by_y, by_z])
    }

    /// The basis at a point of a cell, and its derivatives by local coordinates.
    #[inline]
    fn basis(&self, [x, y, z]: [f32; 3], basis: &mut Basis, derivative: Option<&mut Basis>) {
        if self.reconstruction() == Reconstruction::Hermite {
            hermite::basis(x, y, z, basis);
            scale_slopes(basis, &self.slope_scale);
            if let Some(derivative) = derivative {
                hermite::basis_derivative(x, y, z, derivative);
                scale_slopes(derivative, &self.slope_scale);
            }
            return;
        }

        let is_smooth = self.smoothness() > 0;
        weighted_basis(x, y, z, is_smooth, &self.slope_scale, basis);
        if let Some(derivative) = derivative {
            weighted_basis_derivative(x, y, z, is_smooth, &self.slope_scale, derivative);
        }
    }

    /// The reconstructions that are not built for speed.
    #[inline(never)]
    fn rare(&self, cell: [u32; 3], local: [f32; 3]) -> (f32, [f32; 3]) {
        match self.reconstruction() {
            Reconstruction::Hermite => triquintic(&self.polynomials(cell), local),
            Reconstruction::Nearest => self.nearest(cell, local),
            _ => self.weighted(cell, local),
        }
    }

    /// The polynomial of the nearest sample.
    fn nearest(&self, cell: [u32; 3], local: [f32; 3]) -> (f32, [f32; 3]) {
        // A point midway belongs to the greater sample.
        let [x, y, z] = local.map(|t| u32::from(t >= 0.5));
        let nearest = [cell[0] + x, cell[1] + y, cell[2] + z];
        self.polynomial(nearest).at([local[0] - x as f32, local[1] - y as f32, local[2] - z as f32], WHOLE)
    }

    /// The weighted polynomials of samples of any order.
    fn weighted(&self, cell: [u32; 3], local: [f32; 3]) -> (f32, [f32; 3]) {
        let [x, y, z] = local.map(|t| Weights::new(self.smoothness(), t));
        let Answers { value, slope: [by_x, by_y, by_z] } = self.answers(cell, local);
        let slopes = [
            rare_sum(&value, x.derivative, y.value, z.value) + rare_sum(&by_x, x.value, y.value, z.value),
            rare_sum(&value, x.value, y.derivative, z.value) + rare_sum(&by_y, x.value, y.value, z.value),
            rare_sum(&value, x.value, y.value, z.derivative) + rare_sum(&by_z, x.value, y.value, z.value),
        ];
        (rare_sum(&value, x.value, y.value, z.value), slopes)
    }

    fn answers(&self, cell: [u32; 3], [x, y, z]: [f32; 3]) -> Answers {
        let factors = self.factors();
        let mut answers = Answers { value: Corners::default(), slope: [Corners::default(); 3] };
        for (corner, polynomial) in self.polynomials(cell).iter().enumerate() {
            let end = |bit: usize| (corner >> bit & 1) as f32;
            let (value, [by_x, by_y, by_z]) = polynomial.at([x - end(2), y - end(1), z - end(0)], factors);
            // The mask shows the compiler that no index can fail.
            let corner = corner & 7;
            answers.value[corner] = value;
            answers.slope[0][corner] = by_x;
            answers.slope[1][corner] = by_y;
            answers.slope[2][corner] = by_z;
        }
        answers
    }

    /// Whether it interpolates distances and nothing else.
    #[inline]
    pub(crate) fn is_trilinear(&self) -> bool {
        self.order() == 0 && self.reconstruction() == Reconstruction::Linear
    }

    /// How many derivatives of the weights vanish at the ends.
    #[inline]
    fn smoothness(&self) -> u8 {
        if self.reconstruction() == Reconstruction::Blend { self.order() } else { 0 }
    }

    /// Share of its terms of each degree that a sample contributes.
    #[inline]
    fn factors(&self) -> [f32; 4] {
        if self.reconstruction() != Reconstruction::Half {
            return WHOLE;
        }
        match self.order() {
            1 => [1.0, 0.5, 0.0, 0.0],
            2 => [1.0, 2.0 / 3.0, 1.0 / 3.0, 0.0],
            _ => [1.0, 0.75, 0.5, 0.25],
        }
    }
}

/// [`trilinear_sum`] where it is called seven times and may take its time.
#[inline(never)]
fn rare_sum(corners: &Corners, x: [f32; 2], y: [f32; 2], z: [f32; 2]) -> f32 {
    trilinear_sum(corners, x, y, z)
}
