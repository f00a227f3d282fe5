//! Arguments that several commands share, and the checks of their values.

use super::exit_code::Failure;
use super::files;
use clap::{Args, ValueEnum};
use nearfield::Field;
use nearfield_bake::distance::{SignChoice, SignMethod};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::num::NonZeroUsize;
use std::path::Path;
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

/// Which level of detail of a field.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct LevelOfDetail {
    /// Level of detail: 0 is the field itself, 1 the next coarser, and so on
    #[arg(long, value_name = "K", default_value_t = 0)]
    lod: usize,
}

impl LevelOfDetail {
    /// That level of the field in these bytes, everything about them checked.
    pub(super) fn open<'a>(self, bytes: &'a [u8], path: &Path) -> Result<Field<'a>, Failure> {
        let field = files::open_field(bytes, path)?;
        field.lod(self.lod).ok_or_else(|| {
            let (path, coarsest) = (path.display(), field.lod_count() - 1);
            Failure::Usage(match coarsest {
                0 => format!("{path} has no levels of detail: leave --lod away, or bake it with --lods"),
                _ => format!("{path} has no level of detail {}: its coarsest is {coarsest}", self.lod),
            })
        })
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
        if self.thickness.is_some() && !matches!(self.sign, Sign::Sheet) {
            return Err(Failure::Usage("--thickness goes with --sign sheet".to_owned()));
        }
        Ok(self.sign.choice(self.thickness.unwrap_or_default()))
    }
}

impl Sign {
    /// What it asks for; the thickness is that of sheets, mesh units.
    pub(super) fn choice(self, thickness: f64) -> SignChoice {
        match self {
            Self::Auto => SignChoice::Auto,
            Self::Pseudonormal => SignChoice::Pseudonormal,
            Self::Winding => SignChoice::Winding,
            Self::Rays => SignChoice::Rays,
            Self::Sheet => SignChoice::Sheet { thickness },
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

/// A number of bytes, with K for 1024, M for 1024 K and G for 1024 M.
pub(super) fn bytes(text: &str) -> Result<u64, String> {
    let digits = text.trim_end_matches(|last: char| last.is_ascii_alphabetic());
    let unit = match &text[digits.len()..] {
        "" => Some(1),
        "K" | "k" => Some(1 << 10),
        "M" | "m" => Some(1 << 20),
        "G" | "g" => Some(1 << 30),
        _ => None,
    };
    let number = unit.and_then(|unit: u64| digits.parse::<u64>().ok()?.checked_mul(unit)).filter(|&number| number > 0);
    number.ok_or_else(|| "it must be a number of bytes above 0, as 65536, 64K, 2M or 1G".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_have_units() {
        assert_eq!(["7", "64K", "2m", "3G"].map(bytes), [7, 64 << 10, 2 << 20, 3 << 30].map(Ok));
        for wrong in ["", "0", "K", "1KB", "1.5G", "-1", "99999999999G"] {
            assert!(bytes(wrong).is_err(), "{wrong}");
        }
    }
}
