//! Where the samples of a grid lie.

use crate::geometry::Aabb;
use crate::quantize::grid::Lattice;
use crate::settings::Resolution;
use glam::{DVec3, UVec3};

/// A lattice of samples, the first and the last of each axis on the faces of the box.
#[derive(Clone, Copy, Debug)]
pub struct Domain {
    /// Least sample, mesh units, representable in `f32`.
    pub origin: DVec3,
    /// Distance between samples along each axis, mesh units, representable in `f32`.
    pub spacing: DVec3,
    /// Samples along each axis, at least 2.
    pub resolution: UVec3,
}

impl Domain {
    /// The lattice around a box and its margin, a fraction of the box's longest side. With one number for
    /// the longest side the spacing is the same along all axes, otherwise the samples fill the box.
    pub fn around(bounds: &Aabb, margin: f64, resolution: Resolution) -> Self {
        let grown = bounds.grown(margin * bounds.size().max_element());
        let size = grown.size();
        let (resolution, spacing) = match resolution {
            Resolution::Longest(samples) => {
                let spacing = size.max_element() / f64::from(samples - 1);
                // A whole number of cells must not become one more by rounding.
                let cells = (size / spacing - 1e-9).ceil().max(DVec3::ONE);
                (cells.as_uvec3() + 1, DVec3::splat(spacing))
            }
            Resolution::Each(samples) => {
                let samples = UVec3::from_array(samples.map(u32::from));
                // A flat box has a thickness for a spacing's sake.
                let size = size.max(DVec3::splat(size.max_element() / 64.0));
                (samples, size / (samples - 1).as_dvec3())
            }
        };
        let spacing = spacing.map(|spacing| f64::from((spacing as f32).next_up()));
        let origin = grown.centre() - 0.5 * (resolution - 1).as_dvec3() * spacing;
        Self { origin: origin.as_vec3().as_dvec3(), spacing, resolution }
    }

    /// The box that the samples span.
    pub fn bounds(&self) -> Aabb {
        Aabb { min: self.origin, max: self.origin + (self.resolution - 1).as_dvec3() * self.spacing }
    }

    /// Number of a sample, x fastest.
    pub fn index(&self, at: UVec3) -> usize {
        let [nx, ny] = [self.resolution.x as usize, self.resolution.y as usize];
        at.x as usize + nx * (at.y as usize + ny * at.z as usize)
    }

    /// The vertices, x fastest.
    pub fn vertices(&self) -> impl Iterator<Item = UVec3> {
        let [nx, ny, nz] = self.resolution.to_array();
        (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| UVec3::new(x, y, z))))
    }

    /// Places of the samples, x fastest, mesh units.
    pub fn points(&self) -> Vec<DVec3> {
        self.vertices().map(|at| self.origin + at.as_dvec3() * self.spacing).collect()
    }
}

impl Lattice for Domain {
    fn resolution(&self) -> UVec3 {
        self.resolution
    }

    fn spacing(&self) -> DVec3 {
        self.spacing
    }
}
