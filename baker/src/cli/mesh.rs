//! `nearfield mesh`: a field back to triangles.

use super::arguments::{LevelOfDetail, Threads};
use super::exit_code::Failure;
use super::{files, print};
use clap::Args;
use nearfield_bake::picture;
use std::path::{Path, PathBuf};

/// Turn a field back into triangles
///
/// Surface nets on a regular lattice, their vertices moved onto the field's surface: for looking at, for
/// measuring with other programs, and for offset shells. Sharp edges come out rounded. The format
/// is that of the file's extension: PLY, OBJ or STL.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield mesh spot.nfd -o spot-again.ply
  nearfield mesh spot.nfd -o shell.stl --offset 0.02 --resolution 300")]
pub(super) struct MeshCommand {
    /// The field
    field: PathBuf,

    #[command(flatten)]
    lod: LevelOfDetail,

    /// The mesh to write: .ply, .obj or .stl; `-` is PLY on standard output
    #[arg(short, long, value_name = "MESH")]
    output: PathBuf,

    /// Distance of the surface, in mesh units; negative is inside
    #[arg(long, value_name = "D", default_value_t = 0.0, allow_negative_numbers = true)]
    offset: f32,

    /// Cells along the longest side of the field's box
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(4..=1024), default_value_t = 128)]
    resolution: u32,

    #[command(flatten)]
    threads: Threads,

    /// Print nothing but errors
    #[arg(short, long)]
    quiet: bool,
}

impl MeshCommand {
    pub(super) fn run(self) -> Result<(), Failure> {
        let bytes = files::read_bytes(&self.field)?;
        let field = self.lod.open(&bytes, &self.field)?;
        files::check_output(&self.output, &self.field)?;
        let format = format_of(&self.output)?;

        let surface = self.threads.run(|| Ok(picture::isosurface(&field, self.offset, self.resolution)))?;
        let bytes = match format {
            Format::Ply => surface.to_ply(),
            Format::Obj => surface.to_obj(),
            Format::Stl => surface.to_stl(),
        };
        files::write_bytes(&self.output, &bytes)?;
        if self.quiet || files::is_standard_stream(&self.output) {
            return Ok(());
        }
        print(&format!(
            "{}: {} triangles, {} vertices\n",
            self.output.display(),
            surface.triangles.len(),
            surface.positions.len()
        ))
    }
}

#[derive(Clone, Copy, Debug)]
enum Format {
    Ply,
    Obj,
    Stl,
}

fn format_of(path: &Path) -> Result<Format, Failure> {
    if files::is_standard_stream(path) {
        return Ok(Format::Ply);
    }
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    match extension.to_str() {
        Some("ply") => Ok(Format::Ply),
        Some("obj") => Ok(Format::Obj),
        Some("stl") => Ok(Format::Stl),
        _ => Err(Failure::Usage(format!("{}: the extension must be .ply, .obj or .stl", path.display()))),
    }
}
