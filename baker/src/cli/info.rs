//! `nearfield info`: what a field says about itself.

use super::error_table::{self, ContractReport};
use super::exit_code::Failure;
use super::{files, print, to_json};
use clap::Args;
use nearfield::{
    Continuity, Field, Grid, GridPrecision, Interpolant, Leaf, Octree, PolynomialOctree, Reconstruction, SignMethod,
};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;

/// Show what a field holds and what it promises
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield info spot.nfd
  nearfield info spot.nfd --json | jq .errors.band.max")]
pub(super) struct Info {
    /// The field
    field: PathBuf,

    /// Print a report in JSON; lengths in mesh units
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct InfoReport {
    schema: u32,
    version: [u16; 2],
    bytes: usize,
    box_min: [f32; 3],
    box_max: [f32; 3],
    diagonal: f32,
    target_error: f32,
    lipschitz: f32,
    errors: ContractReport,
    sign_method: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    octree: Option<OctreeReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    polynomial_octree: Option<PolynomialOctreeReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    grid: Option<GridReport>,
    sections: Vec<SectionReport>,
    /// Coarser fields within the file: level 1 and so on.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    lods: Vec<LevelReport>,
    mesh_hash: String,
    settings_hash: String,
    baker_version: String,
}

#[derive(Debug, Serialize, JsonSchema)]
struct OctreeReport {
    root_cells: [u32; 3],
    root_edge: f32,
    depth: u8,
    interpolant: &'static str,
    continuity: &'static str,
    leaves: u32,
    /// Edge of the smallest leaves: walls thinner than this may be lost. Mesh units.
    smallest_edge: f32,
    /// One entry a level, from the root cells down.
    leaves_by_level: Vec<u32>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct PolynomialOctreeReport {
    root_cells: [u32; 3],
    root_edge: f32,
    depth: u8,
    continuity: &'static str,
    /// How far leaves reach into their neighbours, as a share of their edge.
    overlap: f32,
    /// Finest step of a coefficient, mesh units.
    quantum: f32,
    leaves: u32,
    /// Edge of the smallest leaves, mesh units.
    smallest_edge: f32,
    /// One entry a level, from the root cells down.
    leaves_by_level: Vec<u32>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct GridReport {
    resolution: [u32; 3],
    spacing: [f32; 3],
    order: u8,
    reconstruction: &'static str,
    precision: &'static str,
    brick_ranges: bool,
    quantum: f32,
}

#[derive(Debug, Serialize, JsonSchema)]
struct LevelReport {
    bytes: usize,
    target_error: f32,
    lipschitz: f32,
    errors: ContractReport,
}

#[derive(Debug, Serialize, JsonSchema)]
struct SectionReport {
    kind: String,
    offset: usize,
    bytes: usize,
}

impl Info {
    pub(super) fn run(self) -> Result<(), Failure> {
        let bytes = files::read_bytes(&self.field)?;
        let field = files::open_field(&bytes, &self.field)?;
        let report = InfoReport::of(&field);

        print(&if self.json { to_json(&report) } else { report.text(&field) })
    }
}

impl InfoReport {
    pub(super) fn of(field: &Field<'_>) -> Self {
        let header = field.header();
        Self {
            schema: 1,
            version: header.version,
            bytes: field.bytes().len(),
            box_min: header.bounds.min,
            box_max: header.bounds.max,
            diagonal: header.diagonal,
            target_error: header.target_error,
            lipschitz: header.lipschitz,
            errors: (&field.contract()).into(),
            sign_method: match header.sign_method {
                SignMethod::Pseudonormal => "pseudonormal",
                SignMethod::Winding => "winding",
                SignMethod::Rays => "rays",
                SignMethod::Sheet => "sheet",
                _ => "none",
            },
            octree: field.octree().as_ref().map(OctreeReport::of),
            polynomial_octree: field.polynomial_octree().as_ref().map(PolynomialOctreeReport::of),
            grid: field.grid().as_ref().map(GridReport::of),
            sections: field
                .sections()
                .map(|section| SectionReport {
                    kind: String::from_utf8_lossy(&section.kind.to_le_bytes()).into_owned(),
                    offset: section.range.start,
                    bytes: section.range.len(),
                })
                .collect(),
            lods: levels(field).map(|level| LevelReport::of(&level)).collect(),
            mesh_hash: hexadecimal(&header.mesh_hash),
            settings_hash: hexadecimal(&header.settings_hash),
            baker_version: header.baker_version.map(|part| part.to_string()).join("."),
        }
    }

    /// Bytes of the file.
    pub(super) fn bytes(&self) -> usize {
        self.bytes
    }

    /// How many leaves there are, in all and by level, or how many samples.
    pub(super) fn cells(&self) -> String {
        match (&self.octree, &self.polynomial_octree, &self.grid) {
            (Some(octree), _, _) => format!("leaves {}", leaves(octree.leaves, &octree.leaves_by_level)),
            (_, Some(octree), _) => format!("leaves {}", leaves(octree.leaves, &octree.leaves_by_level)),
            (_, _, Some(grid)) => format!("samples {}", grid.samples()),
            (None, None, None) => "nothing that this program knows".to_owned(),
        }
    }

    fn text(&self, field: &Field<'_>) -> String {
        let mut text = String::new();
        let mut line = |name: &str, value: String| {
            writeln!(text, "{name:<14}{value}").expect("memory takes every write");
        };
        let coordinates = |point: [f32; 3]| point.map(|coordinate| coordinate.to_string()).join(" ");

        line("format", format!("{}.{}, {} bytes", self.version[0], self.version[1], self.bytes));
        line("box", format!("{}  to  {}", coordinates(self.box_min), coordinates(self.box_max)));
        line("diagonal", format!("{} (of the mesh's box, mesh units)", self.diagonal));
        line("target", format!("{:.2e} of the diagonal", self.target_error / self.diagonal));
        line("slope", format!("at most {}", self.lipschitz));
        line("sign", self.sign_method.to_owned());

        if let Some(octree) = &self.octree {
            let [x, y, z] = octree.root_cells;
            line("octree", format!("{}, continuity {}", octree.interpolant, octree.continuity));
            line("root cells", format!("{x} x {y} x {z} of edge {}", octree.root_edge));
            line("leaves", leaves(octree.leaves, &octree.leaves_by_level));
            line("smallest", format!("{} (edge of the smallest leaves, mesh units)", octree.smallest_edge));
        }
        if let Some(octree) = &self.polynomial_octree {
            let [x, y, z] = octree.root_cells;
            line("octree", format!("polynomial, continuity {}, overlap {}", octree.continuity, octree.overlap));
            line("root cells", format!("{x} x {y} x {z} of edge {}", octree.root_edge));
            line("leaves", leaves(octree.leaves, &octree.leaves_by_level));
            line("smallest", format!("{} (edge of the smallest leaves, mesh units)", octree.smallest_edge));
        }
        if let Some(grid) = &self.grid {
            line("grid", format!("order {}, {}, {}", grid.order, grid.reconstruction, grid.precision));
            line("samples", grid.samples());
            line("spacing", coordinates(grid.spacing));
        }

        for section in &self.sections {
            line("section", format!("{} {} bytes at {}", section.kind, section.bytes, section.offset));
        }
        line("mesh", self.mesh_hash.clone());
        line("settings", self.settings_hash.clone());
        line("baker", self.baker_version.clone());

        text += &error_table::table(&field.contract(), self.diagonal);
        text + &levels_of_detail(field)
    }
}

/// The levels of detail beside the field itself.
fn levels<'a>(field: &Field<'a>) -> impl Iterator<Item = Field<'a>> {
    (1..field.lod_count()).filter_map(|level| field.lod(level))
}

/// What each level of detail takes and keeps, a line each.
pub(super) fn levels_of_detail(field: &Field<'_>) -> String {
    let alone = field.bytes().len() - levels(field).map(|level| level.bytes().len()).sum::<usize>();
    let mut text = String::new();
    for (level, number) in levels(field).zip(1..) {
        let (bytes, contract) = (level.bytes().len(), level.contract());
        let share = 100.0 * bytes as f64 / alone as f64;
        let relative = |error: f32| f64::from(error) / f64::from(field.header().diagonal);
        text += &format!(
            "lod {number}: {bytes} bytes, {share:.1} % of the field; RMSE {:.2e}, band RMSE {:.2e}, max {:.2e}\n",
            relative(contract.uniform.rmse),
            relative(contract.band.rmse),
            relative(contract.max_error())
        );
    }
    text
}

impl LevelReport {
    fn of(level: &Field<'_>) -> Self {
        let header = level.header();
        Self {
            bytes: level.bytes().len(),
            target_error: header.target_error,
            lipschitz: header.lipschitz,
            errors: (&level.contract()).into(),
        }
    }
}

/// How many leaves there are, in all and by level.
fn leaves(count: u32, by_level: &[u32]) -> String {
    let levels = by_level.iter().enumerate().filter(|(_, leaves)| **leaves > 0);
    let levels: Vec<String> = levels.map(|(level, leaves)| format!("{leaves} at level {level}")).collect();
    format!("{count}: {}", levels.join(", "))
}

impl OctreeReport {
    fn of(octree: &Octree<'_>) -> Self {
        let leaves_by_level = by_level(octree.depth(), octree.leaves());
        Self {
            root_cells: octree.root_cells(),
            root_edge: octree.root_edge(),
            depth: octree.depth(),
            interpolant: match octree.interpolant() {
                Interpolant::Trilinear => "trilinear",
                Interpolant::Tricubic => "tricubic",
                _ => "unknown",
            },
            continuity: name_of(octree.continuity()),
            leaves: octree.leaf_count(),
            smallest_edge: octree.edge(deepest(&leaves_by_level)),
            leaves_by_level,
        }
    }
}

impl PolynomialOctreeReport {
    fn of(octree: &PolynomialOctree<'_>) -> Self {
        let leaves_by_level = by_level(octree.depth(), octree.leaves());
        Self {
            root_cells: octree.root_cells(),
            root_edge: octree.edge(0),
            depth: octree.depth(),
            continuity: name_of(octree.continuity()),
            overlap: octree.overlap(),
            quantum: octree.quantum(),
            leaves: octree.leaf_count(),
            smallest_edge: octree.edge(deepest(&leaves_by_level)),
            leaves_by_level,
        }
    }
}

fn name_of(continuity: Continuity) -> &'static str {
    match continuity {
        Continuity::None => "none",
        Continuity::C0 => "c0",
        Continuity::C1 => "c1",
        _ => "unknown",
    }
}

