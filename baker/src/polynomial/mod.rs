//! A field function to an octree of polynomials in as few bits as the target allows.
//!
//! Leaves are fitted on samples of their own cell alone and blended where they meet (after Koschier et al.
//! 2016, who choose the degree by cell, and Ohtake et al. 2003, who blend).

pub mod cells;
mod choose;
mod keep;
pub mod overlap;
mod refine;

use crate::field_function::FieldFunction;
use crate::geometry::Aabb;
use crate::octree::domain::Domain;
use crate::progress::Progress;
use crate::quantize::piece::Steps;
use crate::sampling::cell::Stencil;
use crate::settings::{Continuity, NEAR, PolynomialSettings, Profile, Settings};
use cells::Cells;
pub use choose::MAX_BITS;
use choose::Tolerance;
pub use keep::Unkept;
use overlap::Reach;
use refine::{Demand, Refinement};

/// Tolerance of a leaf's root mean square error, as a share of the target. Leaves see neither what lies between their
/// samples nor their neighbours; with this share the measured errors are those that octrees of interpolants reach
/// (Pujol and Chica 2023): about half the target over the box and 0.6 of it near the surface.
const LEAF_SHARE: f64 = 0.75;
/// Tolerance of a leaf's greatest error at its samples, in root mean square tolerances, where none is asked for.
const LEAF_MAX: f64 = 6.0;
/// Mean square error over the box that jumps of the function may leave, in squares of the leaves' tolerance.
const JUMP_SHARE: f64 = 0.25;
/// The finest step, as a share of a leaf's tolerance.
const FINEST_STEP: f64 = 1.0 / 256.0;
/// Finest steps that the diagonal of the domain may take, in bits: what a constant has, and the largest exponent less
/// some bits to spare.
const COUNTED_BITS: u32 = 30;

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
    /// Points at which the function was sampled.
    pub samples: usize,
}

/// The finest step: fine enough for the tolerance, but such that the coarsest can count any distance of the domain, and
/// within the format.
fn quantum(rmse: f64, domain: &Domain) -> f64 {
    let least = domain.root_cells.as_dvec3().length() * domain.root_edge / f64::from(1u32 << COUNTED_BITS);
    (FINEST_STEP * rmse).max(least).min(domain.root_edge)
}

impl PolynomialOctree {
    /// Builds the octree of a function around a box. Relative targets are fractions of `diagonal`, mesh units.
    ///
    /// # Errors
    /// [`Unkept`] if the greatest error asked for cannot be kept at the greatest depth.
    pub fn build(
        function: &dyn FieldFunction,
        bounds: &Aabb,
        settings: &Settings,
        polynomial: &PolynomialSettings,
        diagonal: f64,
        progress: &dyn Progress,
    ) -> Result<Self, Unkept> {
        let domain = Domain::around(bounds, settings);
        let overlap = match settings.continuity {
            Continuity::None => 0.0,
            Continuity::C0 | Continuity::C1 => f64::from(polynomial.overlap as f32),
        };
        let rmse = LEAF_SHARE * settings.error.absolute(diagonal);
        let greatest = polynomial.max_error.map_or(f64::INFINITY, |max| max.absolute(diagonal));
        let near = Tolerance { rmse, max: greatest.min(LEAF_MAX * rmse) };
        let constant_within = match polynomial.profile {
            Profile::Uniform => f64::INFINITY,
            Profile::Surface => NEAR * diagonal,
        };
        let left_of_jumps = JUMP_SHARE * rmse * rmse * bounds.size().element_product();
        let mut refinement = Refinement {
            function,
            stencil: Stencil::default(),
            steps: Steps::new(quantum(rmse, &domain) as f32),
            demand: Demand { near, greatest, constant_within, left_of_jumps },
            graded: overlap > 0.0,
            progress,
            samples: 0,
        };
        let mut cells = refinement.refine(domain);
        if greatest.is_finite() {
            refinement.keep(&mut cells, overlap)?;
        }
        let (steps, samples) = (refinement.steps, refinement.samples);
        let reaches = overlap::reaches(&cells);
        Ok(Self { cells, reaches, overlap, steps, samples })
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
