//! What a field can be over a region.

use crate::field::Field;
use crate::header::Aabb;
use crate::march::nearest;
use crate::math::{self, each_axis};
use crate::representation::Representation;

/// Parts along each axis into which a box is divided for its [`Field::range`].
const PARTS: u32 = 4;

impl<'a, R: Representation<'a>> Field<'a, R> {
    /// Bounds of the field over a box, mesh units: no value in it is less than the first or greater than the
    /// second. Takes 64 queries.
    ///
    /// Each part of the box is bounded by the value in its middle and the stored Lipschitz bound. The range is wider
    /// than the true one by at most a quarter of the box's diagonal, times that bound plus 1 outside the field's
    /// box. A field without continuity may exceed it by [`seam_max`](crate::ErrorContract::seam_max).
    ///
    /// `min <= max` along every axis is expected, and finite numbers; else it is ±∞.
    pub fn range(&self, region: Aabb) -> (f32, f32) {
        const EVERYTHING: (f32, f32) = (f32::NEG_INFINITY, f32::INFINITY);
        let size = each_axis(|axis| region.max[axis] - region.min[axis]);
        if !size.iter().all(|side| (0.0..=f32::MAX).contains(side)) {
            return EVERYTHING;
        }

        // Beyond the field's box the distance to it is added, whose slope is 1.
        let (bounds, steepest) = self.bounds_and_steepest();
        let is_inside = nearest(bounds, region.min) == region.min && nearest(bounds, region.max) == region.max;
        let slope = steepest + if is_inside { 0.0 } else { 1.0 };
        let radius = if size == [0.0; 3] { 0.0 } else { math::length_and_direction(size).0 / (2 * PARTS) as f32 };

        let (mut least, mut greatest) = (f32::INFINITY, f32::NEG_INFINITY);
        for part in 0..PARTS * PARTS * PARTS {
            let cell = [part % PARTS, part / PARTS % PARTS, part / (PARTS * PARTS)];
            let share = cell.map(|index| (index as f32 + 0.5) / PARTS as f32);
            let middle = each_axis(|axis| region.min[axis] + share[axis] * size[axis]);
            let value = self.distance(middle);
            (least, greatest) = (least.min(value), greatest.max(value));
        }

        // One part in 2¹⁸ covers every rounding on the way.
        let reach = slope * radius;
        let rounding = (reach + largest(region)) * (1.0 / (1 << 18) as f32);
        (least - reach - rounding, greatest + reach + rounding)
    }

    /// How far a point is at least from the true surface, mesh units: what a robot may rely on as far as it may rely on
    /// the [contract](crate::ErrorContract). At most 0 where nothing is known; negative inside. Never NaN.
    ///
    /// Inside the box it is the field less the largest measured error. Outside it is no less than the distance to the
    /// box, which holds the mesh.
    pub fn clearance(&self, point: [f32; 3]) -> f32 {
        let error = self.contract().max_error();
        let closest = nearest(self.bounds_and_steepest().0, point);
        if closest == point {
            return self.distance(point) - error;
        }
        if !point.iter().all(|coordinate| coordinate.is_finite()) {
            return f32::NEG_INFINITY;
        }
        let away = each_axis(|axis| point[axis] - closest[axis]);
        let (outside, _) = math::length_and_direction(away);
        (self.distance(closest) - error - outside).max(outside)
    }

    /// Whether the true surface is nowhere within `radius` of a point outside the shape, as far as the
    /// [contract](crate::ErrorContract) goes: whether the [`clearance`](Self::clearance) exceeds it. Mesh units.
    pub fn is_clear(&self, centre: [f32; 3], radius: f32) -> bool {
        self.clearance(centre) > radius
    }
}

/// Largest magnitude of a coordinate.
fn largest(region: Aabb) -> f32 {
    region.min.iter().chain(&region.max).fold(0.0, |largest, coordinate| coordinate.abs().max(largest))
}
