//! What a grid answers between its samples (SPEC.md §11.4).

use crate::grid::{Grid, Reconstruction};
use crate::grid_sample::FirstOrder;
use crate::hermite::{
    Corners, mix, tricubic, tricubic_and_derivatives, trilinear, trilinear_and_derivatives, trilinear_sum,
};
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

    /// The same of smoothness 1 and above.
    #[inline(never)]
    fn smooth(smoothness: u8, t: f32) -> Self {
        let rest = 1.0 - t;
        let (end, slope) = match smoothness {
            1 => (t * t * (3.0 - 2.0 * t), 6.0 * t * rest),
            2 => (t * t * t * (10.0 - t * (15.0 - 6.0 * t)), 30.0 * (t * t) * (rest * rest)),
            _ => {
                let (square, cube) = (t * t, t * rest * (t * rest) * (t * rest));
                (square * square * (35.0 - t * (84.0 - t * (70.0 - 20.0 * t))), 140.0 * cube)
            }
        };
        Self { value: [1.0 - end, end], derivative: [-slope, slope] }
    }
}

/// A point of a cell of first-order samples.
struct Place {
    local: [f32; 3],
    weights: [Weights; 3],
    /// Share of its slope that a sample contributes.
    share: f32,
}

/// What is left of a cell's first-order samples when x is given, at `2 y + z`: the value, and the derivatives by local
/// coordinates that the samples' own slopes give.
struct Face {
    value: [f32; 4],
    by_x: [f32; 4],
    by_y: [f32; 4],
    by_z: [f32; 4],
}

impl Face {
    const ZERO: Self = Self { value: [0.0; 4], by_x: [0.0; 4], by_y: [0.0; 4], by_z: [0.0; 4] };
    /// Where its four ends lie.
    const Y: [f32; 4] = [0.0, 0.0, 1.0, 1.0];
    const Z: [f32; 4] = [0.0, 1.0, 0.0, 1.0];
}

// The two functions that follow stay apart and end in memory: so compilers find their four-wide form.

/// The values of a face.
#[inline(never)]
fn values_at_x(corners: &FirstOrder, place: &Place, face: &mut Face) {
    let Place { local: [x, y, z], weights: [Weights { value: [near, far], .. }, ..], share } = *place;
    for end in 0..4 {
        let (from_y, from_z) = (y - Face::Y[end], z - Face::Z[end]);
        let at = |corner: usize, from_x: f32| corners.value_from(corner, [from_x, from_y, from_z], share);
        face.value[end] = at(end, x) * near + at(4 + end, x - 1.0) * far;
    }
}

/// The derivatives of a face.
#[inline(never)]
fn slopes_at_x(corners: &FirstOrder, place: &Place, face: &mut Face) {
    let Place { local: [x, y, z], weights: [Weights { value: [near, far], derivative }, ..], share } = *place;
    let [slope_x, slope_y, slope_z] = &corners.gradient;
    for end in 0..4 {
        let (from_y, from_z) = (y - Face::Y[end], z - Face::Z[end]);
        let at = |corner: usize, from_x: f32| corners.value_from(corner, [from_x, from_y, from_z], share);
        let own = |slopes: &Corners| share * (slopes[end] * near + slopes[4 + end] * far);
        face.by_x[end] = at(end, x) * derivative[0] + at(4 + end, x - 1.0) * derivative[1] + own(slope_x);
        face.by_y[end] = own(slope_y);
        face.by_z[end] = own(slope_z);
    }
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
        let cell = [0, 1, 2].map(|axis: usize| cell[axis].min(last[axis] - 2));
        let (value, slopes) = match (self.order(), self.reconstruction()) {
            (0, Reconstruction::Linear) => trilinear_and_derivatives(&self.distances(cell), local),
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
    #[inline(never)]
    pub(crate) fn value_between(&self, corners: &FirstOrder, local: [f32; 3]) -> f32 {
        match self.reconstruction() {
            Reconstruction::Hermite => tricubic(&corners.jets(), local),
            _ => first_order_value(corners, &self.place(local)),
        }
    }

    /// Value and derivatives by local coordinates between first-order samples.
    #[inline(never)]
    pub(crate) fn value_and_slopes_between(&self, corners: &FirstOrder, local: [f32; 3]) -> (f32, [f32; 3]) {
        match self.reconstruction() {
            Reconstruction::Hermite => tricubic_and_derivatives(&corners.jets(), local),
            _ => first_order_value_and_slopes(corners, &self.place(local)),
        }
    }

    /// What a first-order reconstruction makes of a point.
    #[inline]
    fn place(&self, local: [f32; 3]) -> Place {
        let [_, share, ..] = self.factors();
        let ([x, y, z], smoothness) = (local, self.smoothness());
        // Each by its name: of an array compilers make a call.
        let weights = [Weights::new(smoothness, x), Weights::new(smoothness, y), Weights::new(smoothness, z)];
        Place { local, weights, share }
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

/// Value between first-order samples.
#[inline]
fn first_order_value(corners: &FirstOrder, place: &Place) -> f32 {
    let mut face = Face::ZERO;
    values_at_x(corners, place, &mut face);
    let [_, y, z] = place.weights;
    face_sum(&face.value, y.value, z.value)
}

/// Value, with the bits of [`first_order_value`], and derivatives by local coordinates.
#[inline]
fn first_order_value_and_slopes(corners: &FirstOrder, place: &Place) -> (f32, [f32; 3]) {
    let mut face = Face::ZERO;
    values_at_x(corners, place, &mut face);
    slopes_at_x(corners, place, &mut face);
    let [_, y, z] = place.weights;
    let slopes = [
        face_sum(&face.by_x, y.value, z.value),
        face_sum(&face.value, y.derivative, z.value) + face_sum(&face.by_y, y.value, z.value),
        face_sum(&face.value, y.value, z.derivative) + face_sum(&face.by_z, y.value, z.value),
    ];
    (face_sum(&face.value, y.value, z.value), slopes)
}

/// Weighted sum of the four ends of a face.
#[inline]
fn face_sum(&[a, b, c, d]: &[f32; 4], y: [f32; 2], z: [f32; 2]) -> f32 {
    mix(z, [mix(y, [a, c]), mix(y, [b, d])])
}
