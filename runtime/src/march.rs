//! Walks through a field: along a ray, and down to the surface.

use crate::field::Field;
use crate::header::Aabb;
use crate::math::{self, each_axis};
use crate::representation::Representation;

/// Most queries of a [`Field::raycast`].
const MAX_RAY_STEPS: u32 = 512;
/// Most queries of a [`Field::closest_point`].
const MAX_DESCENT_STEPS: u32 = 16;
/// Share of the box's longest side below which lengths are lost in the rounding of coordinates: 2⁻²⁰.
const RESOLUTION: f32 = 1.0 / (1 << 20) as f32;

/// Where a ray met the surface. Mesh units, mesh frame, finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// Along the ray from its origin, at least 0.
    pub distance: f32,
    /// On the ray, inside the box.
    pub point: [f32; 3],
    /// Unit gradient at the point, or zero where the field has none.
    pub normal: [f32; 3],
    /// Queries that it took.
    pub steps: u32,
}

/// What became of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Raycast {
    /// The field is at most `within` here, and was more before.
    Hit(RayHit),
    /// The ray left the box or ended first.
    Miss {
        /// Queries that it took.
        steps: u32,
    },
    /// The ray grazed the surface for longer than its 512 steps: clear up to here.
    OutOfSteps {
        /// Along the ray from its origin, mesh units.
        clear: f32,
    },
}

/// The end of a descent to the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestPoint {
    /// Inside the box; mesh units, mesh frame.
    pub point: [f32; 3],
    /// The field there, mesh units: how far the descent stayed from the surface.
    pub residual: f32,
    /// Queries that it took, at most 16.
    pub steps: u32,
}

impl<'a, R: Representation<'a>> Field<'a, R> {
    /// Follows a ray to the surface by sphere tracing (Hart 1996), inside the box, with at most 512 queries.
    ///
    /// `direction` needs no unit length; `length` and `within` are mesh units. The ray stops where the field is at
    /// most `within`, or 2⁻²⁰ of the box's longest side if that is more.
    ///
    /// No step is longer than the field divided by its stored Lipschitz bound, so a ray passes no place where the field,
    /// if it is continuous, is `within` or less by more than the rounding of a coordinate, however thin the wall. With
    /// `within` of at least [`max_error`](crate::ErrorContract::max_error) it stops before the true surface wherever
    /// the field is as good as at the points that were measured. A ray that starts so near stops at once.
    ///
    /// A miss if the direction is zero, or anything is not finite.
    pub fn raycast(&self, origin: [f32; 3], direction: [f32; 3], length: f32, within: f32) -> Raycast {
        let is_finite = origin.iter().chain(&direction).chain([&within]).all(|number| number.is_finite());
        if !is_finite || length.is_nan() || direction == [0.0; 3] {
            return Raycast::Miss { steps: 0 };
        }
        let (_, direction) = math::length_and_direction(direction);
        let (bounds, steepest) = self.bounds_and_steepest();
        let Some((start, end)) = clip(bounds, origin, direction, length) else {
            return Raycast::Miss { steps: 0 };
        };

        let within = within.max(RESOLUTION * longest_side(bounds));
        let at = |t: f32| {
            let point = each_axis(|axis| origin[axis] + t * direction[axis]);
            nearest(bounds, point)
        };

        let mut cursor = self.cursor();
        let mut t = start;
        for step in 1..=MAX_RAY_STEPS {
            let point = at(t);
            let distance = cursor.distance(point);
            if distance <= within {
                let normal = self.normal(point);
                return Raycast::Hit(RayHit { distance: t, point, normal, steps: step });
            }
            if t >= end {
                return Raycast::Miss { steps: step };
            }
            t = (t + distance / steepest).min(end);
        }
        Raycast::OutOfSteps { clear: t }
    }

    /// Goes down the gradient to the surface, with at most 16 queries.
    ///
    /// The end is inside the box, and the field there, the `residual`, is not farther from 0 than at the start, or at the
    /// nearest point of the box for a start outside it. Where the field is smooth it ends on the surface, near the
    /// closest point; beyond a medial axis or a crease it may end at another point of the surface. That it is the
    /// closest is not promised. NaN coordinates count as those of the box's least corner.
    pub fn closest_point(&self, point: [f32; 3]) -> ClosestPoint {
        let (bounds, _) = self.bounds_and_steepest();
        let enough = RESOLUTION * longest_side(bounds);
        let mut point = nearest(bounds, point);
        let (mut distance, mut gradient) = self.distance_and_gradient(point);

        let mut stride = 1.0;
        let mut steps = 1;
        while steps < MAX_DESCENT_STEPS && distance.abs() > enough && gradient != [0.0; 3] {
            let (slope, direction) = math::length_and_direction(gradient);
            let step = stride * (distance / slope.max(0.5));
            let next = nearest(bounds, each_axis(|axis| point[axis] - step * direction[axis]));
            let there = self.distance_and_gradient(next);
            steps += 1;

            // A step that leads nowhere is tried again at half its length.
            if there.0.abs() < distance.abs() {
                (point, (distance, gradient), stride) = (next, there, 1.0);
            } else {
                stride *= 0.5;
            }
        }
        ClosestPoint { point, residual: distance, steps }
    }

    /// Unit vector along the gradient at a point, or zero where there is none. NaN if a coordinate is.
    pub fn normal(&self, point: [f32; 3]) -> [f32; 3] {
        let (_, gradient) = self.distance_and_gradient(point);
        let is_some = gradient != [0.0; 3] && gradient.iter().all(|component| component.is_finite());
        if is_some { math::length_and_direction(gradient).1 } else { gradient }
    }
}

/// Nearest point of a box; NaN becomes the least corner's.
#[inline(never)]
pub(crate) fn nearest(bounds: Aabb, point: [f32; 3]) -> [f32; 3] {
    let mut nearest = point;
    for ((part, min), max) in nearest.iter_mut().zip(bounds.min).zip(bounds.max) {
        // Each comparison is false for a NaN.
        let above = if *part > min { *part } else { min };
        *part = if above < max { above } else { max };
    }
    nearest
}

pub(crate) fn longest_side(bounds: Aabb) -> f32 {
    let sides = bounds.min.into_iter().zip(bounds.max).map(|(min, max)| max - min);
    sides.fold(0.0, f32::max)
}

/// The part of a ray inside a box: where along it, from 0 to `length`.
fn clip(bounds: Aabb, origin: [f32; 3], direction: [f32; 3], length: f32) -> Option<(f32, f32)> {
    let (mut start, mut end) = (0.0_f32, length.min(f32::MAX));
    for (((min, max), origin), direction) in bounds.min.into_iter().zip(bounds.max).zip(origin).zip(direction) {
        let (low, high) = (min - origin, max - origin);
        if direction == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
            continue;
        }
        let (a, b) = (low / direction, high / direction);
        start = start.max(a.min(b));
        end = end.min(a.max(b));
    }
    (start <= end).then_some((start, end))
}
