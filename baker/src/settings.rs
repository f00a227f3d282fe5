//! What the caller asks of a bake, filled once and passed along unchanged.

use crate::distance::SignChoice;
use nearfield::layout::grid::{MAX_ORDER, MIN_RESOLUTION};
use nearfield::layout::octree::MAX_DEPTH;
use nearfield::layout::polynomial::{MAX_OVERLAP, MIN_OVERLAP};
use thiserror::Error;

/// The error asked of every leaf, a root mean square unless [`Termination`] says otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// A fraction of the diagonal of the mesh's bounding box.
    Relative(f64),
    /// Mesh units.
    Absolute(f64),
}

impl Target {
    /// The target in mesh units.
    pub fn absolute(self, diagonal: f64) -> f64 {
        match self {
            Self::Relative(fraction) => fraction * diagonal,
            Self::Absolute(error) => error,
        }
    }

    /// The target so many times as large.
    pub fn times(self, times: f64) -> Self {
        match self {
            Self::Relative(fraction) => Self::Relative(times * fraction),
            Self::Absolute(error) => Self::Absolute(times * error),
        }
    }

    /// Points that a field of this error is measured at unless others are asked for: 100 000, and fewer for relative targets
    /// above a thousandth, but 20 000. A coarse field has few leaves, and its measurement would be half of its bake.
    pub fn measured_points(self) -> u32 {
        match self {
            Self::Relative(fraction) => (100.0 / fraction).clamp(20_000.0, 100_000.0) as u32,
            Self::Absolute(_) => 100_000,
        }
    }

    fn number(self) -> f64 {
        let (Self::Relative(number) | Self::Absolute(number)) = self;
        number
    }
}

/// What a leaf interpolates from its eight corners (Pujol and Chica 2023, section 4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolant {
    /// Distances.
    Trilinear,
    /// Distances and gradients.
    Tricubic,
}

/// What holds across the faces between leaves of different levels (Pujol and Chica 2023, section 6).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Continuity {
    /// Nothing.
    None,
    /// The value is continuous, up to rounding.
    C0,
    /// Value and gradient are continuous, up to rounding. Tricubic only.
    C1,
}

/// When a leaf of interpolants is good enough: how its error is estimated from the 27 samples at its corners
/// and midpoints (Pujol and Chica 2023, section 5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Termination {
    /// Root mean square by the trapezoid rule, the paper's choice.
    Trapezoid,
    /// Root mean square by Simpson's rule, which is exact where the squared error is cubic along each axis.
    Simpson,
    /// Root mean square by the trapezoid rule, of errors divided by their distance from the surface beyond
    /// [`NEAR`] of the diagonal: what [`Profile::Surface`] is to polynomials.
    ByDistance,
    /// The greatest of the 27.
    MaxError,
}

/// How the samples are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// 32 bits a first-order sample: 10 + 10 octahedral gradient, 12 distance (Bán and Valasek 2020, section 5.3).
    Packed32,
    /// 16 bits a component.
    F16,
    /// 32-bit floats.
    F32,
}

/// How a field is represented.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Layout {
    /// Adaptive cells that interpolate samples at their corners (Pujol and Chica 2023).
    Octree,
    /// Adaptive cells that each hold a polynomial, or the lesser or greater of two, blended where they meet.
    Polynomial(PolynomialSettings),
    /// A uniform grid (Bán and Valasek 2020; Valasek and Bán 2022).
    Grid(GridSettings),
}

/// What is asked of a polynomial octree, beside the target error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolynomialSettings {
    /// Greatest error asked for.
    pub max_error: Option<Target>,
    /// Where the error may be.
    pub profile: Profile,
    /// How far leaves reach into their neighbours, as a share of their edge, if the field is to be continuous.
    pub overlap: f64,
}

impl Default for PolynomialSettings {
    fn default() -> Self {
        Self { max_error: None, profile: Profile::Uniform, overlap: 0.2 }
    }
}

/// Where a polynomial octree may err.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Equally everywhere.
    Uniform,
    /// Farther from the surface than [`NEAR`] of the diagonal in proportion to the distance.
    Surface,
}

/// Within this share of the diagonal of the surface, tolerances of [`Profile::Surface`] and [`Termination::ByDistance`] are
/// constant.
pub const NEAR: f64 = 0.02;

/// What is asked of a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridSettings {
    /// How many samples there are.
    pub resolution: Resolution,
    /// Order of the samples: the degree of their polynomials, 0 to 3.
    pub order: u8,
    /// How the reader answers between them.
    pub reconstruction: Reconstruction,
    /// How they are taken from the function.
    pub sampling: Sampling,
    /// What stored distances count from.
    pub range: RangeScope,
}

/// How many samples a grid has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resolution {
    /// So many along the longest side, spaced alike along the others.
    Longest(u16),
    /// So many along x, y and z, each spaced to fill the box.
    Each([u16; 3]),
}

