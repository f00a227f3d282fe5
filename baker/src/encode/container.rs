//! The container around the sections: header, section table, checksums.

use super::EncodeError;
use crate::geometry::Aabb;
use nearfield::layout::{self, header, section_entry};
use nearfield::{ErrorContract, Field};
use std::ops::Range;

/// Where a field came from.
#[derive(Clone, Copy, Debug)]
pub struct Provenance {
    /// Hash of the welded mesh; zero for a field that did not come from one.
    pub mesh_hash: [u8; 16],
    /// Hash of the settings.
    pub settings_hash: [u8; 8],
    /// One of [`layout::sign_method`].
    pub sign_method: u8,
    /// Diagonal of the mesh's bounding box, mesh units.
    pub diagonal: f64,
    /// The error asked for, mesh units.
    pub target_error: f64,
}

/// What the header says of the representation.
pub(super) struct Shape {
    /// One of [`layout::family`].
    pub(super) family: u8,
    /// The box that is sampled, mesh units.
    pub(super) bounds: Aabb,
    /// Upper bound of the slope inside the box.
    pub(super) lipschitz: f64,
}

pub(super) struct Section {
    pub(super) kind: u32,
    pub(super) bytes: Vec<u8>,
}

/// Copies bytes to their place.
pub(super) fn put(bytes: &mut [u8], range: Range<usize>, value: &[u8]) {
    bytes[range].copy_from_slice(value);
}

/// The file of these sections, its error contract still blank.
pub(super) fn assemble(shape: &Shape, provenance: &Provenance, sections: &[Section]) -> Result<Vec<u8>, EncodeError> {
    lay_out(header_of(shape, provenance), sections)
}

/// A file with levels of detail in front of its sections, so that its first bytes hold the coarsest.
///
/// `levels` are files of the same family and diagonal, the coarsest first, at most
/// [`MAX_LODS`](nearfield::layout::MAX_LODS); `file` and they have none of their own.
pub fn with_levels(file: &Field<'_>, levels: &[Vec<u8>]) -> Result<Vec<u8>, EncodeError> {
    let bytes = file.bytes();
    let mut sections = vec![Section { kind: layout::section::LODS, bytes: levels.concat() }];
    sections
        .extend(file.sections().map(|section| Section { kind: section.kind, bytes: bytes[section.range].to_vec() }));
    lay_out(bytes[..header::LENGTH].to_vec(), &sections)
}

/// Lays sections out behind a header.
fn lay_out(mut bytes: Vec<u8>, sections: &[Section]) -> Result<Vec<u8>, EncodeError> {
    let table_end = header::LENGTH + sections.len() * section_entry::LENGTH;
    let file_length = table_end + sections.iter().map(|section| section.bytes.len()).sum::<usize>();
    let file_length = u32::try_from(file_length).map_err(|_| EncodeError::TooLarge)?;

    put(&mut bytes, header::FILE_LENGTH, &file_length.to_le_bytes());
    bytes[header::SECTION_COUNT] = sections.len() as u8;
    bytes.resize(table_end, 0);
    for (section, at) in sections.iter().zip((header::LENGTH..).step_by(section_entry::LENGTH)) {
        let entry = [section.kind, bytes.len() as u32, section.bytes.len() as u32, crc32c::crc32c(&section.bytes)];
        put(&mut bytes, at..at + section_entry::LENGTH, entry.map(u32::to_le_bytes).as_flattened());
        bytes.extend_from_slice(&section.bytes);
    }
    seal(&mut bytes);
    Ok(bytes)
}

/// A header that knows neither its sections nor its errors.
fn header_of(shape: &Shape, provenance: &Provenance) -> Vec<u8> {
    let mut bytes = vec![0; header::LENGTH];
    let Aabb { min, max } = shape.bounds;
    let [major, minor, patch] = BAKER_VERSION;

    put(&mut bytes, header::MAGIC, &layout::MAGIC);
    put(&mut bytes, header::VERSION_MAJOR, &layout::VERSION_MAJOR.to_le_bytes());
    put(&mut bytes, header::VERSION_MINOR, &layout::VERSION_MINOR.to_le_bytes());
    bytes[header::FAMILY] = shape.family;
    bytes[header::SIGN_METHOD] = provenance.sign_method;
    put(&mut bytes, header::BOX_MIN, min.as_vec3().to_array().map(f32::to_le_bytes).as_flattened());
    put(&mut bytes, header::BOX_MAX, max.as_vec3().to_array().map(f32::to_le_bytes).as_flattened());
    put(&mut bytes, header::DIAGONAL, &(provenance.diagonal as f32).to_le_bytes());
    put(&mut bytes, header::TARGET_ERROR, &(provenance.target_error as f32).to_le_bytes());
    // Rounded up: it is a bound.
    put(&mut bytes, header::LIPSCHITZ, &(shape.lipschitz as f32).next_up().to_le_bytes());
    put(&mut bytes, header::MESH_HASH, &provenance.mesh_hash);
    put(&mut bytes, header::SETTINGS_HASH, &provenance.settings_hash);
    put(&mut bytes, header::BAKER_VERSION, &(major << 16 | minor << 8 | patch).to_le_bytes());
    bytes
}

/// Major, minor, patch.
const BAKER_VERSION: [u32; 3] = [
    parse(env!("CARGO_PKG_VERSION_MAJOR")),
    parse(env!("CARGO_PKG_VERSION_MINOR")),
    parse(env!("CARGO_PKG_VERSION_PATCH")),
];

const fn parse(digits: &str) -> u32 {
    match u32::from_str_radix(digits, 10) {
        Ok(number) => number,
        Err(_) => panic!("Cargo gives decimal versions"),
    }
}

/// Writes the measured errors into the header of a file.
pub fn write_contract(bytes: &mut [u8], contract: &ErrorContract) {
    let fields = [
        (header::UNIFORM_RMSE, contract.uniform.rmse.to_le_bytes()),
        (header::UNIFORM_P99, contract.uniform.p99.to_le_bytes()),
        (header::UNIFORM_MAX, contract.uniform.max.to_le_bytes()),
        (header::BAND_RMSE, contract.band.rmse.to_le_bytes()),
        (header::BAND_P99, contract.band.p99.to_le_bytes()),
        (header::BAND_MAX, contract.band.max.to_le_bytes()),
        (header::SEAM_MAX, contract.seam_max.to_le_bytes()),
        (header::SAMPLE_COUNT, contract.sample_count.to_le_bytes()),
        (header::DOUBTFUL_SIGNS, contract.doubtful_signs.to_le_bytes()),
    ];
    for (range, value) in fields {
        put(bytes, range, &value);
    }
    seal(bytes);
}

/// Writes the Lipschitz bound into the header of a file, rounded up.
pub fn write_lipschitz(bytes: &mut [u8], lipschitz: f64) {
    put(bytes, header::LIPSCHITZ, &(lipschitz as f32).next_up().to_le_bytes());
    seal(bytes);
}

/// Writes the checksum of header and section table.
fn seal(bytes: &mut [u8]) {
    put(bytes, header::CHECKSUM, &[0; 4]);
    let table_end = header::LENGTH + usize::from(bytes[header::SECTION_COUNT]) * section_entry::LENGTH;
    let checksum = crc32c::crc32c(&bytes[..table_end]);
    put(bytes, header::CHECKSUM, &checksum.to_le_bytes());
}
