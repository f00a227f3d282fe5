//! Size against error: one mesh at many targets.

use crate::bake::{BakeError, bake};
use crate::mesh::CheckedMesh;
use crate::progress::Progress;
use crate::settings::{Layout, PolynomialSettings, Profile, Resolution, Settings, Target};
use crate::smallest::KINDS;
use crate::verify::Measurement;

/// How often the finest target is doubled, or the finest resolution halved.
const STEPS: u16 = 5;
/// Samples along the longest side of grids beside octrees: these numbers and their doubles.
const FEWEST_SAMPLES: [u16; 2] = [8, 12];

/// Fields of one kind, from the coarsest to the finest.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What they have in common.
    pub name: &'static str,
    /// The fields.
    pub fields: Vec<Point>,
}

/// One field of a curve.
#[derive(Clone, Debug)]
pub struct Point {
    /// What was asked for.
    pub settings: Settings,
    /// Length of the file.
    pub bytes: usize,
    /// What was measured.
    pub measurement: Measurement,
}

/// Bakes a mesh at targets that halve down to the one of the settings, or at resolutions that double up to it.
///
/// A polynomial octree makes a curve for each profile. `with_grids` adds the packed grids that
/// [`bake_smallest`](crate::bake_smallest) tries, until one is larger than the largest octree. `each` is told of every field
/// once it is measured.
///
/// # Errors
/// Those of [`bake`] for what was asked for; the grids beside it end where they fail.
pub fn sweep(
    mesh: &CheckedMesh,
    settings: &Settings,
    with_grids: bool,
    progress: &dyn Progress,
    mut each: impl FnMut(&'static str, &Point),
) -> Result<Vec<Curve>, BakeError> {
    let mut measure = |name: &'static str, settings: Settings| {
        let baked = bake(mesh, &settings, progress)?;
        let point = Point { settings, bytes: baked.bytes.len(), measurement: baked.report.measurement };
        each(name, &point);
        Ok(point)
    };

    let mut curves = Vec::new();
    for (name, kind) in asked_for(settings) {
        let settings = coarsened(&kind);
        let fields: Result<Vec<Point>, BakeError> = settings.map(|settings| measure(name, settings)).collect();
        curves.push(Curve { name, fields: fields? });
    }

    let largest = curves.iter().flat_map(|curve| &curve.fields).map(|point| point.bytes).max().unwrap_or(0);
    for kind in KINDS.iter().filter(|kind| with_grids && kind.continuity >= settings.continuity) {
        let resolutions = (0..=12).flat_map(|doublings| FEWEST_SAMPLES.map(|samples| samples << doublings));
        let mut fields: Vec<Point> = Vec::new();
        for samples in resolutions {
            let Ok(point) = measure(kind.name, kind.within(settings, samples)) else { break };
            let is_larger = point.bytes > largest;
            fields.push(point);
            if is_larger {
                break;
            }
        }
        curves.push(Curve { name: kind.name, fields });
    }
    Ok(curves)
}

/// The kinds of field that the settings ask for.
fn asked_for(settings: &Settings) -> Vec<(&'static str, Settings)> {
    let Layout::Polynomial(polynomial) = settings.layout else {
        let name = if matches!(settings.layout, Layout::Octree) { "octree" } else { "grid" };
        return vec![(name, *settings)];
    };
    let with = |profile| {
        let layout = Layout::Polynomial(PolynomialSettings { profile, ..polynomial });
        Settings { layout, ..*settings }
    };
    vec![("uniform", with(Profile::Uniform)), ("surface", with(Profile::Surface))]
}

/// The same settings ever finer, up to themselves.
fn coarsened(settings: &Settings) -> impl Iterator<Item = Settings> {
    (0..=STEPS).rev().map(|step| {
        let mut coarse = *settings;
        coarse.error = doubled(settings.error, step);
        match &mut coarse.layout {
            Layout::Octree => {}
            Layout::Polynomial(polynomial) => polynomial.max_error = polynomial.max_error.map(|max| doubled(max, step)),
            Layout::Grid(grid) => grid.resolution = halved(grid.resolution, step),
        }
        coarse
    })
}

fn doubled(target: Target, times: u16) -> Target {
    let factor = f64::from(1u32 << times);
    match target {
        Target::Relative(error) => Target::Relative(factor * error),
        Target::Absolute(error) => Target::Absolute(factor * error),
    }
}

fn halved(resolution: Resolution, times: u16) -> Resolution {
    let halved = |samples: u16| (samples >> times).max(2);
    match resolution {
        Resolution::Longest(samples) => Resolution::Longest(halved(samples)),
        Resolution::Each(samples) => Resolution::Each(samples.map(halved)),
    }
}
