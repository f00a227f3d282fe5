//! Levels of detail: a field with coarser ones of the same shape in its file.

use crate::bake::{BakeError, Baked, accepted};
use crate::encode::with_levels;
use crate::report::Stage;
use crate::settings::{Layout, Resolution, Settings, Target};
use nearfield::layout::grid::MIN_RESOLUTION;
use std::time::Duration;

/// How much larger the error of a level is than that of the next finer. Bytes fall to about an eighth.
pub const STEP: f64 = 4.0;
/// Most bytes of all levels together, as a share of the field's.
pub const MOST_SHARE: f64 = 0.2;

/// Adds up to `count` levels of detail to a field that `settings` gave, each at [`STEP`] times the error of the one before it
/// and measured as the field was. A level that would take the bytes of all beyond [`MOST_SHARE`] of the field's is left out;
/// without any, the file stays as it is.
///
/// A level is what `bake` makes of coarser settings: the target, and the greatest error if one is asked for, are larger; the
/// largest cells of an octree too, so that they do not outweigh the others; the samples of a grid are half as many along
/// each axis.
///
/// # Errors
/// Those of `bake`.
pub fn add_levels(
    field: Baked,
    settings: &Settings,
    count: u8,
    mut bake: impl FnMut(&Settings) -> Result<Baked, BakeError>,
) -> Result<Baked, BakeError> {
    let Baked { bytes, mut report } = field;
    let opened = accepted(&bytes)?;
    let mut room = (MOST_SHARE * bytes.len() as f64) as usize;
    let mut stages = Vec::new();
    let mut levels = Vec::new();
    for level in 1..=count {
        let coarser = bake(&coarser(settings, f64::from(opened.header().target_error), level))?;
        stages.extend(coarser.report.stages);
        if let Some(left) = room.checked_sub(coarser.bytes.len()) {
            room = left;
            levels.insert(0, coarser.bytes);
        }
    }
    if count > 0 {
        report.stages.push(in_all(&stages));
        report.lods_left_out = usize::from(count) - levels.len();
    }
    if levels.is_empty() {
        return Ok(Baked { bytes, report });
    }
    let bytes = with_levels(&opened, &levels)?;
    accepted(&bytes)?;
    Ok(Baked { bytes, report })
}

/// Bytes that a field may take, so that it fits `max_bytes` with its levels.
pub fn bytes_without_levels(max_bytes: u64) -> u64 {
    (max_bytes.saturating_sub(ENTRY) as f64 / (1.0 + MOST_SHARE)) as u64
}

/// Bytes of the entry of the levels in the section table.
const ENTRY: u64 = nearfield::layout::section_entry::LENGTH as u64;

/// Settings of a level, counted from 1, of a field whose target error is `target`, mesh units.
fn coarser(settings: &Settings, target: f64, level: u8) -> Settings {
    let times = libm::pow(STEP, level.into());
    let mut coarser = Settings {
        error: Target::Absolute(times * target),
        max_bytes: None,
        start_depth: settings.start_depth.saturating_sub(level),
        ..*settings
    };
    match &mut coarser.layout {
        Layout::Octree => {}
        Layout::Polynomial(polynomial) => polynomial.max_error = polynomial.max_error.map(|max| max.times(times)),
        Layout::Grid(grid) => {
            let fewer = |samples: u16| (samples >> level).max(MIN_RESOLUTION);
            grid.resolution = match grid.resolution {
                Resolution::Longest(samples) => Resolution::Longest(fewer(samples)),
                Resolution::Each(samples) => Resolution::Each(samples.map(fewer)),
            };
        }
    }
    coarser
}

/// The stages of all levels as one.
fn in_all(stages: &[Stage]) -> Stage {
    let sum = |time: fn(&Stage) -> Duration| stages.iter().map(time).sum();
    Stage { name: "levels", wall: sum(|stage| stage.wall), cpu: sum(|stage| stage.cpu) }
}
