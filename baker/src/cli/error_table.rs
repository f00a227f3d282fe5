//! Measured errors, for eyes and for programs.

use nearfield::{ErrorContract, ErrorStatistics};
use nearfield_bake::verify::{ErrorDistribution, Measurement, SeamBound};
use schemars::JsonSchema;
use serde::Serialize;

/// The contract of a field as JSON: mesh units.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct ContractReport {
    uniform: FiguresReport,
    band: FiguresReport,
    seam_max: f64,
    sample_count: u32,
    doubtful_signs: u32,
}

#[derive(Debug, Serialize, JsonSchema)]
struct FiguresReport {
    rmse: f64,
    p99: f64,
    max: f64,
}

impl From<&ErrorContract> for ContractReport {
    fn from(contract: &ErrorContract) -> Self {
        Self {
            uniform: (&contract.uniform).into(),
            band: (&contract.band).into(),
            seam_max: f64::from(contract.seam_max),
            sample_count: contract.sample_count,
            doubtful_signs: contract.doubtful_signs,
        }
    }
}

impl From<&ErrorStatistics> for FiguresReport {
    fn from(figures: &ErrorStatistics) -> Self {
        Self { rmse: f64::from(figures.rmse), p99: f64::from(figures.p99), max: f64::from(figures.max) }
    }
}

/// A measurement as JSON: the contract, and what a header has no room for. Mesh units.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct MeasurementReport {
    #[serde(flatten)]
    contract: ContractReport,
    uniform_detail: SetReport,
    band_detail: SetReport,
    seam_points: usize,
    seam_rms: f64,
    seam_gradient_max: f64,
    seam_gradient_rms: f64,
    /// What no face between leaves exceeds, from what they hold: of trilinear and tricubic octrees.
    seam_bound: Option<SeamBoundReport>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct SeamBoundReport {
    faces: usize,
    /// Faces between leaves of different sizes.
    uneven_faces: usize,
    value: f64,
    /// The same, in distance quanta of the smaller leaf.
    quanta: f64,
    gradient: Option<f64>,
}

impl From<SeamBound> for SeamBoundReport {
    fn from(SeamBound { faces, uneven_faces, value, quanta, gradient }: SeamBound) -> Self {
        Self { faces, uneven_faces, value, quanta, gradient }
    }
}

#[derive(Debug, Serialize, JsonSchema)]
struct SetReport {
    points: usize,
    mean_gradient_angle_degrees: f64,
    wrong_signs: usize,
    farthest_wrong_sign: f64,
}

impl From<&Measurement> for MeasurementReport {
    fn from(measurement: &Measurement) -> Self {
        let seams = &measurement.seams;
        Self {
            contract: (&measurement.contract()).into(),
            uniform_detail: (&measurement.uniform).into(),
            band_detail: (&measurement.band).into(),
            seam_points: seams.points,
            seam_rms: seams.rms,
            seam_gradient_max: seams.gradient_max,
            seam_gradient_rms: seams.gradient_rms,
            seam_bound: seams.bound.map(SeamBoundReport::from),
        }
    }
}

impl From<&ErrorDistribution> for SetReport {
    fn from(errors: &ErrorDistribution) -> Self {
        Self {
            points: errors.count(),
            mean_gradient_angle_degrees: errors.mean_gradient_angle,
            wrong_signs: errors.wrong_signs,
            farthest_wrong_sign: errors.farthest_wrong_sign,
        }
    }
}

/// The contract as a table, relative to the diagonal.
pub(super) fn table(contract: &ErrorContract, diagonal: f32) -> String {
    let relative = |error: f32| f64::from(error) / f64::from(diagonal);
    let row = |name: &str, figures: &ErrorStatistics| {
        format!(
            "  {name:<10}{:>10.2e}{:>10.2e}{:>10.2e}\n",
            relative(figures.rmse),
            relative(figures.p99),
            relative(figures.max)
        )
    };

    let mut text = format!("error / diagonal  {:>4}{:>10}{:>10}\n", "RMSE", "p99", "max");
    text += &row("uniform", &contract.uniform);
    text += &row("band", &contract.band);
    text += &format!("  {:<30}{:>10.2e}\n", "seams", relative(contract.seam_max));
    text += &format!(
        "  measured at {} points uniform in the mesh's box and as many within 1 % of its diagonal of the surface\n",
        contract.sample_count
    );
    if contract.doubtful_signs > 0 {
        text += &format!("  the sign is a guess at {} of these points\n", contract.doubtful_signs);
    }
    text
}

/// What a header has no room for, in sentences.
pub(super) fn details(measurement: &Measurement, diagonal: f32) -> String {
    let mut text = String::new();
    for (name, errors) in [("uniform", &measurement.uniform), ("band", &measurement.band)] {
        text += &format!("  {name}: gradient off by {:.2} degrees on average, ", errors.mean_gradient_angle);
        text += &match errors.wrong_signs {
            0 => "no wrong sign\n".to_owned(),
            wrong => format!(
                "{wrong} wrong signs, at most {:.1e} of the diagonal from the surface\n",
                errors.farthest_wrong_sign / f64::from(diagonal)
            ),
        };
    }
    text += &format!(
        "  seams: the value jumps by {:.1e} of the diagonal (RMS), the gradient by {:.1e} (RMS) and {:.1e} at most\n",
        measurement.seams.rms / f64::from(diagonal),
        measurement.seams.gradient_rms,
        measurement.seams.gradient_max
    );
    if let Some(bound) = measurement.seams.bound {
        let gradient = bound.gradient.map(|gradient| format!(", the gradient by more than {gradient:.1e}"));
        text += &format!(
            "  seams: at no point of the {} faces between leaves does the value jump by more than {:.1e} of the diagonal{}\n",
            bound.faces,
            bound.value / f64::from(diagonal),
            gradient.unwrap_or_default()
        );
    }
    text
}
