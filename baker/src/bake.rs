//! The pipeline, on one screen.

use crate::distance::{SignMethod, SignedDistance};
use crate::encode::{EncodeError, Provenance, encode, write_contract};
use crate::mesh::CheckedMesh;
use crate::octree::Octree;
use crate::progress::Progress;
use crate::report::{Report, Stopwatch};
use crate::settings::{Settings, SettingsError};
use crate::verify::{self, CONTRACT_SEED};
use nearfield::{Field, layout};
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