/// How a grid answers between its samples; see [`nearfield::Reconstruction`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reconstruction {
    /// The nearest sample's polynomial.
    Nearest,
    /// Polynomials weighted trilinearly.
    Linear,
    /// Reduced polynomials weighted trilinearly: exact one degree higher. Order 1 and above.
    Half,
    /// Polynomials weighted by smooth steps of their order. Order 1 and above.
    Blend,
    /// Hermite interpolation of the derivatives. Order 1 and 2.
    Hermite,
}

/// How samples are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    /// The exact distance and gradient. Order 0 and 1.
    Taylor,
    /// Least squares over a fine grid around each sample.
    LeastSquares(FineGrid),
    /// Least squares of the reconstruction over all cells at once, starting from the exact ones. Order 0 and 1; not
    /// for the nearest sample.
    Fitted,
}

/// The neighbourhood of a least-squares sample (Bán and Valasek 2020, section 4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FineGrid {
    /// Points along each axis, more than the order.
    pub count: u8,
    /// How far they reach from the sample, in spacings of the grid.
    pub extent: f64,
    /// Points at distance r, in extents, weigh 1 / (1 + falloff · r²).
    pub falloff: f64,
    /// Whether first-order gradients are made unit vectors.
    pub normalized: bool,
}

impl Default for FineGrid {
    fn default() -> Self {
        Self { count: 3, extent: 0.1, falloff: 0.0, normalized: true }
    }
}

/// What the distance codes of a grid count from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RangeScope {
    /// One base for the whole file (Bán and Valasek 2020, section 5.3).
    File,
    /// A base for each brick of 4 x 4 x 4 samples.
    Brick,
}

/// Everything that decides the bytes of a field, beside the mesh and the baker's version.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Representation of the field.
    pub layout: Layout,
    /// Target error of every leaf.
    pub error: Target,
    /// Bytes that the file of an octree may take; the error is then the least that fits, and `error` is not looked at.
    pub max_bytes: Option<u64>,
    /// Interpolant of the leaves of [`Layout::Octree`].
    pub interpolant: Interpolant,
    /// When a leaf of interpolants is good enough.
    pub termination: Termination,
    /// Continuity across levels.
    pub continuity: Continuity,
    /// Storage of the samples.
    pub precision: Precision,
    /// Level of the root grid: its cells are the longest side of the domain divided by two to this power.
    pub start_depth: u8,
    /// Deepest level of a leaf, counted like `start_depth`.
    pub max_depth: u8,
    /// Added around the mesh's box on every side, as a fraction of its longest side.
    pub margin: f64,
    /// Where the sign comes from.
    pub sign: SignChoice,
    /// Points at which the error is measured, uniform in the mesh's box and as many in the band.
    pub samples: u32,
}

impl Default for Settings {
    /// What the command line bakes when it is asked for nothing else.
    fn default() -> Self {
        let error = Target::Relative(5e-4);
        Self {
            layout: Layout::Polynomial(PolynomialSettings::default()),
            error,
            max_bytes: None,
            interpolant: Interpolant::Tricubic,
            termination: Termination::Trapezoid,
            continuity: Continuity::C1,
            precision: Precision::Packed32,
            start_depth: 3,
            max_depth: 9,
            margin: 0.2,
            sign: SignChoice::Auto,
            samples: error.measured_points(),
        }
    }
}

/// Settings that contradict themselves or the format.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum SettingsError {
    /// The target is zero, negative or not finite.
    #[error("the target error must be a positive number, not {0}")]
    Target(f64),
    /// The greatest error is zero, negative or not finite.
    #[error("the greatest error must be a positive number, not {0}")]
    MaxError(f64),
    /// The overlap is not one of the format.
    #[error(
        "the overlap must be from {MIN_OVERLAP} to {MAX_OVERLAP}, not {0}; for none at all, ask for --continuity none"
    )]
    Overlap(f64),
    /// The size of a grid follows from its resolution.
    #[error("the size of a grid follows from its resolution: ask for --resolution, or for --layout octree")]
    GridBytes,
    /// The margin is negative or not finite.
    #[error("the margin must be zero or more and at most 100, not {0}")]
    Margin(f64),
    /// The depths are out of order or beyond the format.
    #[error("depths must satisfy start depth ({start}) <= max depth ({max}) <= {MAX_DEPTH}")]
    Depth {
        /// Start depth asked for.
        start: u8,
        /// Maximum depth asked for.
        max: u8,
    },
    /// A trilinear field has no continuous gradient.
    #[error("trilinear leaves are c0 at best: ask for --continuity c0, or for tricubic leaves")]
    TrilinearC1,
    /// The order or the reconstruction of a grid is out of range, or they do not go together.
    #[error("order {0} has no such reconstruction: orders are 0 to 3, half and blend need 1 or more, hermite 1 or 2")]
    Reconstruction(u8),
    /// Exact derivatives end with the gradient.
    #[error("exact derivatives end with the gradient: samples of order {0} are taken by least squares")]
    Taylor(u8),
    /// What is fitted is linear in distances and gradients, and reaches from sample to sample.
    #[error("fitted samples are of order 0 or 1, and of a reconstruction other than nearest")]
    Fitted,
    /// A grid needs two samples along an axis, a fit more points than its order.
    #[error("a grid needs at least 2 samples along every axis")]
    Resolution,
    /// The neighbourhood of the fit is too small, or not one.
    #[error("the fine grid needs {needed} to 16 points along an axis, a reach above 0 and a falloff of 0 or more")]
    FineGrid {
        /// Fewest points for the order.
        needed: u8,
    },
    /// Nothing would be measured.
    #[error("at least one sample is needed to measure the error")]
    Samples,
}

