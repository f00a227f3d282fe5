use crate::support::numbers::Numbers;
use crate::vectors::{folder, manifest, names, read};
use glam::{DVec3, Vec3};
use nearfield::{Aabb, Error, Family, Field};
use serde::Deserialize;

/// An answer as stored beside a vector: what JSON cannot say is a string.
#[derive(Deserialize)]
struct Answer {
    point: [Number; 3],
    distance: Number,
    gradient: [Number; 3],
    distance_tolerance: f64,
    gradient_tolerance: f64,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Number {
    Finite(f32),
    Other(String),
}

impl Number {
    fn value(&self) -> f32 {
        match self {
            Self::Finite(number) => *number,
            Self::Other(name) => name.parse().expect("nan, inf or -inf"),
        }
    }
}

fn answers(name: &str) -> Vec<Answer> {
    let path = folder("valid").join(name).with_extension("json");
    let text = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_slice(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn check(bytes: &[u8]) -> Result<(), Error> {
    Field::open(bytes)?.validate()
}

#[test]
fn valid_vectors_are_accepted() {
    for name in names(&folder("valid")) {
        assert_eq!(check(&read(&folder("valid"), &name)), Ok(()), "{name}");
    }
}

/// A weight that is held between 0 and 1 before its slope is known has a slope of exactly 0 beyond its support.
#[test]
fn at_the_edge_of_a_support_the_gradient_is_that_of_the_other_leaves() {
    let bytes = read(&folder("valid"), "polynomial_unused_shape.nfd");
    let field = Field::open(&bytes).expect("a field");
    // Both from the reference reader.
    let (distance, gradient) = field.distance_and_gradient([1.800038, 3.8271208, 4.2475243]);
    assert_close(distance, 1.035_415_9, 5.2e-5, "distance");
    for (component, expected) in gradient.into_iter().zip([-0.882_982_25, -0.112_343_04, -0.454_400_4]) {
        assert_close(component, expected, 1e-3, "gradient");
    }
}

#[test]
fn valid_vectors_answer_as_expected() {
    for name in names(&folder("valid")) {
        let bytes = read(&folder("valid"), &name);
        let field = Field::open(&bytes).expect("a field");
        let answers = answers(&name);
        assert!(answers.len() >= 40, "{name} has {} answers", answers.len());
        for answer in answers {
            let point = answer.point.each_ref().map(Number::value);
            let (distance, gradient) = field.distance_and_gradient(point);
            let place = format!("{name} at {point:?}");
            assert_close(distance, answer.distance.value(), answer.distance_tolerance, &place);
            for (component, expected) in gradient.into_iter().zip(answer.gradient) {
                assert_close(component, expected.value(), answer.gradient_tolerance, &place);
            }

            // What the specification defines to the bit, as it does of octrees, this reader gives to the bit.
            let bounds = field.header().bounds;
            let is_octree = field.header().family == Family::Octree;
            if is_octree && (0..3).all(|axis| (bounds.min[axis]..=bounds.max[axis]).contains(&point[axis])) {
                assert_eq!(distance.to_bits(), answer.distance.value().to_bits(), "{place}");
            }
        }
    }
}

#[test]
fn a_batch_answers_as_its_points_do_alone() {
    for name in names(&folder("valid")) {
        let bytes = read(&folder("valid"), &name);
        let field = Field::open(&bytes).expect("a field");
        let Aabb { min, max } = field.header().bounds;
        let mut numbers = Numbers::new(3);
        // Points of a row after those of the vector: some leaves hold several, and some are outside.
        let mut points: Vec<[f32; 3]> =
            answers(&name).iter().map(|answer| answer.point.each_ref().map(Number::value)).collect();
        for _ in 0..7 {
            let (start, end) =
                (numbers.point(DVec3::ZERO, DVec3::ONE), numbers.point(DVec3::splat(-0.2), DVec3::splat(1.2)));
            let part = |step: i32| (start + (end - start) * (f64::from(step) / 30.0)).as_vec3();
            let (min, max) = (Vec3::from(min), Vec3::from(max));
            points.extend((0..=30).map(|step| (min + part(step) * (max - min)).to_array()));
        }
        for count in [points.len(), 33, 16, 15, 1] {
            let points = &points[points.len() - count..];
            let (mut alone, mut distances, mut gradients) = (vec![0.0; count], vec![0.0; count], vec![[0.0; 3]; count]);
            assert_eq!(field.distances(points, &mut alone), count);
            assert_eq!(field.distances_and_gradients(points, &mut distances, &mut gradients), count);
            for (index, &point) in points.iter().enumerate() {
                let (distance, gradient) = field.distance_and_gradient(point);
                let place = format!("{name} at {point:?}, of {count}");
                assert_eq!(alone[index].to_bits(), distance.to_bits(), "{place}");
                assert_eq!(distances[index].to_bits(), distance.to_bits(), "{place}");
                assert_eq!(gradients[index].map(f32::to_bits), gradient.map(f32::to_bits), "{place}");
            }
        }
    }
}

fn assert_close(answer: f32, expected: f32, tolerance: f64, place: &str) {
    let is_same = answer == expected || answer.is_nan() && expected.is_nan();
    let is_close = (f64::from(answer) - f64::from(expected)).abs() <= tolerance;
    assert!(is_same || is_close, "{place}: {answer} instead of {expected}");
}

#[test]
fn invalid_vectors_are_refused_for_their_reason() {
    let manifest = manifest();
    for name in names(&folder("invalid")) {
        let error = check(&read(&folder("invalid"), &name)).expect_err(&name);
        assert_eq!(format!("{error:?}"), manifest[&name], "{name}");
    }
}

#[test]
fn every_error_has_a_name_and_a_vector() {
    let specification = include_str!("../format-spec/SPEC.md");
    let manifest = manifest();
    for error in Error::ALL {
        let name = format!("{error:?}");
        assert!(manifest.values().any(|broken| *broken == name), "no vector for {name}");
        assert!(specification.contains(&format!("| `{name}` |")), "§13 does not name {name}");
    }
}

#[test]
fn every_truncation_of_every_vector_is_refused() {
    for name in names(&folder("valid")) {
        let bytes = read(&folder("valid"), &name);
        for length in 0..bytes.len() {
            assert!(Field::open(&bytes[..length]).is_err(), "{length} bytes of {name}");
        }
    }
}
