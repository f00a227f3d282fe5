//! The least error whose field fits a number of bytes.

/// Coarsest target that is tried, as a share of the diagonal: any leaf is good enough.
const COARSEST: f64 = 1.0;
/// Finest target that is tried.
const FINEST: f64 = 1e-7;
/// First guess.
const FIRST: f64 = 4e-3;
/// Bytes fall about as the target to this power, until two sizes tell better.
const POWER: f64 = 1.6;
/// A field that fills this share of the bytes is good enough.
const FULL: f64 = 0.98;
/// Most fields that are built.
const MOST_TRIALS: usize = 14;

/// Why no field fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TooSmall {
    /// Bytes of the smallest field.
    pub(crate) smallest: usize,
}

/// Looks for the finest target, as a share of the diagonal, whose field takes at most `max_bytes`, and gives the field, or
/// the fewest bytes with which the search would find one.
///
/// Sizes are taken to fall as targets grow, which holds but for a few bytes. A build that fails counts as too large.
pub(crate) fn finest_within<F>(
    max_bytes: usize,
    mut build: impl FnMut(f64) -> Option<F>,
    size: impl Fn(&F) -> usize,
) -> Result<F, TooSmall> {
    search(max_bytes, &mut build, &size).map_err(|TooSmall { mut smallest }| {
        while let Ok(field) = search(smallest - 1, &mut build, &size) {
            smallest = size(&field);
        }
        TooSmall { smallest }
    })
}

fn search<F>(
    max_bytes: usize,
    build: &mut impl FnMut(f64) -> Option<F>,
    size: &impl Fn(&F) -> usize,
) -> Result<F, TooSmall> {
    let (mut fine, mut coarse) = (FINEST, COARSEST);
    let mut best: Option<F> = None;
    let (mut guess, mut power) = (FIRST, POWER);
    let mut last: Option<(f64, usize)> = None;
    for _ in 0..MOST_TRIALS {
        let field = build(guess);
        let bytes = field.as_ref().map_or(usize::MAX, size);
        if bytes <= max_bytes {
            coarse = guess;
            let is_full = bytes as f64 >= FULL * max_bytes as f64;
            best = field;
            if is_full {
                break;
            }
        } else {
            fine = guess;
        }

        // Where the power law through the last two sizes puts it, a little to the side that fits, within what is left.
        if let Some((before, bytes_before)) = last.filter(|&(_, bytes_before)| bytes_before != bytes) {
            let slope = libm::log(bytes as f64 / bytes_before as f64) / libm::log(before / guess);
            power = slope.clamp(0.5, 4.0);
        }
        last = Some((guess, bytes));
        let aim = guess * libm::pow(bytes as f64 / (0.99 * max_bytes as f64), 1.0 / power);
        let ratio = coarse / fine;
        if ratio < 1.002 {
            break;
        }
        guess = aim.clamp(fine * libm::pow(ratio, 0.02), fine * libm::pow(ratio, 0.98));
    }
    if let Some(best) = best {
        return Ok(best);
    }

    let field = build(COARSEST);
    let smallest = field.as_ref().map_or(usize::MAX, size);
    field.filter(|_| smallest <= max_bytes).ok_or(TooSmall { smallest })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fields of a size that falls as a power of the target, down to 1000 bytes.
    fn find(max_bytes: usize, power: f64) -> (Result<f64, TooSmall>, usize) {
        let mut trials = 0;
        let size = |target: &f64| 1000 + (50.0 * libm::pow(*target, -power)) as usize;
        let found = finest_within(
            max_bytes,
            |target| {
                trials += 1;
                Some(target)
            },
            size,
        );
        if let Ok(target) = &found {
            let bytes = size(target);
            assert!(bytes <= max_bytes && bytes as f64 >= 0.98 * max_bytes as f64, "{bytes} for {max_bytes}");
        }
        (found, trials)
    }

    #[test]
    fn a_budget_is_filled_in_a_few_trials() {
        for power in [1.0, 1.6, 2.0, 3.0] {
            for max_bytes in [1500, 65_536, 1 << 20] {
                let (found, trials) = find(max_bytes, power);
                assert!(found.is_ok() && trials <= 8, "{max_bytes} bytes, power {power}: {trials} trials");
            }
        }
    }

    #[test]
    fn a_budget_below_the_smallest_field_names_it() {
        assert_eq!(find(1000, 1.6).0, Err(TooSmall { smallest: 1050 }));
    }
}
