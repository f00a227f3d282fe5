//! A field function to an octree of polynomials in as few bits as the target allows.
//!
//! Leaves are fitted on samples of their own cell alone and blended where they meet (after Koschier et al.
//! 2016, who choose the degree by cell, and Ohtake et al. 2003, who blend).

pub mod cells;
mod choose;
pub mod overlap;
mod refine;

use crate::field_function::FieldFunction;
use crate::geometry::Aabb;
use crate::octree::domain::Domain;
use crate::progress::Progress;
use crate::quantize::piece::Steps;
use crate::sampling::cell::Stencil;
use crate::settings::Settings;
use cells::Cells;
use choose::Tolerance;
use overlap::Reach;
use refine::{Demand, Refinement};

fn env(name: &str, default: f64) -> f64 {
    std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(default)
}

/// The finest step, as a share of the target error.
const FINEST_STEP: f64 = 1.0 / 256.0;

/// A built tree, rounded: all that the file will say of the field.
pub struct PolynomialOctree {
    /// Cells and leaves.
    pub cells: Cells,
    /// Codes of the leaves by their places; not stored if there is no overlap.
    pub reaches: Vec<Reach>,
    /// How far leaves reach beyond their cells, as a share of the edge, representable in `f32`; 0 if they do not.
    pub overlap: f64,
    /// How coefficients were rounded.
    pub steps: Steps,
    /// Upper bound of the gradient's length inside the domain.
    pub lipschitz: f64,
    /// Points at which the function was sampled.
    pub samples: usize,
}

impl PolynomialOctree {
    /// Builds the octree of a function around a box, to a target error in mesh units.
    pub fn build(
        function: &dyn FieldFunction,
        bounds: &Aabb,
        settings: &Settings,
        target: f64,
        progress: &dyn Progress,
    ) -> Self {
        let domain = Domain::around(bounds, settings);
        let overlap = env("NF_R", 0.1875);
        let rmse = target;
        let near = Tolerance { rmse, max: env("NF_MAX", 4.0) * rmse };
        let surface = env("NF_SURFACE", 0.0) > 0.0;
        let constant_within = if surface { 0.02 * bounds.diagonal() } else { f64::INFINITY };
        let mut refinement = Refinement {
            function,
            stencil: Stencil::new(),
            steps: Steps::new((rmse * FINEST_STEP) as f32),
            demand: Demand { near, constant_within },
            graded: overlap > 0.0,
            progress,
            samples: 0,
        };
        let cells = refinement.refine(domain);
        let (steps, samples) = (refinement.steps, refinement.samples);
        let reaches = overlap::reaches(&cells);
        Self { cells, reaches, overlap, steps, lipschitz: 1.0, samples }
    }

    /// Leaves of each level below the root grid.
    pub fn leaves_by_level(&self) -> Vec<usize> {
        let mut leaves = vec![0; usize::from(self.cells.domain.depth) + 1];
        for (_, cell, _) in self.cells.leaves() {
            leaves[usize::from(cell.level)] += 1;
        }
        leaves
    }
}
