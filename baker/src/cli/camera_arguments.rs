//! Arguments that place a camera.

use super::arguments::positive;
use clap::{Args, ValueEnum};
use nearfield_bake::picture::{Camera, Up};

/// Where a surface is seen from.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct CameraArguments {
    /// Degrees that the camera has gone around the up axis
    #[arg(long, value_name = "DEGREES", default_value_t = 35.0, allow_negative_numbers = true)]
    pub(super) azimuth: f64,

    /// Degrees of the camera above the horizon
    #[arg(long, value_name = "DEGREES", value_parser = elevation, default_value_t = 20.0, allow_negative_numbers = true)]
    elevation: f64,

    /// 1 shows the whole box, 2 half of it
    #[arg(long, value_name = "Z", value_parser = positive, default_value_t = 1.5)]
    zoom: f64,

    /// Axis that points up
    #[arg(long, value_enum, value_name = "AXIS", default_value_t = UpAxis::Y)]
    up: UpAxis,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum UpAxis {
    Y,
    Z,
}

impl CameraArguments {
    /// The camera, gone around to `azimuth`.
    pub(super) fn camera(&self, azimuth: f64) -> Camera {
        let up = match self.up {
            UpAxis::Y => Up::Y,
            UpAxis::Z => Up::Z,
        };
        Camera { azimuth, elevation: self.elevation, zoom: self.zoom, up }
    }
}

fn elevation(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|degrees| (-90.0..=90.0).contains(degrees))
        .ok_or_else(|| "it must be from -90 to 90".to_owned())
}
