//! Where a picture is taken from.

use crate::geometry::Aabb;
use glam::DVec3;

/// Axis that points up in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// As in glTF and most of graphics.
    Y,
    /// As in most of engineering.
    Z,
}

/// A perspective camera that orbits a box and sees all of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Degrees around the up axis; at 0 it looks along the next axis but one, negated: from +z for y up, from +y for z up.
    pub azimuth: f64,
    /// Degrees above the horizon, from −90 to 90.
    pub elevation: f64,
    /// 1 fits the box's sphere into the picture, 2 halves what is seen. Above 0.
    pub zoom: f64,
    /// Axis that points up.
    pub up: Up,
}

/// Degrees between the lower and the upper edge of a picture.
const FIELD_OF_VIEW: f64 = 30.0;

/// A half line. Mesh units, mesh frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    pub(super) origin: DVec3,
    /// Of length 1.
    pub(super) direction: DVec3,
}

impl Ray {
    pub(super) fn at(&self, travelled: f64) -> DVec3 {
        self.origin + self.direction * travelled
    }

    /// Where the ray enters and leaves a box, if it meets it: distances along the ray, the first at least 0.
    pub(super) fn through(&self, bounds: &Aabb) -> Option<(f64, f64)> {
        let (low, high) = ((bounds.min - self.origin) / self.direction, (bounds.max - self.origin) / self.direction);
        // A ray within a face gives NaN on that axis, which min and max pass over.
        let enter = low.min(high).to_array().into_iter().fold(0.0, f64::max);
        let leave = low.max(high).to_array().into_iter().fold(f64::INFINITY, f64::min);
        (enter < leave).then_some((enter, leave))
    }
}

/// A camera in its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    eye: DVec3,
    forward: DVec3,
    right: DVec3,
    up: DVec3,
    /// Half the height of the picture one unit in front of the eye.
    half_height: f64,
}

impl Camera {
    pub(super) fn around(&self, bounds: &Aabb) -> View {
        let world_up = match self.up {
            Up::Y => DVec3::Y,
            Up::Z => DVec3::Z,
        };
        let (ahead, aside) = match self.up {
            Up::Y => (DVec3::Z, DVec3::X),
            Up::Z => (-DVec3::Y, DVec3::X),
        };
        let (azimuth_sine, azimuth_cosine) = libm::sincos(self.azimuth.to_radians());
        let (elevation_sine, elevation_cosine) = libm::sincos(self.elevation.to_radians());
        let around = ahead * azimuth_cosine + aside * azimuth_sine;
        let from = around * elevation_cosine + world_up * elevation_sine;

        // Far enough for the sphere around the box to touch the edges of the picture.
        let half_angle = (0.5 * FIELD_OF_VIEW).to_radians();
        let eye = bounds.centre() + from * (0.5 * bounds.diagonal() / libm::sin(half_angle));
        let right = aside * azimuth_cosine - ahead * azimuth_sine;
        View { eye, forward: -from, right, up: from.cross(right), half_height: libm::tan(half_angle) / self.zoom }
    }
}

impl View {
    /// The ray through a place of a picture of this size: pixels from its left and its top.
    pub(super) fn ray(&self, [x, y]: [f64; 2], [width, height]: [u32; 2]) -> Ray {
        let (width, height) = (f64::from(width), f64::from(height));
        let scale = 2.0 * self.half_height / height.min(width);
        let direction =
            self.forward + self.right * ((x - 0.5 * width) * scale) + self.up * ((0.5 * height - y) * scale);
        Ray { origin: self.eye, direction: direction.normalize() }
    }

    /// Width of a pixel one unit in front of the eye.
    pub(super) fn pixel(&self, [width, height]: [u32; 2]) -> f64 {
        2.0 * self.half_height / f64::from(height.min(width))
    }

    /// A direction given by how far it points right, up and toward the eye.
    pub(super) fn direction(&self, [right, up, back]: [f64; 3]) -> DVec3 {
        (self.right * right + self.up * up - self.forward * back).normalize()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Aabb = Aabb { min: DVec3::splat(-1.0), max: DVec3::ONE };

    #[test]
    fn the_camera_looks_at_the_middle_with_up_on_top() {
        for (up, axis) in [(Up::Y, DVec3::Y), (Up::Z, DVec3::Z)] {
            for azimuth in [0.0, 30.0, 200.0] {
                let view = Camera { azimuth, elevation: 20.0, zoom: 1.0, up }.around(&UNIT);
                let middle = view.ray([50.0, 50.0], [100, 100]);
                assert!(middle.direction.cross(-middle.origin).length() < 1e-12, "{up:?} {azimuth}");
                let (upper, lower) = (view.ray([50.0, 0.0], [100, 100]), view.ray([50.0, 100.0], [100, 100]));
                assert!((upper.direction - lower.direction).dot(axis) > 0.1, "{up:?} {azimuth}");
                let (left, right) = (view.ray([0.0, 50.0], [100, 100]), view.ray([100.0, 50.0], [100, 100]));
                assert!(axis.cross(middle.direction).dot(left.direction - right.direction) > 0.1, "not mirrored");
            }
        }
    }

    #[test]
    fn a_ray_meets_the_box_or_does_not() {
        let along_x = |y: f64| Ray { origin: DVec3::new(-3.0, y, 0.0), direction: DVec3::X };
        assert_eq!(along_x(0.5).through(&UNIT), Some((2.0, 4.0)));
        assert_eq!(along_x(1.5).through(&UNIT), None);
    }
}
