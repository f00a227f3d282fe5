//! The pipeline, on one screen.

use crate::budget::{self, TooSmall};
use crate::distance::{SignMethod, SignedDistance};
use crate::encode::{EncodeError, Provenance, encode, encode_grid, encode_polynomial, write_contract, write_lipschitz};
use crate::field_function::FieldFunction;
use crate::geometry::Aabb;
use crate::grid::{self, Grid};
use crate::mesh::CheckedMesh;
use crate::octree::Octree;
use crate::octree::domain::Domain;
use crate::polynomial::{PolynomialOctree, Unkept};
use crate::progress::Progress;
use crate::report::{Report, Stopwatch};
use crate::settings::{Layout, PolynomialSettings, Settings, SettingsError, Target};
use crate::verify::{self, CONTRACT_SEED, Measurement};
use nearfield::Field;
use nearfield::layout::{self, limit};
use thiserror::Error;

/// A finished field.
#[derive(Clone, Debug)]
pub struct Baked {
    /// The file.
    pub bytes: Vec<u8>,
    /// What happened on the way.
    pub report: Report,
}

/// Why a bake gave no field.
#[derive(Debug, Error)]
pub enum BakeError {
    /// The settings contradict themselves.
    #[error(transparent)]
    Settings(#[from] SettingsError),
    /// The mesh is too small, too large or too far from the origin for the `f32` of the reader.
    #[error(
        "cells of edge {edge:e} as far out as {farthest:e} are beyond the format, which ends at edges of {:e} and coordinates of {:e}: scale the mesh",
        limit::MIN_ROOT_EDGE,
        limit::MAX_MAGNITUDE
    )]
    Extent {
        /// Edge of a root cell or least spacing of a grid, mesh units.
        edge: f64,
        /// Largest coordinate of the domain, mesh units.
        farthest: f64,
    },
    /// The format cannot hold the field.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// The smallest field is larger than the bytes allow.
    #[error(
        "no field of this mesh and these settings is smaller than {smallest} bytes, which is more than {max_bytes}"
    )]
    Budget {
        /// Bytes that were allowed.
        max_bytes: u64,
        /// Bytes of the smallest field.
        smallest: usize,
    },
    /// The greatest error asked for is too small for the depth.
    #[error("the largest error cannot be kept: {0}; allow a greater depth or a larger error")]
    Unkept(#[from] Unkept),
    /// The greatest error asked for is kept wherever it was looked for, but not at the points of the contract.
    #[error(
        "the largest error is {found:e}, more than the {asked:e} asked for; allow a greater depth or a larger error"
    )]
    Exceeded {
        /// What was asked for, mesh units.
        asked: f64,
        /// What was measured, mesh units.
        found: f64,
    },
    /// The reader rejects what was encoded: a defect of the baker.
    #[error("the baker wrote a field that its own reader rejects ({0}); please report this")]
    Rejected(nearfield::Error),
}

/// Bakes a mesh: the same mesh and settings give the same bytes on any machine and any number of threads.
pub fn bake(mesh: &CheckedMesh, settings: &Settings, progress: &dyn Progress) -> Result<Baked, BakeError> {
    settings.check()?;
    check_extent(&mesh.bounds, settings)?;
    let diagonal = mesh.bounds.diagonal();
    let target = settings.error.absolute(diagonal);
    let mut stopwatch = Stopwatch::start(progress);

    // 1. The exact distance.
    stopwatch.stage("distance");
    let (distance, decision) = SignedDistance::choose(mesh, settings.sign);

    let provenance = Provenance {
        mesh_hash: mesh.hash(),
        settings_hash: settings.hash(),
        sign_method: match decision.method {
            SignMethod::Pseudonormal => layout::sign_method::PSEUDONORMAL,
            SignMethod::Winding => layout::sign_method::WINDING,
            SignMethod::Rays => layout::sign_method::RAYS,
            SignMethod::Sheet { .. } => layout::sign_method::SHEET,
        },
        diagonal,
        target_error: target,
    };

    // 2. Samples, 3. bytes, 4. the error contract, as the shipping reader answers.
    let measure = |field: &Field<'_>| verify::measure(field, &distance, mesh, settings.samples, CONTRACT_SEED);
    let (Built { bytes, leaves_by_level, samples }, measurement) =
        build_and_measure(&distance, &mesh.bounds, settings, &provenance, measure, &mut stopwatch, progress)?;

    let report = Report {
        sign: Some(decision),
        leaves_by_level,
        samples,
        measurement,
        lods_left_out: 0,
        stages: stopwatch.stop(),
    };
    Ok(Baked { bytes, report })
}