fn by_level(depth: u8, leaves: impl Iterator<Item = Leaf>) -> Vec<u32> {
    let mut by_level = vec![0; usize::from(depth) + 1];
    for leaf in leaves {
        by_level[usize::from(leaf.level)] += 1;
    }
    by_level
}

/// The deepest level that has leaves.
fn deepest(leaves_by_level: &[u32]) -> u8 {
    leaves_by_level.iter().rposition(|&leaves| leaves > 0).unwrap_or(0) as u8
}

impl GridReport {
    /// How many samples there are.
    fn samples(&self) -> String {
        let [x, y, z] = self.resolution;
        format!("{}: {x} x {y} x {z}", u64::from(x) * u64::from(y) * u64::from(z))
    }

    fn of(grid: &Grid<'_>) -> Self {
        Self {
            resolution: grid.resolution(),
            spacing: grid.spacing(),
            order: grid.order(),
            reconstruction: match grid.reconstruction() {
                Reconstruction::Nearest => "nearest",
                Reconstruction::Linear => "linear",
                Reconstruction::Half => "half",
                Reconstruction::Blend => "blend",
                Reconstruction::Hermite => "hermite",
                _ => "unknown",
            },
            precision: match grid.precision() {
                GridPrecision::Packed32 => "packed32",
                GridPrecision::F16 => "f16",
                GridPrecision::F32 => "f32",
                _ => "unknown",
            },
            brick_ranges: grid.has_brick_ranges(),
            quantum: grid.quantum(),
        }
    }
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
