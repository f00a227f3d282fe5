//! `nearfield bake`: a mesh to a field.

use super::arguments::{SignArguments, Threads, bytes, not_negative, positive};
use super::exit_code::Failure;
use super::grid_arguments::GridArguments;
use super::mesh_arguments::MeshArguments;
use super::pareto_report;
use super::progress_bar::TerminalProgress;
use super::{bake_report, files, print, tell, to_json};
use clap::{Args, FromArgMatches, ValueEnum};
use nearfield::layout::{MAX_LODS, octree::MAX_DEPTH};
use nearfield_bake::batch::Asset;
use nearfield_bake::depfile;
use nearfield_bake::import;
use nearfield_bake::lod;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::pareto::{self, Point};
use nearfield_bake::progress::Progress;
use nearfield_bake::report::Stopwatch;
use nearfield_bake::settings::{self, Layout, PolynomialSettings, Settings, Target};
use nearfield_bake::verify::Measurement;
use nearfield_bake::{BakeError, Baked, bake, bake_smallest};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// Bake a mesh into a field
///
/// Reads a mesh and writes one file that answers distance and gradient anywhere in
/// the mesh's box and around it. The same mesh and settings give the same bytes on any machine and on
/// any number of threads. The errors that were measured on the finished file are stored in it.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield bake spot.ply -o spot.nfd
  nearfield bake part.obj -o part.nfd --error-abs 0.05 --precision f16
  nearfield bake spot.ply -o small.nfd --error 1e-3 --profile surface
  nearfield bake spot.ply -o tiny.nfd --max-bytes 16K
  nearfield bake spot.ply -o spot.nfd --lods 2
  nearfield bake soup.obj -o soup.nfd --sign winding --report soup.json
  nearfield bake spot.ply -o spot.nfd --layout grid --resolution 64 --reconstruction half
  nearfield bake spot.ply -o spot.nfd --depfile spot.d --if-changed
  nearfield bake spot.ply --pareto curve.json --layout auto")]
pub(super) struct Bake {
    /// The mesh: OBJ, STL, PLY, OFF, glTF or GLB
    mesh: PathBuf,

    /// The field to write; `-` is standard output
    #[arg(short, long, value_name = "FIELD", required_unless_present = "pareto")]
    output: Option<PathBuf>,

    /// Write no field but the curve of size against error in JSON, and a chart beside it: fields at six targets that halve
    /// down to --error, or at resolutions that double up to --resolution
    #[arg(long, value_name = "JSON", conflicts_with_all = ["output", "max_bytes", "report", "depfile", "if_changed", "fail_on_doubt", "lods"])]
    pareto: Option<PathBuf>,

    /// Error asked of every leaf (root mean square), as a fraction of the diagonal of the mesh's box
    #[arg(long, value_name = "E", value_parser = positive, default_value_t = 5e-4)]
    error: f64,

    /// The same error in mesh units
    #[arg(long, value_name = "E", value_parser = positive, conflicts_with = "error")]
    error_abs: Option<f64>,

    /// Bytes that the field may take, as 65536, 64K or 2M; the error is then the least that fits
    #[arg(long, value_name = "N", value_parser = bytes, conflicts_with_all = ["error", "error_abs"])]
    max_bytes: Option<u64>,

