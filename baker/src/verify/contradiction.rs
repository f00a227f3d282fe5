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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field_function::Sample;
    use crate::verify::SeamStatistics;
    use glam::DVec3;

    /// A change to what a file promises.
    type Edit = fn(&mut ErrorContract);

    /// Errors of 0.001, 0.002, … 1, in mesh units.
    fn measurement() -> Measurement {
        let answers: Vec<(f32, [f32; 3])> = (1..=1000).map(|step| (step as f32 / 1000.0, [1.0, 0.0, 0.0])).collect();
        let truth = vec![Sample { distance: 0.0, gradient: DVec3::X }; answers.len()];
        let errors = ErrorDistribution::of(&answers, &truth);
        Measurement {
            steepest: 1.0,
            uniform: errors.clone(),
            band: errors,
            seams: SeamStatistics { max: 0.5, ..SeamStatistics::default() },
            samples: 1000,
            doubtful_signs: 0,
            doubtful_places: Vec::new(),
        }
    }

    #[test]
    fn a_measurement_keeps_its_own_contract() {
        let contract = measurement().contract();

        assert_eq!(exceeds(&contract, &measurement()), None);
        assert_eq!(refutes(&contract, &measurement()), None);
    }

    #[test]
    fn every_figure_can_be_exceeded() {
        let lowered: [(&str, Edit); 7] = [
            ("uniform RMSE", |contract| contract.uniform.rmse *= 0.99),
            ("uniform 99 % quantile", |contract| contract.uniform.p99 *= 0.99),
            ("uniform maximum", |contract| contract.uniform.max *= 0.99),
            ("band RMSE", |contract| contract.band.rmse *= 0.99),
            ("band 99 % quantile", |contract| contract.band.p99 *= 0.99),
            ("band maximum", |contract| contract.band.max *= 0.99),
            ("largest seam", |contract| contract.seam_max *= 0.99),
        ];
        for (figure, lower) in lowered {
            let mut contract = measurement().contract();
            lower(&mut contract);
            assert_eq!(exceeds(&contract, &measurement()).map(|found| found.figure), Some(figure));
        }
    }

    #[test]
    fn fresh_points_refute_what_chance_does_not_explain() {
        let explained: [Edit; 3] = [
            |contract| contract.uniform.rmse /= 1.2,
            |contract| contract.band.p99 = 0.981,
            |contract| contract.band.max = 0.9995,
        ];
        for lower in explained {
            let mut contract = measurement().contract();
            lower(&mut contract);
            assert_eq!(refutes(&contract, &measurement()), None);
        }

        let refuted: [(&str, Edit); 6] = [
            ("uniform RMSE", |contract| contract.uniform.rmse /= 1.3),
            ("uniform 98 % quantile", |contract| contract.uniform.p99 = 0.979),
            ("uniform 99.9 % quantile", |contract| contract.uniform.max = 0.998),
            ("band RMSE", |contract| contract.band.rmse /= 1.3),
            ("band 98 % quantile", |contract| contract.band.p99 = 0.979),
            ("band 99.9 % quantile", |contract| contract.band.max = 0.998),
        ];
        for (figure, lower) in refuted {
            let mut contract = measurement().contract();
            lower(&mut contract);
            assert_eq!(refutes(&contract, &measurement()).map(|found| found.figure), Some(figure));
        }
    }
}
