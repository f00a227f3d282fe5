//! What a field is, and what the library is.

use crate::field::NearfieldField;
use crate::vector::NearfieldVector;
use nearfield::{ErrorStatistics, layout};

/// Version of this interface. A library and a program go together if both have the same: compare it with
/// nearfield_abi_version when the library is loaded at run time. The name of the shared library has it too.
pub const NEARFIELD_ABI_VERSION: u32 = 1;

/// Which files the library reads.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NearfieldFormat {
    /// Major version that a file must have.
    pub major: u16,
    /// Newest minor version that is read; so is every one before.
    pub newest_minor: u16,
}

/// Errors measured over a set of points: mesh units, finite, at least 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NearfieldErrors {
    /// Root mean square error.
    pub rmse: f32,
    /// 99th percentile of the absolute error.
    pub p99: f32,
    /// Largest absolute error.
    pub max: f32,
}

/// What a field is and how wrong it was found to be when it was baked.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearfieldInfo {
    /// Least corner of the box, mesh units, mesh frame.
    pub box_min: NearfieldVector,
    /// Greatest corner of the box.
    pub box_max: NearfieldVector,
    /// Diagonal of the mesh's bounding box, mesh units.
    pub diagonal: f32,
    /// Error that the baker was asked for, mesh units.
    pub target_error: f32,
    /// Upper bound of the slope of the field inside the box.
    pub lipschitz: f32,
    /// Largest error measured anywhere, mesh units: infinite if nothing was measured.
    pub max_error: f32,
    /// Errors over points spread evenly over the mesh's bounding box.
    pub uniform: NearfieldErrors,
    /// Errors over points within 1 % of the diagonal of the surface.
    pub band: NearfieldErrors,
    /// Largest jump of the value across a face between leaves, mesh units.
    pub seam_max: f32,
    /// Points measured, uniform and again in the band; 0 when nothing was measured.
    pub sample_count: u32,
    /// Measured points whose sign nothing could vouch for.
    pub doubtful_signs: u32,
    /// Minor version of the file's format.
    pub format_minor: u16,
    /// Major, minor and patch version of the baker.
    pub baker_version: [u16; 3],
    /// Hash of the mesh that was baked.
    pub mesh_hash: [u8; 16],
    /// Hash of the settings that it was baked with.
    pub settings_hash: [u8; 8],
}

/// NEARFIELD_ABI_VERSION of the library.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_abi_version() -> u32 {
    NEARFIELD_ABI_VERSION
}

/// Which files the library reads.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_format() -> NearfieldFormat {
    NearfieldFormat { major: layout::VERSION_MAJOR, newest_minor: layout::VERSION_MINOR }
}

/// What a field is. All zero if the handle is not open.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_info(field: Option<&NearfieldField>) -> NearfieldInfo {
    let Some(reader) = NearfieldField::reader(field) else {
        return nothing();
    };
    let (header, contract) = (reader.header(), reader.contract());
    let errors = |ErrorStatistics { rmse, p99, max }| NearfieldErrors { rmse, p99, max };
    NearfieldInfo {
        box_min: header.bounds.min.into(),
        box_max: header.bounds.max.into(),
        diagonal: header.diagonal,
        target_error: header.target_error,
        lipschitz: header.lipschitz,
        max_error: contract.max_error(),
        uniform: errors(contract.uniform),
        band: errors(contract.band),
        seam_max: contract.seam_max,
        sample_count: contract.sample_count,
        doubtful_signs: contract.doubtful_signs,
        format_minor: header.version[1],
        baker_version: header.baker_version,
        mesh_hash: header.mesh_hash,
        settings_hash: header.settings_hash,
    }
}

fn nothing() -> NearfieldInfo {
    let zero = NearfieldVector::from([0.0; 3]);
    NearfieldInfo {
        box_min: zero,
        box_max: zero,
        diagonal: 0.0,
        target_error: 0.0,
        lipschitz: 0.0,
        max_error: 0.0,
        uniform: NearfieldErrors::default(),
        band: NearfieldErrors::default(),
        seam_max: 0.0,
        sample_count: 0,
        doubtful_signs: 0,
        format_minor: 0,
        baker_version: [0; 3],
        mesh_hash: [0; 16],
        settings_hash: [0; 8],
    }
}
