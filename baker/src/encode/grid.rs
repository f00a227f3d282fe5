//! The sections of a grid: parameters, bases of the bricks, samples.

use super::container::{Section, put};
use crate::grid::Grid;
use crate::settings::{Precision, RangeScope, Reconstruction};
use nearfield::layout::{grid as layout, precision, range, reconstruction, section};

/// The sections in file order.
pub(super) fn sections(grid: &Grid) -> Vec<Section> {
    let stored = &grid.stored;
    let words = |words: &mut dyn Iterator<Item = u32>| words.flat_map(u32::to_le_bytes).collect();
    let mut sections = vec![Section { kind: section::GRID, bytes: parameters(grid) }];
    if stored.precision != Precision::F32 {
        let bases = words(&mut stored.bases.iter().map(|base| base.cast_unsigned()));
        sections.push(Section { kind: section::BASES, bytes: bases });
    }
    sections.push(Section { kind: section::SAMPLES, bytes: words(&mut stored.words.iter().copied()) });
    sections
}

fn parameters(grid: &Grid) -> Vec<u8> {
    let stored = &grid.stored;
    let resolution = grid.domain.resolution.to_array().map(|samples| (samples as u16).to_le_bytes());
    let spacing = grid.domain.spacing.as_vec3().to_array().map(f32::to_le_bytes);

    let mut bytes = vec![0; layout::LENGTH];
    put(&mut bytes, layout::RESOLUTION, resolution.as_flattened());
    bytes[layout::ORDER] = grid.order;
    bytes[layout::RECONSTRUCTION] = match grid.reconstruction {
        Reconstruction::Nearest => reconstruction::NEAREST,
        Reconstruction::Linear => reconstruction::LINEAR,
        Reconstruction::Half => reconstruction::HALF,
        Reconstruction::Blend => reconstruction::BLEND,
        Reconstruction::Hermite => reconstruction::HERMITE,
    };
    bytes[layout::PRECISION] = match stored.precision {
        Precision::Packed32 => precision::PACKED32 as u8,
        Precision::F16 => precision::F16 as u8,
        Precision::F32 => precision::F32 as u8,
    };
    bytes[layout::RANGE] = match stored.range {
        RangeScope::File => range::FILE,
        RangeScope::Brick => range::BRICK,
    };
    put(&mut bytes, layout::SPACING, spacing.as_flattened());
    put(&mut bytes, layout::QUANTUM, &stored.quantum.to_le_bytes());
    bytes
}
