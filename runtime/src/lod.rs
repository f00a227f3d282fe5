//! Levels of detail: whole files of coarser fields within a file (SPEC.md §4.2).

use crate::bytes::{f32_at, u8_at, u32_at};
use crate::error::Error;
use crate::layout::{MAX_LODS, header, section as kind};
use crate::section;

/// Whether a file announces levels. Not inlined: its stack is not that of the checks.
#[inline(never)]
pub(crate) fn has_levels(file: &[u8]) -> bool {
    section::find(file, kind::LODS).is_ok()
}

/// The levels in what there is of a file whose section table is sound, each the bytes of a file; coarsest first, as they lie
/// there. Ends where no whole one follows, and after the most that there may be.
pub(crate) fn levels(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    let range = section::find(bytes, kind::LODS).map_or(0..0, |section| section.range);
    let mut rest = bytes.get(range.start..range.end.min(bytes.len())).unwrap_or(&[]);
    let next = move || {
        let (level, others) = rest.split_at_checked(u32_at(rest, header::FILE_LENGTH) as usize)?;
        rest = others;
        (level.len() >= header::LENGTH).then_some(level)
    };
    core::iter::from_fn(next).take(MAX_LODS)
}

/// The bytes of a level by its number, from 1, the finest of those beside the field itself.
pub(crate) fn level(bytes: &[u8], number: usize) -> Option<&[u8]> {
    let index = levels(bytes).count().checked_sub(number)?;
    levels(bytes).nth(index)
}

/// Checks that the levels of a file that has some tile their section, and are levels of this field. Whether each is a valid file
/// is another question.
pub(crate) fn check(bytes: &[u8]) -> Result<(), Error> {
    let length: usize = levels(bytes).map(<[u8]>::len).sum();
    if length == 0 || length != section::find_bytes(bytes, kind::LODS)?.len() {
        return Err(Error::LodLength);
    }

    let identity = |file| (u8_at(file, header::FAMILY), u32_at(file, header::DIAGONAL));
    if levels(bytes).any(|level| identity(level) != identity(bytes) || has_levels(level)) {
        return Err(Error::LodHeader);
    }

    let targets = levels(bytes).chain([bytes]).map(|file| f32_at(file, header::TARGET_ERROR));
    let mut coarser = f32::INFINITY;
    for target in targets {
        if target >= coarser {
            return Err(Error::LodOrder);
        }
        coarser = target;
    }
    Ok(())
}
