//! Grids: every rule of §11, and damaged samples.

use std::vec::Vec;

use super::file::{Random, assemble, open};
use crate::layout::{block, family, grid as at, precision, range, reconstruction, section};
use crate::{Error, Field};

/// A grid file to be.
#[derive(Clone)]
struct File {
    resolution: [u16; 3],
    order: u8,
    reconstruction: u8,
    precision: u32,
    range: u8,
    reserved: u8,
    spacing: [f32; 3],
    quantum: f32,
    bases: Vec<i32>,
    words: Vec<u32>,
}

/// Words of a sample of order 1 to 3.
fn stride(precision: u32, order: u8) -> usize {
    let table = match precision {
        precision::PACKED32 => [1, 4, 9],
        precision::F16 => [2, 5, 10],
        _ => [4, 10, 20],
    };
    table[usize::from(order) - 1]
}

impl File {
    /// 5 × 3 × 2 samples of random content: two bricks.
    fn new(order: u8, reconstruction: u8, precision: u32) -> Self {
        let mut random = Random::new(9);
        let count = 30 * stride(precision, order);
        let words = (0..count).map(|place| match precision {
            precision::F32 => random.unit().to_bits(),
            precision::PACKED32 if place % stride(precision, order) == 0 => random.packed_sample(),
            _ => random.word() & 0x3BFF_3BFF,
        });
        let words = words.collect();
        let has_bases = precision != precision::F32;
        Self {
            resolution: [5, 3, 2],
            order,
            reconstruction,
            precision,
            range: if has_bases { range::BRICK } else { range::FILE },
            reserved: 0,
            spacing: [0.5, 0.25, 1.0],
            quantum: 1.0 / 4096.0,
            bases: if has_bases { std::vec![-7, 100] } else { Vec::new() },
            words,
        }
    }

    fn bytes(&self) -> Vec<u8> {
        let mut parameters = std::vec![0; at::LENGTH];
        parameters[at::RESOLUTION].copy_from_slice(self.resolution.map(u16::to_le_bytes).as_flattened());
        parameters[at::ORDER] = self.order;
        parameters[at::RECONSTRUCTION] = self.reconstruction;
        parameters[at::PRECISION] = self.precision as u8;
        parameters[at::RANGE] = self.range;
        parameters[at::RESERVED.start] = self.reserved;
        parameters[at::SPACING].copy_from_slice(self.spacing.map(f32::to_le_bytes).as_flattened());
        parameters[at::QUANTUM].copy_from_slice(&self.quantum.to_le_bytes());
        let mut sections = std::vec![(section::GRID, parameters)];
        if !self.bases.is_empty() {
            sections.push((section::BASES, self.bases.iter().flat_map(|base| base.to_le_bytes()).collect()));
        }
        sections.push((section::SAMPLES, self.words.iter().flat_map(|word| word.to_le_bytes()).collect()));
        let extent = [0, 1, 2].map(|axis| f32::from(self.resolution[axis].max(2) - 1) * self.spacing[axis]);
        assemble(family::GRID, [1.0, 2.0, 3.0], extent, &sections)
    }

    /// What is wrong, after a change.
    fn error_after(&self, change: impl Fn(&mut Self)) -> Option<Error> {
        let mut changed = self.clone();
        change(&mut changed);
        let bytes = changed.bytes();
        Field::open(&bytes).and_then(|field| field.validate()).err()
    }
}

fn assert_finite(field: &Field<'_>, random: &mut Random) {
    for _ in 0..40 {
        let point = random.point().map(|unit| 4.0 * unit + 0.5);
        let (distance, gradient) = field.distance_and_gradient(point);
        assert!(distance.is_finite() && gradient.iter().all(|component| component.is_finite()), "{point:?}");
        assert_eq!(distance.to_bits(), field.distance(point).to_bits());
    }
}

#[test]
fn every_kind_opens_and_answers() {
    let mut random = Random::new(1);
    for precision in [precision::PACKED32, precision::F16, precision::F32] {
        for order in 1..=3 {
            for reconstruction in 0..=4 {
                let bytes = File::new(order, reconstruction, precision).bytes();
                if order == 3 && reconstruction == reconstruction::HERMITE {
                    assert_eq!(Field::open(&bytes).err(), Some(Error::GridReconstruction));
                } else {
                    assert_finite(&open(&bytes), &mut random);
                }
            }
        }
    }
}

