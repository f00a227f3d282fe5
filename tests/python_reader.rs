use crate::support::numbers::Numbers;
use crate::vectors::samples::Random;
use crate::vectors::{folder, manifest, names, read};
use glam::DVec3;
use nearfield::{Family, Field};
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Layout, Settings, Target};
use nearfield_fuzz::structure::{Choices, mutate, repair};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Runs the reference reader; none without Python, which is a failure in CI.
fn run(arguments: &[&str], files: &[PathBuf]) -> Option<String> {
    let script = folder("../reference_reader.py");
    let output = match Command::new("python3").arg(script).args(arguments).args(files).output() {
        Ok(output) => output,
        Err(error) => {
            assert_ne!(std::env::var("CI").as_deref(), Ok("true"), "python3 cannot run: {error}");
            // Written past the harness, which hides what passing tests print.
            let _written = writeln!(std::io::stderr(), "SKIPPED: python3 cannot run: {error}");
            return None;
        }
    };
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).expect("text"))
}

/// What the reference reader says of each file.
fn verdicts(files: &[PathBuf]) -> Option<Vec<String>> {
    let text = run(&["check"], files)?;
    let verdicts: Vec<String> = text.lines().map(|line| line.split(' ').next().unwrap_or("").to_owned()).collect();
    assert_eq!(verdicts.len(), files.len(), "one verdict a file");
    Some(verdicts)
}

fn paths(kind: &str) -> Vec<PathBuf> {
    names(&folder(kind)).iter().map(|name| folder(kind).join(name).with_extension("nfd")).collect()
}

#[test]
fn valid_vectors_are_accepted_and_answered_as_stored() {
    let files = paths("valid");
    let Some(verdicts) = verdicts(&files) else { return };
    for (file, verdict) in files.iter().zip(verdicts) {
        assert_eq!(verdict, "valid", "{}", file.display());
    }

    let answers = run(&["expect"], &files).expect("python3 ran before");
    let mut lines = answers.lines();
    for file in files {
        let stored = fs::read_to_string(file.with_extension("json")).expect("answers");
        for line in stored.lines() {
            assert_eq!(lines.next(), Some(line), "{} is not answered as stored", file.display());
        }
    }
    assert_eq!(lines.next(), None, "answers of no file");
}

#[test]
fn invalid_vectors_are_refused_for_their_reason() {
    let files = paths("invalid");
    let Some(verdicts) = verdicts(&files) else { return };
    for (verdict, (name, error)) in verdicts.into_iter().zip(manifest()) {
        assert_eq!(verdict, error, "{name}");
    }
}

/// A baked field, with implied and full samples.
#[test]
fn a_baked_field_is_answered_alike() {
    let mesh = crate::shapes::read("bob_small.ply");
    let settings = Settings {
        error: Target::Relative(4e-3),
        max_depth: 7,
        samples: 1000,
        layout: Layout::Octree,
        ..Settings::default()
    };
    let bytes = bake(&mesh, &settings, &Silent).expect("the mesh bakes").bytes;
    agree_on(&bytes, 500);
}

/// Fields with right checksums and one wrong word, or a few: what one reader accepts the other does, and answers alike.
/// With `NEARFIELD_CORPUS`, also every file of that folder.
#[test]
fn damaged_fields_are_judged_alike() {
    let scratch = tempfile::tempdir().expect("a folder");
    let mut files = Vec::new();
    for (index, name) in names(&folder("valid")).iter().enumerate() {
        let bytes = read(&folder("valid"), name);
        let mut choices = Choices::new(index as u32 + 1);
        for copy in 0..8 {
            let mut damaged = [&bytes[..], &[0; 64]].concat();
            let mut length = bytes.len();
            for _ in 0..1 + copy % 3 {
                length = mutate(&mut damaged, length, &mut choices);
            }
            damaged.truncate(length);
            repair(&mut damaged);
            files.push(scratch.path().join(format!("{name}-{copy}.nfd")));
            fs::write(&files[files.len() - 1], damaged).expect("written");
        }
    }
    if let Some(corpus) = std::env::var_os("NEARFIELD_CORPUS") {
        let entries = fs::read_dir(corpus).expect("a folder of fields");
        files.extend(entries.map(|entry| entry.expect("an entry").path()));
    }

    let Some(verdicts) = verdicts(&files) else { return };
    let mut valid = 0;
    for (file, verdict) in files.iter().zip(verdicts) {
        let bytes = fs::read(file).expect("a file");
        let accepted = Field::open(&bytes).and_then(|field| field.validate());
        assert_eq!(accepted.is_ok(), verdict == "valid", "{}: {accepted:?} against {verdict}", file.display());
        if accepted.is_ok() {
            valid += 1;
            if valid % 8 == 0 {
                agree_on(&bytes, 20);
            }
        }
    }
    assert!(valid > 50 && files.len() - valid > 50, "{valid} of {} are valid", files.len());
}

