//! Polynomials and sums of polynomial leaves at many points side by side: a vector holds a number of four points or eight.
//!
//! The operations and their order are those for one point, so the bits are the same. Functions that are never inlined end in
//! memory, for the sake of vectors.

use crate::blend::{self, Steepness};
use crate::legendre::Coefficients;
use crate::polynomial_leaf::{Answer, Polynomials};

/// Points that are evaluated side by side.
pub(crate) const POINTS: usize = 16;

/// A number for each point.
pub(crate) type Row = [f32; POINTS];

/// What a leaf answers at each point, or several: values, and gradients by axis if asked for.
#[derive(Clone, Copy, Default)]
pub(crate) struct Answers {
    pub(crate) value: Row,
    pub(crate) gradient: [Row; 3],
}

/// Sums over leaves, as for one point.
#[derive(Clone, Copy, Default)]
pub(crate) struct Sums {
    weight: Row,
    value: Row,
    weight_slope: [Row; 3],
    slope: [Row; 3],
}

/// Local coordinates of positions, -1 to 1 within the leaf that holds a cell.
#[inline(never)]
pub(crate) fn locals(positions: &[Row; 3], cell: &[u32; 4], shift: u32, local: &mut [Row; 3]) {
    let per_half = f32::from_bits((128 - shift) << 23);
    for axis in 0..3 {
        let low = (cell[axis] & (u32::MAX << shift)).cast_signed() as f32;
        for lane in 0..POINTS {
            local[axis][lane] = (positions[axis][lane] - low) * per_half - 1.0;
        }
    }
}

/// Leaves a share of 1 to those points alone that a support holds.
#[inline(never)]
pub(crate) fn holds([x, y, z]: &[Row; 3], steepness: Steepness, share: &mut Row) {
    for lane in 0..POINTS {
        let (x, y, z) = (x[lane].abs(), y[lane].abs(), z[lane].abs());
        let xy = if x > y { x } else { y };
        let farthest = if xy > z { xy } else { z };
        share[lane] *= if 0.5 + (1.0 - farthest) * steepness > 0.0 { 1.0 } else { 0.0 };
    }
}

impl Answers {
    /// At one point.
    pub(crate) fn at(&self, lane: usize) -> Answer {
        let lane = lane & (POINTS - 1);
        let [x, y, z] = &self.gradient;
        Answer { value: self.value[lane], gradient: [x[lane], y[lane], z[lane], 0.0] }
    }

    pub(crate) fn set(&mut self, lane: usize, (value, gradient): (f32, [f32; 3])) {
        let lane = lane & (POINTS - 1);
        self.value[lane] = value;
        for (row, part) in self.gradient.iter_mut().zip(gradient) {
            row[lane] = part;
        }
    }
}

#[inline(never)]
fn scale(row: &mut Row, factor: f32) {
    for number in row {
        *number *= factor;
    }
}

/// The smooth steps of an axis, and their derivatives.
#[inline(never)]
fn steps(local: &Row, steepness: Steepness, step: &mut Row, slope: &mut Row) {
    for lane in 0..POINTS {
        (step[lane], slope[lane]) = blend::step(local[lane], steepness);
    }
}

/// The weight of a leaf at each point, and what its slopes are made of.
#[derive(Default)]
struct Weights {
    /// 1 at the points that the leaf is added at, otherwise 0.
    share: Row,
    weight: Row,
    step: [Row; 3],
    slope: [Row; 3],
}

impl Weights {
    fn at(local: &[Row; 3], steepness: Steepness, share: &Row) -> Self {
        let mut weights = Self { share: *share, ..Self::default() };
        for (local, (step, slope)) in local.iter().zip(weights.step.iter_mut().zip(&mut weights.slope)) {
            steps(local, steepness, step, slope);
        }
        weights
    }
}

impl Sums {
    /// Adds a leaf at the points whose share is 1 rather than 0.
    pub(crate) fn add(
        &mut self,
        local: &[Row; 3],
        steepness: Steepness,
        per_half: f32,
        answers: &Answers,
        share: &Row,
    ) {
        let mut weights = Weights::at(local, steepness, share);
        self.add_values(&mut weights, &answers.value);
        for axis in 0..3 {
            self.add_slopes(axis, &weights, per_half, answers);
        }
    }

    #[inline(never)]
    fn add_values(&mut self, weights: &mut Weights, value: &Row) {
        let [x, y, z] = &weights.step;
        for lane in 0..POINTS {
            let weight = (x[lane] * (y[lane] * z[lane])) * weights.share[lane];
            weights.weight[lane] = weight;
            self.weight[lane] += weight;
            self.value[lane] += weight * value[lane];
        }
    }

    #[inline(never)]
    fn add_slopes(&mut self, axis: usize, weights: &Weights, per_half: f32, answers: &Answers) {
        let (axis, next, previous) = (axis % 3, (axis + 1) % 3, (axis + 2) % 3);
        let (next, previous) = (&weights.step[next], &weights.step[previous]);
        let (step_slope, gradient) = (&weights.slope[axis], &answers.gradient[axis]);
        let (weight_slope, sum) = (&mut self.weight_slope[axis], &mut self.slope[axis]);
        for lane in 0..POINTS {
            let slope = ((step_slope[lane] * (next[lane] * previous[lane])) * per_half) * weights.share[lane];
            weight_slope[lane] += slope;
            sum[lane] += weights.weight[lane] * gradient[lane] + slope * answers.value[lane];
        }
    }

