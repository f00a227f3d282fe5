//! Questions in, answers out: what `query`, `raycast` and `closest-point` have in common.
//!
//! Questions are lines of text on standard input or a file of floats, however long; answers go the same way, or as lines of JSON.

use super::arguments::{LevelOfDetail, Threads};
use super::exit_code::Failure;
use super::files;
use clap::Args;
use nearfield::Field;
use nearfield_bake::output::OutputFile;
use rayon::prelude::*;
use serde::Serialize;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};

/// A kind of question of `NUMBERS` numbers.
pub(super) trait Kind<const NUMBERS: usize>: Sync {
    type Answer: Serialize + Send;
    /// What one question is, and its numbers as they stand in a line.
    const NAME: &'static str;
    const SHAPE: &'static str;

    /// Answers some questions, one after the other.
    fn answers(&self, field: &Field<'_>, questions: &[[f32; NUMBERS]]) -> Vec<Self::Answer>;

    /// Adds an answer to a file of floats.
    fn add_floats(&self, answer: &Self::Answer, floats: &mut Vec<f32>);

    /// An answer in a line of text: unless the kind says otherwise, its floats.
    fn line(&self, answer: &Self::Answer) -> String {
        let mut floats = Vec::new();
        self.add_floats(answer, &mut floats);
        spaced(&floats)
    }
}

/// Where answers go, and how they are written.
#[derive(Debug, Args)]
pub(super) struct Answers {
    /// Where the answers go; `-`, the default, is standard output
    #[arg(short, long, value_name = "ANSWERS", default_value = "-")]
    output: PathBuf,

    /// Answer in JSON, one object a line
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    lod: LevelOfDetail,

    #[command(flatten)]
    threads: Threads,
}

/// Questions read, answered and written at a time: memory stays small whatever the input's length.
const BLOCK: usize = 1 << 16;
/// Questions that a thread answers at a time.
const BATCH: usize = 1 << 10;

/// Answers the questions of a file, or those that stand in lines of standard input.
pub(super) fn answer<const NUMBERS: usize>(
    kind: &impl Kind<NUMBERS>,
    field: &Path,
    questions: Option<&Path>,
    answers: &Answers,
) -> Result<(), Failure> {
    let to_stdout = files::is_standard_stream(&answers.output);
    if questions.is_some() && !answers.json && to_stdout && io::stdout().is_terminal() {
        return Err(Failure::Usage(
            "binary answers do not go to a terminal: name a file with -o, or use a pipe".to_owned(),
        ));
    }
    let bytes = files::read_bytes(field)?;
    let opened = answers.lod.open(&bytes, field)?;
    files::check_output(&answers.output, field)?;

    let conversation = Conversation { kind, field: &opened, json: answers.json, output: &answers.output };
    answers.threads.run(|| {
        if to_stdout {
            match conversation.hold(questions, &mut BufWriter::new(io::stdout())) {
                // A reader that has seen enough (`| head`) is no failure.
                Err(Stop::Closed) => Ok(()),
                outcome => outcome.map_err(Stop::into_failure),
            }
        } else {
            let not_written = |error| files::not_written(&answers.output, &error);
            let mut sink = BufWriter::new(OutputFile::create(&answers.output).map_err(not_written)?);
            conversation.hold(questions, &mut sink).map_err(Stop::into_failure)?;
            let complete = sink.into_inner().map_err(|error| not_written(error.into_error()))?;
            complete.commit().map_err(not_written)
        }
    })
}

struct Conversation<'c, K> {
    kind: &'c K,
    field: &'c Field<'c>,
    json: bool,
    output: &'c Path,
}

