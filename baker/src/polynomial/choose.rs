//! The cheapest leaf that is good enough.

use crate::quantize::piece::{Coded, Steps};
use crate::sampling::cell::{CellSamples, Fit, Piece};
use glam::DVec3;
use nearfield::layout::leaf::{REACH_BITS, SUPPORT_BITS};
use nearfield::layout::polynomial::MAX_SHAPE_BITS;
use nearfield::layout::shape::MAX_EXPONENT;

/// Bits of a leaf beside its coefficients: shape and codes, and half a byte lost to the end.
const OVERHEAD: u32 = 15;
/// Most bytes of a leaf: seven of them fit the starts of a record, whatever the eighth.
const MAX_BYTES: u32 = 36;
/// Most bits of the coefficients of a leaf, beside the longest shape number and the codes of the overlap.
pub const MAX_BITS: u32 = 8 * MAX_BYTES - MAX_SHAPE_BITS as u32 - SUPPORT_BITS - REACH_BITS;

/// How far a leaf may be from the function between its samples, by its slopes, in greatest errors allowed at them.
/// Slopes are pessimists; this much catches polynomials that swing and hardly any other.
const MOST_DOUBT: f64 = 2.0;

/// What is asked of a leaf, mesh units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tolerance {
    /// Root mean square error.
    pub(super) rmse: f64,
    /// Greatest error at a sample.
    pub(super) max: f64,
}

/// A point where a leaf has to keep a greatest error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Check {
    /// Where, by the coordinates of the leaf: in the cube [-1, 1]³ or a little outside.
    pub(super) at: DVec3,
    /// The function there, mesh units.
    pub(super) distance: f64,
    /// Greatest error, mesh units.
    pub(super) within: f64,
}

impl Check {
    fn is_kept(&self, piece: &Piece) -> bool {
        (piece.evaluate(self.at).0 - self.distance).abs() <= self.within
    }
}

/// Bits that a leaf may cost more if that lowers its mean square error by as much as the tolerance allows: spent
/// where they buy most, they save more leaves than they cost (half as much costs 4 % of the bytes at equal error, twice as
/// much 2 %).
const WORTH: f64 = 200.0;

/// The leaf of all fits that costs least among those within the tolerance; none if there is none. What is checked is not fitted: it
/// is no part of the mean.
pub(super) fn cheapest(
    steps: &Steps,
    cell: &CellSamples<'_>,
    fits: &[Fit],
    checks: &[Check],
    tolerance: Tolerance,
) -> Option<Coded> {
    let mut candidates: Vec<(f64, usize, u8)> = Vec::new();
    for (index, fit) in fits.iter().enumerate() {
        candidates.extend(exponents(steps, fit, tolerance).map(|(cost, exponent)| (cost, index, exponent)));
    }
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    candidates.into_iter().find_map(|(_, index, exponent)| {
        let coded = steps.code(&fits[index].piece, exponent)?;
        let piece = steps.decode(&coded);
        let errors = cell.errors(&piece);
        let is_good = errors.mean_square <= tolerance.rmse * tolerance.rmse && errors.max <= tolerance.max;
        let is_sure = || cell.doubt(&fits[index].piece) <= MOST_DOUBT * tolerance.max;
        (is_good && checks.iter().all(|check| check.is_kept(&piece)) && is_sure()).then_some(coded)
    })
}

/// The leaf of all fits whose error is least, for a cell that cannot be split, and its mean square error.
pub(super) fn best(steps: &Steps, cell: &CellSamples<'_>, fits: &[Fit], tolerance: Tolerance) -> (Coded, f64) {
    let coded = fits.iter().filter_map(|fit| {
        // As fine as is worth it, or as it must be to fit.
        let noise = 0.25 * (fit.errors.mean_square + tolerance.rmse * tolerance.rmse);
        let finest = steps.coarsest(&fit.piece, noise).unwrap_or(0);
        (finest..=MAX_EXPONENT)
            .find_map(|exponent| steps.code(&fit.piece, exponent).filter(|coded| coded.bits(&coded.widths) <= MAX_BITS))
    });
    let with_error = coded.map(|coded| {
        let mean_square = cell.errors(&steps.decode(&coded)).mean_square;
        (coded, mean_square)
    });
    with_error.min_by(|(_, a), (_, b)| a.total_cmp(b)).expect("a constant can always be coded")
}

/// The exponents worth a look, and what they cost.
fn exponents(steps: &Steps, fit: &Fit, tolerance: Tolerance) -> impl Iterator<Item = (f64, u8)> {
    let allowed = tolerance.rmse * tolerance.rmse;
    let is_good = fit.errors.mean_square <= allowed && fit.errors.max <= tolerance.max;
    let coarsest = is_good.then(|| steps.coarsest(&fit.piece, allowed - fit.errors.mean_square)).flatten();
    coarsest.into_iter().flat_map(|coarsest| coarsest.saturating_sub(3)..=coarsest).filter_map(move |exponent| {
        let coded = steps.code(&fit.piece, exponent)?;
        let bits = coded.bits(&coded.widths);
        let square = fit.errors.mean_square + steps.noise(&fit.piece, exponent);
        (bits <= MAX_BITS).then_some((f64::from(bits + OVERHEAD) + WORTH * square / allowed, exponent))
    })
}