/// Both readers at random points of a valid field's box and around it.
fn agree_on(bytes: &[u8], count: usize) {
    let field = Field::open(bytes).expect("a field");
    let bounds = field.header().bounds;
    let [min, max] = [bounds.min, bounds.max].map(|corner| DVec3::from(corner.map(f64::from)));
    let (mut numbers, mut random) = (Numbers::new(7), Random::new(7));
    let mut point = || {
        let margin = if random.word() % 8 == 0 { 1.0 } else { 0.0 };
        let beyond = margin * (max - min);
        numbers.point(min - beyond, max + beyond).as_vec3().to_array()
    };
    let points: Vec<[f32; 3]> = (0..count).map(|_| point()).collect();

    let scratch = tempfile::tempdir().expect("a folder");
    let [field_path, points_path, out_path] =
        ["field.nfd", "points.f32", "out.f32"].map(|name| scratch.path().join(name));
    fs::write(&field_path, bytes).expect("written");
    let words: Vec<u8> = points.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
    fs::write(&points_path, words).expect("written");
    if run(&["query"], &[field_path, points_path, out_path.clone()]).is_none() {
        return;
    }

    let answers = read_floats(&out_path);
    assert_eq!(answers.len(), 6 * count, "an answer a point");
    let is_octree = field.header().family == Family::Octree;
    for (&point, answer) in points.iter().zip(answers.as_chunks::<6>().0) {
        let (distance, gradient) = field.distance_and_gradient(point);
        let is_inside = (0..3).all(|axis| (bounds.min[axis]..=bounds.max[axis]).contains(&point[axis]));
        let [expected, x, y, z, tolerance, gradient_tolerance] = *answer;
        let close = |a: f32, b: f32, tolerance: f32| (a - b).abs() <= tolerance;
        if is_octree && is_inside {
            assert_eq!(distance.to_bits(), expected.to_bits(), "at {point:?}");
            assert_eq!(gradient.map(f32::to_bits), [x, y, z].map(f32::to_bits), "gradient at {point:?}");
        } else if is_octree {
            // Only the length of the way to the box may be rounded differently.
            let at = DVec3::from(point.map(f64::from));
            let nearest = at.clamp(min, max);
            let scale = field.distance(nearest.as_vec3().to_array()).abs() + at.distance(nearest) as f32;
            let rounding = 4.0 * f32::EPSILON;
            assert!(close(distance, expected, rounding * scale), "{distance} and {expected} at {point:?}");
            assert!(gradient.iter().zip([x, y, z]).all(|(&a, b)| close(a, b, rounding)), "gradient at {point:?}");
        } else {
            assert!(close(distance, expected, tolerance), "{distance} and {expected} ± {tolerance} at {point:?}");
            let is_close = gradient.iter().zip([x, y, z]).all(|(&a, b)| close(a, b, gradient_tolerance));
            assert!(is_close, "{gradient:?} and {:?} ± {gradient_tolerance} at {point:?}", [x, y, z]);
        }
    }
}

fn read_floats(path: &Path) -> Vec<f32> {
    let bytes = fs::read(path).expect("answers");
    bytes.as_chunks::<4>().0.iter().map(|word| f32::from_le_bytes(*word)).collect()
}
