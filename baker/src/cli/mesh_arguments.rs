//! Arguments that say which parts of a mesh file are read, and how they lie.

use super::arguments::positive;
use super::exit_code::Failure;
use clap::{Args, ValueEnum};
use nearfield_bake::import::{Names, Placement, ReadOptions, Selection, Up};

#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Mesh")]
pub(super) struct MeshArguments {
    #[command(flatten)]
    parts: PartArguments,

    /// Turn the mesh so that this axis is up; a glTF has y up, of others the other axis is taken to be
    #[arg(long, value_enum, value_name = "AXIS")]
    up: Option<UpAxis>,
}

impl MeshArguments {
    pub(super) fn read_options(&self) -> Result<ReadOptions, Failure> {
        self.parts.read_options(self.up)
    }
}

/// All but the axis that is up, for commands where this is the camera's.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Mesh")]
pub(super) struct PartArguments {
    /// Take only nodes whose name, or that of a node above, fits: shell patterns; objects and groups of an OBJ,
    /// nodes and meshes of a glTF
    #[arg(long, value_name = "NAME")]
    node: Vec<String>,

    /// Leave out nodes whose name, or that of a node above, fits
    #[arg(long, value_name = "NAME")]
    exclude_node: Vec<String>,

    /// Take only triangles of the materials whose name fits
    #[arg(long, value_name = "NAME")]
    material: Vec<String>,

    /// Leave out triangles of the materials whose name fits
    #[arg(long, value_name = "NAME")]
    exclude_material: Vec<String>,

    /// Multiply the mesh by this, about its origin
    #[arg(long, value_name = "S", value_parser = positive, default_value_t = 1.0)]
    scale: f64,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum UpAxis {
    Y,
    Z,
}

impl PartArguments {
    pub(super) fn read_options(&self, up: Option<UpAxis>) -> Result<ReadOptions, Failure> {
        let names = |with, without| Names::new(with, without).map_err(Failure::Usage);
        Ok(ReadOptions {
            selection: Selection {
                nodes: names(&self.node, &self.exclude_node)?,
                materials: names(&self.material, &self.exclude_material)?,
            },
            placement: Placement {
                scale: self.scale,
                up: up.map(|axis| match axis {
                    UpAxis::Y => Up::Y,
                    UpAxis::Z => Up::Z,
                }),
            },
        })
    }
}
