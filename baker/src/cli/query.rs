//! `nearfield query`: distances at given points.

use super::arguments::Threads;
use super::exit_code::Failure;
use super::files::{self, POINT_BYTES};
use clap::Args;
use nearfield::Field;
use nearfield_bake::output::OutputFile;
use rayon::prelude::*;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};

/// Ask a field for distances
///
/// With --points, reads little-endian f32 triples (x, y, z) without a header, and writes one f32
/// distance a point, or four f32 (distance, then gradient) with --gradient. Without --points, reads
/// lines of text "x y z" from standard input and writes lines of text. Distances are in mesh units,
/// negative inside.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  echo 0 0 0 | nearfield query spot.nfd
  nearfield query spot.nfd --points points.f32 -o distances.f32
  make-points | nearfield query spot.nfd --points - -o - --gradient | use-them")]
pub(super) struct Query {
    /// The field
    field: PathBuf,

    /// Binary points; `-` is standard input
    #[arg(long, value_name = "POINTS")]
    points: Option<PathBuf>,

    /// Where the answers go; `-`, the default, is standard output
    #[arg(short, long, value_name = "ANSWERS", default_value = "-")]
    output: PathBuf,

    /// Answer with the gradient as well
    #[arg(long)]
    gradient: bool,

    #[command(flatten)]
    threads: Threads,
}

/// Points read, answered and written at a time: memory stays small whatever the input's length.
const BLOCK: usize = 1 << 16;

impl Query {
    pub(super) fn run(self) -> Result<(), Failure> {
        let to_stdout = files::is_standard_stream(&self.output);
        if self.points.is_some() && to_stdout && io::stdout().is_terminal() {
            return Err(Failure::Usage(
                "binary answers do not go to a terminal: name a file with -o, or use a pipe".to_owned(),
            ));
        }
        let bytes = files::read_bytes(&self.field)?;
        let field = files::open_field(&bytes, &self.field)?;
        files::check_output(&self.output, &self.field)?;

        self.threads.run(|| {
            if to_stdout {
                let mut answers = BufWriter::new(io::stdout());
                match self.answer(&field, &mut answers) {
                    // A reader that has seen enough (`| head`) is no failure.
                    Err(Stop::Closed) => Ok(()),
                    outcome => outcome.map_err(Stop::into_failure),
                }
            } else {
                let not_written = |error| files::not_written(&self.output, &error);
                let mut answers = BufWriter::new(OutputFile::create(&self.output).map_err(not_written)?);
                self.answer(&field, &mut answers).map_err(Stop::into_failure)?;
                let complete = answers.into_inner().map_err(|error| not_written(error.into_error()))?;
                complete.commit().map_err(not_written)
            }
        })
    }

    fn answer(&self, field: &Field<'_>, answers: &mut impl Write) -> Result<(), Stop> {
        match &self.points {
            Some(path) => self.answer_binary(field, path, answers),
            None => self.answer_text(field, answers),
        }
    }

    fn answer_binary(&self, field: &Field<'_>, path: &Path, answers: &mut impl Write) -> Result<(), Stop> {
        let unreadable = |error| Stop::Failed(Failure::Input(format!("{} cannot be read: {error}", path.display())));
        let mut source: Box<dyn Read> = if files::is_standard_stream(path) {
            Box::new(io::stdin())
        } else {
            Box::new(File::open(path).map_err(unreadable)?)
        };
        let mut block = Vec::with_capacity(BLOCK * POINT_BYTES);

        loop {
            block.clear();
            let length = (BLOCK * POINT_BYTES) as u64;
            source.by_ref().take(length).read_to_end(&mut block).map_err(unreadable)?;
            let (points, rest) = block.as_chunks::<POINT_BYTES>();
            if !rest.is_empty() {
                return Err(Stop::Failed(files::ends_within_a_point(path)));
            }
            if points.is_empty() {
                return self.flush(answers);
            }

            let points: Vec<[f32; 3]> = points.iter().map(files::point_of_bytes).collect();
            let encoded: Vec<u8> = if self.gradient {
                answers_with_gradients(field, &points)
                    .into_iter()
                    .flat_map(|(distance, [x, y, z])| [distance, x, y, z])
                    .flat_map(f32::to_le_bytes)
                    .collect()
            } else {
                answers_without_gradients(field, &points).into_iter().flat_map(f32::to_le_bytes).collect()
            };
            self.write(answers, &encoded)?;
        }
    }

    fn answer_text(&self, field: &Field<'_>, answers: &mut impl Write) -> Result<(), Stop> {
        let mut line = String::new();
        let mut number = 0u64;
        let mut source = BufReader::new(io::stdin());

        loop {
            line.clear();
            number += 1;
            let length = source
                .read_line(&mut line)
                .map_err(|error| Stop::Failed(Failure::Input(format!("standard input, line {number}: {error}"))))?;
            if length == 0 {
                return self.flush(answers);
            }
            if line.trim().is_empty() {
                continue;
            }

            let point = point_of_text(&line).ok_or_else(|| {
                let sentence = format!("standard input, line {number}: expected three numbers \"x y z\"");
                Stop::Failed(Failure::Input(sentence))
            })?;
            let mut answer = String::new();
            let written = if self.gradient {
                let (distance, [x, y, z]) = field.distance_and_gradient(point);
                writeln!(answer, "{distance} {x} {y} {z}")
            } else {
                writeln!(answer, "{}", field.distance(point))
            };
            written.expect("memory takes every write");
            self.write(answers, answer.as_bytes())?;
        }
    }

    fn write(&self, answers: &mut impl Write, bytes: &[u8]) -> Result<(), Stop> {
        answers.write_all(bytes).map_err(|error| self.stop(&error))
    }

    fn flush(&self, answers: &mut impl Write) -> Result<(), Stop> {
        answers.flush().map_err(|error| self.stop(&error))
    }

    fn stop(&self, error: &io::Error) -> Stop {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Stop::Closed,
            _ => Stop::Failed(files::not_written(&self.output, error)),
        }
    }
}

/// Why the answers end early.
enum Stop {
    /// Whoever reads them has left.
    Closed,
    Failed(Failure),
}

impl Stop {
    fn into_failure(self) -> Failure {
        match self {
            Self::Closed => {
                Failure::Output("the answers were not written: their reader has closed the pipe".to_owned())
            }
            Self::Failed(failure) => failure,
        }
    }
}

/// Points a thread answers at a time.
const BATCH: usize = 1 << 10;

fn answers_without_gradients(field: &Field<'_>, points: &[[f32; 3]]) -> Vec<f32> {
    let mut distances = vec![0.0; points.len()];
    points.par_chunks(BATCH).zip(distances.par_chunks_mut(BATCH)).for_each(|(points, distances)| {
        field.distances(points, distances);
    });
    distances
}

fn answers_with_gradients(field: &Field<'_>, points: &[[f32; 3]]) -> Vec<(f32, [f32; 3])> {
    points.par_iter().with_min_len(BATCH).map(|&point| field.distance_and_gradient(point)).collect()
}

fn point_of_text(line: &str) -> Option<[f32; 3]> {
    let mut words = line.split_ascii_whitespace();
    let mut coordinate = || words.next()?.parse().ok();
    let point = [coordinate()?, coordinate()?, coordinate()?];
    words.next().is_none().then_some(point)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_three_numbers() {
        assert_eq!(point_of_text(" 1 -2.5\t3e2 \n"), Some([1.0, -2.5, 300.0]));
        for wrong in ["1 2", "1 2 3 4", "1 2 x", "1,2,3"] {
            assert_eq!(point_of_text(wrong), None, "{wrong}");
        }
    }
}
