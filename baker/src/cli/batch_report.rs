//! What a batch tells: a line a mesh, a summary, a report for programs.

use super::exit_code::Failure;
use nearfield_bake::batch::{Asset, Reason};
use schemars::JsonSchema;
use serde::Serialize;
use std::time::Duration;

/// Version of the report's names and meanings.
const SCHEMA: u32 = 1;

/// What became of one mesh.
pub(super) struct Outcome {
    pub(super) asset: Asset,
    pub(super) verdict: Verdict,
    pub(super) elapsed: Duration,
}

pub(super) enum Verdict {
    UpToDate,
    Copied(Reason),
    Baked { reason: Reason, bytes: usize },
    WouldCopy(Reason),
    WouldBake(Reason),
    NotStarted,
    Failed(Failure),
}

impl Verdict {
    /// One word for the terminal and for programs.
    fn word(&self) -> &'static str {
        match self {
            Self::UpToDate => "unchanged",
            Self::Copied(_) => "copied",
            Self::Baked { .. } => "baked",
            Self::WouldCopy(_) => "would-copy",
            Self::WouldBake(_) => "would-bake",
            Self::NotStarted => "not-started",
            Self::Failed(_) => "failed",
        }
    }

    fn reason(&self) -> Option<String> {
        match self {
            Self::UpToDate => None,
            Self::Copied(reason) | Self::WouldCopy(reason) | Self::WouldBake(reason) => Some(reason.to_string()),
            Self::Baked { reason, .. } => Some(reason.to_string()),
            Self::NotStarted => Some("others failed".to_owned()),
            Self::Failed(failure) => Some(failure.to_string()),
        }
    }
}

impl Outcome {
    /// `baked        fields/spot.nfd (the mesh changed), 910048 bytes, 1.31 s`
    pub(super) fn line(&self) -> String {
        let why = match (&self.verdict, self.verdict.reason()) {
            (Verdict::UpToDate, _) => " (mesh, settings and baker are as they were)".to_owned(),
            (Verdict::Copied(_) | Verdict::WouldCopy(_), Some(reason)) => format!(" ({reason}; from the cache)"),
            (_, Some(reason)) => format!(" ({reason})"),
            (_, None) => String::new(),
        };
        let cost = match self.verdict {
            Verdict::Baked { bytes, .. } => format!(", {bytes} bytes, {:.2} s", self.elapsed.as_secs_f64()),
            _ => String::new(),
        };
        let mut text = format!("{:<12} {}{why}{cost}\n", self.verdict.word(), self.asset.field.display());
        if let Verdict::WouldBake(_) = self.verdict {
            // As one would type it.
            let (mesh, field) = (self.asset.mesh.display(), self.asset.field.display());
            text += &format!("             nearfield bake {mesh} -o {field} {}\n", self.asset.flags.join(" "));
        }
        text
    }
}

/// How many of each.
pub(super) fn summary(outcomes: &[Outcome]) -> String {
    let words = ["baked", "copied", "unchanged", "would-bake", "would-copy", "failed", "not-started"];
    let counts = words.map(|word| (word, outcomes.iter().filter(|outcome| outcome.verdict.word() == word).count()));
    let counts: Vec<String> =
        counts.iter().filter(|(_, count)| *count > 0).map(|(word, count)| format!("{count} {word}")).collect();
    format!(
        "{} meshes: {}\n",
        outcomes.len(),
        if counts.is_empty() { "nothing to do".to_owned() } else { counts.join(", ") }
    )
}

#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct BatchReport {
    /// Version of the names and their meanings: 1.
    schema: u32,
    /// In the order of the manifest.
    assets: Vec<AssetReport>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct AssetReport {
    /// Path of the mesh.
    mesh: String,
    /// Path of the field.
    field: String,
    /// The settings, as flags of `nearfield bake`.
    flags: Vec<String>,
    /// baked, copied, unchanged, failed, not-started, would-bake or would-copy.
    verdict: &'static str,
    /// Why, or what went wrong.
    reason: Option<String>,
    /// 0, or the exit code that `nearfield bake` would have ended with.
    exit_code: u8,
    /// Time that it took.
    wall_seconds: f64,
}

impl BatchReport {
    pub(super) fn of(outcomes: &[Outcome]) -> Self {
        let assets = outcomes.iter().map(|outcome| AssetReport {
            mesh: outcome.asset.mesh.display().to_string(),
            field: outcome.asset.field.display().to_string(),
            flags: outcome.asset.flags.clone(),
            verdict: outcome.verdict.word(),
            reason: outcome.verdict.reason(),
            exit_code: match &outcome.verdict {
                Verdict::Failed(failure) => failure.code(),
                _ => 0,
            },
            wall_seconds: outcome.elapsed.as_secs_f64(),
        });
        Self { schema: SCHEMA, assets: assets.collect() }
    }
}
