//! `nearfield diff`: what changed from one field to another.

use super::arguments::not_negative;
use super::exit_code::Failure;
use super::info::InfoReport;
use super::{files, print, to_json};
use clap::Args;
use nearfield::Field;
use nearfield_bake::verify::{FieldDifference, compare};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;
use std::path::PathBuf;

/// Compare two fields
///
/// Lists what their headers say differently, and how far their distances are apart at random points of
/// the box that they share and near the surface of the first. For the review of assets: what did the
/// new settings change?
#[derive(Debug, Args)]
#[command(after_help = "\
Exit code 1 means that the distances differ by more than the tolerance.

Examples:
  nearfield diff old.nfd new.nfd
  nearfield diff old.nfd new.nfd --tolerance 1e-3
  nearfield diff old.nfd new.nfd --json | jq .near_surface.max")]
pub(super) struct Diff {
    /// The first field
    a: PathBuf,

    /// The second field
    b: PathBuf,

    /// Points in the shared box, and as many near the surface
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), default_value_t = 100_000)]
    samples: u32,

    /// Fail when distances differ by more than this fraction of the first field's diagonal
    #[arg(long, value_name = "E", value_parser = not_negative)]
    tolerance: Option<f64>,

    /// Print a report in JSON; lengths in mesh units
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct DiffReport {
    /// Version of the names and their meanings: 1.
    schema: u32,
    /// Whether the files are the same, byte by byte.
    identical: bool,
    /// What the headers say differently.
    properties: Vec<Property>,
    /// At random points of the box that both cover; absent when the boxes share nothing.
    shared_box: Option<Figures>,
    /// Near the surface of the first.
    near_surface: Option<Figures>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct Property {
    /// Path in the report of `nearfield info --json`, with dots.
    name: String,
    a: Value,
    b: Value,
}

/// Differences of the distances, mesh units.
#[derive(Debug, Serialize, JsonSchema)]
struct Figures {
    /// How many points were compared.
    points: usize,
    /// Root mean square.
    rms: f64,
    /// 99 % quantile of the size.
    p99: f64,
    /// Largest size.
    max: f64,
    /// Mean angle between the gradients.
    gradient_angle_degrees: f64,
    /// Points whose signs differ.
    signs: usize,
}

impl Diff {
    pub(super) fn run(self) -> Result<(), Failure> {
        let (a_bytes, b_bytes) = (files::read_bytes(&self.a)?, files::read_bytes(&self.b)?);
        let (a, b) = (files::open_field(&a_bytes, &self.a)?, files::open_field(&b_bytes, &self.b)?);

        let difference = compare(&a, &b, self.samples);
        let report = DiffReport {
            schema: 1,
            identical: a_bytes == b_bytes,
            properties: properties(&a, &b),
            shared_box: difference.as_ref().map(|difference| Figures::of(&difference.uniform)),
            near_surface: difference.as_ref().map(|difference| Figures::of(&difference.near_surface)),
        };
        let diagonal = f64::from(a.header().diagonal);
        print(&if self.json { to_json(&report) } else { report.text(diagonal) })?;
        self.judge(difference.as_ref(), diagonal)
    }

    fn judge(&self, difference: Option<&FieldDifference>, diagonal: f64) -> Result<(), Failure> {
        let Some(tolerance) = self.tolerance else { return Ok(()) };
        let verdict = match difference {
            None => "their boxes share nothing".to_owned(),
            Some(difference) => {
                let largest = difference.uniform.max().max(difference.near_surface.max()) / diagonal;
                if largest <= tolerance {
                    return Ok(());
                }
                format!("distances differ by up to {largest:.2e} of the diagonal, more than {tolerance:.2e}")
            }
        };
        Err(Failure::Verification(format!("{} and {}: {verdict}", self.a.display(), self.b.display())))
    }
}

impl Figures {
    fn of(errors: &nearfield_bake::verify::ErrorDistribution) -> Self {
        Self {
            points: errors.count(),
            rms: errors.rmse,
            p99: errors.p99(),
            max: errors.max(),
            gradient_angle_degrees: errors.mean_gradient_angle,
            signs: errors.wrong_signs,
        }
    }
}

impl DiffReport {
    fn text(&self, diagonal: f64) -> String {
        if self.identical {
            return "the fields are the same, byte by byte\n".to_owned();
        }
        let mut text = String::new();
        for Property { name, a, b } in &self.properties {
            text += &format!("{name:<26}{a}  ->  {b}\n");
        }
        let (Some(uniform), Some(near)) = (&self.shared_box, &self.near_surface) else {
            return text + "the boxes share nothing\n";
        };
        text += "difference / diagonal    RMS       p99       max  gradient  signs\n";
        for (name, figures) in [("shared box", uniform), ("near surface", near)] {
            let [rms, p99, max] = [figures.rms, figures.p99, figures.max].map(|length| length / diagonal);
            text += &format!(
                "  {name:<16}{rms:>10.2e}{p99:>10.2e}{max:>10.2e}{:>8.2} deg{:>5}\n",
                figures.gradient_angle_degrees, figures.signs
            );
        }
        text
    }
}

/// The leaves of both reports that differ.
fn properties(a: &Field<'_>, b: &Field<'_>) -> Vec<Property> {
    let value = |field: &Field<'_>| serde_json::to_value(InfoReport::of(field)).expect("a report has string keys");
    let mut found = Vec::new();
    collect(String::new(), &value(a), &value(b), &mut found);
    found
}

/// Walks two values of one shape. They are a few levels deep.
fn collect(name: String, a: &Value, b: &Value, found: &mut Vec<Property>) {
    match (a, b) {
        (Value::Object(a), Value::Object(b)) => {
            let mut names: Vec<&String> = a.keys().chain(b.keys()).collect();
            names.sort_unstable();
            names.dedup();
            for key in names {
                let path = if name.is_empty() { key.clone() } else { format!("{name}.{key}") };
                let side = |side: &serde_json::Map<String, Value>| side.get(key).cloned().unwrap_or(Value::Null);
                collect(path, &side(a), &side(b), found);
            }
        }
        _ if a == b => {}
        _ => found.push(Property { name, a: a.clone(), b: b.clone() }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn properties_that_differ_are_named_by_their_path() {
        let (a, b) = (json!({"x": 1, "y": {"z": [1, 2], "w": 0}}), json!({"x": 1, "y": {"z": [1, 3]}}));
        let mut found = Vec::new();
        collect(String::new(), &a, &b, &mut found);
        let names: Vec<&str> = found.iter().map(|property| property.name.as_str()).collect();
        assert_eq!(names, ["y.w", "y.z"]);
    }
}
