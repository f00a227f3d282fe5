//! Changes to a file that know where its words are, and checksums that follow.

use nearfield::crc32c;
use nearfield::layout::{header, node, section, section_entry};
use std::ops::Range;

/// Numbers without pattern: xorshift (Marsaglia 2003).
pub struct Choices(u64);

impl Choices {
    /// Another seed, another sequence.
    pub fn new(seed: u32) -> Self {
        Self(u64::from(seed) << 1 | 1)
    }

    /// Any word.
    pub fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) as u32
    }

    /// From 0 up to the end, which is not 0.
    pub fn below(&mut self, end: usize) -> usize {
        self.word() as usize % end
    }
}

/// Words at which rules change their mind.
const NOTABLE: [u32; 12] = [
    0,
    1,
    u32::MAX,
    1 << 31,
    node::LEAF << node::OFFSET_BITS,
    2 << node::OFFSET_BITS,
    0x7F80_0000, // infinity
    0x7FC0_0000, // NaN
    0x5D80_0000, // 2^60, the largest magnitude
    0x5D80_0001,
    0x2B80_0000, // 2^-40, the smallest root edge
    0x3FF,
];

/// Changes one word of a section, or of the header, to another of its kind; answers the new length.
///
/// Every other change is one of length: a section loses or repeats its last words, and those after it move.
pub fn mutate(bytes: &mut [u8], length: usize, choices: &mut Choices) -> usize {
    let sections = sections(&bytes[..length]);
    if sections.is_empty() {
        return length;
    }
    let chosen = choices.below(sections.len() + 1);
    let Some((entry, range)) = sections.get(chosen).cloned() else {
        change_word(&mut bytes[16..header::LENGTH], choices);
        return length;
    };
    if is_kind(bytes, entry, section::LODS) && choices.below(8) > 0 {
        change_level(&mut bytes[range], choices);
        return length;
    }
    if choices.below(8) > 0 || range.len() < 64 {
        change_word(&mut bytes[range], choices);
        return length;
    }

    // A group of eight nodes, or the end of a block.
    let size = 32.min(range.len());
    let is_room = length + size <= bytes.len();
    let new_length = if choices.below(2) == 0 && is_room {
        bytes.copy_within(range.end - size..length, range.end);
        length + size
    } else {
        bytes.copy_within(range.end..length, range.end - size);
        length - size
    };
    let moved = |offset: usize| (offset + new_length - length) as u32;
    let length_of = entry + section_entry::SECTION_LENGTH.start;
    put(bytes, length_of, moved(range.len()));
    for (later, its_range) in &sections {
        if its_range.start >= range.end && *later != entry {
            put(bytes, later + section_entry::OFFSET.start, moved(its_range.start));
        }
    }
    new_length
}

/// Changes a word of a section of one of the levels of detail, or of its header.
fn change_level(levels: &mut [u8], choices: &mut Choices) {
    let mut files = files(levels);
    if files.is_empty() {
        return change_word(levels, choices);
    }
    let file = files.swap_remove(choices.below(files.len()));
    let level = &mut levels[file];
    let mut ranges: Vec<Range<usize>> = sections(level).into_iter().map(|(_, range)| range).collect();
    ranges.push(16..header::LENGTH);
    let range = ranges.swap_remove(choices.below(ranges.len()));
    change_word(&mut level[range], choices);
}

fn change_word(bytes: &mut [u8], choices: &mut Choices) {
    let words = bytes.as_chunks_mut::<4>().0;
    if words.is_empty() {
        return;
    }
    let (at, from) = (choices.below(words.len()), choices.below(words.len()));
    let word = u32::from_le_bytes(words[at]);
    let changed = match choices.below(8) {
        0 => choices.word(),
        1 => NOTABLE[choices.below(NOTABLE.len())],
        2 => word.wrapping_add(1),
        3 => word.wrapping_sub(1),
        4 => word.wrapping_add(8),
        5 => u32::from_le_bytes(words[from]),
        _ => word ^ 1 << choices.below(32),
    };
    words[at] = changed.to_le_bytes();
}

/// Makes the length and the checksums of whatever looks like a header and a table right, in levels of detail too.
pub fn repair(bytes: &mut [u8]) {
    for (entry, range) in sections(bytes) {
        if is_kind(bytes, entry, section::LODS) {
            let levels = &mut bytes[range];
            files(levels).into_iter().for_each(|file| repair_alone(&mut levels[file]));
        }
    }
    repair_alone(bytes);
}

fn repair_alone(bytes: &mut [u8]) {
    let sections = sections(bytes);
    if sections.is_empty() {
        return;
    }
    let length = bytes.len() as u32;
    put(bytes, header::FILE_LENGTH.start, length);
    for (entry, range) in &sections {
        let checksum = crc32c(&bytes[range.clone()]);
        put(bytes, entry + section_entry::CHECKSUM.start, checksum);
    }
    put(bytes, header::CHECKSUM.start, 0);
    let table_end = header::LENGTH + sections_announced(bytes) * section_entry::LENGTH;
    let checksum = crc32c(&bytes[..table_end]);
    put(bytes, header::CHECKSUM.start, checksum);
}

/// The place of each entry of the table whose section is in the file, and the section; none if the table is not.
fn sections(bytes: &[u8]) -> Vec<(usize, Range<usize>)> {
    let table_end = header::LENGTH + sections_announced(bytes) * section_entry::LENGTH;
    if table_end > bytes.len() {
        return Vec::new();
    }
    let section = |entry: usize| {
        let word = |range: Range<usize>| u32::from_le_bytes(bytes[entry..][range].try_into().expect("a word")) as usize;
        let start = word(section_entry::OFFSET);
        let range = start..start.saturating_add(word(section_entry::SECTION_LENGTH));
        // A section over the table would undo the repair of the table.
        (start >= table_end && range.end <= bytes.len()).then_some((entry, range))
    };
    (header::LENGTH..table_end).step_by(section_entry::LENGTH).filter_map(section).collect()
}

/// Whether an entry of the table is of a section of this kind.
fn is_kind(bytes: &[u8], entry: usize, kind: u32) -> bool {
    bytes[entry..][section_entry::KIND] == kind.to_le_bytes()
}

/// The files of levels of detail, each as long as its header says.
fn files(levels: &[u8]) -> Vec<Range<usize>> {
    let (mut files, mut start) = (Vec::new(), 0);
    while let Some(length) = levels.get(start + header::FILE_LENGTH.start..start + header::FILE_LENGTH.end) {
        let end = start.saturating_add(u32::from_le_bytes(length.try_into().expect("a word")) as usize);
        if end < start + header::LENGTH || end > levels.len() {
            break;
        }
        files.push(start..end);
        start = end;
    }
    files
}

fn sections_announced(bytes: &[u8]) -> usize {
    bytes.get(header::SECTION_COUNT).map_or(0, |&count| count.into())
}

fn put(bytes: &mut [u8], at: usize, word: u32) {
    bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
}
