//! Outside the box, and what is not a point at all.

use super::file::{Random, open, three_levels};

#[test]
fn outside_adds_the_distance_to_the_box() {
    let bytes = three_levels().bytes();
    let field = open(&bytes);
    let bounds = field.header().bounds;

    let face = [bounds.max[0], 2.5, 3.25];
    let (distance, gradient) = field.distance_and_gradient([face[0] + 4.0, face[1], face[2]]);
    assert_eq!(distance, field.distance(face) + 4.0);
    assert_eq!(gradient, [1.0, 0.0, 0.0]);

    let corner = bounds.min;
    let (distance, gradient) = field.distance_and_gradient([corner[0] - 3.0, corner[1] - 4.0, corner[2]]);
    assert!((distance - (field.distance(corner) + 5.0)).abs() < 4e-6);
    assert!((gradient[0] + 0.6).abs() < 1e-6 && (gradient[1] + 0.8).abs() < 1e-6);
    assert_eq!(gradient[2], 0.0);

    let mut random = Random::new(1);
    for _ in 0..1000 {
        let point = random.point().map(|unit| 40.0 * unit - 20.0);
        let (distance, _) = field.distance_and_gradient(point);
        assert_eq!(distance.to_bits(), field.distance(point).to_bits());
        if !field.octree().expect("an octree").lattice.contains(point) {
            let nearest = [0, 1, 2].map(|i| point[i].clamp(bounds.min[i], bounds.max[i]));
            let away: f64 = (0..3).map(|i| f64::from(point[i] - nearest[i]).powi(2)).sum();
            let expected = f64::from(field.distance(nearest)) + away.sqrt();
            assert!((f64::from(distance) - expected).abs() < 4e-7 * away.sqrt() + 2e-6);
        }
    }
}

#[test]
fn every_finite_point_has_a_finite_answer() {
    let bytes = three_levels().bytes();
    let field = open(&bytes);
    let extremes = [0.0, -0.0, 1e-45, -1e-38, 1.0, 3.5, -7.0, 1e19, -1e30, f32::MAX, f32::MIN];
    for x in extremes {
        for y in extremes {
            for z in extremes {
                let (distance, gradient) = field.distance_and_gradient([x, y, z]);
                assert!(distance.is_finite(), "{x} {y} {z}");
                assert!(gradient.iter().all(|component| component.is_finite()), "{x} {y} {z}");
            }
        }
    }
    let far = field.distance([f32::MAX; 3]);
    assert_eq!(far, f32::MAX, "saturated");
    assert_eq!(field.distance_and_gradient([f32::MAX, 2.5, 3.25]).1, [1.0, 0.0, 0.0]);
}

#[test]
fn nan_and_infinity_are_answered_in_kind() {
    let bytes = three_levels().bytes();
    let field = open(&bytes);
    for axis in 0..3 {
        let mut point = [2.0, f32::INFINITY, 3.0];
        point[axis] = f32::NAN;
        let (distance, gradient) = field.distance_and_gradient(point);
        assert!(distance.is_nan() && gradient.iter().all(|component| component.is_nan()));
        assert!(field.distance(point).is_nan());
    }
    let infinite = field.distance_and_gradient([f32::NEG_INFINITY, 2.0, f32::MAX]);
    assert_eq!(infinite, (f32::INFINITY, [-1.0, 0.0, 0.0]));
    let (distance, gradient) = field.distance_and_gradient([f32::INFINITY; 3]);
    assert_eq!(distance, f32::INFINITY);
    assert!((gradient[0] - 0.577_350_26).abs() < 1e-6);
}
