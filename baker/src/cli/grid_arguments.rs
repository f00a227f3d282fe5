//! Arguments of `nearfield bake` that decide between layouts and shape a grid.

use super::arguments::{not_negative, positive};
use super::exit_code::Failure;
use clap::{Args, ValueEnum};
use nearfield::layout::grid::{MAX_ORDER, MIN_RESOLUTION};
use nearfield_bake::settings::{self, FineGrid, GridSettings, Layout, Resolution, Sampling};

#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = "Layout")]
pub(super) struct GridArguments {
    /// How the field is represented
    #[arg(long, value_enum, value_name = "L", default_value_t = LayoutName::Octree)]
    layout: LayoutName,

    /// Samples of a grid along the longest side, or along each axis as NxMxK
    #[arg(long, value_name = "N", value_parser = resolution, default_value = "64")]
    resolution: Resolution,

    /// Order of the samples of a grid: the degree of their polynomials
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u8).range(..=i64::from(MAX_ORDER)), default_value_t = 1)]
    order: u8,

    /// What a grid answers between its samples [default: half; linear for order 0]
    #[arg(long, value_enum, value_name = "R")]
    reconstruction: Option<Reconstruction>,

    /// How a grid takes its samples [default: taylor; least-squares for orders 2 and 3]
    #[arg(long, value_enum, value_name = "S")]
    sampling: Option<SamplingName>,

    /// Points of the fine grid of a least-squares sample along each axis [default: 3; 5 for order 3]
    #[arg(long, value_name = "N")]
    fine_count: Option<u8>,

    /// How far the fine grid reaches, in spacings of the grid [default: 0.1; 0.5 for orders 2 and 3]
    #[arg(long, value_name = "E", value_parser = positive)]
    fine_extent: Option<f64>,

    /// Points of the fine grid at distance r, in extents, weigh 1 / (1 + F r²)
    #[arg(long, value_name = "F", value_parser = not_negative, default_value_t = 0.0)]
    fine_falloff: f64,

    /// Keep first-order least-squares gradients as they are instead of making them unit vectors
    #[arg(long)]
    no_normalize: bool,

    /// What the stored distances of a grid count from
    #[arg(long, value_enum, value_name = "R", default_value_t = Range::Brick)]
    range: Range,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum LayoutName {
    /// Cells as small as the error needs them
    Octree,
    /// Samples at equal distances
    Grid,
    /// An octree, or a grid that is smaller and measured to be no worse
    Auto,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Reconstruction {
    /// The nearest sample's polynomial
    Nearest,
    /// Polynomials weighted trilinearly
    Linear,
    /// The same of polynomials reduced so that it is exact one degree higher; order 1 and above
    Half,
    /// Polynomials weighted by smooth steps: cubic, quintic, septic; order 1 and above
    Blend,
    /// Hermite interpolation of the derivatives; order 1 and 2
    Hermite,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum SamplingName {
    /// Exact distance and gradient; order 0 and 1
    Taylor,
    /// Least squares over a fine grid around each sample
    LeastSquares,
    /// Least squares of the whole reconstruction, which errs by a quarter less; order 0 and 1, not for nearest
    Fitted,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Range {
    /// One range for the whole file
    File,
    /// A range for each brick of 4 x 4 x 4 samples
    Brick,
}

impl GridArguments {
    /// Whether grids are tried beside the octree.
    pub(super) fn is_auto(&self) -> bool {
        self.layout == LayoutName::Auto
    }

    /// The layout that these arguments make.
    pub(super) fn layout(&self) -> Result<Layout, Failure> {
        if self.layout != LayoutName::Grid {
            return Ok(Layout::Octree);
        }
        let order = self.order;
        let sampling = match self.sampling {
            Some(SamplingName::Taylor) => Sampling::Taylor,
            Some(SamplingName::Fitted) => Sampling::Fitted,
            None if order < 2 => Sampling::Taylor,
            Some(SamplingName::LeastSquares) | None => Sampling::LeastSquares(FineGrid {
                count: self.fine_count.unwrap_or(if order == 3 { 5 } else { 3 }),
                extent: self.fine_extent.unwrap_or(if order < 2 { 0.1 } else { 0.5 }),
                falloff: self.fine_falloff,
                normalized: !self.no_normalize,
            }),
        };
        let reconstruction = match self.reconstruction {
            Some(Reconstruction::Nearest) => settings::Reconstruction::Nearest,
            Some(Reconstruction::Linear) => settings::Reconstruction::Linear,
            Some(Reconstruction::Half) => settings::Reconstruction::Half,
            Some(Reconstruction::Blend) => settings::Reconstruction::Blend,
            Some(Reconstruction::Hermite) => settings::Reconstruction::Hermite,
            None if order == 0 => settings::Reconstruction::Linear,
            None => settings::Reconstruction::Half,
        };
        let range = match self.range {
            Range::File => settings::RangeScope::File,
            Range::Brick => settings::RangeScope::Brick,
        };
        Ok(Layout::Grid(GridSettings { resolution: self.resolution, order, reconstruction, sampling, range }))
    }
}

/// `N` or `NxMxK`, each at least 2.
fn resolution(text: &str) -> Result<Resolution, String> {
    let numbers: Option<Vec<u16>> =
        text.split('x').map(|number| number.parse().ok().filter(|&samples| samples >= MIN_RESOLUTION)).collect();
    match numbers.as_deref() {
        Some([samples]) => Ok(Resolution::Longest(*samples)),
        Some([x, y, z]) => Ok(Resolution::Each([*x, *y, *z])),
        _ => Err("it must be a number from 2 to 65535, or three of them as 32x16x64".to_owned()),
    }
}
