//! `nearfield verify`: does a field keep its promise?

use super::arguments::{LevelOfDetail, Threads, method_of, not_negative};
use super::error_table::{self, ContractReport, MeasurementReport};
use super::exit_code::Failure;
use super::mesh_arguments::MeshArguments;
use super::{files, print, to_json};
use clap::Args;
use nearfield::Field;
use nearfield_bake::distance::SignedDistance;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::verify::{self, Contradiction, Measurement};
use serde::Serialize;
use std::path::PathBuf;

/// Measure a field against its mesh
///
/// Reopens the field, computes exact distances from the mesh, and compares the errors with the
/// contract that the file stores.
///
/// Without --samples, the very points of the contract are measured again. The contract is contradicted
/// when any of its figures (RMSE, 99 % quantile and maximum, uniform and in the band, and the largest
/// seam) is exceeded by more than 1e-4 of itself.
///
/// With --samples N, N fresh points are drawn. The contract is contradicted when, uniform or in the
/// band, the RMSE exceeds the stored one by more than 25 %, or more than 2 % of the points exceed the
/// stored 99 % quantile, or more than 0.1 % of the points exceed the stored maximum.
///
/// Either way a mesh other than the baked one is a contradiction.
#[derive(Debug, Args)]
#[command(after_help = "\
Exit code 1 means that the mesh contradicts the field.

Examples:
  nearfield verify spot.nfd --mesh spot.ply
  nearfield verify spot.nfd --mesh spot.ply --samples 1000000 --json")]
pub(super) struct Verify {
    /// The field
    field: PathBuf,

    #[command(flatten)]
    lod: LevelOfDetail,

    /// The mesh that it was baked from
    #[arg(long, value_name = "MESH")]
    mesh: PathBuf,

    /// Draw this many fresh points, uniform and again in the band
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(i64::from(verify::MIN_FRESH_SAMPLES)..))]
    samples: Option<u32>,

    /// The thickness that a sheet was baked with, mesh units
    #[arg(long, value_name = "T", value_parser = not_negative, default_value_t = 0.0)]
    thickness: f64,

    #[command(flatten)]
    reading: MeshArguments,

    #[command(flatten)]
    threads: Threads,

    /// Print a report in JSON
    #[arg(long)]
    json: bool,
}

/// Seed of fresh points: any but the contract's.
const FRESH_SEED: u64 = verify::CONTRACT_SEED + 1;

impl Verify {
    pub(super) fn run(self) -> Result<(), Failure> {
        let bytes = files::read_bytes(&self.field)?;
        let field = self.lod.open(&bytes, &self.field)?;
        if field.contract().sample_count == 0 {
            return Err(Failure::Verification(format!(
                "{} promises nothing: its contract is empty; bake it again",
                self.field.display()
            )));
        }

        let options = self.reading.read_options()?;
        let (measurement, contradiction) = self.threads.run(|| {
            let mesh = files::read_mesh(&self.mesh, &options)?;
            files::refuse_other_mesh(&self.field, &field, &self.mesh, &mesh)?;
            self.measure(&field, &mesh)
        })?;

        let (diagonal, stored) = (field.header().diagonal, field.contract());
        if self.json {
            print(&to_json(&VerifyReport {
                schema: 1,
                diagonal,
                stored: (&stored).into(),
                measured: (&measurement).into(),
                holds: contradiction.is_none(),
            }))?;
        } else {
            print(&error_table::table(&measurement.contract(), diagonal))?;
            print(&error_table::details(&measurement, diagonal))?;
        }

        match contradiction {
            None if self.json => Ok(()),
            None => print("the field keeps its contract\n"),
            Some(contradiction) => Err(Failure::Verification(format!(
                "{} does not keep its contract: {contradiction} (mesh units); bake it again from {}",
                self.field.display(),
                self.mesh.display()
            ))),
        }
    }

    fn measure(&self, field: &Field<'_>, mesh: &CheckedMesh) -> Result<(Measurement, Option<Contradiction>), Failure> {
        let contract = field.contract();
        let method = method_of(field.header().sign_method, self.thickness);
        let truth = SignedDistance::new(mesh, method);

        Ok(match self.samples {
            None => {
                let measurement = verify::measure(field, &truth, mesh, contract.sample_count, verify::CONTRACT_SEED);
                let contradiction = verify::exceeds(&contract, &measurement);
                (measurement, contradiction)
            }
            Some(samples) => {
                let measurement = verify::measure(field, &truth, mesh, samples, FRESH_SEED);
                let contradiction = verify::refutes(&contract, &measurement);
                (measurement, contradiction)
            }
        })
    }
}

#[derive(Debug, Serialize)]
struct VerifyReport {
    schema: u32,
    diagonal: f32,
    stored: ContractReport,
    measured: MeasurementReport,
    holds: bool,
}
