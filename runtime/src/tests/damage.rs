//! Damaged files: an error, or answers that are finite.

use std::vec::Vec;

use super::file::{File, Random, divided, open, seal, three_levels, trilinear};
use crate::layout::{block, header, precision, section, section_entry};
use crate::{Field, Raycast, crc32c};

fn assert_finite(field: &Field<'_>, random: &mut Random) {
    for _ in 0..8 {
        let point = random.point().map(|unit| 12.0 * unit - 1.0);
        let (distance, gradient) = field.distance_and_gradient(point);
        assert!(distance.is_finite(), "{distance} at {point:?}");
        assert!(gradient.iter().all(|component| component.is_finite()), "{gradient:?}");
        assert!(field.distance(point).is_finite());
    }

    let point = random.point().map(|unit| 12.0 * unit - 1.0);
    if let Raycast::Hit(hit) = field.raycast(point, random.point().map(|unit| unit - 0.5), 9.0, 1e-3) {
        let numbers = [hit.distance].into_iter().chain(hit.point).chain(hit.normal);
        assert!(numbers.into_iter().all(f32::is_finite), "{hit:?}");
    }
    let closest = field.closest_point(point);
    assert!(closest.residual.is_finite() && closest.point.iter().all(|x| x.is_finite()), "{closest:?}");
    assert!(field.normal(point).iter().all(|x| x.is_finite()));
    assert!(!field.clearance(point).is_nan());
    assert_eq!(field.cursor().distance(point).to_bits(), field.distance(point).to_bits());
    for leaf in field.octree().expect("an octree").leaves().take(100) {
        let (distance, gradient) = field.octree().expect("an octree").evaluate(&leaf, [0.25, 1.0, 0.5]);
        assert!(distance.is_finite() && gradient.iter().all(|component| component.is_finite()));
    }
}

/// How many times Miri, which is some thousand times slower, does less: it looks for what no answer shows.
const FEWER: usize = if cfg!(miri) { 1000 } else { 1 };

/// A file with full samples of every kind.
fn rich() -> File {
    let mut random = Random::new(1);
    let mut samples = Vec::new();
    let mut nodes = std::vec![super::file::inner(2), super::file::inner(10)];
    for precision in [precision::PACKED32, precision::F16] {
        let start = samples.len();
        let data: Vec<_> = (0..20 + 7 * 4).map(|_| random.packed_sample() & 0x3BFF_3BFF).collect();
        let count = if precision == precision::F16 { 20 * 2 + 7 * 4 } else { data.len() };
        let data = data.into_iter().cycle().take(count);
        let words = super::file::block(block::LATTICE_MASK, 0o7007001, precision, 100, data);
        samples.extend(words);
        nodes.extend([super::file::leaf(start); 8]);
    }
    File { root_cells: [2, 1, 1], nodes, ..divided(samples) }
}

#[test]
fn every_truncation_is_an_error() {
    for file in [trilinear(|_| 1.0), three_levels(), rich()] {
        let bytes = file.bytes();
        open(&bytes);
        for length in (0..bytes.len()).step_by(FEWER) {
            assert!(Field::open(&bytes[..length]).is_err(), "{length} of {} bytes", bytes.len());
        }
        let longer = [&bytes[..], &[0]].concat();
        assert!(Field::open(&longer).is_err(), "a byte too many");
    }
}

#[test]
fn every_flipped_bit_is_found() {
    let mut random = Random::new(2);
    for file in [trilinear(|_| 1.0), three_levels(), rich()] {
        let bytes = file.bytes();
        for bit in (0..8 * bytes.len()).step_by(FEWER) {
            let mut damaged = bytes.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            if let Ok(field) = Field::open(&damaged) {
                assert!(field.validate().is_err(), "bit {bit}");
                assert_finite(&field, &mut random);
            }
        }
    }
}

#[test]
fn wild_words_under_right_checksums_are_harmless() {
    let mut random = Random::new(3);
    for file in [trilinear(|_| 1.0), three_levels(), rich()] {
        for _ in 0..3000 / FEWER {
            let mut wild = file.clone();
            wild.interpolant = (random.word() & 1) as u8;
            for _ in 0..1 + random.word() % 3 {
                let words = if random.word() & 1 == 0 { &mut wild.nodes } else { &mut wild.samples };
                let at = random.word() as usize % words.len();
                words[at] = match random.word() % 4 {
                    0 => random.word(),
                    1 => words[at] ^ 1 << (random.word() % 32),
                    2 => f32::NAN.to_bits(),
                    _ => words[at].wrapping_add(8),
                };
            }
            let bytes = wild.bytes();
            let field = Field::open(&bytes).expect("the header is untouched");
            // Whether it is valid depends on the word; neither may panic.
            let _valid = field.validate();
            assert_finite(&field, &mut random);
        }
    }
}

#[test]
fn wild_headers_under_right_checksums_are_harmless() {
    let mut random = Random::new(4);
    let bytes = three_levels().bytes();
    let end = header::LENGTH + 3 * section_entry::LENGTH + crate::layout::octree::LENGTH;
    let mut opened = 0;
    for _ in 0..20_000 / FEWER {
        let mut wild = bytes.clone();
        let at = random.word() as usize % end;
        wild[at] = random.word() as u8;
        repair_checksums(&mut wild);
        if let Ok(field) = Field::open(&wild) {
            opened += 1;
            let _valid = field.validate();
            assert_finite(&field, &mut random);
            assert!(field.contract().max_error() >= 0.0);
            assert!(field.sections().count() <= 16);
        }
    }
    assert!(opened > 1000 / FEWER, "only {opened} files opened");
}

/// Makes the checksums of the parameters and of the header right again.
fn repair_checksums(bytes: &mut [u8]) {
    let entry = header::LENGTH;
    let word = |bytes: &[u8], at: usize| {
        u32::from_le_bytes(bytes[entry + at..entry + at + 4].try_into().expect("four bytes")) as usize
    };
    let start = word(bytes, section_entry::OFFSET.start);
    let end = start.saturating_add(word(bytes, section_entry::SECTION_LENGTH.start));
    if word(bytes, 0) == section::OCTREE as usize && end <= bytes.len() {
        let checksum = crc32c(&bytes[start..end]).to_le_bytes();
        bytes[entry..][section_entry::CHECKSUM].copy_from_slice(&checksum);
    }
    if bytes[header::SECTION_COUNT] <= 10 {
        seal(bytes);
    }
}
