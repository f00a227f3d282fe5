//! `nearfield generate`: what packages of this program install beside it.

use super::bake_report::BakeReport;
use super::batch_report::BatchReport;
use super::diff::DiffReport;
use super::exit_code::Failure;
use super::pareto_report::ParetoReport;
use super::{CommandLine, files, print, to_json};
use clap::{Args, CommandFactory, Subcommand};
use clap_complete::Shell;
use std::fs;
use std::path::{Path, PathBuf};

/// Write man pages, shell completions, or the schemas of reports
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  nearfield generate man -o /usr/local/share/man/man1
  nearfield generate completions bash > /etc/bash_completion.d/nearfield
  nearfield generate report-schema > report.schema.json")]
pub(super) struct Generate {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Man pages, one a command
    Man {
        /// The folder to write them to
        #[arg(short, long, value_name = "FOLDER")]
        output: PathBuf,
    },
    /// Completions of a shell, on standard output
    Completions {
        /// The shell
        shell: Shell,
    },
    /// The JSON Schema of `bake --report`, on standard output
    ReportSchema,
    /// The JSON Schema of `bake --pareto`, on standard output
    ParetoSchema,
    /// The JSON Schema of `batch --report`, on standard output
    BatchSchema,
    /// The JSON Schema of `diff --json`, on standard output
    DiffSchema,
}

impl Generate {
    pub(super) fn run(self) -> Result<(), Failure> {
        match self.what {
            What::Man { output } => man_pages(&output),
            What::Completions { shell } => {
                let mut text = Vec::new();
                clap_complete::generate(shell, &mut CommandLine::command(), "nearfield", &mut text);
                print(&String::from_utf8_lossy(&text))
            }
            What::ReportSchema => print(&to_json(&schemars::schema_for!(BakeReport))),
            What::ParetoSchema => print(&to_json(&schemars::schema_for!(ParetoReport))),
            What::BatchSchema => print(&to_json(&schemars::schema_for!(BatchReport))),
            What::DiffSchema => print(&to_json(&schemars::schema_for!(DiffReport))),
        }
    }
}

fn man_pages(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| files::not_written(folder, &error))?;

    let program = CommandLine::command().name("nearfield").disable_help_subcommand(true);
    clap_mangen::generate_to(program, folder).map_err(|error| files::not_written(folder, &error))
}