impl<K> Conversation<'_, K> {
    fn hold<const NUMBERS: usize>(&self, questions: Option<&Path>, sink: &mut impl Write) -> Result<(), Stop>
    where
        K: Kind<NUMBERS>,
    {
        match questions {
            Some(path) => self.answer_floats(path, sink),
            None => self.answer_lines(sink),
        }?;
        sink.flush().map_err(|error| self.stop(&error))
    }

    fn answer_floats<const NUMBERS: usize>(&self, path: &Path, sink: &mut impl Write) -> Result<(), Stop>
    where
        K: Kind<NUMBERS>,
    {
        let unreadable = |error| Stop::Failed(Failure::Input(format!("{} cannot be read: {error}", path.display())));
        let mut source: Box<dyn Read> = if files::is_standard_stream(path) {
            Box::new(io::stdin())
        } else {
            Box::new(File::open(path).map_err(unreadable)?)
        };
        let length = NUMBERS * size_of::<f32>();
        let mut block = Vec::with_capacity(BLOCK * length);

        loop {
            block.clear();
            source.by_ref().take((BLOCK * length) as u64).read_to_end(&mut block).map_err(unreadable)?;
            let (floats, rest) = block.as_chunks();
            let floats: Vec<f32> = floats.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect();
            let (questions, more) = floats.as_chunks::<NUMBERS>();
            if !rest.is_empty() || !more.is_empty() {
                let (path, name) = (path.display(), K::NAME);
                let sentence = format!(
                    "{path} ends within a {name}: a {name} is {NUMBERS} little-endian f32 ({}), {length} bytes",
                    K::SHAPE
                );
                return Err(Stop::Failed(Failure::Input(sentence)));
            }
            if questions.is_empty() {
                return Ok(());
            }

            let answers = questions.par_chunks(BATCH).map(|questions| self.kind.answers(self.field, questions));
            let encoded: Vec<Vec<u8>> = answers.map(|answers| self.encode(&answers)).collect();
            for encoded in encoded {
                self.write(sink, &encoded)?;
            }
        }
    }

    /// Answers to a file of floats.
    fn encode<const NUMBERS: usize>(&self, answers: &[K::Answer]) -> Vec<u8>
    where
        K: Kind<NUMBERS>,
    {
        if self.json {
            return answers.iter().flat_map(|answer| json_line(answer).into_bytes()).collect();
        }
        let mut floats = Vec::new();
        answers.iter().for_each(|answer| self.kind.add_floats(answer, &mut floats));
        floats.into_iter().flat_map(f32::to_le_bytes).collect()
    }

    fn answer_lines<const NUMBERS: usize>(&self, sink: &mut impl Write) -> Result<(), Stop>
    where
        K: Kind<NUMBERS>,
    {
        let failed = |sentence: String| Stop::Failed(Failure::Input(sentence));
        let mut line = String::new();
        let mut number = 0u64;
        let mut source = BufReader::new(io::stdin());

        loop {
            line.clear();
            number += 1;
            let length = source
                .read_line(&mut line)
                .map_err(|error| failed(format!("standard input, line {number}: {error}")))?;
            if length == 0 {
                return Ok(());
            }
            if line.trim().is_empty() {
                continue;
            }

            let question: [f32; NUMBERS] = question_of_text(&line).ok_or_else(|| {
                failed(format!("standard input, line {number}: expected {NUMBERS} numbers \"{}\"", K::SHAPE))
            })?;
            for answer in self.kind.answers(self.field, &[question]) {
                let answer = if self.json { json_line(&answer) } else { self.kind.line(&answer) + "\n" };
                self.write(sink, answer.as_bytes())?;
            }
        }
    }

    fn write(&self, sink: &mut impl Write, bytes: &[u8]) -> Result<(), Stop> {
        sink.write_all(bytes).map_err(|error| self.stop(&error))
    }

    fn stop(&self, error: &io::Error) -> Stop {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Stop::Closed,
            _ => Stop::Failed(files::not_written(self.output, error)),
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

/// Numbers in a line of text.
pub(super) fn spaced(numbers: &[f32]) -> String {
    numbers.iter().map(f32::to_string).collect::<Vec<_>>().join(" ")
}

/// One answer in JSON. A number that is not finite is null.
fn json_line(answer: &impl Serialize) -> String {
    serde_json::to_string(answer).expect("an answer has string keys") + "\n"
}

fn question_of_text<const NUMBERS: usize>(line: &str) -> Option<[f32; NUMBERS]> {
    let numbers: Option<Vec<f32>> = line.split_ascii_whitespace().map(|word| word.parse().ok()).collect();
    numbers?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_as_many_numbers() {
        assert_eq!(question_of_text(" 1 -2.5\t3e2 \n"), Some([1.0, -2.5, 300.0]));
        for wrong in ["1 2", "1 2 3 4", "1 2 x", "1,2,3"] {
            assert_eq!(question_of_text::<3>(wrong), None, "{wrong}");
        }
    }
}
