//! What the caller asks of a bake, filled once and passed along unchanged.

use crate::distance::SignChoice;
use nearfield::layout::octree::MAX_DEPTH;
use thiserror::Error;

/// The root mean square error asked of every leaf.
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

/// Everything that decides the bytes of a field, beside the mesh and the baker's version.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Target error of every leaf.
    pub error: Target,
    /// Interpolant of the leaves.
    pub interpolant: Interpolant,
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
    fn default() -> Self {
        Self {
            error: Target::Relative(5e-4),
            interpolant: Interpolant::Tricubic,
            continuity: Continuity::C1,
            precision: Precision::Packed32,
            start_depth: 3,
            max_depth: 9,
            margin: 0.2,
            sign: SignChoice::Auto,
            samples: 100_000,
        }
    }
}

/// Settings that contradict themselves or the format.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum SettingsError {
    /// The target is zero, negative or not finite.
    #[error("the target error must be a positive number, not {0}")]
    Target(f64),
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
    /// Nothing would be measured.
    #[error("at least one sample is needed to measure the error")]
    Samples,
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
        if self.interpolant == Interpolant::Trilinear && self.continuity == Continuity::C1 {
            return Err(SettingsError::TrilinearC1);
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
