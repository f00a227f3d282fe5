//! Where the pixels of a slice lie.

use glam::DVec3;
use nearfield::Field;

/// Axis that a slice is perpendicular to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The picture shows z to the right and y up.
    X,
    /// The picture shows x to the right and z up.
    Y,
    /// The picture shows x to the right and y up.
    Z,
}

/// Where on its axis a slice lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Position {
    /// From 0, the low side of the field's box, to 1, the high side.
    Fraction(f64),
    /// Mesh units, mesh frame.
    Coordinate(f64),
}

/// The plane of a slice. Its picture covers what the field's box casts on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut {
    /// Perpendicular to an axis.
    Across {
        /// The axis.
        axis: Axis,
        /// Place of the plane on that axis.
        position: Position,
    },
    /// Perpendicular to any direction. The picture is what one sees who looks against it, y up; z up where the
    /// direction is that of y.
    Oblique {
        /// A point of the plane, mesh units; without one the middle of the field's box.
        origin: Option<DVec3>,
        /// Direction across the plane, of any length but zero.
        normal: DVec3,
    },
}

/// Closer to the y axis than this (sine of the angle), a direction has z up.
const UPRIGHT: f64 = 1e-3;

/// The pixels' places in space.
pub(super) struct Plane {
    /// Centre of the top left pixel.
    first: DVec3,
    /// Directions of unit length to the right and up.
    right: DVec3,
    up: DVec3,
    /// Edge of a pixel, mesh units.
    pixel: f64,
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Plane {
    /// Square pixels that cover the field's box, `resolution` of them along the longer side.
    pub(super) fn through(field: &Field<'_>, cut: &Cut, resolution: u32) -> Self {
        let bounds = field.header().bounds;
        let [min, max] = [bounds.min, bounds.max].map(|corner| DVec3::from_array(corner.map(f64::from)));
        let (origin, right, up) = frame(min, max, cut);

        // The box's shadow on the plane, from its origin.
        let corners = (0..8).map(|index| {
            let pick = |axis: usize| if index >> axis & 1 == 0 { min[axis] } else { max[axis] };
            DVec3::new(pick(0), pick(1), pick(2)) - origin
        });
        let range = |direction: DVec3| {
            let along = corners.clone().map(|corner| corner.dot(direction));
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
        };
        let ((left, far_right), (bottom, top)) = (range(right), range(up));

        let (size_right, size_up) = (far_right - left, top - bottom);
        let pixel = size_right.max(size_up) / f64::from(resolution);
        let pixels_along = |size: f64| ((size / pixel).round() as usize).max(1);
        let (width, height) = (pixels_along(size_right), pixels_along(size_up));
        let first = origin + (left + 0.5 * pixel) * right + (top - 0.5 * pixel) * up;
        Self { first, right, up, pixel, width, height }
    }

    /// The points of a row, mesh frame.
    pub(super) fn row(&self, row: usize) -> Vec<[f32; 3]> {
        let start = self.first - row as f64 * self.pixel * self.up;
        (0..self.width).map(|column| (start + column as f64 * self.pixel * self.right).as_vec3().to_array()).collect()
    }
}

/// A point of the plane, and the directions of the picture.
fn frame(min: DVec3, max: DVec3, cut: &Cut) -> (DVec3, DVec3, DVec3) {
    match *cut {
        Cut::Across { axis, position } => {
            let (axis, right, up) = match axis {
                Axis::X => (0, DVec3::Z, DVec3::Y),
                Axis::Y => (1, DVec3::X, DVec3::Z),
                Axis::Z => (2, DVec3::X, DVec3::Y),
            };
            let mut origin = DVec3::ZERO;
            origin[axis] = match position {
                Position::Fraction(fraction) => min[axis] + fraction * (max[axis] - min[axis]),
                Position::Coordinate(coordinate) => coordinate,
            };
            (origin, right, up)
        }
        Cut::Oblique { origin, normal } => {
            let normal = normal.normalize();
            let upright = if normal.cross(DVec3::Y).length() < UPRIGHT { DVec3::Z } else { DVec3::Y };
            let right = upright.cross(normal).normalize();
            (origin.unwrap_or(0.5 * (min + max)), right, normal.cross(right))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_oblique_picture_is_upright_and_its_directions_are_right_handed() {
        for normal in [DVec3::Z, DVec3::new(3.0, 0.5, -1.0), DVec3::NEG_X, DVec3::Y, DVec3::new(0.0, -7.0, 1e-9)] {
            let cut = Cut::Oblique { origin: None, normal };
            let (origin, right, up) = frame(DVec3::ZERO, DVec3::ONE, &cut);
            assert_eq!(origin, DVec3::splat(0.5));
            assert!((right.cross(up).dot(normal.normalize()) - 1.0).abs() < 1e-12, "{normal}");
            assert!(up.y > 0.0 || up.z.abs() > 0.99, "{normal}: {up}");
        }
        let along_z = Cut::Oblique { origin: None, normal: DVec3::Z };
        assert_eq!(frame(DVec3::ZERO, DVec3::ONE, &along_z).1, DVec3::X, "as --axis z");
    }
}
