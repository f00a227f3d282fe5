//! The section table.

use core::ops::Range;

use crate::bytes::{u8_at, u32_at};
use crate::checksum::crc32c;
use crate::error::Error;
use crate::layout::{MAX_SECTIONS, header, section_entry as at};

/// One section of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// Four ASCII letters, read as a little-endian `u32`: see [`layout::section`](crate::layout::section).
    pub kind: u32,
    /// Where the section lies, in bytes from the start of the file.
    pub range: Range<usize>,
    /// CRC-32C that its bytes should have.
    pub checksum: u32,
}

/// The sections of a file, in the order of the file.
#[derive(Clone, Debug)]
pub struct Sections<'a> {
    entries: core::slice::Iter<'a, [u8; at::LENGTH]>,
}

impl Iterator for Sections<'_> {
    type Item = Section;

    fn next(&mut self) -> Option<Section> {
        let entry = self.entries.next()?;
        let start = u32_at(entry, at::OFFSET) as usize;
        Some(Section {
            kind: u32_at(entry, at::KIND),
            range: start..start.saturating_add(u32_at(entry, at::SECTION_LENGTH) as usize),
            checksum: u32_at(entry, at::CHECKSUM),
        })
    }
}

/// The bytes of the section table.
pub(crate) fn table_bytes(bytes: &[u8]) -> Result<&[u8], Error> {
    let count = usize::from(u8_at(bytes, header::SECTION_COUNT));
    if count > MAX_SECTIONS {
        return Err(Error::SectionTable);
    }
    let end = header::LENGTH + count * at::LENGTH;
    bytes.get(header::LENGTH..end).ok_or(Error::Truncated)
}

/// The sections of a file whose header names them.
pub(crate) fn sections(bytes: &[u8]) -> Sections<'_> {
    Sections { entries: table_bytes(bytes).unwrap_or(&[]).as_chunks().0.iter() }
}

/// Checks that whole words tile the rest of the file, and that no kind comes twice (SPEC.md §4).
pub(crate) fn check(bytes: &[u8]) -> Result<(), Error> {
    let mut end = header::LENGTH + table_bytes(bytes)?.len();
    for (index, Section { kind, range, .. }) in sections(bytes).enumerate() {
        if range.start != end || !range.len().is_multiple_of(4) {
            return Err(Error::SectionTable);
        }
        if sections(bytes).take(index).any(|earlier| earlier.kind == kind) {
            return Err(Error::SectionDuplicate);
        }
        end = range.end;
    }
    if end == bytes.len() { Ok(()) } else { Err(Error::SectionTable) }
}

/// The section of a kind.
pub(crate) fn find(bytes: &[u8], kind: u32) -> Result<Section, Error> {
    sections(bytes).find(|section| section.kind == kind).ok_or(Error::SectionMissing)
}

/// Bytes of the section of a kind.
pub(crate) fn find_bytes(bytes: &[u8], kind: u32) -> Result<&[u8], Error> {
    bytes.get(find(bytes, kind)?.range).ok_or(Error::SectionTable)
}

/// Checks the checksum of a section (SPEC.md §4).
pub(crate) fn check_sum(bytes: &[u8], section: &Section) -> Result<(), Error> {
    let contents = bytes.get(section.range.clone()).ok_or(Error::SectionTable)?;
    if crc32c(contents) == section.checksum { Ok(()) } else { Err(Error::SectionChecksum) }
}
