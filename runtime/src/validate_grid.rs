//! What of a grid cannot be checked in constant time: every base, every sample.

use crate::error::Error;
use crate::grid::{Grid, GridPrecision};
use crate::layout::block;
use crate::validate::{check_gradient_code, check_singles};

/// Checks every base distance and every sample (SPEC.md §11.2, §11.3).
pub(crate) fn grid(grid: &Grid<'_>) -> Result<(), Error> {
    if grid.sample_words() != Some(grid.samples.len() as u64) || grid.base_words() != grid.bases.len() as u64 {
        return Err(Error::GridSamples);
    }
    let in_range = |word: u32| (block::MIN_BASE..=block::MAX_BASE).contains(&word.cast_signed());
    if !grid.bases.iter().all(in_range) {
        return Err(Error::BlockBase);
    }

    match (grid.precision, grid.order()) {
        (GridPrecision::F32, _) => check_singles(grid.samples),
        (_, 0) => check_padding(grid),
        (GridPrecision::F16, _) => check_halves(grid, |half| half > 0),
        (GridPrecision::Packed32, _) => {
            // Never 0: the compiler must see it, for a step of 0 would panic.
            let stride = (grid.halves_per_sample() / 2).max(1) as usize;
            grid.samples.iter().step_by(stride).try_for_each(check_gradient_code)?;
            check_halves(grid, |half| half > 1)
        }
    }
}

/// Checks the half after the last code of an odd number.
fn check_padding(grid: &Grid<'_>) -> Result<(), Error> {
    let is_odd = grid.resolution().iter().all(|samples| samples % 2 == 1);
    let last = grid.samples.word(grid.samples.len().saturating_sub(1));
    if is_odd && last >> 16 != 0 { Err(Error::Reserved) } else { Ok(()) }
}

/// Checks the halves of every sample that hold half floats, given their number in the sample.
fn check_halves(grid: &Grid<'_>, is_float: impl Fn(u32) -> bool) -> Result<(), Error> {
    let words = grid.halves_per_sample() / 2;
    let finite = |half: u32| half & 0x7C00 != 0x7C00;
    let mut place = 0;
    for word in grid.samples.iter() {
        let valid = (!is_float(2 * place) || finite(word)) && (!is_float(2 * place + 1) || finite(word >> 16));
        if !valid {
            return Err(Error::SampleValue);
        }
        place = if place + 1 == words { 0 } else { place + 1 };
    }
    Ok(())
}
