//! Arguments to a request, a request to its run, a failure to its exit code.

mod arguments;
mod bake;
mod bake_report;
mod batch;
mod batch_report;
mod bench;
mod camera_arguments;
mod closest_point;
mod diff;
mod error_table;
mod exit_code;
mod files;
mod generate;
mod grid_arguments;
mod info;
mod inspect;
mod mesh;
mod mesh_arguments;
mod pareto_report;
mod progress_bar;
mod query;
mod questions;
mod raycast;
mod render;
mod slice;
mod verify;
mod view;

use clap::{Parser, Subcommand};
use exit_code::Failure;
use std::io::{self, Write};
use std::process::ExitCode;

/// Signed distance fields that ship: bakes a triangle mesh into one small file, and answers from it.
#[derive(Debug, Parser)]
#[command(version, after_help = exit_code::HELP)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Bake(bake::Bake),
    Batch(batch::Batch),
    Info(info::Info),
    Inspect(inspect::Inspect),
    Query(query::Query),
    Raycast(raycast::Raycast),
    ClosestPoint(closest_point::ClosestPoint),
    Verify(verify::Verify),
    Diff(diff::Diff),
    Slice(slice::SliceCommand),
    Render(render::RenderCommand),
    View(view::ViewCommand),
    Mesh(mesh::MeshCommand),
    Bench(bench::Bench),
    Generate(generate::Generate),
}

/// Runs the command line of this process.
pub(crate) fn run() -> ExitCode {
    // Usage errors that the parser sees itself leave here, with the same code as ours.
    let outcome = match CommandLine::parse().command {
        Command::Bake(command) => command.run(),
        Command::Batch(command) => command.run(),
        Command::Info(command) => command.run(),
        Command::Inspect(command) => command.run(),
        Command::Query(command) => command.run(),
        Command::Raycast(command) => command.run(),
        Command::ClosestPoint(command) => command.run(),
        Command::Verify(command) => command.run(),
        Command::Slice(command) => command.run(),
        Command::Bench(command) => command.run(),
        Command::Diff(command) => command.run(),
        Command::Render(command) => command.run(),
        Command::View(command) => command.run(),
        Command::Mesh(command) => command.run(),
        Command::Generate(command) => command.run(),
    };

    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            tell(&format!("error: {failure}\n"));
            failure.exit_code()
        }
    }
}

/// Writes to standard output. A reader that has seen enough (`| head`) is no failure.
fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::Output(format!("standard output could not be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Writes to standard error. When this fails too, nobody is left to tell.
fn tell(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

/// The JSON text of a report, ending in a line break.
fn to_json(report: &impl serde::Serialize) -> String {
    let mut text = serde_json::to_string_pretty(report).expect("a report has string keys and finite numbers");
    text.push('\n');
    text
}