#[test]
fn every_rule_is_enforced() {
    let file = File::new(1, reconstruction::HALF, precision::PACKED32);
    assert_eq!(file.error_after(|_| ()), None);

    type Rule = (Error, fn(&mut File));
    let rules: [Rule; 19] = [
        (Error::Reserved, |file| file.reserved = 1),
        (Error::GridReconstruction, |file| file.order = 4),
        (Error::GridReconstruction, |file| file.order = 0),
        (Error::GridReconstruction, |file| file.reconstruction = 5),
        (Error::GridPrecision, |file| file.precision = 3),
        (Error::GridPrecision, |file| file.range = 2),
        (Error::GridPrecision, |file| (file.precision, file.range) = (precision::F32, range::BRICK)),
        (Error::GridScale, |file| file.spacing[1] = f32::NAN),
        (Error::GridScale, |file| file.spacing[1] = 5e-5),
        (Error::GridScale, |file| file.quantum = 0.0),
        (Error::GridScale, |file| file.quantum = f32::INFINITY),
        (Error::GridResolution, |file| file.resolution[2] = 1),
        (Error::GridResolution, |file| file.resolution = [u16::MAX; 3]),
        (Error::GridResolution, |file| file.words.truncate(file.words.len() - 1)),
        (Error::GridResolution, |file| file.bases.truncate(1)),
        (Error::GridSamples, |file| file.words.push(0)),
        (Error::GridSamples, |file| file.bases.push(0)),
        (Error::BlockBase, |file| file.bases[1] = block::MAX_BASE + 1),
        (Error::GradientCode, |file| file.words[29] |= 1023 << 10),
    ];
    for (index, (error, change)) in rules.into_iter().enumerate() {
        let found = file.error_after(change);
        // A box of NaN is none before its grid is looked at.
        let expected = if index == 7 { Error::Bounds } else { error };
        assert_eq!(found, Some(expected), "rule {index}");
    }

    let halves = File::new(2, reconstruction::NEAREST, precision::F16);
    assert_eq!(halves.error_after(|file| file.words[0] |= 0xFFFF), None, "a distance code may be anything");
    assert_eq!(halves.error_after(|file| file.words[0] |= 0x7C00_0000), Some(Error::SampleValue));
    assert_eq!(halves.error_after(|file| file.words[149] |= 0x7C00), Some(Error::SampleValue));
    let singles = File::new(3, reconstruction::BLEND, precision::F32);
    let nan = |file: &mut File| file.words[599] = f32::NAN.to_bits();
    assert_eq!(singles.error_after(nan), Some(Error::SampleValue));
}

#[test]
fn a_grid_of_lone_distances() {
    let mut file = File::new(1, reconstruction::LINEAR, precision::PACKED32);
    (file.order, file.resolution, file.bases) = (0, [3, 3, 3], std::vec![-7]);
    file.words = (0..14).map(|pair: u32| (2 * pair) | ((2 * pair + 1) << 16)).collect();
    assert_eq!(file.error_after(|_| ()), Some(Error::Reserved), "the 28th of 27 codes");
    file.words[13] &= 0xFFFF;
    let bytes = file.bytes();
    let field = open(&bytes);
    let grid = field.grid().expect("a grid");
    assert_eq!(grid.sample([2, 1, 0]).0, (5.0 - 7.0) / 4096.0);
    // Halfway along y between the codes 5 and 8.
    assert_eq!(field.distance([2.0, 2.375, 3.0]), (6.5 - 7.0) / 4096.0);
    assert_eq!(grid.sample([u32::MAX; 3]).0, (26.0 - 7.0) / 4096.0, "clamped");
}

#[test]
fn samples_that_no_writer_may_write_have_finite_answers() {
    let mut random = Random::new(4);
    for precision in [precision::PACKED32, precision::F16, precision::F32] {
        for (order, reconstruction) in [(1, 1), (1, 2), (1, 4), (2, 0), (2, 3), (2, 4), (3, 2), (3, 3)] {
            let mut file = File::new(order, reconstruction, precision);
            file.words.iter_mut().for_each(|word| *word = random.word() | 0x7800_7800);
            file.bases.iter_mut().for_each(|base| *base = random.word().cast_signed());
            let bytes = file.bytes();
            assert_finite(&Field::open(&bytes).expect("it opens"), &mut random);
        }
    }
}

#[test]
fn the_largest_numbers_stay_finite() {
    let largest = crate::layout::limit::MAX_MAGNITUDE;
    let mut random = Random::new(6);
    for (order, reconstruction) in [(1, 1), (1, 4), (2, 2), (2, 4), (3, 1), (3, 3)] {
        let mut file = File::new(order, reconstruction, precision::F32);
        let sign = |word: u32| if word & 1 == 0 { largest } else { -largest };
        file.words.iter_mut().for_each(|word| *word = sign(random.word()).to_bits());
        let bytes = file.bytes();
        assert_finite(&open(&bytes), &mut random);
    }
}