    /// Levels of detail: coarser fields within the file, each of four times the error of the one before it; together they
    /// take at most a fifth of the field's bytes, and those that do not fit are left out
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(..=MAX_LODS as i64), default_value_t = 0)]
    lods: u8,

    /// What stays continuous where leaves meet [default: c1; c0 for trilinear leaves]
    #[arg(long, value_enum, value_name = "C")]
    continuity: Option<Continuity>,

    /// What a leaf of an octree answers
    #[arg(long, value_enum, value_name = "I", default_value_t = Interpolant::Auto)]
    interpolant: Interpolant,

    /// How the error of trilinear and tricubic leaves is estimated [default: trapezoid]
    #[arg(long, value_enum, value_name = "T")]
    termination: Option<Termination>,

    /// Greatest error asked for, as a fraction of the diagonal; of polynomial leaves
    #[arg(long, value_name = "E", value_parser = positive)]
    max_error: Option<f64>,

    /// Where polynomial leaves may err
    #[arg(long, value_enum, value_name = "P", default_value_t = Profile::Uniform)]
    profile: Profile,

    /// How far continuous polynomial leaves reach into their neighbours, as a share of their edge
    #[arg(long, value_name = "R", value_parser = positive, default_value_t = PolynomialSettings::default().overlap)]
    overlap: f64,

    /// How samples of trilinear and tricubic leaves and of grids are stored
    #[arg(long, value_enum, value_name = "P", default_value_t = Precision::Packed32)]
    precision: Precision,

    /// Level of the largest cells: the longest side of the field's box divided by 2 to this power
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(..=i64::from(MAX_DEPTH)), default_value_t = Settings::default().start_depth)]
    start_depth: u8,

    /// Level of the smallest cells, counted in the same way
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(..=i64::from(MAX_DEPTH)), default_value_t = Settings::default().max_depth)]
    max_depth: u8,

    /// Space around the mesh's box on every side, as a fraction of its longest side
    #[arg(long, value_name = "M", value_parser = not_negative, default_value_t = Settings::default().margin)]
    margin: f64,

    #[command(flatten)]
    sign: SignArguments,

    /// Write no field, and exit with 1, when the sign of a measured point is a guess
    #[arg(long)]
    fail_on_doubt: bool,

    /// Points at which the finished field is measured, uniform in the mesh's box and as many near the surface
    /// [default: 100000; for an octree with --error above 1e-3 and without --max-error fewer, 20000 from 5e-3 on]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    samples: Option<u32>,

    #[command(flatten)]
    grid: GridArguments,

    #[command(flatten)]
    pub(super) reading: MeshArguments,

    #[command(flatten)]
    threads: Threads,

    /// Write a report in JSON: settings, mesh, cells, bytes, errors, times
    #[arg(long, value_name = "JSON")]
    report: Option<PathBuf>,

    /// Write which files the field depends on, in the syntax of Make
    #[arg(long, value_name = "FILE")]
    depfile: Option<PathBuf>,

    /// Do not touch a field that holds these very bytes already (for Ninja's restat)
    #[arg(long)]
    if_changed: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    quiet: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Continuity {
    /// Nothing
    None,
    /// The value
    C0,
    /// Value and gradient; not for trilinear leaves
    C1,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Interpolant {
    /// The baker chooses: polynomial
    Auto,
    /// A polynomial for each leaf, or the lesser or greater of two, blended with the neighbours
    Polynomial,
    /// Distances at the corners
    Trilinear,
    /// Distances and gradients at the corners
    Tricubic,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Termination {
    /// Root mean square of 27 points by the trapezoid rule
    Trapezoid,
    /// Root mean square of 27 points by Simpson's rule
    Simpson,
    /// The trapezoid rule; farther from the surface than 2 % of the diagonal in proportion to the distance
    ByDistance,
    /// The greatest of 27 points
    MaxError,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Profile {
    /// Equally everywhere
    Uniform,
    /// Farther from the surface than 2 % of the diagonal in proportion to the distance
    Surface,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Precision {
    /// 32 bits a sample of distance and gradient, 16 bits a sample of distance alone
    Packed32,
    /// 16 bits a component
    F16,
    /// 32 bits a component
    F32,
}

impl Bake {
    pub(super) fn run(self) -> Result<(), Failure> {
        match (&self.output, &self.pareto) {
            (Some(output), _) => self.field(output),
            (None, Some(numbers)) => self.curves(numbers),
            (None, None) => unreachable!("the parser wants one of them"),
        }
    }

    /// Bakes one field.
    fn field(&self, output: &Path) -> Result<(), Failure> {
        let settings = self.settings()?;
        let options = self.reading.read_options()?;
        self.check_outputs()?;

        // Mesh to field.
        let progress = TerminalProgress::new(self.quiet);
        let (mesh, reading, (baked, settings)) = self.threads.run(|| {
            let mut stopwatch = Stopwatch::start(&progress);
            stopwatch.stage("read");
            let mesh = files::read_mesh(&self.mesh, &options)?;
            let reading = stopwatch.stop();
            let baked = self.bake(&mesh, &settings, &progress)?;
            Ok((mesh, reading, baked))
        })?;
        progress.clear();
        self.check_doubt(&baked.report.measurement)?;

        // What was asked for.
        if self.if_changed {
            files::write_bytes_if_changed(output, &baked.bytes)?;
        } else {
            files::write_bytes(output, &baked.bytes)?;
        }
        if let Some(path) = &self.depfile {
            files::write_bytes(path, self.dependencies()?.as_bytes())?;
        }
        let stages = [reading, baked.report.stages.clone()].concat();
        let field = files::open_field(&baked.bytes, output)?;
        if let Some(path) = &self.report {
            let report = bake_report::report(&self.mesh, &mesh, &settings, &field, &baked.report, &stages);
            files::write_bytes(path, to_json(&report).as_bytes())?;
        }

        // What should be known.
        for warning in bake_report::warnings(&mesh, &settings, &baked.report) {
            tell(&format!("warning: {}: {warning}\n", self.mesh.display()))
        }
        if self.quiet {
            return Ok(());
        }
        let summary = bake_report::summary(&self.mesh, output, &mesh, &field, &baked.report, &stages);
        if files::is_standard_stream(output) {
            tell(&summary);
            return Ok(());
        }
        print(&summary)
    }

    /// Bakes fields at many targets for the curve of size against error.
    fn curves(&self, numbers: &Path) -> Result<(), Failure> {
        let settings = self.settings()?;
        let options = self.reading.read_options()?;
        let chart = pareto_report::chart_path(numbers)?;
        for path in [numbers, &chart] {
            files::check_output(path, &self.mesh)?;
        }

        let progress = TerminalProgress::new(self.quiet);
        let show = |text: &str| if self.quiet { Ok(()) } else { progress.suspend(|| print(text)) };
        let (mesh, curves) = self.threads.run(|| {
            let mesh = files::read_mesh(&self.mesh, &options)?;
            let diagonal = mesh.bounds.diagonal();
            show(pareto_report::HEADING)?;
            let mut shown = Ok(());
            let each = |name: &str, point: &Point| {
                if shown.is_ok() {
                    shown = show(&pareto_report::row(name, point, diagonal));
                }
            };
            let curves = pareto::sweep(&mesh, &settings, self.grid.is_auto(), &progress, each);
            shown?;
            Ok((mesh, curves.map_err(|error| bake_failure(&error, &self.mesh))?))
        })?;
        progress.clear();

        pareto_report::write(numbers, &chart, &self.mesh, &mesh, &curves)
    }

    /// The arguments of one asset of a batch, from its flags.
    pub(super) fn of_asset(asset: &Asset) -> Result<Self, Failure> {
        let command = clap::Command::new("bake").no_binary_name(true).disable_help_flag(true);
        let flags = asset.flags.iter().map(OsStr::new);
        let places = [asset.mesh.as_os_str(), OsStr::new("--output"), asset.field.as_os_str()];
        Self::augment_args(command)
            .try_get_matches_from(flags.chain(places))
            .and_then(|matches| Self::from_arg_matches(&matches))
            .map_err(|error| {
                let text = error.to_string();
                let reason = text.lines().next().unwrap_or_default().trim_start_matches("error: ");
                Failure::Usage(format!("{}: {reason}", asset.mesh.display()))
            })
    }

    /// The field, and the settings of what was chosen.
    pub(super) fn bake(
        &self,
        mesh: &CheckedMesh,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<(Baked, Settings), Failure> {
        let baked = if self.grid.is_auto() {
            bake_smallest(mesh, settings, progress)
        } else {
            bake(mesh, settings, progress).map(|baked| (baked, *settings))
        };
        let coarser = |settings: &Settings| bake(mesh, settings, progress);
        baked
            .and_then(|(baked, chosen)| Ok((lod::add_levels(baked, &chosen, self.lods, coarser)?, chosen)))
            .map_err(|error| bake_failure(&error, &self.mesh))
    }

    /// Refuses outputs that cannot be written, before work is spent on them.
    fn check_outputs(&self) -> Result<(), Failure> {
        let outputs: Vec<&PathBuf> =
            [self.output.as_ref(), self.report.as_ref(), self.depfile.as_ref()].into_iter().flatten().collect();
        for (index, path) in outputs.iter().enumerate() {
            if outputs[..index].contains(path) {
                return Err(Failure::Usage(format!("two outputs cannot go to the same place, {}", path.display())));
            }
            files::check_output(path, &self.mesh)?;
        }
        self.dependencies().map(drop)
    }

    /// The quality gate of --fail-on-doubt.
    pub(super) fn check_doubt(&self, measurement: &Measurement) -> Result<(), Failure> {
        match measurement.doubtful_signs {
            doubtful if doubtful > 0 && self.fail_on_doubt => Err(Failure::Verification(format!(
                "{}: {}; close the holes, choose another --sign, or leave --fail-on-doubt away",
                self.mesh.display(),
                bake_report::doubt(measurement)
            ))),
            _ => Ok(()),
        }
    }

    /// The text of the dependency file.
    fn dependencies(&self) -> Result<String, Failure> {
        let (Some(output), Some(_)) = (&self.output, &self.depfile) else {
            return Ok(String::new());
        };
        depfile::rule(output, &self.inputs()?).map_err(|error| Failure::Usage(error.to_string()))
    }

    /// The files that are read: the mesh and what it refers to.
    fn inputs(&self) -> Result<Vec<PathBuf>, Failure> {
        import::inputs(&self.mesh).map_err(|error| Failure::Input(error.to_string()))
    }

    /// Hash of everything in these arguments that decides the bytes of the field.
    pub(super) fn hash(&self) -> Result<[u8; 8], Failure> {
        let mut settings = self.settings()?.hash();
        // The same settings, with more tried beside them, or more baked in front.
        settings[0] ^= u8::from(self.grid.is_auto());
        settings[1] ^= self.lods;
        Ok(self.reading.read_options()?.hash_onto(settings))
    }

    /// The request that these arguments make.
    pub(super) fn settings(&self) -> Result<Settings, Failure> {
        let interpolant = match self.interpolant {
            Interpolant::Trilinear => settings::Interpolant::Trilinear,
            Interpolant::Auto | Interpolant::Polynomial | Interpolant::Tricubic => settings::Interpolant::Tricubic,
        };
        let continuity = match (self.continuity, interpolant) {
            (Some(Continuity::None), _) => settings::Continuity::None,
            (Some(Continuity::C0), _) | (None, settings::Interpolant::Trilinear) => settings::Continuity::C0,
            (Some(Continuity::C1), _) | (None, settings::Interpolant::Tricubic) => settings::Continuity::C1,
        };
        let error = self.error_abs.map_or(Target::Relative(self.error), Target::Absolute);
        let layout = self.layout()?;
        let measured_points = match (layout, self.max_error) {
            (Layout::Octree | Layout::Polynomial(_), None) => error.measured_points(),
            _ => Settings::default().samples,
        };
        let settings = Settings {
            layout,
            error,
            max_bytes: match self.lods {
                0 => self.max_bytes,
                _ => self.max_bytes.map(lod::bytes_without_levels),
            },
            interpolant,
            termination: match self.termination {
                None | Some(Termination::Trapezoid) => settings::Termination::Trapezoid,
                Some(Termination::Simpson) => settings::Termination::Simpson,
                Some(Termination::ByDistance) => settings::Termination::ByDistance,
                Some(Termination::MaxError) => settings::Termination::MaxError,
            },
            continuity,
            precision: match self.precision {
                Precision::Packed32 => settings::Precision::Packed32,
                Precision::F16 => settings::Precision::F16,
                Precision::F32 => settings::Precision::F32,
            },
            start_depth: self.start_depth,
            max_depth: self.max_depth,
            margin: self.margin,
            sign: self.sign.choice()?,
            samples: self.samples.unwrap_or(measured_points),
        };

        settings.check().map_err(|error| Failure::Usage(error.to_string()))?;
        Ok(settings)
    }

    fn layout(&self) -> Result<Layout, Failure> {
        let layout = self.grid.layout()?;
        let is_polynomial =
            layout == Layout::Octree && matches!(self.interpolant, Interpolant::Auto | Interpolant::Polynomial);
        if self.termination.is_some() && (is_polynomial || layout != Layout::Octree) {
            let sentence = "--termination is of the octree's trilinear and tricubic leaves: use --interpolant";
            return Err(Failure::Usage(sentence.to_owned()));
        }
        let polynomial = PolynomialSettings {
            max_error: self.max_error.map(Target::Relative),
            profile: match self.profile {
                Profile::Uniform => settings::Profile::Uniform,
                Profile::Surface => settings::Profile::Surface,
            },
            overlap: self.overlap,
        };
        if is_polynomial {
            return Ok(Layout::Polynomial(polynomial));
        }
        if polynomial != PolynomialSettings::default() {
            let sentence =
                "--max-error, --profile and --overlap are of polynomial leaves: use --interpolant polynomial";
            return Err(Failure::Usage(sentence.to_owned()));
        }
        Ok(layout)
    }
}

fn bake_failure(error: &BakeError, mesh: &Path) -> Failure {
    match error {
        BakeError::Settings(error) => Failure::Usage(error.to_string()),
        BakeError::Extent { .. } => Failure::Input(format!("{}: {error}", mesh.display())),
        BakeError::Encode(_) | BakeError::Budget { .. } | BakeError::Unkept(_) | BakeError::Exceeded { .. } => {
            Failure::Budget(format!("{}: {error}", mesh.display()))
        }
        BakeError::Rejected(_) => Failure::Field(error.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct Command {
        #[command(flatten)]
        bake: Bake,
    }

    /// Who bakes by the library gets the same field.
    #[test]
    fn what_is_not_asked_for_is_the_librarys_default() {
        let Command { bake } = Command::parse_from(["bake", "mesh.obj", "-o", "field.nfd"]);
        let settings = bake.settings().unwrap_or_else(|_| panic!("the defaults do not contradict themselves"));
        assert_eq!(settings, Settings::default());
    }
}
