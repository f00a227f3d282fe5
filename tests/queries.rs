use crate::support::numbers::Numbers;
use crate::support::shapes::{Shape, cuboid};
use glam::{DMat3, DVec3, Vec3};
use nearfield::{Aabb, Field, Instance, NotASimilarity, Raycast};
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Continuity, Interpolant, Layout, Settings, Target};

fn baked(shape: &Shape, interpolant: Interpolant) -> Vec<u8> {
    let error = Target::Relative(2e-3);
    let settings = Settings {
        error,
        interpolant,
        continuity: Continuity::C0,
        max_depth: 6,
        samples: 20_000,
        layout: Layout::Octree,
        ..Settings::default()
    };
    bake(&shape.mesh, &settings, &Silent).expect("the mesh bakes").bytes
}

/// A wall as thin as the error of the field is not what may be missed; this one is a few times thicker.
fn wall() -> Shape {
    cuboid("wall", DVec3::new(0.5, 0.4, 0.01), 4)
}

fn bounds(field: &Field<'_>) -> (DVec3, DVec3) {
    let Aabb { min, max } = field.header().bounds;
    (Vec3::from(min).as_dvec3(), Vec3::from(max).as_dvec3())
}

#[test]
fn a_cursor_answers_as_the_field_does() {
    for interpolant in [Interpolant::Tricubic, Interpolant::Trilinear] {
        let bytes = baked(&wall(), interpolant);
        let field = Field::open(&bytes).expect("a field");
        let (min, max) = bounds(&field);
        let (mut cursor, mut numbers) = (field.cursor(), Numbers::new(1));
        for _ in 0..500 {
            // Short walks, some of which leave the box.
            let (mut point, aim) = (numbers.point(min, max), numbers.point(min, max));
            for _ in 0..20 {
                let asked = point.as_vec3().to_array();
                let (distance, gradient) = field.distance_and_gradient(asked);
                let (again, gradient_again) = cursor.distance_and_gradient(asked);
                assert_eq!(again.to_bits(), distance.to_bits());
                assert_eq!(cursor.distance(asked).to_bits(), distance.to_bits());
                assert_eq!(gradient_again.map(f32::to_bits), gradient.map(f32::to_bits));
                point += 0.07 * (aim - point) + 0.01 * (max - min);
            }
        }
    }
}

#[test]
fn a_cursor_meets_the_corners_of_the_box() {
    let bytes = baked(&wall(), Interpolant::Tricubic);
    let field = Field::open(&bytes).expect("a field");
    let Aabb { min, max } = field.header().bounds;
    let mut cursor = field.cursor();
    for corner in 0..8 {
        let point = [0, 1, 2].map(|axis: usize| if corner >> axis & 1 == 0 { min[axis] } else { max[axis] });
        assert_eq!(cursor.distance(point).to_bits(), field.distance(point).to_bits());
    }
    assert!(cursor.distance([f32::NAN; 3]).is_nan());
}

#[test]
fn no_ray_passes_through_a_wall() {
    let shape = wall();
    let bytes = baked(&shape, Interpolant::Tricubic);
    let field = Field::open(&bytes).expect("a field");
    let within = field.contract().max_error();
    let mut numbers = Numbers::new(2);
    for _ in 0..2000 {
        // From one side to the other: the wall is hit, and not from behind.
        let half = DVec3::new(0.45, 0.35, 0.0);
        let start = numbers.point(-half, half) + DVec3::Z * (0.02 + numbers.unit());
        let end = numbers.point(-half, half) - DVec3::Z * (0.02 + numbers.unit());
        let (origin, direction) = (start.as_vec3().to_array(), (end - start).as_vec3().to_array());
        let Raycast::Hit(hit) = field.raycast(origin, direction, f32::INFINITY, within) else {
            panic!("a ray from {start} to {end} went through");
        };
        let point = Vec3::from(hit.point).as_dvec3();
        let truth = (shape.distance)(point);
        assert!(point.z > 0.0, "hit from behind at {point}");
        assert!(truth > -1e-6 && truth < 3.0 * f64::from(within) + 1e-6, "stopped {truth} from the wall");
        assert!(hit.normal[2] > 0.8, "normal {:?}", hit.normal);
        assert!((Vec3::from(hit.normal).length() - 1.0).abs() < 1e-5);
        let along = start + (end - start).normalize() * f64::from(hit.distance);
        assert!(along.distance(point) < 1e-5, "{along} is not {point}");
    }
}

#[test]
fn rays_that_miss_are_misses() {
    let bytes = baked(&wall(), Interpolant::Tricubic);
    let field = Field::open(&bytes).expect("a field");
    let is_miss =
        |origin, direction, length| matches!(field.raycast(origin, direction, length, 0.0), Raycast::Miss { .. });
    assert!(is_miss([0.0, 0.0, 0.5], [0.0, 0.0, 1.0], f32::INFINITY), "away");
    assert!(is_miss([0.0, 0.0, 0.5], [0.0, 0.0, -1.0], 0.3), "too short");
    assert!(is_miss([9.0, 9.0, 9.0], [0.0, 0.0, -1.0], f32::INFINITY), "past the box");
    assert!(is_miss([0.0, 0.0, 0.5], [0.0; 3], 1.0), "no direction");
    assert!(is_miss([0.0, f32::NAN, 0.5], [0.0, 0.0, -1.0], 1.0), "no origin");
    assert!(!is_miss([0.0, 0.0, 50.0], [0.0, 0.0, -2e-30], f32::INFINITY), "from afar, with a short direction");
}

