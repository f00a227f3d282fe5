//! Fields that are moved, turned, mirrored and uniformly scaled.

use crate::field::Field;
use crate::math::{self, each_axis};
use crate::representation::{Any, Representation};

/// A field placed in a world. Distances and gradients are the world's.
///
/// Worst-case cost: that of the field, and two products of a matrix and a vector.
#[derive(Clone, Copy, Debug)]
pub struct Instance<'a, R = Any<'a>> {
    field: Field<'a, R>,
    /// Columns: where the mesh's axes point in the world, each as long as the scale.
    axes: [[f32; 3]; 3],
    origin: [f32; 3],
    scale: f32,
}

/// A transformation that does not keep angles: no factor turns its distances into those of the world.
///
/// Bake the deformed mesh, or bound the distance: the field's value times the smallest stretch of the transformation is no
/// more than the distance in the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotASimilarity;

impl core::fmt::Display for NotASimilarity {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        formatter.write_str("the transformation is not a rotation or reflection with a uniform scale")
    }
}

impl core::error::Error for NotASimilarity {}

impl<'a, R: Representation<'a>> Instance<'a, R> {
    /// Places a field: its point p is at `axes[0] p.x + axes[1] p.y + axes[2] p.z + origin` in the world.
    ///
    /// # Errors
    ///
    /// Unless the three axes are at right angles and equally long, within 1e-4, and their length is from 2⁻²⁰ to 2²⁰.
    /// They may be left-handed: a mirrored field.
    pub fn new(field: Field<'a, R>, axes: [[f32; 3]; 3], origin: [f32; 3]) -> Result<Self, NotASimilarity> {
        const TOLERANCE: f32 = 1e-4;
        const LARGEST: f32 = (1 << 20) as f32;
        let is_usable = |axis: &[f32; 3]| axis.iter().all(|part| part.abs() <= LARGEST) && *axis != [0.0; 3];
        if !axes.iter().all(is_usable) || !origin.iter().all(|coordinate| coordinate.is_finite()) {
            return Err(NotASimilarity);
        }

        let (scale, _) = math::length_and_direction(axes[0]);
        if !(1.0 / LARGEST..=LARGEST).contains(&scale) {
            return Err(NotASimilarity);
        }
        let [x, y, z] = axes.map(|axis| axis.map(|part| part / scale));
        for (first, second) in [(x, y), (x, z), (y, z)] {
            let product = math::dot(first, second).abs();
            let length = (math::dot(second, second) - 1.0).abs();
            if product > TOLERANCE || length > 2.0 * TOLERANCE {
                return Err(NotASimilarity);
            }
        }
        Ok(Self { field, axes, origin, scale })
    }

    /// Signed distance in the world's units at a point of the world, as [`Field::distance`].
    pub fn distance(&self, point: [f32; 3]) -> f32 {
        (self.field.distance(self.to_field(point)) * self.scale).min(f32::MAX)
    }

    /// Signed distance, as [`distance`](Self::distance) to the bit, and gradient in the world's frame.
    pub fn distance_and_gradient(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        let (distance, gradient) = self.field.distance_and_gradient(self.to_field(point));
        let [x, y, z] = self.axes.map(|axis| axis.map(|part| part / self.scale));
        let turned = each_axis(|row| math::dot([x[row], y[row], z[row]], gradient));
        ((distance * self.scale).min(f32::MAX), turned)
    }

    /// The field.
    pub fn field(&self) -> Field<'a, R> {
        self.field
    }

    /// How long a unit of the field is in the world.
    pub fn scale(&self) -> f32 {
        self.scale
    }

    /// A point of the world in the frame of the field.
    pub fn to_field(&self, point: [f32; 3]) -> [f32; 3] {
        let moved = each_axis(|axis| point[axis] - self.origin[axis]);
        // The inverse of a similarity is its transpose over the square of its scale.
        self.axes.map(|axis| math::dot(axis.map(|part| part / self.scale), moved) / self.scale)
    }
}
