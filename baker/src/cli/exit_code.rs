//! One exit code per class of failure.

use std::process::ExitCode;
use thiserror::Error;

/// What `--help` says about exit codes.
pub(super) const HELP: &str = "\
Exit codes:
  0  done
  1  the quality gate or the verification failed
  2  usage
  3  an input cannot be read, or is not a mesh
  4  an output was not written
  5  not a valid field
  6  the budget is impossible";

/// Why a command failed: one sentence that says what, where, and what to do.
#[derive(Debug, Error)]
pub(super) enum Failure {
    /// The field is not what it should be.
    #[error("{0}")]
    Verification(String),
    /// The arguments contradict themselves.
    #[error("{0}")]
    Usage(String),
    /// An input cannot be read, or is not what it should be.
    #[error("{0}")]
    Input(String),
    /// An output was not written.
    #[error("{0}")]
    Output(String),
    /// The bytes are not a field.
    #[error("{0}")]
    Field(String),
    /// Assets of a batch failed; the code is that of the first of them.
    #[error("{message}")]
    Assets {
        /// What to say.
        message: String,
        /// Its code.
        code: u8,
    },
    /// The request does not fit the limits of the format or the machine.
    #[error("{0}")]
    Budget(String),
}

impl Failure {
    pub(super) fn exit_code(&self) -> ExitCode {
        ExitCode::from(self.code())
    }

    /// The number that `--help` lists.
    pub(super) fn code(&self) -> u8 {
        match self {
            Self::Verification(_) => 1,
            Self::Usage(_) => 2,
            Self::Input(_) => 3,
            Self::Output(_) => 4,
            Self::Field(_) => 5,
            Self::Budget(_) => 6,
            Self::Assets { code, .. } => *code,
        }
    }
}
