//! When a measurement contradicts the contract that a file stores.

use super::Measurement;
use super::distribution::ErrorDistribution;
use nearfield::{ErrorContract, ErrorStatistics};
use thiserror::Error;

/// The fewest fresh points that can contradict a contract.
pub const MIN_FRESH_SAMPLES: u32 = 10_000;

/// Room for other roundings of the same computation.
const SAME: f64 = 1e-4;
/// A fresh RMSE may exceed the stored one by this much. Errors have heavy tails: with the fewest points
/// and a kurtosis of 100, the RMSE's own standard deviation is 5 %.
const FRESH_RMSE: f64 = 1.25;
/// Share of fresh points that must not exceed the stored p99: 2 % may, where 1 % is expected.
const FRESH_P99: f64 = 0.98;
/// Share of fresh points that must not exceed the stored maximum, which more points do exceed now and then.
const FRESH_MAX: f64 = 0.999;

/// A figure that is worse than the contract says. Mesh units.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("the {figure} is {measured:.3e}, but the file promises {stored:.3e}")]
pub struct Contradiction {
    /// What was measured.
    pub figure: &'static str,
    /// Its value.
    pub measured: f64,
    /// What the file stores.
    pub stored: f64,
}

/// The first figure that exceeds the contract, given a measurement at the very points of the contract.
pub fn exceeds(contract: &ErrorContract, measurement: &Measurement) -> Option<Contradiction> {
    let measured = measurement.contract();
    let pairs = [
        ("uniform RMSE", measured.uniform.rmse, contract.uniform.rmse),
        ("uniform 99 % quantile", measured.uniform.p99, contract.uniform.p99),
        ("uniform maximum", measured.uniform.max, contract.uniform.max),
        ("band RMSE", measured.band.rmse, contract.band.rmse),
        ("band 99 % quantile", measured.band.p99, contract.band.p99),
        ("band maximum", measured.band.max, contract.band.max),
        ("largest seam", measured.seam_max, contract.seam_max),
    ];
    pairs.into_iter().find_map(|(figure, measured, stored)| worse(figure, measured.into(), stored, 1.0 + SAME))
}

/// The first figure that refutes the contract, given a measurement at other points, at least
/// [`MIN_FRESH_SAMPLES`] of them.
pub fn refutes(contract: &ErrorContract, measurement: &Measurement) -> Option<Contradiction> {
    let set = |names: [&'static str; 3], errors: &ErrorDistribution, stored: &ErrorStatistics| {
        worse(names[0], errors.rmse, stored.rmse, FRESH_RMSE)
            .or_else(|| worse(names[1], errors.quantile(FRESH_P99), stored.p99, 1.0 + SAME))
            .or_else(|| worse(names[2], errors.quantile(FRESH_MAX), stored.max, 1.0 + SAME))
    };
    let uniform = ["uniform RMSE", "uniform 98 % quantile", "uniform 99.9 % quantile"];
    let band = ["band RMSE", "band 98 % quantile", "band 99.9 % quantile"];

    set(uniform, &measurement.uniform, &contract.uniform).or_else(|| set(band, &measurement.band, &contract.band))
}

fn worse(figure: &'static str, measured: f64, stored: f32, allowance: f64) -> Option<Contradiction> {
    let stored = f64::from(stored);
    (measured > stored * allowance).then_some(Contradiction { figure, measured, stored })
}
