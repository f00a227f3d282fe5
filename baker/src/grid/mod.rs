//! A field function to a uniform grid of polynomials (Bán and Valasek 2020; Valasek and Bán 2022).

mod basis;
mod domain;
mod fit;
mod slope;

pub use domain::Domain;

use crate::field_function::FieldFunction;
use crate::geometry::Aabb;
use crate::progress::Progress;
use crate::quantize::grid::{Stored, round};
use crate::sampling;
use crate::settings::{GridSettings, Precision, Reconstruction, Sampling, Settings};

/// Samples that are settled and rounded: all that the file will say of the field.
pub struct Grid {
    /// Where the samples lie.
    pub domain: Domain,
    /// Order of the samples.
    pub order: u8,
    /// How the reader answers between them.
    pub reconstruction: Reconstruction,
    /// The samples as the file stores them.
    pub stored: Stored,
    /// Upper bound of the gradient's length inside the domain.
    pub lipschitz: f64,
    /// Points at which the function was sampled.
    pub samples: usize,
}

impl Grid {
    /// Samples a function on a grid around a box.
    pub fn build(
        function: &dyn FieldFunction,
        bounds: &Aabb,
        settings: &Settings,
        grid: &GridSettings,
        progress: &dyn Progress,
    ) -> Self {
        let domain = Domain::around(bounds, settings.margin, grid.resolution);
        let (mut coefficients, mut samples) =
            sampling::polynomials(function, &domain.points(), grid.order, grid.sampling, domain.spacing);
        if grid.sampling == Sampling::Fitted {
            let unit_gradients = settings.precision == Precision::Packed32;
            samples += fit::fit(function, &domain, grid, unit_gradients, &mut coefficients);
        }
        progress.advance(samples as u64);

        let stored = round(&mut coefficients, &domain, grid, settings.precision);
        let lipschitz = slope::bound(&coefficients, &domain, grid);
        Self { domain, order: grid.order, reconstruction: grid.reconstruction, stored, lipschitz, samples }
    }
}