/// Bakes any signed distance function, sampled in `bounds` and the margin of the settings around it, mesh units.
///
/// The header names no sign method and no mesh. Errors are relative to the diagonal of `bounds` and measured
/// against the function itself: uniform in `bounds`, and near its zero set as far as projecting points of
/// `bounds` along the gradient finds it. [`field_function::Closure`](crate::field_function::Closure) makes a
/// function of a closure.
///
/// # Errors
/// As [`bake`].
pub fn bake_function(
    function: &dyn FieldFunction,
    bounds: &Aabb,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Baked, BakeError> {
    settings.check()?;
    check_extent(bounds, settings)?;
    let diagonal = bounds.diagonal();
    let provenance = Provenance {
        mesh_hash: [0; 16],
        settings_hash: settings.hash(),
        sign_method: layout::sign_method::NONE,
        diagonal,
        target_error: settings.error.absolute(diagonal),
    };
    let mut stopwatch = Stopwatch::start(progress);
    let measure =
        |field: &Field<'_>| verify::measure_function(field, function, bounds, settings.samples, CONTRACT_SEED);
    let (Built { bytes, leaves_by_level, samples }, measurement) =
        build_and_measure(function, bounds, settings, &provenance, measure, &mut stopwatch, progress)?;
    let report =
        Report { sign: None, leaves_by_level, samples, measurement, lods_left_out: 0, stages: stopwatch.stop() };
    Ok(Baked { bytes, report })
}

/// The field, as the shipping reader accepts it.
pub(crate) fn accepted(bytes: &[u8]) -> Result<Field<'_>, BakeError> {
    Field::open(bytes).and_then(|field| field.validate().map(|()| field)).map_err(BakeError::Rejected)
}

/// How much steeper than the steepest slope that was measured a blended field is allowed to be.
const SLOPE_MARGIN: f64 = 1.25;

/// Writes into the header what was measured.
fn finish(bytes: &mut [u8], settings: &Settings, measurement: &Measurement) {
    write_contract(bytes, &measurement.contract());
    if matches!(settings.layout, Layout::Polynomial(_)) {
        write_lipschitz(bytes, SLOPE_MARGIN * measurement.steepest.max(1.0));
    }
}

/// What the layouts have in common once they are bytes.
struct Built {
    bytes: Vec<u8>,
    leaves_by_level: Vec<usize>,
    samples: usize,
}

/// Shares of the greatest error asked for that the octree keeps where it looks, the next where the points of the contract
/// find more than was asked all the same.
const KEPT_SHARES: [f64; 4] = [0.96, 0.9, 0.8, 0.65];