    /// Makes the answers of the leaf that holds the points the mean by weight, where others had a say: where `blended` is
    /// not 0.
    #[inline(never)]
    pub(crate) fn add_mean_to(&self, blended: &Row, answers: &mut Answers) {
        for (lane, &blended) in blended.iter().enumerate() {
            let per_weight = 1.0 / self.weight[lane];
            let change = self.value[lane] * per_weight;
            let is_blended = (blended > 0.0) & (self.weight[lane] > 0.0);
            answers.value[lane] = if is_blended { answers.value[lane] + change } else { answers.value[lane] };
            for axis in 0..3 {
                let mean = (self.slope[axis][lane] - change * self.weight_slope[axis][lane]) * per_weight;
                let own = answers.gradient[axis][lane];
                answers.gradient[axis][lane] = if is_blended { mean } else { own };
            }
        }
    }
}

impl Polynomials {
    /// What the leaf answers at each point.
    pub(crate) fn evaluate_each(&self, local: &[Row; 3], per_half: f32, answers: &mut Answers) {
        let shape = self.shape;
        self.first.evaluate_each(shape.degree(0), local, answers);
        if !shape.is_single() {
            let mut other = Answers::default();
            self.second.evaluate_each(shape.degree(1), local, &mut other);
            for lane in 0..POINTS {
                if shape.prefers(other.value[lane], answers.value[lane]) {
                    answers.value[lane] = other.value[lane];
                    for axis in 0..3 {
                        answers.gradient[axis][lane] = other.gradient[axis][lane];
                    }
                }
            }
        }
        scale(&mut answers.value, self.step);
        for row in &mut answers.gradient {
            scale(row, self.step * per_half);
        }
    }
}

impl Coefficients {
    /// [`evaluate`](Self::evaluate) at each point, with the same operations in the same order.
    #[inline(never)]
    fn evaluate_each(&self, degree: u32, point: &[Row; 3], answers: &mut Answers) {
        let mut parts = [[0.0; POINTS]; 3];
        for (axis, (part, slope)) in parts.iter_mut().zip(&mut answers.gradient).enumerate() {
            match degree {
                0 => *slope = [0.0; POINTS],
                1 => self.first_each(axis, point, part, slope),
                2 => self.second_each(axis, point, part, slope),
                _ => self.third_each(axis, point, part, slope),
            }
        }
        let product = if degree < 3 { 0.0 } else { self.product };
        self.add_up(product, point, &parts, &mut answers.value);
    }

    #[inline(never)]
    fn add_up(&self, product: f32, [x, y, z]: &[Row; 3], [a, b, c]: &[Row; 3], value: &mut Row) {
        for lane in 0..POINTS {
            let constant = self.constant + product * (x[lane] * y[lane] * z[lane]);
            value[lane] = constant + ((a[lane] + b[lane]) + c[lane]);
        }
    }

    #[inline(never)]
    fn first_each(&self, axis: usize, point: &[Row; 3], part: &mut Row, slope: &mut Row) {
        let linear = self.linear[axis & 3];
        for lane in 0..POINTS {
            part[lane] = linear * point[axis % 3][lane];
            slope[lane] = linear;
        }
    }

    #[inline(never)]
    fn second_each(&self, axis: usize, point: &[Row; 3], part: &mut Row, slope: &mut Row) {
        let (axis, next, previous) = (axis % 3, (axis + 1) % 3, (axis + 2) % 3);
        let [linear, cross, square] = [self.linear[axis], self.cross[axis], self.square[axis]];
        let cross_before = self.cross[previous];
        let (x, y, z) = (&point[axis], &point[next], &point[previous]);
        for lane in 0..POINTS {
            let line = linear + cross * y[lane];
            let second = 1.5 * (x[lane] * x[lane]) - 0.5;
            part[lane] = line * x[lane] + square * second;
            slope[lane] = (line + cross_before * z[lane]) + square * (3.0 * x[lane]);
        }
    }

    #[inline(never)]
    fn third_each(&self, axis: usize, point: &[Row; 3], part: &mut Row, slope: &mut Row) {
        let (axis, next, previous) = (axis % 3, (axis + 1) % 3, (axis + 2) % 3);
        let [linear, cross, square, cube] = [self.linear[axis], self.cross[axis], self.square[axis], self.cube[axis]];
        let [by_next, by_previous] = [self.next[axis], self.previous[axis]];
        let [cross_before, next_before, previous_after] =
            [self.cross[previous], self.next[previous], self.previous[next]];
        let (x, y, z) = (&point[axis], &point[next], &point[previous]);
        for lane in 0..POINTS {
            let (x, y, z) = (x[lane], y[lane], z[lane]);
            let squared = x * x;
            let second = 1.5 * squared - 0.5;
            let line = linear + cross * y;
            let square = square + (by_next * y + by_previous * z);
            let third = x * (2.5 * squared - 1.5);
            part[lane] = (line * x + square * second) + cube * third;
            let next_slope = next_before * (1.5 * (z * z) - 0.5);
            let previous_slope = previous_after * (1.5 * (y * y) - 0.5);
            slope[lane] = ((line + cross_before * z) + square * (3.0 * x))
                + (cube * (7.5 * squared - 1.5) + (next_slope + previous_slope))
                + self.product * (y * z);
        }
    }
}
