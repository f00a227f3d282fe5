//! From pairs of answer and truth to figures.

use crate::field_function::Sample;
use glam::DVec3;

/// How a field differs from the truth over one set of points. Lengths in mesh units.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorDistribution {
    /// Absolute errors, ascending, at least one.
    sorted_errors: Vec<f64>,
    /// Root mean square error.
    pub rmse: f64,
    /// Mean angle between the gradients, degrees. A vanishing gradient counts as 90.
    pub mean_gradient_angle: f64,
    /// Points on which the field and the truth disagree about inside and outside.
    pub wrong_signs: usize,
    /// Largest true |distance| among those points; zero without any.
    pub farthest_wrong_sign: f64,
}

impl ErrorDistribution {
    /// Compares the field's answers (distance, gradient) with the truth at the same points.
    ///
    /// Sums run in the order of the points: the figures do not depend on threads.
    pub(super) fn of(answers: &[(f32, [f32; 3])], truth: &[Sample]) -> Self {
        assert_eq!(answers.len(), truth.len(), "one answer a point");
        let pairs = || {
            answers.iter().zip(truth).map(|(&(distance, gradient), exact)| {
                let gradient = glam::Vec3::from_array(gradient).as_dvec3();
                (Sample { distance: f64::from(distance), gradient }, exact)
            })
        };
        let count = answers.len().max(1) as f64;

        // Values.
        let mut sorted_errors: Vec<f64> =
            pairs().map(|(answer, exact)| (answer.distance - exact.distance).abs()).collect();
        let mean_square = sorted_errors.iter().map(|error| error * error).sum::<f64>() / count;
        sorted_errors.sort_by(f64::total_cmp);

        // Gradients.
        let angles = pairs().map(|(answer, exact)| angle_between(answer.gradient, exact.gradient));
        let mean_angle = angles.sum::<f64>() / count;

        // Signs.
        let wrong = || pairs().filter(|(answer, exact)| (answer.distance < 0.0) != (exact.distance < 0.0));

        Self {
            sorted_errors,
            rmse: mean_square.sqrt(),
            mean_gradient_angle: mean_angle.to_degrees(),
            wrong_signs: wrong().count(),
            farthest_wrong_sign: wrong().map(|(_, exact)| exact.distance.abs()).fold(0.0, f64::max),
        }
    }

    /// Points compared.
    pub fn count(&self) -> usize {
        self.sorted_errors.len()
    }

    /// The smallest error that a share of `quantile` of the points does not exceed (nearest rank).
    pub fn quantile(&self, quantile: f64) -> f64 {
        let rank = (quantile * self.count() as f64).ceil() as usize;
        self.sorted_errors.get(rank.max(1) - 1).copied().unwrap_or(0.0)
    }

    /// The error that 99 % of the points do not exceed.
    pub fn p99(&self) -> f64 {
        self.quantile(0.99)
    }

    /// Largest error.
    pub fn max(&self) -> f64 {
        self.sorted_errors.last().copied().unwrap_or(0.0)
    }
}

/// Radians. Well conditioned for nearly parallel vectors, unlike the arc cosine.
fn angle_between(a: DVec3, b: DVec3) -> f64 {
    if a == DVec3::ZERO || b == DVec3::ZERO {
        return core::f64::consts::FRAC_PI_2;
    }
    libm::atan2(a.cross(b).length(), a.dot(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn truth(distance: f64) -> Sample {
        Sample { distance, gradient: DVec3::X }
    }

    #[test]
    fn figures_of_a_set_worked_out_by_hand() {
        let answers =
            [(1.0, [1.0, 0.0, 0.0]), (2.5, [0.0, 2.0, 0.0]), (-0.5, [0.0, 0.0, 0.0]), (-4.0, [-1.0, 0.0, 0.0])];
        let exact = [truth(1.0), truth(2.0), truth(0.25), truth(-4.25)];

        let errors = ErrorDistribution::of(&answers, &exact);

        assert_eq!(errors.rmse, ((0.25 + 0.5625 + 0.0625) / 4.0f64).sqrt());
        assert_eq!(errors.max(), 0.75);
        assert_eq!(errors.quantile(0.5), 0.25);
        assert_eq!(errors.quantile(0.51), 0.5);
        assert_eq!(errors.p99(), 0.75);
        assert!((errors.mean_gradient_angle - (0.0 + 90.0 + 90.0 + 180.0) / 4.0).abs() < 1e-12);
        assert_eq!(errors.wrong_signs, 1);
        assert_eq!(errors.farthest_wrong_sign, 0.25);
    }

    #[test]
    fn no_points_have_no_error() {
        let errors = ErrorDistribution::of(&[], &[]);

        assert_eq!((errors.count(), errors.rmse, errors.p99(), errors.max()), (0, 0.0, 0.0, 0.0));
    }
}