impl PolynomialSettings {
    /// Checks what the types cannot say.
    fn check(&self) -> Result<(), SettingsError> {
        if let Some(max) = self.max_error.map(Target::number).filter(|max| !(max.is_finite() && *max > 0.0)) {
            return Err(SettingsError::MaxError(max));
        }
        let is_overlap = (MIN_OVERLAP..=MAX_OVERLAP).contains(&(self.overlap as f32));
        if is_overlap { Ok(()) } else { Err(SettingsError::Overlap(self.overlap)) }
    }
}

impl GridSettings {
    /// Checks what the types cannot say.
    fn check(&self) -> Result<(), SettingsError> {
        let order = self.order;
        let (least, most) = match self.reconstruction {
            Reconstruction::Nearest | Reconstruction::Linear => (0, MAX_ORDER),
            Reconstruction::Half | Reconstruction::Blend => (1, MAX_ORDER),
            Reconstruction::Hermite => (1, 2),
        };
        if !(least..=most).contains(&order) {
            return Err(SettingsError::Reconstruction(order));
        }
        let fewest = match self.resolution {
            Resolution::Longest(samples) => samples,
            Resolution::Each(samples) => samples.into_iter().fold(u16::MAX, u16::min),
        };
        if fewest < MIN_RESOLUTION {
            return Err(SettingsError::Resolution);
        }

        match self.sampling {
            Sampling::Taylor if order > 1 => Err(SettingsError::Taylor(order)),
            Sampling::Taylor => Ok(()),
            Sampling::Fitted if order > 1 || self.reconstruction == Reconstruction::Nearest => {
                Err(SettingsError::Fitted)
            }
            Sampling::Fitted => Ok(()),
            Sampling::LeastSquares(fine) => {
                let needed = (order + 1).max(2);
                let positive = fine.extent.is_finite() && fine.extent > 0.0;
                let falloff = (0.0..=1e6).contains(&fine.falloff);
                let enough = (needed..=16).contains(&fine.count);
                if positive && falloff && enough { Ok(()) } else { Err(SettingsError::FineGrid { needed }) }
            }
        }
    }
}

impl Settings {
    /// Checks what the types cannot say.
    pub fn check(&self) -> Result<(), SettingsError> {
        let target = self.error.number();
        if !(target.is_finite() && target > 0.0) {
            return Err(SettingsError::Target(target));
        }
        if !(0.0..=100.0).contains(&self.margin) {
            return Err(SettingsError::Margin(self.margin));
        }
        if self.start_depth > self.max_depth || self.max_depth > MAX_DEPTH {
            return Err(SettingsError::Depth { start: self.start_depth, max: self.max_depth });
        }
        match &self.layout {
            Layout::Octree if self.interpolant == Interpolant::Trilinear && self.continuity == Continuity::C1 => {
                return Err(SettingsError::TrilinearC1);
            }
            Layout::Octree => {}
            Layout::Polynomial(polynomial) => polynomial.check()?,
            Layout::Grid(_) if self.max_bytes.is_some() => return Err(SettingsError::GridBytes),
            Layout::Grid(grid) => grid.check()?,
        }
        if self.samples == 0 {
            return Err(SettingsError::Samples);
        }
        Ok(())
    }

    /// Hash of the settings, for provenance: equal settings, equal hash, on any machine.
    pub fn hash(&self) -> [u8; 8] {
        let digest = blake3::hash(format!("{self:?}").as_bytes());
        let (head, _) = digest.as_bytes().split_first_chunk().expect("a digest has 32 bytes");
        *head
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coarse_fields_are_measured_at_fewer_points() {
        let points = [1e-5, 1e-3, 2e-3, 5e-3, 0.1].map(|error| Target::Relative(error).measured_points());
        assert_eq!(points, [100_000, 100_000, 50_000, 20_000, 20_000]);
        assert_eq!(Target::Absolute(0.1).measured_points(), 100_000);
        assert_eq!(Settings::default().samples, 100_000);
    }
}
