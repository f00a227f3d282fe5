//! Arguments that several commands share, and the checks of their values.

use super::exit_code::Failure;
use clap::{Args, ValueEnum};
use nearfield_bake::distance::{SignChoice, SignMethod};
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
    /// What suits the mesh: the summary says which and why
    Auto,
    /// Angle-weighted pseudonormals: exact on closed surfaces that cross themselves nowhere
    Pseudonormal,
    /// Generalized winding numbers: for open, overlapping and self-intersecting meshes
    Winding,
    /// Rays that vote: for triangles that face all ways
    Rays,
    /// No inside: leaves, cloth and paper as thick as --thickness
    Sheet,
}

/// Where the sign comes from, and what that needs.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct SignArguments {
    /// Where the sign comes from
    #[arg(long, value_enum, value_name = "S", default_value_t = Sign::Auto)]
    sign: Sign,

    /// How thick a sheet is, mesh units: the field is the unsigned distance less half of it
    #[arg(long, value_name = "T", value_parser = not_negative, required_if_eq("sign", "sheet"))]
    thickness: Option<f64>,
}

impl SignArguments {
    pub(super) fn choice(self) -> Result<SignChoice, Failure> {
        match (self.sign, self.thickness) {
            (Sign::Sheet, thickness) => Ok(SignChoice::Sheet { thickness: thickness.unwrap_or_default() }),
            (_, Some(_)) => Err(Failure::Usage("--thickness goes with --sign sheet".to_owned())),
            (Sign::Auto, None) => Ok(SignChoice::Auto),
            (Sign::Pseudonormal, None) => Ok(SignChoice::Pseudonormal),
            (Sign::Winding, None) => Ok(SignChoice::Winding),
            (Sign::Rays, None) => Ok(SignChoice::Rays),
        }
    }
}

/// The method that a file's header names; sheets need the thickness, which no header holds.
pub(super) fn method_of(header: nearfield::SignMethod, thickness: f64) -> SignMethod {
    match header {
        nearfield::SignMethod::Winding => SignMethod::Winding,
        nearfield::SignMethod::Rays => SignMethod::Rays,
        nearfield::SignMethod::Sheet => SignMethod::Sheet { thickness },
        _ => SignMethod::Pseudonormal,
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
