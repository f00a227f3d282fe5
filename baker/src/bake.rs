//! The pipeline, on one screen.

use crate::distance::{SignMethod, SignedDistance};
use crate::encode::{EncodeError, Provenance, encode, write_contract};
use crate::mesh::CheckedMesh;
use crate::octree::Octree;
use crate::octree::domain::Domain;
use crate::progress::Progress;
use crate::report::{Report, Stopwatch};
use crate::settings::{Settings, SettingsError};
use crate::verify::{self, CONTRACT_SEED};
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
        /// Edge of a root cell, mesh units.
        edge: f64,
        /// Largest coordinate of the domain, mesh units.
        farthest: f64,
    },
    /// The format cannot hold the field.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// The reader rejects what was encoded: a defect of the baker.
    #[error("the baker wrote a field that its own reader rejects ({0}); please report this")]
    Rejected(nearfield::Error),
}

/// Bakes a mesh: the same mesh and settings give the same bytes on any machine and any number of threads.
pub fn bake(mesh: &CheckedMesh, settings: &Settings, progress: &dyn Progress) -> Result<Baked, BakeError> {
    settings.check()?;
    check_extent(&Domain::around(&mesh.bounds, settings))?;
    let diagonal = mesh.bounds.diagonal();
    let target = settings.error.absolute(diagonal);
    let mut stopwatch = Stopwatch::start(progress);

    // 1. The exact distance.
    stopwatch.stage("distance");
    let sign_method = settings.sign.resolve(&mesh.topology);
    let distance = SignedDistance::new(mesh, sign_method);

    // 2. Cells and samples.
    stopwatch.stage("octree");
    let octree = Octree::build(&distance, &mesh.bounds, settings, target, progress);

    // 3. Bytes.
    stopwatch.stage("encode");
    let provenance = Provenance {
        mesh_hash: mesh.hash(),
        settings_hash: settings.hash(),
        sign_method: match sign_method {
            SignMethod::Pseudonormal => layout::sign_method::PSEUDONORMAL,
            SignMethod::Winding => layout::sign_method::WINDING,
        },
        diagonal,
        target_error: target,
    };
    let mut bytes = encode(&octree, &provenance)?;

    // 4. The error contract, as the shipping reader answers.
    stopwatch.stage("verify");
    let field = Field::open(&bytes).and_then(|field| field.validate().map(|()| field)).map_err(BakeError::Rejected)?;
    let measurement = verify::measure(&field, &distance, mesh, settings.samples, CONTRACT_SEED);
    write_contract(&mut bytes, &measurement.contract());

    let report = Report {
        sign_method,
        leaves_by_level: octree.leaves_by_level(),
        samples: octree.samples,
        measurement,
        stages: stopwatch.stop(),
    };
    Ok(Baked { bytes, report })
}

/// The reader computes in `f32`: lengths must stay in its range.
fn check_extent(domain: &Domain) -> Result<(), BakeError> {
    let far_corner = domain.origin + domain.root_cells.as_dvec3() * domain.root_edge;
    let (edge, farthest) = (domain.root_edge, domain.origin.abs().max(far_corner.abs()).max_element());
    let fits = edge >= f64::from(limit::MIN_ROOT_EDGE) && farthest <= f64::from(limit::MAX_MAGNITUDE);
    if fits { Ok(()) } else { Err(BakeError::Extent { edge, farthest }) }
}
