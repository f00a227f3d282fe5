//! Any bytes, any points: the reader neither panics nor answers with anything but finite numbers.
#![no_main]

use libfuzzer_sys::fuzz_target;
use nearfield::layout::{header, section, section_entry};
use nearfield::{Field, crc32c};

/// Leaves to look at: a damaged tree may have more than anyone can wait for.
const MOST_LEAVES: usize = 200;

fuzz_target!(|bytes: &[u8]| {
    open_and_query(bytes);
    let mut repaired = bytes.to_vec();
    repair(&mut repaired);
    open_and_query(&repaired);
});

fn open_and_query(bytes: &[u8]) {
    let Ok(field) = Field::open(bytes) else { return };
    let is_valid = field.validate().is_ok();

    let bounds = field.header().bounds;
    let numbers = bytes.as_chunks::<4>().0.iter().rev().map(|word| f32::from_le_bytes(*word));
    let wild: Vec<f32> = numbers.take(30).collect();
    for point in wild.as_chunks::<3>().0 {
        check(&field, *point);
        // The same within the box.
        let unit = point.map(|number| number.to_bits() as f32 / u32::MAX as f32);
        check(
            &field,
            [0, 1, 2].map(|axis| {
                let (min, max) = (bounds.min[axis], bounds.max[axis]);
                min + unit[axis] * (max - min)
            }),
        );
    }

    let octree = field.octree();
    let mut leaves = 0;
    for leaf in octree.leaves().take(MOST_LEAVES) {
        leaves += 1;
        let (distance, gradient) = octree.evaluate(&leaf, [0.0, 0.5, 1.0]);
        assert!(distance.is_finite() && gradient.iter().all(|component| component.is_finite()));
    }
    if is_valid && leaves < MOST_LEAVES {
        assert_eq!(leaves, octree.leaf_count() as usize, "leaves of a valid tree");
    }
}

fn check(field: &Field<'_>, point: [f32; 3]) {
    let (distance, gradient) = field.distance_and_gradient(point);
    assert_eq!(distance.to_bits(), field.distance(point).to_bits(), "at {point:?}");
    if point.iter().all(|coordinate| coordinate.is_finite()) {
        assert!(distance.is_finite(), "{distance} at {point:?}");
        assert!(gradient.iter().all(|component| component.is_finite()), "at {point:?}");
    }
}

/// Makes the length and the checksums of whatever looks like a header and a table right.
fn repair(bytes: &mut [u8]) {
    let length = bytes.len() as u32;
    let Some(&count) = bytes.get(header::SECTION_COUNT) else { return };
    let table_end = header::LENGTH + usize::from(count) * section_entry::LENGTH;
    if table_end > bytes.len() {
        return;
    }
    bytes[header::FILE_LENGTH].copy_from_slice(&length.to_le_bytes());

    for entry in (header::LENGTH..table_end).step_by(section_entry::LENGTH) {
        let word = |range: std::ops::Range<usize>| {
            let word = bytes[entry..][range].try_into().expect("a word");
            u32::from_le_bytes(word)
        };
        let start = word(section_entry::OFFSET) as usize;
        let end = start.saturating_add(word(section_entry::SECTION_LENGTH) as usize);
        let known = [section::OCTREE, section::NODES, section::SAMPLES];
        if known.contains(&word(section_entry::KIND))
            && let Some(contents) = bytes.get(start..end)
        {
            let checksum = crc32c(contents).to_le_bytes();
            bytes[entry..][section_entry::CHECKSUM].copy_from_slice(&checksum);
        }
    }

    bytes[header::CHECKSUM].fill(0);
    let checksum = crc32c(&bytes[..table_end]).to_le_bytes();
    bytes[header::CHECKSUM].copy_from_slice(&checksum);
}
