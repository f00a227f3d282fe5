//! What a bake tells: warnings, a summary for eyes, a report for programs.

use super::error_table::{self, MeasurementReport};
use super::info::{self, InfoReport};
use nearfield::Field;
use nearfield_bake::distance::SignMethod;
use nearfield_bake::lod;
use nearfield_bake::mesh::{CheckedMesh, Role};
use nearfield_bake::report::{Report, Stage};
use nearfield_bake::settings::{
    Continuity, Interpolant, Layout, PolynomialSettings, Precision, Profile, Settings, Target, Termination,
};
use nearfield_bake::verify::Measurement;
use schemars::JsonSchema;
use serde::Serialize;
use std::fs;
use std::path::Path;

/// Version of the report's names and meanings.
const SCHEMA: u32 = 1;

/// What should not pass in silence, one sentence each.
pub(super) fn warnings(mesh: &CheckedMesh, settings: &Settings, report: &Report) -> Vec<String> {
    let mut warnings = Vec::new();

    if let (Some(sign), Some(obstacle)) = (&report.sign, mesh.oriented.pseudonormal_obstacle()) {
        warnings.push(match sign.method {
            SignMethod::Pseudonormal => format!("{obstacle}; the sign may be wrong; use --sign auto"),
            method => format!("{obstacle}; the sign comes from {}, {}", sign_name(method), sign.reason),
        });
    }
    warnings.extend(orientation_changes(mesh));
    if report.measurement.doubtful_signs > 0 {
        warnings.push(doubt(&report.measurement));
    }
    if report.lods_left_out > 0 {
        warnings.push(format!(
            "{} of the levels of detail would take more than {:.0} % of the field's bytes and are left out",
            report.lods_left_out,
            100.0 * lod::MOST_SHARE
        ));
    }
    let target = settings.error.absolute(mesh.bounds.diagonal());
    let error = match &settings.layout {
        Layout::Polynomial(polynomial) if polynomial.profile == Profile::Surface => report.measurement.band.rmse,
        Layout::Octree if settings.termination == Termination::ByDistance => report.measurement.band.rmse,
        Layout::Polynomial(_) | Layout::Octree => report.measurement.uniform.rmse,
        Layout::Grid(_) => 0.0,
    };
    // Where bytes are asked for, no error is.
    if settings.max_bytes.is_none() && error > target {
        let times = error / target;
        warnings.push(format!("the error is {times:.2} times the target; raise --max-depth or the target"));
    }
    warnings
}

/// What was done for the sign, to triangles that the file keeps as they are.
fn orientation_changes(mesh: &CheckedMesh) -> Option<String> {
    let turned = mesh.orientation.count(Role::Turned);
    let changes: Vec<String> = [
        (turned, "turned over"),
        (mesh.orientation.count(Role::Duplicate), "left out as copies"),
        (mesh.orientation.count(Role::Wall), "ignored as walls inside"),
    ]
    .into_iter()
    .filter(|&(count, _)| count > 0)
    .map(|(count, change)| format!("{count} {change}"))
    .collect();
    if turned == mesh.triangles.len() {
        return Some("the mesh is inside out: for the sign, all its triangles were turned over".into());
    }
    (!changes.is_empty()).then(|| format!("for the sign, some triangles count otherwise: {}", changes.join(", ")))
}

/// How many signs are guesses, where the first of them is, and what to try where they are many.
pub(super) fn doubt(measurement: &Measurement) -> String {
    /// Percent. Loose triangles and sheets are above it, of open solids those with holes as large as themselves.
    const MANY: f64 = 30.0;
    let points = 2 * measurement.samples;
    let place = measurement.doubtful_places.first().map(|[x, y, z]| format!(", first at ({x}, {y}, {z})"));
    let share = 100.0 * measurement.doubtful_signs as f64 / f64::from(points);
    let advice = if share > MANY { "; if the triangles enclose nothing, use --sign sheet" } else { "" };
    format!(
        "the sign of {} measured points ({share:.2} %) is a guess{}{advice}",
        measurement.doubtful_signs,
        place.unwrap_or_default()
    )
}

