//! `nearfield inspect`: what a mesh is like, before it is baked.

use super::arguments::{SignArguments, Threads, positive};
use super::bake_report::sign_name;
use super::exit_code::Failure;
use super::mesh_arguments::MeshArguments;
use super::{files, print, to_json};
use clap::Args;
use nearfield::layout::octree::MAX_DEPTH;
use nearfield_bake::inspect::{Inspection, Thickness, inspect};
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::settings::{Settings, Target};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Look at a mesh before it is baked
///
/// Tells what the mesh is made of, what is wrong with it, where its sign would come from and why, and
/// whether its thin parts are larger than the cells of a field. Nothing is written.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield inspect spot.ply
  nearfield inspect car.glb --node 'wheel*' --json")]
pub(super) struct Inspect {
    /// The mesh: OBJ, STL, PLY, OFF, glTF or GLB
    mesh: PathBuf,

    #[command(flatten)]
    sign: SignArguments,

    /// Target of the field, a fraction of the diagonal, against which thin parts are measured
    #[arg(long, value_name = "E", value_parser = positive, default_value_t = 5e-4)]
    error: f64,

    /// Level of the smallest cells, against which thin parts are measured
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(i64::from(Settings::default().start_depth)..=i64::from(MAX_DEPTH)), default_value_t = Settings::default().max_depth)]
    max_depth: u8,

    #[command(flatten)]
    reading: MeshArguments,

    #[command(flatten)]
    threads: Threads,

    /// Print a report in JSON
    #[arg(long)]
    json: bool,
}

impl Inspect {
    pub(super) fn run(self) -> Result<(), Failure> {
        let options = self.reading.read_options()?;
        let error = Target::Relative(self.error);
        let settings = Settings { error, sign: self.sign.choice()?, max_depth: self.max_depth, ..Settings::default() };
        let (mesh, found) = self.threads.run(|| {
            let mesh = files::read_mesh(&self.mesh, &options)?;
            let found = inspect(&mesh, &settings);
            Ok((mesh, found))
        })?;
        let report = InspectReport::of(&self.mesh, &mesh, &found);
        print(&if self.json { to_json(&report) } else { report.text() })
    }
}

#[derive(Debug, Serialize)]
struct InspectReport {
    schema: u32,
    path: String,
    triangles: usize,
    vertices: usize,
    box_min: [f64; 3],
    box_max: [f64; 3],
    diagonal: f64,
    area: f64,
    /// Meaningless unless the mesh is closed.
    volume: f64,
    is_closed_and_oriented: bool,
    components: usize,
    cavities: usize,
    /// Shells within shells that face the same way.
    nested_shells: usize,
    welded_vertices: usize,
    degenerate_triangles: usize,
    duplicate_triangles: usize,
    wall_triangles: usize,
    turned_triangles: usize,
    boundary_edges: usize,
    rims: usize,
    non_manifold_edges: usize,
    non_manifold_vertices: usize,
    inconsistent_edges: usize,
    self_intersections: usize,
    sign: SignReport,
    thickness: Option<ThicknessReport>,
}

#[derive(Debug, Serialize)]
struct SignReport {
    method: &'static str,
    reason: String,
    /// Share of the mesh's box where the sign is a guess.
    doubtful: f64,
    doubtful_places: Vec<[f64; 3]>,
}

#[derive(Debug, Serialize)]
struct ThicknessReport {
    p01: f64,
    median: f64,
    smallest_cell: f64,
    /// Share of the surface thinner than two of the smallest cells.
    too_thin: f64,
    target: f64,
    /// Share of the surface thinner than nine targets.
    too_thin_for_target: f64,
}

impl ThicknessReport {
    fn of(found: Thickness) -> Self {
        let Thickness { p01, median, smallest_cell, too_thin, target, too_thin_for_target } = found;
        Self { p01, median, smallest_cell, too_thin, target, too_thin_for_target }
    }
}

