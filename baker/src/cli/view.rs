//! `nearfield view`: a page that shows a field in a browser.

use super::arguments::LevelOfDetail;
use super::camera_arguments::CameraArguments;
use super::exit_code::Failure;
use super::files;
use clap::Args;
use nearfield_bake::picture::{Viewer, viewer_page};
use std::path::PathBuf;

/// Make a page that shows a field in a browser
///
/// One HTML file that needs no network and no server: it holds the field and traces spheres through its bytes with
/// WebGL2. Drag to turn, scroll to zoom, cut it open, move the surface, drop another field on it.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield view spot.nfd -o spot.html
  nearfield view spot.nfd -o spot.html --azimuth 140 --zoom 2")]
pub(super) struct ViewCommand {
    /// The field
    field: PathBuf,

    #[command(flatten)]
    lod: LevelOfDetail,

    /// The HTML to write; `-` is standard output
    #[arg(short, long, value_name = "HTML")]
    output: PathBuf,

    #[command(flatten)]
    camera: CameraArguments,

    /// Show the surface at this distance, in mesh units; negative is inside
    #[arg(long, value_name = "D", default_value_t = 0.0, allow_negative_numbers = true)]
    offset: f64,
}

impl ViewCommand {
    pub(super) fn run(self) -> Result<(), Failure> {
        let bytes = files::read_bytes(&self.field)?;
        let field = self.lod.open(&bytes, &self.field)?;
        files::check_output(&self.output, &self.field)?;

        let name = self.field.file_name().unwrap_or_default().to_string_lossy();
        let camera = self.camera.camera(self.camera.azimuth);
        let page = viewer_page(field.bytes(), &Viewer { name: &name, camera, offset: self.offset });
        files::write_bytes(&self.output, page.as_bytes())
    }
}