#[test]
fn descents_end_on_the_surface() {
    let shape = cuboid("box", DVec3::new(0.5, 0.4, 0.3), 4);
    let bytes = baked(&shape, Interpolant::Tricubic);
    let field = Field::open(&bytes).expect("a field");
    let ((min, max), mut numbers) = (bounds(&field), Numbers::new(3));
    let (mut arrived, mut nearest, mut count) = (0, 0, 0);
    for _ in 0..2000 {
        let start = numbers.point(min, max);
        let first = field.distance(start.as_vec3().to_array());
        let closest = field.closest_point(start.as_vec3().to_array());
        let point = Vec3::from(closest.point).as_dvec3();
        assert!(point.cmpge(min).all() && point.cmple(max).all() && closest.steps <= 16);
        assert_eq!(closest.residual, field.distance(closest.point));
        assert!(closest.residual.abs() <= first.abs(), "{first} grew to {}", closest.residual);
        let error = f64::from(field.contract().max_error());
        arrived += i32::from((shape.distance)(point).abs() <= error + 1e-4);
        nearest += i32::from((start.distance(point) - (shape.distance)(start).abs()).abs() <= 5.0 * error);
        count += 1;
    }
    // Inside the box the medial axis is never far.
    assert!(arrived * 100 >= 97 * count, "{arrived} of {count} arrived");
    assert!(nearest * 100 >= 85 * count, "{nearest} of {count} were as near as the surface");
}

#[test]
fn a_range_holds_every_value() {
    let bytes = baked(&wall(), Interpolant::Tricubic);
    let field = Field::open(&bytes).expect("a field");
    let ((min, max), mut numbers) = (bounds(&field), Numbers::new(4));
    for round in 0..200 {
        // Boxes of every size; some stick out.
        let centre = numbers.point(min, max);
        let half = numbers.point(DVec3::ZERO, max - min) * 0.5_f64.powi(round % 8);
        let (low, high) = ((centre - half).as_vec3(), (centre + half).as_vec3());
        let (least, greatest) = field.range(Aabb { min: low.to_array(), max: high.to_array() });
        for _ in 0..200 {
            let point = numbers.point(low.as_dvec3(), high.as_dvec3()).as_vec3().clamp(low, high);
            let value = field.distance(point.to_array());
            assert!((least..=greatest).contains(&value), "{value} is not in {least} to {greatest}");
        }
    }
    let everything = (f32::NEG_INFINITY, f32::INFINITY);
    assert_eq!(field.range(Aabb { min: [f32::NAN; 3], max: [1.0; 3] }), everything);
    assert_eq!(field.range(Aabb { min: [1.0; 3], max: [0.0; 3] }), everything);
}

#[test]
fn what_is_clear_is_clear() {
    let shape = wall();
    let bytes = baked(&shape, Interpolant::Tricubic);
    let field = Field::open(&bytes).expect("a field");
    let ((min, max), mut numbers) = (bounds(&field), Numbers::new(5));
    let (mut clear, mut refused) = (0, 0);
    for _ in 0..5000 {
        let centre = numbers.point(2.0 * min, 2.0 * max);
        let radius = 0.3 * numbers.unit();
        if field.is_clear(centre.as_vec3().to_array(), radius as f32) {
            let truth = (shape.distance)(centre);
            assert!(truth > radius - 1e-6, "{centre} is {truth} from the wall, not {radius}");
            clear += 1;
        } else {
            refused += 1;
        }
    }
    assert!(clear > 1000 && refused > 100, "{clear} clear, {refused} refused: a test of nothing");
    assert!(!field.is_clear([f32::NAN; 3], 0.0));
}

#[test]
fn instances_are_the_field_elsewhere() {
    let bytes = baked(&wall(), Interpolant::Tricubic);
    let field = Field::open(&bytes).expect("a field");
    let ((min, max), mut numbers) = (bounds(&field), Numbers::new(6));
    for mirror in [1.0, -1.0] {
        let turn =
            DMat3::from_euler(glam::EulerRot::XYZ, 0.4, -1.1, 2.0) * DMat3::from_diagonal(DVec3::new(mirror, 1.0, 1.0));
        let (scale, origin) = (2.5, DVec3::new(1.0, -2.0, 3.0));
        let matrix = turn * scale;
        let axes = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(|axis| axis.as_vec3().to_array());
        let instance = Instance::new(field, axes, origin.as_vec3().to_array()).expect("a similarity");
        for _ in 0..500 {
            let point = numbers.point(min, max);
            let there = (matrix * point + origin).as_vec3().to_array();
            let (distance, gradient) = field.distance_and_gradient(point.as_vec3().to_array());
            let (moved, turned) = instance.distance_and_gradient(there);
            assert_eq!(moved.to_bits(), instance.distance(there).to_bits());
            assert!((moved - 2.5 * distance).abs() < 2e-5, "{moved} is not 2.5 times {distance}");
            let expected = (turn * Vec3::from(gradient).as_dvec3()).as_vec3();
            assert!(Vec3::from(turned).distance(expected) < 0.02, "{turned:?} is not {expected}");
        }
    }

    for (axes, fault) in [
        ([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]], "stretched"),
        ([[1.0, 0.0, 0.0], [0.5, 1.0, 0.0], [0.0, 0.0, 1.0]], "sheared"),
        ([[0.0; 3]; 3], "flat"),
        ([[f32::NAN; 3]; 3], "not a number"),
    ] {
        assert_eq!(Instance::new(field, axes, [0.0; 3]).err(), Some(NotASimilarity), "{fault}");
    }
}
