//! The box that a tree covers and the lattice on which its vertices lie.

use crate::geometry::Aabb;
use crate::settings::Settings;
use glam::{DVec3, UVec3};

/// A box of cubic root cells. Vertices lie on its *lattice*, whose spacing is the edge of the
/// smallest possible leaf; cells and vertices are named by lattice coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Domain {
    /// Smallest corner, mesh units, representable in `f32`.
    pub origin: DVec3,
    /// Root cells along each axis.
    pub root_cells: UVec3,
    /// Edge of a root cell, mesh units, representable in `f32`.
    pub root_edge: f64,
    /// Levels below the root grid.
    pub depth: u8,
}

impl Domain {
    /// The smallest domain around a mesh's box and its margin, centred on it.
    pub fn around(bounds: &Aabb, settings: &Settings) -> Self {
        let grown = bounds.grown(settings.margin * bounds.size().max_element());
        let size = grown.size();
        let root_edge = f64::from(((size.max_element() / f64::from(1u32 << settings.start_depth)) as f32).next_up());
        let root_cells = (size / root_edge).ceil().max(DVec3::ONE);
        let origin = grown.min - 0.5 * (root_cells * root_edge - size);
        Self {
            origin: origin.as_vec3().as_dvec3(),
            root_cells: root_cells.as_uvec3(),
            root_edge,
            depth: settings.max_depth - settings.start_depth,
        }
    }

    /// Edge of a cell of this level, mesh units.
    pub fn edge(&self, level: u8) -> f64 {
        self.root_edge / f64::from(1u32 << level)
    }

    /// Edge of a cell of this level, in lattice units.
    pub fn lattice_edge(&self, level: u8) -> u32 {
        1 << (self.depth - level)
    }

    /// Lattice coordinates of the largest corner.
    pub fn lattice_size(&self) -> UVec3 {
        self.root_cells << u32::from(self.depth)
    }

    /// Where a vertex lies, mesh units, mesh frame.
    pub fn point(&self, vertex: UVec3) -> DVec3 {
        self.origin + vertex.as_dvec3() * self.edge(self.depth)
    }
}
