//! Derivatives to what the file can store of them.
//!
//! Distances are whole multiples of a quantum that halves from level to level, counted from the base
//! of each block. A vertex is rounded once, by the quantum of the coarsest leaf that has it as a
//! corner; that is a multiple of every finer leaf's quantum, so all of them decode the same number.

use super::sample::encode_gradient;
use crate::corner::Corner;
use crate::field_function::Sample;
use crate::settings::{Interpolant, Precision, Settings};
use glam::DVec3;
use half::f16;
use nearfield::layout::packed_sample::DISTANCE_MAX;
use nearfield::sample::decode_gradient;

/// Parts of a quantum that the 16-bit distances of full and of trilinear samples count.
pub const FINE_PER_QUANTUM: f64 = 16.0;

/// How much wider than the distances of an exact field a block's range is. Samples differ by at
/// most the diagonal of the block; forced corners and the quantum of a coarser leaf may go beyond.
const RANGE_SLACK: f64 = 1.0625;

/// The rounding of a whole field.
#[derive(Clone, Copy, Debug)]
pub struct Rounding {
    interpolant: Interpolant,
    precision: Precision,
    root_edge: f64,
    root_quantum: f32,
}

impl Rounding {
    /// The rounding of a field with root cells of this edge, mesh units.
    pub fn new(settings: &Settings, root_edge: f64) -> Self {
        let block_diagonal = 2.0 * root_edge * DVec3::ONE.length();
        let root_quantum = (RANGE_SLACK * block_diagonal / f64::from(DISTANCE_MAX)) as f32;
        let Settings { interpolant, precision, .. } = *settings;
        Self { interpolant, precision, root_edge, root_quantum }
    }

    /// The interpolant whose corners are rounded.
    pub fn interpolant(&self) -> Interpolant {
        self.interpolant
    }

    /// The precision asked for.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// The quantum at level 0, mesh units, as the file states it.
    pub fn root_quantum(&self) -> f32 {
        self.root_quantum
    }

    /// The distance quantum of a level, mesh units.
    pub fn quantum(&self, level: u8) -> f64 {
        f64::from(self.root_quantum) / f64::from(1u32 << level)
    }

    /// Edge of a cell of this level, mesh units: the unit of stored mixed derivatives.
    pub fn edge(&self, level: u8) -> f64 {
        self.root_edge / f64::from(1u32 << level)
    }

    /// A gradient sampled from the function.
    pub fn gradient(&self, gradient: DVec3) -> DVec3 {
        match self.precision {
            Precision::Packed32 => DVec3::from_array(decode_gradient(encode_gradient(gradient)).map(f64::from)),
            Precision::F16 => gradient.map(to_f16),
            Precision::F32 => gradient.map(to_f32),
        }
    }

    /// A sample whose gradient is already rounded, first needed at this level.
    pub fn sample(&self, sample: Sample, level: u8) -> Corner {
        let distance = match (self.precision, self.interpolant) {
            (Precision::F32, _) => to_f32(sample.distance),
            (Precision::Packed32, Interpolant::Tricubic) => to_multiple(sample.distance, self.quantum(level)),
            _ => to_multiple(sample.distance, self.quantum(level) / FINE_PER_QUANTUM),
        };
        Corner::first_order(distance, sample.gradient)
    }
}

fn to_multiple(value: f64, quantum: f64) -> f64 {
    (value / quantum).round() * quantum
}

fn to_f16(value: f64) -> f64 {
    f16::from_f64(value).to_f64()
}

fn to_f32(value: f64) -> f64 {
    f64::from(value as f32)
}
