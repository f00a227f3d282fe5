//! The header: what a field is, where it came from and how wrong it may be.

use crate::bytes::{bytes_at, f32_at, f32x3_at, u8_at, u16_at, u32_at};
use crate::checksum::Crc32c;
use crate::error::Error;
use crate::layout::{MAGIC, VERSION_MAJOR, VERSION_MINOR, family, header as at, limit, sign_method};
use crate::section;

/// An axis-aligned box. Mesh units, mesh frame, finite, `min < max` along every axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Least corner.
    pub min: [f32; 3],
    /// Greatest corner.
    pub max: [f32; 3],
}

impl Aabb {
    /// Whether a point lies in the box, faces included. False for a NaN.
    #[inline]
    pub fn contains(&self, [x, y, z]: [f32; 3]) -> bool {
        let Self { min, max } = self;
        (x >= min[0]) & (x <= max[0]) & (y >= min[1]) & (y <= max[1]) & (z >= min[2]) & (z <= max[2])
    }
}

/// How a field is represented.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Family {
    /// A uniform lattice of samples.
    Grid,
    /// Adaptive cells.
    Octree,
    /// Adaptive cells of quantized polynomials.
    Polynomial,
}

/// How the baker told inside from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SignMethod {
    /// The field did not come from a mesh.
    None,
    /// Angle-weighted pseudonormals (Bærentzen and Aanæs 2005).
    Pseudonormal,
    /// Generalized winding numbers (Jacobson et al. 2013).
    Winding,
    /// The majority of rays that count crossings.
    Rays,
    /// There is no inside: the unsigned distance less half the thickness of a sheet.
    Sheet,
}

/// The header of a field, apart from its error contract.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Header {
    /// Major and minor version of the format.
    pub version: [u16; 2],
    /// How the field is represented.
    pub family: Family,
    /// How the baker told inside from outside.
    pub sign_method: SignMethod,
    /// Where the field was sampled; outside, distances are upper bounds.
    pub bounds: Aabb,
    /// Diagonal of the mesh's bounding box, mesh units, at least 0.
    pub diagonal: f32,
    /// Error that the baker was asked for, mesh units, at least 0.
    pub target_error: f32,
    /// Upper bound of the slope of the reconstruction inside the box, at least 0.
    pub lipschitz: f32,
    /// Major, minor and patch version of the baker.
    pub baker_version: [u16; 3],
    /// Hash of the welded mesh.
    pub mesh_hash: [u8; 16],
    /// Hash of the settings.
    pub settings_hash: [u8; 8],
}

/// Errors measured over a set of points: mesh units, finite, at least 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorStatistics {
    /// Root mean square error.
    pub rmse: f32,
    /// 99th percentile of the absolute error.
    pub p99: f32,
    /// Largest absolute error.
    pub max: f32,
}

/// How wrong the field was found to be at bake time. Mesh units.
///
/// These are measurements at [`sample_count`](Self::sample_count) points of the mesh's box and as
/// many of the band, not proofs for every point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorContract {
    /// Over points spread evenly over the mesh's bounding box.
    pub uniform: ErrorStatistics,
    /// Over points within 1 % of the diagonal of the surface.
    pub band: ErrorStatistics,
    /// Largest jump of the value across a face between leaves.
    pub seam_max: f32,
    /// Points measured, uniform and again in the band; 0 when nothing was measured.
    pub sample_count: u32,
    /// Measured points whose sign the sign method could not vouch for.
    pub doubtful_signs: u32,
}

impl ErrorContract {
    /// Largest error measured anywhere, mesh units: `distance - max_error()` can serve as clearance.
    ///
    /// [`f32::INFINITY`] when nothing was measured. Says nothing about outside the box.
    pub fn max_error(&self) -> f32 {
        if self.sample_count == 0 {
            return f32::INFINITY;
        }
        self.uniform.max.max(self.band.max)
    }
}

/// Checks the header and the section table, all but the contents of the sections (SPEC.md §3, §4).
pub(crate) fn check(bytes: &[u8]) -> Result<(), Error> {
    // A file of another format or version is told apart before anything else is believed.
    if bytes.len() < MAGIC.len() || !bytes.starts_with(&MAGIC) {
        return Err(if MAGIC.starts_with(bytes) { Error::Truncated } else { Error::Magic });
    }
    if bytes.len() < at::LENGTH {
        return Err(Error::Truncated);
    }
    if u16_at(bytes, at::VERSION_MAJOR) != VERSION_MAJOR || u16_at(bytes, at::VERSION_MINOR) > VERSION_MINOR {
        return Err(Error::Version);
    }
    if u32_at(bytes, at::FILE_LENGTH) as usize != bytes.len() {
        return Err(Error::FileLength);
    }

    // The rest may be read only if it is what the writer wrote.
    let table = section::table_bytes(bytes)?;
    let header = bytes.get(..at::LENGTH).unwrap_or(&[]);
    if checksum(header, table) != u32_at(bytes, at::CHECKSUM) {
        return Err(Error::HeaderChecksum);
    }
    if u8_at(bytes, at::RESERVED) != 0 {
        return Err(Error::Reserved);
    }
    family_of(bytes)?;
    sign_method_of(bytes)?;
    check_quantities(bytes)?;
    section::check(bytes)
}