/// The method as `--sign` names it.
pub(super) fn sign_name(method: SignMethod) -> &'static str {
    match method {
        SignMethod::Pseudonormal => "pseudonormals",
        SignMethod::Winding => "winding numbers",
        SignMethod::Rays => "rays",
        SignMethod::Sheet { .. } => "the thickness of a sheet",
    }
}

/// The summary on the terminal.
pub(super) fn summary(
    mesh_path: &Path,
    field_path: &Path,
    mesh: &CheckedMesh,
    field: &Field<'_>,
    report: &Report,
    stages: &[Stage],
) -> String {
    let topology = &mesh.topology;
    let mut text = format!(
        "{}: {} triangles, {} vertices, {}\n",
        mesh_path.display(),
        mesh.triangles.len(),
        mesh.positions.len(),
        if topology.is_closed_and_oriented() {
            "closed and consistently wound"
        } else {
            "not closed and consistently wound"
        }
    );
    if topology.degenerate_triangles > 0 {
        text += &format!("  without {} degenerate triangles\n", topology.degenerate_triangles);
    }

    let [min, max] = [mesh.bounds.min, mesh.bounds.max];
    text += &format!("  in ({}, {}, {}) to ({}, {}, {})\n", min.x, min.y, min.z, max.x, max.y, max.z);
    if let Some(sign) = &report.sign {
        text += &format!("  sign from {}, {}\n", sign_name(sign.method), sign.reason);
    }

    let info = InfoReport::of(field);
    text += &format!("{}: {} bytes, {}\n", field_path.display(), info.bytes(), info.cells());
    text += &error_table::table(&field.contract(), field.header().diagonal);
    text += &error_table::details(&report.measurement, field.header().diagonal);
    text += &info::levels_of_detail(field);

    text += &format!("seconds      {:>8}{:>8}\n", "wall", "CPU");
    let total = Stage {
        name: "total",
        wall: stages.iter().map(|stage| stage.wall).sum(),
        cpu: stages.iter().map(|stage| stage.cpu).sum(),
    };
    for stage in stages.iter().chain([&total]) {
        text += &format!("  {:<11}{:>8.2}{:>8.2}\n", stage.name, stage.wall.as_secs_f64(), stage.cpu.as_secs_f64());
    }
    text
}

#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct BakeReport {
    schema: u32,
    mesh: MeshReport,
    sign: Option<SignReport>,
    settings: SettingsReport,
    field: InfoReport,
    measured: MeasurementReport,
    /// Points at which the exact distance was sampled to build the field.
    samples: usize,
    stages: Vec<StageReport>,
    /// The most memory that the process has held; absent where the operating system does not say.
    peak_memory_bytes: Option<u64>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct MeshReport {
    path: String,
    triangles: usize,
    vertices: usize,
    box_min: [f64; 3],
    box_max: [f64; 3],
    welded_vertices: usize,
    degenerate_triangles: usize,
    boundary_edges: usize,
    non_manifold_edges: usize,
    inconsistent_edges: usize,
    non_manifold_vertices: usize,
    components: usize,
    /// Triangles that were turned over for the sign.
    turned_triangles: usize,
    /// Triangles left out because others have the same corners.
    duplicate_triangles: usize,
    /// Triangles that both sides of a closed surface share: they bear on no sign.
    wall_triangles: usize,
}