impl InspectReport {
    fn of(path: &Path, mesh: &CheckedMesh, found: &Inspection) -> Self {
        let topology = &mesh.topology;
        Self {
            schema: 1,
            path: path.display().to_string(),
            triangles: mesh.triangles.len(),
            vertices: mesh.positions.len(),
            box_min: mesh.bounds.min.to_array(),
            box_max: mesh.bounds.max.to_array(),
            diagonal: mesh.bounds.diagonal(),
            area: found.area,
            volume: found.volume,
            is_closed_and_oriented: topology.is_closed_and_oriented(),
            components: topology.components,
            cavities: found.cavities,
            nested_shells: found.nested,
            welded_vertices: topology.welded_vertices,
            degenerate_triangles: topology.degenerate_triangles,
            duplicate_triangles: found.duplicates,
            wall_triangles: found.walls,
            turned_triangles: found.turned,
            boundary_edges: topology.boundary_edges,
            rims: found.rims,
            non_manifold_edges: topology.non_manifold_edges,
            non_manifold_vertices: topology.non_manifold_vertices,
            inconsistent_edges: topology.inconsistent_edges,
            self_intersections: found.self_intersections,
            sign: SignReport {
                method: sign_name(found.sign.method),
                reason: found.sign.reason.clone(),
                doubtful: found.doubtful,
                doubtful_places: found.doubtful_places.clone(),
            },
            thickness: found.thickness.map(ThicknessReport::of),
        }
    }

    fn text(&self) -> String {
        let mut text = format!("{}: {} triangles, {} vertices\n", self.path, self.triangles, self.vertices);
        let mut line = |name: &str, value: String| text += &format!("  {name:<18}{value}\n");
        let ([x, y, z], [u, v, w]) = (self.box_min, self.box_max);
        line("box", format!("({x}, {y}, {z}) to ({u}, {v}, {w}), diagonal {:.6}", self.diagonal));
        line("area, volume", format!("{:.6}, {:.6}", self.area, self.volume));
        line("pieces", format!("{}, of which {} cavities", self.components, self.cavities));
        let closed = if self.is_closed_and_oriented { "yes" } else { "no" };
        line("closed, oriented", closed.to_owned());

        // Flaws: nothing is said of those that it has not.
        let flaws = [
            ("rim", self.boundary_edges, format!("{} edges in {} loops", self.boundary_edges, self.rims)),
            (
                "non-manifold",
                self.non_manifold_edges,
                format!("{} edges with more than two triangles", self.non_manifold_edges),
            ),
            ("", self.non_manifold_vertices, format!("{} vertices with more than one fan", self.non_manifold_vertices)),
            (
                "inconsistent",
                self.inconsistent_edges,
                format!("{} edges whose triangles disagree", self.inconsistent_edges),
            ),
            ("crossing", self.self_intersections, format!("{} pairs of triangles", self.self_intersections)),
            (
                "nested",
                self.nested_shells,
                format!("{} shells within shells that face the same way", self.nested_shells),
            ),
            ("degenerate", self.degenerate_triangles, format!("{} triangles, dropped", self.degenerate_triangles)),
            ("duplicate", self.duplicate_triangles, format!("{} triangles, counted once", self.duplicate_triangles)),
            ("walls", self.wall_triangles, format!("{} triangles, of no bearing on the sign", self.wall_triangles)),
            (
                "inside out",
                self.turned_triangles,
                format!("{} triangles, turned over for the sign", self.turned_triangles),
            ),
        ];
        flaws.into_iter().filter(|(_, count, _)| *count > 0).for_each(|(name, _, value)| line(name, value));

        line("sign", format!("from {}, {}", self.sign.method, self.sign.reason));
        if let Some([x, y, z]) = self.sign.doubtful_places.first() {
            line(
                "doubtful",
                format!("{:.2} % of the box, first at ({x:.6}, {y:.6}, {z:.6})", 100.0 * self.sign.doubtful),
            );
        }
        if let Some(thickness) = &self.thickness {
            line("thickness", format!("median {:.6}, 1 % below {:.6}", thickness.median, thickness.p01));
            let share = 100.0 * thickness.too_thin;
            line(
                "smallest cell",
                format!("{:.6}; {share:.2} % of the surface is thinner than two", thickness.smallest_cell),
            );
            let share = 100.0 * thickness.too_thin_for_target;
            line("target", format!("{:.6}; {share:.2} % of the surface is thinner than nine", thickness.target));
        }
        text
    }
}
