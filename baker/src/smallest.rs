//! The smallest of an octree and the grids that are no worse.

use crate::bake::{BakeError, Baked, bake};
use crate::grid::Domain;
use crate::mesh::CheckedMesh;
use crate::progress::Progress;
use crate::settings::{
    Continuity, GridSettings, Layout, Precision, RangeScope, Reconstruction, Resolution, Sampling, Settings,
};
use crate::verify::Measurement;

/// A kind of grid that is tried.
pub(crate) struct Kind {
    /// What it is called beside others.
    pub(crate) name: &'static str,
    order: u8,
    reconstruction: Reconstruction,
    /// The most continuous field that it makes.
    pub(crate) continuity: Continuity,
    /// Bytes of a sample, all of them `packed32`.
    bytes: u64,
}

/// Of the packed grids those that took the fewest bytes at equal error, and plain distances.
pub(crate) const KINDS: [Kind; 3] = [
    Kind {
        name: "grid, hermite",
        order: 1,
        reconstruction: Reconstruction::Hermite,
        continuity: Continuity::C1,
        bytes: 4,
    },
    Kind { name: "grid, half", order: 1, reconstruction: Reconstruction::Half, continuity: Continuity::C0, bytes: 4 },
    Kind {
        name: "grid, order 0",
        order: 0,
        reconstruction: Reconstruction::Linear,
        continuity: Continuity::C0,
        bytes: 2,
    },
];

/// Bakes an octree, and each kind of grid that is as continuous with just fewer samples than would fill the octree's
/// bytes; where such a grid is no worse, the fewest samples with which it is not. Gives the smallest and its settings.
///
/// No worse is: in root mean square over the box and near the surface, and in the largest error of both, as measured.
/// Errors are taken to fall as samples grow.
///
/// # Errors
/// Those of [`bake`] for the octree. A grid that fails is no candidate.
pub fn bake_smallest(
    mesh: &CheckedMesh,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<(Baked, Settings), BakeError> {
    let octree = bake(mesh, settings, progress)?;
    let asked = octree.report.measurement.clone();
    let mut best = (octree, *settings);
    for kind in KINDS.iter().filter(|kind| kind.continuity >= settings.continuity) {
        let at = |samples: u16| {
            let settings = kind.within(settings, samples);
            let baked = bake(mesh, &settings, progress).ok()?;
            is_no_worse(&baked.report.measurement, &asked).then_some((baked, settings))
        };
        let bytes_of = |samples| {
            let domain = Domain::around(&mesh.bounds, settings.margin, Resolution::Longest(samples));
            domain.resolution.to_array().map(u64::from).iter().product::<u64>() * kind.bytes
        };

        let limit = best.0.bytes.len() as u64;
        let (mut few, mut many) = (2, most(|samples| bytes_of(samples) < limit));
        let Some(mut found) = at(many) else { continue };
        while few < many {
            let middle = few.midpoint(many);
            match at(middle) {
                Some(smaller) => (many, found) = (middle, smaller),
                None => few = middle + 1,
            }
        }
        if found.0.bytes.len() < best.0.bytes.len() {
            best = found;
        }
    }
    Ok(best)
}

impl Kind {
    /// Settings with this kind of grid in place of their layout.
    pub(crate) fn within(&self, settings: &Settings, samples: u16) -> Settings {
        let grid = GridSettings {
            resolution: Resolution::Longest(samples),
            order: self.order,
            reconstruction: self.reconstruction,
            sampling: Sampling::Taylor,
            range: RangeScope::Brick,
        };
        Settings { layout: Layout::Grid(grid), precision: Precision::Packed32, max_bytes: None, ..*settings }
    }
}

/// The greatest number that fits, or 2.
fn most(fits: impl Fn(u16) -> bool) -> u16 {
    let (mut low, mut high) = (2, u16::MAX);
    while low < high {
        let middle = high - (high - low) / 2;
        if fits(middle) { low = middle } else { high = middle - 1 }
    }
    low
}

fn is_no_worse(measured: &Measurement, asked: &Measurement) -> bool {
    let pairs = [(&measured.uniform, &asked.uniform), (&measured.band, &asked.band)];
    pairs.into_iter().all(|(measured, asked)| measured.rmse <= asked.rmse && measured.max() <= asked.max())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_that_fits_is_found() {
        for limit in [2, 3, 64, 1000, u16::MAX - 1, u16::MAX] {
            assert_eq!(most(|samples| samples <= limit), limit);
        }
        assert_eq!(most(|_| false), 2);
    }
}
