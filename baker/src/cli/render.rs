//! `nearfield render`: a view of a field's surface.

use super::arguments::{LevelOfDetail, Sign, Threads, method_of, not_negative};
use super::camera_arguments::CameraArguments;
use super::exit_code::Failure;
use super::files;
use super::mesh_arguments::{PartArguments, UpAxis};
use super::progress_bar::TerminalProgress;
use clap::{Args, ValueEnum};
use nearfield_bake::distance::SignedDistance;
use nearfield_bake::picture::{self, Image, Render, Shading, Surface};
use std::path::{Path, PathBuf};

/// Draw a view of a field's surface
///
/// Traces spheres through the field. The camera orbits the field's box and sees all of it.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield render spot.nfd -o spot.png
  nearfield render spot.nfd -o spot.png --azimuth 140 --elevation 10 --zoom 1.6 --size 1920x1080
  nearfield render spot.nfd -o normals.png --shading normals
  nearfield render spot.nfd -o grown.png --offset 0.05
  nearfield render spot.nfd -o compare.png --mesh spot.ply
  nearfield render part.nfd -o compare.png --mesh part.stl --scale 0.001 --mesh-up y
  nearfield render spot.nfd -o turn.png --frames 36")]
pub(super) struct RenderCommand {
    /// The field
    field: PathBuf,

    #[command(flatten)]
    lod: LevelOfDetail,

    /// The PNG to write; `-` is standard output
    #[arg(short, long, value_name = "PNG")]
    output: PathBuf,

    /// Pixels of a view
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "960x720")]
    size: [u32; 2],

    #[command(flatten)]
    camera: CameraArguments,

    /// Draw the surface at this distance, in mesh units; negative is inside
    #[arg(long, value_name = "D", default_value_t = 0.0, allow_negative_numbers = true)]
    offset: f64,

    /// What colours mean
    #[arg(long, value_enum, value_name = "S", default_value_t = ShadingName::Shaded)]
    shading: ShadingName,

    /// Do not darken what is hidden among other parts
    #[arg(long)]
    no_occlusion: bool,

    /// Do not draw shadows
    #[arg(long)]
    no_shadow: bool,

    /// Rays a pixel along each axis
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=8), default_value_t = 2)]
    antialias: u32,

    /// Draw the exact surface of this mesh beside the field's, and the difference of the two views
    #[arg(long, value_name = "MESH")]
    mesh: Option<PathBuf>,

    /// Where the sign of that mesh's distance comes from [default: as in the field]
    #[arg(long, value_enum, value_name = "S", requires = "mesh")]
    sign: Option<Sign>,

    /// The thickness of a sheet, mesh units
    #[arg(long, value_name = "T", value_parser = not_negative, default_value_t = 0.0, requires = "mesh")]
    thickness: f64,

    /// Turn the mesh so that this axis is up, as `bake --up` does
    #[arg(long, value_enum, value_name = "AXIS", requires = "mesh")]
    mesh_up: Option<UpAxis>,

    #[command(flatten)]
    parts: PartArguments,

    /// Views of a full turn, in numbered files: turn.png becomes turn-000.png and so on
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=999))]
    frames: Option<u32>,

    #[command(flatten)]
    threads: Threads,

    /// Draw no progress bar
    #[arg(short, long)]
    quiet: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum ShadingName {
    /// Clay under a lamp
    Shaded,
    /// Red, green and blue are the gradient's x, y and z
    Normals,
}

impl RenderCommand {
    pub(super) fn run(self) -> Result<(), Failure> {
        let bytes = files::read_bytes(&self.field)?;
        let field = self.lod.open(&bytes, &self.field)?;
        if self.frames.is_some() && files::is_standard_stream(&self.output) {
            return Err(Failure::Usage("several frames cannot go to standard output: name a file".to_owned()));
        }
        files::check_output(&self.output, &self.field)?;

        let progress = TerminalProgress::new(self.quiet);
        self.threads.run(|| {
            let surface = Surface::of_field(field);
            let exact = self.exact_distance(field.header().sign_method)?;
            let views = |azimuth: f64| {
                let request = self.request(azimuth);
                let view = picture::render(&surface, &request, &progress);
                let Some(exact) = &exact else { return view };
                let truth = picture::render(&Surface::of_mesh(exact, &surface), &request, &progress);
                let difference = view.difference(&truth);
                Image::beside(&[view, truth, difference])
            };

            let Some(frames) = self.frames else {
                return files::write_bytes(&self.output, &views(self.camera.azimuth).to_png());
            };
            for frame in 0..frames {
                let azimuth = self.camera.azimuth + 360.0 * f64::from(frame) / f64::from(frames);
                files::write_bytes(&numbered(&self.output, frame), &views(azimuth).to_png())?;
            }
            Ok(())
        })?;
        progress.clear();
        Ok(())
    }

    fn request(&self, azimuth: f64) -> Render {
        Render {
            size: self.size,
            camera: self.camera.camera(azimuth),
            offset: self.offset,
            shading: match self.shading {
                ShadingName::Shaded => Shading::Shaded { occlusion: !self.no_occlusion, shadow: !self.no_shadow },
                ShadingName::Normals => Shading::Normals,
            },
            antialias: self.antialias,
        }
    }

    fn exact_distance(&self, method: nearfield::SignMethod) -> Result<Option<SignedDistance>, Failure> {
        let Some(path) = &self.mesh else { return Ok(None) };
        let mesh = files::read_mesh(path, &self.parts.read_options(self.mesh_up)?)?;
        Ok(Some(match self.sign {
            None => SignedDistance::new(&mesh, method_of(method, self.thickness)),
            Some(sign) => SignedDistance::choose(&mesh, sign.choice(self.thickness)).0,
        }))
    }
}

/// `turn.png` and 7 make `turn-007.png`.
fn numbered(path: &Path, frame: u32) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let extension = path.extension().map_or_else(|| "png".into(), |extension| extension.to_string_lossy());
    path.with_file_name(format!("{stem}-{frame:03}.{extension}"))
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let numbers = text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    numbers
        .filter(|size: &[u32; 2]| size.iter().all(|side| (1..=8192).contains(side)))
        .ok_or_else(|| "it must be a width and a height of 1 to 8192, such as 1280x720".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_frames() {
        assert_eq!(size("1280x720"), Ok([1280, 720]));
        for wrong in ["", "1280", "0x1", "9000x1", "ax1"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
        assert_eq!(numbered(Path::new("a/turn.png"), 7), Path::new("a/turn-007.png"));
    }
}
