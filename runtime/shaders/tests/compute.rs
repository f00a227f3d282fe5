//! The compute shader answers as the reader of the processor does: at every valid vector of the format and at baked fields,
//! about a million points in all.

mod fields;
#[path = "../examples/gpu/mod.rs"]
mod gpu;
mod querier;
mod tolerance;

use fields::Sample;
use gpu::Gpu;
use nearfield::{Field, Interpolant, Reconstruction};
use querier::Querier;
use tolerance::Tolerances;

/// Points at each field, those of the vectors' own answers not counted.
const POINTS: u32 = 10_000;

#[test]
fn vectors_answer_alike() {
    let Some(gpu) = Gpu::open() else { return };
    let querier = Querier::new(&gpu);
    let mut tally = Tally::default();
    for (sample, own) in fields::vectors() {
        compare(&querier, &sample, &[points(&sample, POINTS), own].concat(), &mut tally);
    }
    tally.print(&gpu.name);
    assert!(tally.points > 500_000, "only {} points", tally.points);
}

#[test]
fn baked_fields_answer_alike() {
    let (Some(gpu), Some(baker)) = (Gpu::open(), fields::baker()) else { return };
    let querier = Querier::new(&gpu);
    let folder = tempfile::tempdir().expect("a folder");
    let mut tally = Tally::default();
    for (name, arguments) in [
        ("default", &["--error", "2e-3"][..]),
        ("discontinuous", &["--error", "2e-3", "--continuity", "none"]),
        ("octree", &["--error", "2e-3", "--interpolant", "tricubic", "--layout", "octree"]),
        ("grid", &["--layout", "grid", "--resolution", "32", "--reconstruction", "half"]),
    ] {
        let sample = fields::sample(&fields::bake(&baker, folder.path(), name, arguments));
        compare(&querier, &sample, &points(&sample, 4 * POINTS), &mut tally);
    }
    tally.print(&gpu.name);
}

/// Points in the box, on its faces and around it, the same at every run.
fn points(sample: &Sample, count: u32) -> Vec<[f32; 3]> {
    let bounds = Field::open(&sample.bytes).expect("a field").header().bounds;
    let mut state = 1_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 24) as f32
    };
    let mut point = |index: u32| {
        [0, 1, 2].map(|axis| {
            let (low, high) = (bounds.min[axis], bounds.max[axis]);
            let share = match index % 10 {
                // Up to half the box away from it.
                0 => 2.0 * random() - 0.5,
                // Lattice planes, and the faces of the box.
                1 => (random() * 16.0).round() / 16.0,
                _ => random(),
            };
            low + share * (high - low)
        })
    };
    (0..count).map(&mut point).collect()
}

/// What has been compared, and how far answers differ at most, by what they may.
#[derive(Default)]
struct Tally {
    fields: usize,
    points: usize,
    equal: usize,
    distance: f64,
    gradient: f64,
}

impl Tally {
    fn print(&self, device: &str) {
        let Self { fields, points, equal, distance, gradient } = self;
        let share = 100.0 * *equal as f64 / *points as f64;
        println!("{device}: {points} points of {fields} fields, distances with equal bits {share:.1} %");
        println!("largest difference, by what is tolerated: distance {distance:.3}, gradient {gradient:.3}");
    }
}

fn compare(querier: &Querier<'_>, sample: &Sample, points: &[[f32; 3]], tally: &mut Tally) {
    let field = Field::open(&sample.bytes).expect("a field");
    let is_exact = querier.is_software() && has_plain_weights(&field);
    let tolerances = Tolerances::of(field);
    tally.fields += 1;
    for (&point, [distance, gradient @ ..]) in points.iter().zip(querier.answers(&sample.bytes, points)) {
        let (expected, slope) = field.distance_and_gradient(point);
        let place = format!("{} at {point:?}: {distance} {gradient:?}, not {expected} {slope:?}", sample.name);
        tally.points += 1;
        if distance.to_bits() == expected.to_bits() || distance.is_nan() && expected.is_nan() {
            tally.equal += 1;
        } else {
            assert!(!is_exact, "bits of the distance: {place}");
        }
        if point.iter().any(|coordinate| !coordinate.is_finite()) {
            let same = |a: f32, b: f32| a == b || a.is_nan() && b.is_nan();
            assert!(same(distance, expected), "{place}");
            assert!(gradient.iter().zip(slope).all(|(&a, b)| same(a, b) || (a - b).abs() < 1e-6), "{place}");
            continue;
        }

        let tolerance = tolerances.at(point);
        let off = f64::from((distance - expected).abs()) / f64::from(tolerance.distance);
        assert!(off <= 1.0, "distance off by {off} of what is tolerated: {place}");
        tally.distance = tally.distance.max(off);
        for (part, expected) in gradient.into_iter().zip(slope) {
            let off = f64::from((part - expected).abs()) / f64::from(tolerance.gradient);
            assert!(off <= 1.0, "gradient off by {off} of what is tolerated: {place}");
            tally.gradient = tally.gradient.max(off);
        }
    }
}

/// Whether a field weights its corners by nothing but products of 1 - t and t or of smooth steps: the driver of software
/// then does not change the order of its sums. Between samples of first order the reader and the shaders add up in orders of
/// their own, as the format leaves them to (SPEC.md §11.4).
fn has_plain_weights(field: &Field<'_>) -> bool {
    match (field.grid(), field.octree()) {
        (Some(grid), _) => grid.reconstruction() != Reconstruction::Hermite && grid.order() != 1,
        (_, Some(octree)) => octree.interpolant() == Interpolant::Trilinear,
        _ => false,
    }
}
