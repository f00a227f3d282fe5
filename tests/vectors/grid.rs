//! The grid of a file (§11), a field at a time, with samples of numbers without pattern.

use super::samples::{F16, F32, PACKED32, Random};
use super::writer::{File, little_endian};
use half::f16;

pub(crate) const NEAREST: u8 = 0;
pub(crate) const LINEAR: u8 = 1;
pub(crate) const HALF: u8 = 2;
pub(crate) const BLEND: u8 = 3;
pub(crate) const HERMITE: u8 = 4;

/// One base distance for all samples, or one a brick.
pub(crate) const WHOLE: u8 = 0;
pub(crate) const BRICK: u8 = 1;

/// Coefficients of a sample of each order.
const COEFFICIENTS: [usize; 4] = [1, 4, 10, 20];

/// The grid of a file, and the least corner of its box.
#[derive(Clone)]
pub(crate) struct Grid {
    pub(crate) box_min: [f32; 3],
    pub(crate) resolution: [u16; 3],
    pub(crate) order: u8,
    pub(crate) reconstruction: u8,
    pub(crate) precision: u8,
    pub(crate) range: u8,
    pub(crate) reserved: [u8; 2],
    pub(crate) spacing: [f32; 3],
    pub(crate) quantum: f32,
    /// None without the section.
    pub(crate) bases: Option<Vec<i32>>,
    pub(crate) samples: Vec<u32>,
}

/// What the samples of a grid are made from.
#[derive(Clone, Copy)]
pub(crate) struct Like {
    pub(crate) resolution: [u16; 3],
    pub(crate) order: u8,
    pub(crate) reconstruction: u8,
    pub(crate) precision: u32,
    pub(crate) range: u8,
}

impl Grid {
    /// Three spacings, and bases that differ.
    pub(crate) fn new(like: Like, seed: u64) -> Self {
        let Like { resolution, order, reconstruction, precision, range } = like;
        let mut random = Random::new(seed);
        let bricks = match range {
            WHOLE => 1,
            _ => resolution.iter().map(|&samples| usize::from(samples.div_ceil(4))).product(),
        };
        let bases = (precision != F32).then(|| (0..bricks).map(|brick| -2000 + 700 * brick as i32).collect());
        Self {
            box_min: [1.0, 2.0, 3.0],
            resolution,
            order,
            reconstruction,
            precision: precision as u8,
            range,
            reserved: [0; 2],
            spacing: [0.5, 0.75, 2.0],
            quantum: 1.0 / 256.0,
            bases,
            samples: samples(&mut random, like),
        }
    }

    /// A file that holds the grid.
    pub(crate) fn file(&self) -> File {
        let extent = |axis: usize| (f32::from(self.resolution[axis]) - 1.0) * self.spacing[axis];
        let box_max = [0, 1, 2].map(|axis| self.box_min[axis] + extent(axis));
        let mut sections = vec![(*b"GRID", self.parameters()), (*b"SAMP", little_endian(&self.samples))];
        if let Some(bases) = &self.bases {
            sections.push((*b"BASE", bases.iter().flat_map(|base| base.to_le_bytes()).collect()));
        }
        File::holding(1, [self.box_min, box_max], sections)
    }

    fn parameters(&self) -> Vec<u8> {
        let mut bytes: Vec<u8> = self.resolution.iter().flat_map(|samples| samples.to_le_bytes()).collect();
        bytes.extend([self.order, self.reconstruction, self.precision, self.range]);
        bytes.extend(self.reserved);
        bytes.extend(self.spacing.iter().flat_map(|spacing| spacing.to_le_bytes()));
        bytes.extend(self.quantum.to_le_bytes());
        bytes
    }
}

/// The words of all samples (§11.3).
fn samples(random: &mut Random, like: Like) -> Vec<u32> {
    let count = like.resolution.iter().map(|&samples| usize::from(samples)).product();
    let coefficients = COEFFICIENTS[usize::from(like.order)];
    if like.precision == F32 {
        return (0..count * coefficients).map(|_| random.number().to_bits()).collect();
    }
    let mut halves = Vec::new();
    for _ in 0..count {
        let floats = match (like.precision, like.order) {
            (PACKED32, 1..) => {
                let word = random.sample(PACKED32, false)[0];
                halves.extend([word & 0xFFFF, word >> 16]);
                coefficients - 4
            }
            (PACKED32 | F16, _) => {
                halves.push(random.word() & 0xFFFF);
                coefficients - 1
            }
            _ => unreachable!("a precision of a grid that can be written"),
        };
        halves.extend((0..floats).map(|_| u32::from(f16::from_f32(random.number()).to_bits())));
    }
    halves.chunks(2).map(|pair| pair[0] | pair.get(1).unwrap_or(&0) << 16).collect()
}