/// Builds a field and measures it, again until it keeps the greatest error asked for.
fn build_and_measure(
    function: &dyn FieldFunction,
    bounds: &Aabb,
    settings: &Settings,
    provenance: &Provenance,
    measure: impl Fn(&Field<'_>) -> Measurement,
    stopwatch: &mut Stopwatch<'_>,
    progress: &dyn Progress,
) -> Result<(Built, Measurement), BakeError> {
    let mut attempt = |settings: &Settings| -> Result<(Built, Measurement), BakeError> {
        let mut built = build_within_budget(function, bounds, settings, provenance, stopwatch, progress)?;
        stopwatch.stage("verify");
        let measurement = measure(&accepted(&built.bytes)?);
        finish(&mut built.bytes, settings, &measurement);
        Ok((built, measurement))
    };
    let Layout::Polynomial(PolynomialSettings { max_error: Some(asked), profile, .. }) = settings.layout else {
        return attempt(settings);
    };
    let asked = asked.absolute(provenance.diagonal);
    let mut found = f64::INFINITY;
    for share in KEPT_SHARES {
        let (built, measurement) = attempt(&with_greatest_error(settings, share * asked))?;
        found = measurement.greatest(profile);
        if found <= asked {
            return Ok((built, measurement));
        }
    }
    Err(BakeError::Exceeded { asked, found })
}

fn with_greatest_error(settings: &Settings, greatest: f64) -> Settings {
    let mut settings = *settings;
    if let Layout::Polynomial(polynomial) = &mut settings.layout {
        polynomial.max_error = Some(Target::Absolute(greatest));
    }
    settings
}

/// Builds once, or as often as it takes to find the least error that fits.
fn build_within_budget(
    function: &dyn FieldFunction,
    bounds: &Aabb,
    settings: &Settings,
    provenance: &Provenance,
    stopwatch: &mut Stopwatch<'_>,
    progress: &dyn Progress,
) -> Result<Built, BakeError> {
    let Some(max_bytes) = settings.max_bytes else {
        return build(function, bounds, settings, provenance, stopwatch, progress);
    };
    let mut failure = None;
    let with_error = |error: f64| {
        let target_error = error * provenance.diagonal;
        let settings = Settings { error: Target::Absolute(target_error), ..*settings };
        let provenance = Provenance { target_error, ..*provenance };
        let built = build(function, bounds, &settings, &provenance, stopwatch, progress);
        built.map_err(|error| failure = Some(error)).ok()
    };
    let max = usize::try_from(max_bytes).unwrap_or(usize::MAX);
    budget::finest_within(max, with_error, |built| built.bytes.len()).map_err(|TooSmall { smallest }| match failure {
        Some(failure) if smallest == usize::MAX => failure,
        _ => BakeError::Budget { max_bytes, smallest },
    })
}

fn build(
    function: &dyn FieldFunction,
    bounds: &Aabb,
    settings: &Settings,
    provenance: &Provenance,
    stopwatch: &mut Stopwatch<'_>,
    progress: &dyn Progress,
) -> Result<Built, BakeError> {
    match &settings.layout {
        Layout::Polynomial(polynomial) => {
            stopwatch.stage("octree");
            let octree =
                PolynomialOctree::build(function, bounds, settings, polynomial, provenance.diagonal, progress)?;
            stopwatch.stage("encode");
            let bytes = encode_polynomial(&octree, provenance)?;
            Ok(Built { bytes, leaves_by_level: octree.leaves_by_level(), samples: octree.samples })
        }
        Layout::Octree => {
            stopwatch.stage("octree");
            let octree = Octree::build(function, bounds, settings, provenance.target_error, progress);
            stopwatch.stage("encode");
            let bytes = encode(&octree, provenance)?;
            Ok(Built { bytes, leaves_by_level: octree.leaves_by_level(), samples: octree.samples })
        }
        Layout::Grid(grid_settings) => {
            stopwatch.stage("grid");
            let grid = Grid::build(function, bounds, settings, grid_settings, progress);
            stopwatch.stage("encode");
            let bytes = encode_grid(&grid, provenance)?;
            Ok(Built { bytes, leaves_by_level: Vec::new(), samples: grid.samples })
        }
    }
}

/// The reader computes in `f32`: lengths must stay in its range.
fn check_extent(bounds: &Aabb, settings: &Settings) -> Result<(), BakeError> {
    let (edge, min, max) = match &settings.layout {
        Layout::Octree | Layout::Polynomial(_) => {
            let domain = Domain::around(bounds, settings);
            let max = domain.origin + domain.root_cells.as_dvec3() * domain.root_edge;
            (domain.root_edge, domain.origin, max)
        }
        Layout::Grid(grid) => {
            let domain = grid::Domain::around(bounds, settings.margin, grid.resolution);
            (domain.spacing.min_element(), domain.bounds().min, domain.bounds().max)
        }
    };
    let farthest = min.abs().max(max.abs()).max_element();
    let fits = edge >= f64::from(limit::MIN_ROOT_EDGE) && farthest <= f64::from(limit::MAX_MAGNITUDE);
    if fits { Ok(()) } else { Err(BakeError::Extent { edge, farthest }) }
}
