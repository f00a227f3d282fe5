//! What a grid answers between its samples (SPEC.md §11.4).

use crate::grid::{Grid, Reconstruction};
use crate::hermite::{Corners, tricubic, tricubic_and_derivatives, trilinear_sum};
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
        let rest = 1.0 - t;
        let (end, slope) = match smoothness {
            0 => (t, 1.0),
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

/// The polynomials of the corners at one point: mesh units, slopes by local coordinates.
struct Answers {
    value: Corners,
    slope: [Corners; 3],
}

impl Grid<'_> {
    /// Value at local coordinates of a cell, 0 to 1 along each axis; mesh units.
    #[inline]
    pub(crate) fn value(&self, cell: [u32; 3], local: [f32; 3]) -> f32 {
        match (self.reconstruction(), self.order()) {
            (Reconstruction::Hermite, 1) => tricubic(&self.first_order(cell).jets(), local),
            (Reconstruction::Nearest | Reconstruction::Hermite, _) => self.rare(cell, local).0,
            _ => {
                let [x, y, z] = local.map(|t| Weights::new(self.smoothness(), t));
                trilinear_sum(&self.answers(cell, local).value, x.value, y.value, z.value)
            }
        }
    }

    /// Value and gradient at local coordinates, 0 to 1 along each axis, of the cell above a sample.
    ///
    /// The value is in mesh units, the gradient without unit. Cells beyond the last count as it.
    #[inline]
    pub fn evaluate(&self, cell: [u32; 3], local: [f32; 3]) -> (f32, [f32; 3]) {
        let last = self.resolution();
        let cell = [0, 1, 2].map(|axis: usize| cell[axis].min(last[axis] - 2));
        let (value, slopes) = match (self.reconstruction(), self.order()) {
            (Reconstruction::Hermite, 1) => tricubic_and_derivatives(&self.first_order(cell).jets(), local),
            (Reconstruction::Nearest | Reconstruction::Hermite, _) => self.rare(cell, local),
            _ => {
                let [x, y, z] = local.map(|t| Weights::new(self.smoothness(), t));
                let Answers { value, slope: [by_x, by_y, by_z] } = self.answers(cell, local);
                let of_weights = [
                    trilinear_sum(&value, x.derivative, y.value, z.value),
                    trilinear_sum(&value, x.value, y.derivative, z.value),
                    trilinear_sum(&value, x.value, y.value, z.derivative),
                ];
                let of_polynomials = [by_x, by_y, by_z].map(|slope| trilinear_sum(&slope, x.value, y.value, z.value));
                let slopes = [0, 1, 2].map(|axis: usize| of_weights[axis] + of_polynomials[axis]);
                (trilinear_sum(&value, x.value, y.value, z.value), slopes)
            }
        };
        (value, self.per_unit(slopes))
    }

    /// The reconstructions that are not built for speed. Apart, so that the others need less stack.
    #[inline(never)]
    fn rare(&self, cell: [u32; 3], local: [f32; 3]) -> (f32, [f32; 3]) {
        if self.reconstruction() == Reconstruction::Hermite {
            return triquintic(&self.polynomials(cell), local);
        }
        // A point midway belongs to the greater sample.
        let [x, y, z] = local.map(|t| u32::from(t >= 0.5));
        let nearest = [cell[0] + x, cell[1] + y, cell[2] + z];
        self.polynomial(nearest).at([local[0] - x as f32, local[1] - y as f32, local[2] - z as f32], WHOLE)
    }

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

    #[inline]
    fn answers(&self, cell: [u32; 3], local: [f32; 3]) -> Answers {
        match self.order() {
            0 => Answers { value: self.distances(cell), slope: [Corners::default(); 3] },
            1 => self.first_order_answers(cell, local),
            _ => self.polynomial_answers(cell, local),
        }
    }

    #[inline]
    fn first_order_answers(&self, cell: [u32; 3], [x, y, z]: [f32; 3]) -> Answers {
        let [_, factor, ..] = self.factors();
        let corners = self.first_order(cell);
        let mut answers = Answers { value: corners.distance, slope: corners.gradient };
        let [by_x, by_y, by_z] = &mut answers.slope;
        let slopes = by_x.iter_mut().zip(by_y).zip(by_z);
        for (corner, (value, ((by_x, by_y), by_z))) in answers.value.iter_mut().zip(slopes).enumerate() {
            let end = |bit: usize| (corner >> bit & 1) as f32;
            (*by_x, *by_y, *by_z) = (*by_x * factor, *by_y * factor, *by_z * factor);
            *value += *by_x * (x - end(2)) + *by_y * (y - end(1)) + *by_z * (z - end(0));
        }
        answers
    }

    #[inline(never)]
    fn polynomial_answers(&self, cell: [u32; 3], [x, y, z]: [f32; 3]) -> Answers {
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
}