/// CRC-32C of the header, with its checksum as zero, and the section table.
fn checksum(header: &[u8], table: &[u8]) -> u32 {
    let before = header.get(..at::CHECKSUM.start).unwrap_or(&[]);
    let after = header.get(at::CHECKSUM.end..).unwrap_or(&[]);
    Crc32c::new().update(before).update(&[0; 4]).update(after).update(table).finish()
}

fn check_quantities(bytes: &[u8]) -> Result<(), Error> {
    let Aabb { min, max } = bounds_of(bytes);
    let in_range = |value: &f32| value.abs() <= limit::MAX_MAGNITUDE;
    let ordered = min.iter().zip(&max).all(|(min, max)| min < max);
    if !(ordered && min.iter().chain(&max).all(in_range)) {
        return Err(Error::Bounds);
    }

    let ErrorContract { uniform, band, seam_max, .. } = contract_of(bytes);
    let scalars = [at::DIAGONAL, at::TARGET_ERROR, at::LIPSCHITZ].map(|range| f32_at(bytes, range));
    let errors = [uniform.rmse, uniform.p99, uniform.max, band.rmse, band.p99, band.max, seam_max];
    let is_quantity = |value: &f32| (0.0..=limit::MAX_MAGNITUDE).contains(value);
    if !scalars.iter().chain(&errors).all(is_quantity) {
        return Err(Error::Quantity);
    }

    let consistent = |errors: ErrorStatistics| errors.rmse.max(errors.p99) <= errors.max;
    if consistent(uniform) && consistent(band) { Ok(()) } else { Err(Error::Contract) }
}

pub(crate) fn family_of(bytes: &[u8]) -> Result<Family, Error> {
    match u8_at(bytes, at::FAMILY) {
        family::GRID => Ok(Family::Grid),
        family::OCTREE => Ok(Family::Octree),
        family::POLYNOMIAL => Ok(Family::Polynomial),
        _ => Err(Error::Family),
    }
}

fn sign_method_of(bytes: &[u8]) -> Result<SignMethod, Error> {
    match u8_at(bytes, at::SIGN_METHOD) {
        sign_method::NONE => Ok(SignMethod::None),
        sign_method::PSEUDONORMAL => Ok(SignMethod::Pseudonormal),
        sign_method::WINDING => Ok(SignMethod::Winding),
        sign_method::RAYS => Ok(SignMethod::Rays),
        sign_method::SHEET => Ok(SignMethod::Sheet),
        _ => Err(Error::SignMethod),
    }
}

#[inline(never)]
pub(crate) fn bounds_of(bytes: &[u8]) -> Aabb {
    Aabb { min: f32x3_at(bytes, at::BOX_MIN), max: f32x3_at(bytes, at::BOX_MAX) }
}

/// The header of checked bytes.
pub(crate) fn header_of(bytes: &[u8]) -> Header {
    let baker = u32_at(bytes, at::BAKER_VERSION);
    Header {
        version: [u16_at(bytes, at::VERSION_MAJOR), u16_at(bytes, at::VERSION_MINOR)],
        family: family_of(bytes).unwrap_or(Family::Octree),
        sign_method: sign_method_of(bytes).unwrap_or(SignMethod::None),
        bounds: bounds_of(bytes),
        diagonal: f32_at(bytes, at::DIAGONAL),
        target_error: f32_at(bytes, at::TARGET_ERROR),
        lipschitz: f32_at(bytes, at::LIPSCHITZ),
        baker_version: [(baker >> 16) as u16, (baker >> 8) as u16 & 255, baker as u16 & 255],
        mesh_hash: bytes_at(bytes, at::MESH_HASH),
        settings_hash: bytes_at(bytes, at::SETTINGS_HASH),
    }
}

/// How steep the field is at most, and at least 1: a distance field's slope is 1 somewhere, and a bound below it is not worth
/// believing.
pub(crate) fn steepest_of(bytes: &[u8]) -> f32 {
    f32_at(bytes, at::LIPSCHITZ).max(1.0)
}

/// The error contract of checked bytes.
#[inline(never)]
pub(crate) fn contract_of(bytes: &[u8]) -> ErrorContract {
    let statistics = |[rmse, p99, max]: [core::ops::Range<usize>; 3]| ErrorStatistics {
        rmse: f32_at(bytes, rmse),
        p99: f32_at(bytes, p99),
        max: f32_at(bytes, max),
    };
    ErrorContract {
        uniform: statistics([at::UNIFORM_RMSE, at::UNIFORM_P99, at::UNIFORM_MAX]),
        band: statistics([at::BAND_RMSE, at::BAND_P99, at::BAND_MAX]),
        seam_max: f32_at(bytes, at::SEAM_MAX),
        sample_count: u32_at(bytes, at::SAMPLE_COUNT),
        doubtful_signs: u32_at(bytes, at::DOUBTFUL_SIGNS),
    }
}
