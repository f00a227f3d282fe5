//! Arguments that several commands share, and the checks of their values.

use super::exit_code::Failure;
use clap::{Args, ValueEnum};
use nearfield_bake::distance::SignChoice;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::num::NonZeroUsize;
use std::str::FromStr;

/// How many threads work.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct Threads {
    /// Threads to use; all of the machine's by default. The result does not depend on it.
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
}

impl Threads {
    /// Runs `work` on that many threads.
    pub(super) fn run<R: Send>(self, work: impl FnOnce() -> Result<R, Failure> + Send) -> Result<R, Failure> {
        self.pool()?.install(work)
    }

    /// That many threads.
    pub(super) fn pool(self) -> Result<ThreadPool, Failure> {
        let threads = self.threads.map_or(0, NonZeroUsize::get);
        ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| Failure::Usage(format!("cannot start {threads} threads ({error}): ask for fewer")))
    }
}

/// Where the sign of the distance comes from.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Sign {
    /// Pseudonormals on closed, consistently wound meshes, winding numbers elsewhere
    Auto,
    /// Angle-weighted pseudonormals: exact on closed, consistently wound meshes
    Pseudonormal,
    /// Generalized winding numbers: for open or overlapping meshes
    Winding,
}

impl From<Sign> for SignChoice {
    fn from(sign: Sign) -> Self {
        match sign {
            Sign::Auto => Self::Auto,
            Sign::Pseudonormal => Self::Pseudonormal,
            Sign::Winding => Self::Winding,
        }
    }
}

/// A finite number above zero.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    match f64::from_str(text) {
        Ok(number) if number.is_finite() && number > 0.0 => Ok(number),
        _ => Err("it must be a number above 0".to_owned()),
    }
}

/// A finite number, zero or more.
pub(super) fn not_negative(text: &str) -> Result<f64, String> {
    match f64::from_str(text) {
        Ok(number) if number.is_finite() && number >= 0.0 => Ok(number),
        _ => Err("it must be a number, 0 or more".to_owned()),
    }
}

/// A number of bytes, with K for 1024 and M for 1024 K.
pub(super) fn bytes(text: &str) -> Result<u64, String> {
    let (digits, unit) = match text.strip_suffix(['K', 'k']) {
        Some(digits) => (digits, 1 << 10),
        None => text.strip_suffix(['M', 'm']).map_or((text, 1), |digits| (digits, 1 << 20)),
    };
    let number = digits.parse::<u64>().ok().and_then(|number| number.checked_mul(unit)).filter(|&number| number > 0);
    number.ok_or_else(|| "it must be a number of bytes above 0, as 65536, 64K or 2M".to_owned())
}