#[derive(Debug, Serialize, JsonSchema)]
struct SignReport {
    method: &'static str,
    reason: String,
    /// Pairs of triangles that cross; absent if they were not looked for.
    self_intersections: Option<usize>,
    /// Measured points whose sign is a guess.
    doubtful: usize,
    /// The first of these.
    doubtful_places: Vec<[f32; 3]>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct SettingsReport {
    error: f64,
    error_is_relative: bool,
    interpolant: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    polynomial: Option<PolynomialReport>,
    /// Of trilinear and tricubic leaves.
    termination: Option<&'static str>,
    continuity: &'static str,
    precision: &'static str,
    start_depth: u8,
    max_depth: u8,
    margin: f64,
    /// Points at which the finished field is measured.
    samples: u32,
}

#[derive(Debug, Serialize, JsonSchema)]
struct PolynomialReport {
    profile: &'static str,
    /// As asked for, a fraction of the diagonal or mesh units as the error is.
    max_error: Option<f64>,
    overlap: f64,
}

impl PolynomialReport {
    fn of(settings: &PolynomialSettings) -> Self {
        Self {
            profile: match settings.profile {
                Profile::Uniform => "uniform",
                Profile::Surface => "surface",
            },
            max_error: settings.max_error.map(|(Target::Relative(error) | Target::Absolute(error))| error),
            overlap: settings.overlap,
        }
    }
}

#[derive(Debug, Serialize, JsonSchema)]
struct StageReport {
    name: &'static str,
    wall_seconds: f64,
    cpu_seconds: f64,
}

/// The report for programs.
pub(super) fn report(
    mesh_path: &Path,
    mesh: &CheckedMesh,
    settings: &Settings,
    field: &Field<'_>,
    report: &Report,
    stages: &[Stage],
) -> BakeReport {
    let topology = &mesh.topology;
    let (error, error_is_relative) = match settings.error {
        Target::Relative(error) => (error, true),
        Target::Absolute(error) => (error, false),
    };
    BakeReport {
        schema: SCHEMA,
        mesh: MeshReport {
            path: mesh_path.display().to_string(),
            triangles: mesh.triangles.len(),
            vertices: mesh.positions.len(),
            box_min: mesh.bounds.min.to_array(),
            box_max: mesh.bounds.max.to_array(),
            welded_vertices: topology.welded_vertices,
            degenerate_triangles: topology.degenerate_triangles,
            boundary_edges: topology.boundary_edges,
            non_manifold_edges: topology.non_manifold_edges,
            inconsistent_edges: topology.inconsistent_edges,
            non_manifold_vertices: topology.non_manifold_vertices,
            components: topology.components,
            turned_triangles: mesh.orientation.count(Role::Turned),
            duplicate_triangles: mesh.orientation.count(Role::Duplicate),
            wall_triangles: mesh.orientation.count(Role::Wall),
        },
        sign: report.sign.as_ref().map(|sign| SignReport {
            method: sign_name(sign.method),
            reason: sign.reason.clone(),
            self_intersections: sign.self_intersections,
            doubtful: report.measurement.doubtful_signs,
            doubtful_places: report.measurement.doubtful_places.clone(),
        }),
        settings: SettingsReport {
            error,
            error_is_relative,
            interpolant: match (&settings.layout, settings.interpolant) {
                (Layout::Polynomial(_), _) => "polynomial",
                (_, Interpolant::Trilinear) => "trilinear",
                (_, Interpolant::Tricubic) => "tricubic",
            },
            polynomial: match &settings.layout {
                Layout::Polynomial(polynomial) => Some(PolynomialReport::of(polynomial)),
                Layout::Octree | Layout::Grid(_) => None,
            },
            termination: (settings.layout == Layout::Octree).then_some(match settings.termination {
                Termination::Trapezoid => "trapezoid",
                Termination::Simpson => "simpson",
                Termination::ByDistance => "by-distance",
                Termination::MaxError => "max-error",
            }),
            continuity: match settings.continuity {
                Continuity::None => "none",
                Continuity::C0 => "c0",
                Continuity::C1 => "c1",
            },
            precision: match settings.precision {
                Precision::Packed32 => "packed32",
                Precision::F16 => "f16",
                Precision::F32 => "f32",
            },
            start_depth: settings.start_depth,
            max_depth: settings.max_depth,
            margin: settings.margin,
            samples: settings.samples,
        },
        field: InfoReport::of(field),
        measured: (&report.measurement).into(),
        samples: report.samples,
        stages: stages
            .iter()
            .map(|stage| StageReport {
                name: stage.name,
                wall_seconds: stage.wall.as_secs_f64(),
                cpu_seconds: stage.cpu.as_secs_f64(),
            })
            .collect(),
        peak_memory_bytes: peak_memory(),
    }
}

/// What Linux counts as the high-water mark of resident memory.
fn peak_memory() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let kilobytes = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.split_whitespace().next()?;
    Some(kilobytes.parse::<u64>().ok()? * 1024)
}
