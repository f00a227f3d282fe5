//! The exact distance is exact: against every triangle one by one, and against formulas.

use crate::support::numbers::Numbers;
use crate::support::{oracle, shapes};
use glam::DVec3;
use nearfield_bake::distance::{SignChoice, SignMethod, SignedDistance};
use nearfield_bake::field_function::{FieldFunction, Sample};
use nearfield_bake::import::{self, TriangleSoup};
use nearfield_bake::mesh::CheckedMesh;

fn auto(mesh: &CheckedMesh) -> SignedDistance {
    SignedDistance::choose(mesh, SignChoice::Auto).0
}

/// Points in and around the box, next to the surface, and on vertices, edges and faces.
fn points(mesh: &CheckedMesh, count: usize) -> Vec<DVec3> {
    let mut numbers = Numbers::new(11);
    let space = mesh.bounds.grown(0.5 * mesh.bounds.diagonal());
    (0..count)
        .map(|k| {
            let anywhere = numbers.point(space.min, space.max);
            let [a, b, c] = mesh.corners((numbers.unit() * mesh.triangles.len() as f64) as usize);
            let on_face = a + 0.3 * (b - a) + 0.2 * (c - a);
            match k % 8 {
                0 => a,
                1 => 0.5 * (b + c),
                2 => on_face,
                3 | 4 => on_face + 10f64.powf(-1.0 - 6.0 * numbers.unit()) * (anywhere - mesh.bounds.centre()),
                _ => anywhere,
            }
        })
        .collect()
}

#[track_caller]
fn expect_oracle(name: &str, mesh: &CheckedMesh, count: usize, tolerance: f64) {
    let points = points(mesh, count);
    let samples = auto(mesh).sample_all(&points);
    for (point, sample) in points.iter().zip(samples) {
        let error = (sample.distance.abs() - oracle::distance(mesh, *point)).abs();
        assert!(error <= tolerance * mesh.bounds.diagonal(), "{name}: off by {error:e} at {point}");
    }
}

#[test]
fn every_shape_agrees_with_the_oracle() {
    for shape in shapes::all() {
        expect_oracle(shape.name, &shape.mesh, 500, 1e-14);
    }
}

#[test]
fn scanned_meshes_agree_with_the_oracle() {
    for name in ["spot.ply", "bob_small.ply"] {
        let path = format!("{}/meshes/{name}", env!("CARGO_MANIFEST_DIR"));
        let mesh = CheckedMesh::new(import::read(path).unwrap()).unwrap();
        assert!(mesh.topology.is_closed_and_oriented(), "{name}: {:?}", mesh.topology);
        expect_oracle(name, &mesh, 500, 1e-14);
    }
}

#[test]
fn obtuse_and_sliver_triangles_agree_with_the_oracle() {
    let mut numbers = Numbers::new(5);
    for height in [1.0, 1e-2, 1e-4, 1e-6, 1e-8] {
        let mut soup = TriangleSoup::default();
        for triangle in 0..300 {
            let mut vector = || numbers.point(DVec3::NEG_ONE, DVec3::ONE);
            let (a, along, across) = (vector(), vector(), vector());
            // The third corner above the middle of the long side, or beyond its end.
            let foot = 1.5 * numbers.unit();
            soup.positions.extend([a, a + along, a + foot * along + height * across]);
            soup.triangles.push([0, 1, 2].map(|corner| 3 * triangle + corner));
        }
        let mesh = CheckedMesh::new(soup).unwrap();
        // Rounding turns the plane of a sliver, by more the thinner it is, but never beyond it.
        let tolerance = (1e-15 / height).clamp(1e-14, f64::max(height, 1e-14));
        expect_oracle(&format!("height {height}"), &mesh, 2000, tolerance);
    }
}

#[test]
fn every_shape_agrees_with_its_formula() {
    for shape in shapes::all() {
        let rounding = 1e-14 * shape.mesh.bounds.diagonal();
        let points = points(&shape.mesh, 4000);
        for (point, sample) in points.iter().zip(auto(&shape.mesh).sample_all(&points)) {
            let expected = (shape.distance)(*point);
            let error = (sample.distance - expected).abs();
            assert!(
                error <= shape.chord_error + rounding,
                "{}: {} for {expected} at {point}",
                shape.name,
                sample.distance
            );
        }
    }
}

#[test]
fn place_and_scale_do_not_matter() {
    let sphere = shapes::sphere();
    let moved = |scale: f64, offset: DVec3| {
        let positions = sphere.mesh.positions.iter().map(|p| p * scale + offset).collect();
        CheckedMesh::new(TriangleSoup { positions, triangles: sphere.mesh.triangles.clone() }).unwrap()
    };
    let far = DVec3::new(1e5, -2e5, 3e5);
    // Far away the coordinates themselves are rounded to 1e-11 of the size.
    for (scale, offset, tolerance) in [(1e-6, DVec3::ZERO, 1e-14), (1e7, DVec3::ZERO, 1e-14), (1.0, far, 1e-10)] {
        let name = format!("scale {scale}, offset {offset}");
        let mesh = moved(scale, offset);
        expect_oracle(&name, &mesh, 300, tolerance);
        let distance = auto(&mesh);
        for (point, expected) in [(0.0, -1.0), (0.5, -0.5), (2.0, 1.0)] {
            let found = distance.sample(DVec3::X * point * scale + offset).distance / scale;
            assert!((found - expected).abs() < 2.2e-3, "{name}: {found} for {expected}");
        }
    }
}

#[test]
fn order_and_threads_do_not_matter() {
    let path = format!("{}/meshes/spot.ply", env!("CARGO_MANIFEST_DIR"));
    let whole = import::read(path).unwrap();

    // Closed; with pinholes, where a sign carries far but not everywhere; with a third missing.
    for missing in [usize::MAX, 200, 3] {
        let triangles = whole.triangles.iter().copied().enumerate().filter(|(k, _)| k % missing != missing - 1);
        let soup = TriangleSoup {
            positions: whole.positions.clone(),
            triangles: triangles.map(|(_, corners)| corners).collect(),
        };
        expect_order_not_to_matter(&CheckedMesh::new(soup).unwrap());
    }
}

#[track_caller]
fn expect_order_not_to_matter(mesh: &CheckedMesh) {
    let distance = auto(mesh);

    // Dense clusters, as a refined cell asks for them, among points from everywhere.
    let mut numbers = Numbers::new(13);
    let mut points = points(mesh, 2000);
    for centre in points.clone().into_iter().step_by(50) {
        points.extend((0..64).map(|_| centre + 1e-3 * numbers.point(DVec3::NEG_ONE, DVec3::ONE)));
    }
    let samples = distance.sample_all(&points);
    for (point, sample) in points.iter().zip(&samples) {
        assert_eq!(distance.sample(*point), *sample, "alone at {point}");
    }
    points.reverse();
    let mut reversed = distance.sample_all(&points);
    reversed.reverse();
    assert_eq!(samples, reversed, "in reverse");
}

#[test]
fn the_sign_method_never_bears_on_the_size() {
    for shape in shapes::all() {
        let points = points(&shape.mesh, 1000);
        let by = |method| SignedDistance::new(&shape.mesh, method).sample_all(&points);
        let size = |sample: &Sample| sample.distance.abs();
        let [pseudonormal, winding] = [by(SignMethod::Pseudonormal), by(SignMethod::Winding)];
        assert!(pseudonormal.iter().map(size).eq(winding.iter().map(size)), "{}", shape.name);

        // And on a closed mesh both know the inside, except where dipoles blur the surface.
        for (k, (a, b)) in pseudonormal.iter().zip(&winding).enumerate() {
            let is_clear = size(a) > 1e-9;
            assert!(!is_clear || a.distance == b.distance, "{}: sign at {}", shape.name, points[k]);
        }
    }
}

#[test]
fn gradients_point_away_and_have_unit_length() {
    for shape in shapes::all() {
        let distance = auto(&shape.mesh);
        for point in points(&shape.mesh, 500) {
            let Sample { distance: here, gradient } = distance.sample(point);
            assert!((gradient.length() - 1.0).abs() < 1e-12, "{}: {gradient} at {point}", shape.name);
            // Against the gradient by |d|: on the surface, at the closest point.
            let surface = distance.sample(point - here * gradient).distance;
            assert!(surface.abs() < 1e-12, "{}: {surface} from {point}", shape.name);
        }
    }
}

#[test]
fn on_the_surface_the_gradient_is_the_pseudonormal() {
    let distance = auto(&shapes::cuboid("cube", DVec3::ONE, 2).mesh);
    for (point, normal) in [
        (DVec3::new(1.0, 0.3, 0.4), DVec3::X),
        (DVec3::new(1.0, 1.0, 0.4), DVec3::new(1.0, 1.0, 0.0)),
        (DVec3::new(-1.0, 1.0, -1.0), DVec3::new(-1.0, 1.0, -1.0)),
    ] {
        let Sample { distance, gradient } = distance.sample(point);
        assert_eq!(distance, 0.0, "at {point}");
        assert!(gradient.distance(normal.normalize()) < 1e-12, "{gradient} at {point}");
    }
}

#[test]
fn a_hole_switches_to_winding_numbers_and_casts_doubt() {
    let mut mesh = shapes::sphere().mesh;
    mesh.triangles.retain(|triangle| triangle.iter().any(|&v| mesh.positions[v as usize].z < 0.9));
    let soup = TriangleSoup { positions: mesh.positions, triangles: mesh.triangles };
    let mesh = CheckedMesh::new(soup).unwrap();
    assert!(mesh.topology.boundary_edges > 0);
    let method = |choice| SignedDistance::choose(&mesh, choice).1.method;
    assert_eq!(method(SignChoice::Auto), SignMethod::Winding);
    assert_eq!(method(SignChoice::Pseudonormal), SignMethod::Pseudonormal);

    let distance = auto(&mesh);
    for (point, is_inside) in
        [(DVec3::ZERO, true), (DVec3::Z * 1.5, false), (-0.9 * DVec3::Z, true), (-1.1 * DVec3::Z, false)]
    {
        assert_eq!(distance.sample(point).distance < 0.0, is_inside, "at {point}");
        assert!(!distance.sign_is_doubtful(point), "at {point}");
    }
    assert!(distance.sign_is_doubtful(DVec3::Z * 0.9), "in the hole");
}

#[test]
fn queries_far_away_are_answered() {
    let distance = auto(&shapes::cuboid("cube", DVec3::ONE, 2).mesh);
    for far in [1e3, 1e6, 1e9, 1e12, 1e100] {
        let Sample { distance, gradient } = distance.sample(DVec3::new(far, 0.0, 0.0));
        assert!((distance - (far - 1.0)).abs() <= 1e-15 * far, "{distance} at {far}");
        assert!(gradient.distance(DVec3::X) < 2.0 / far, "{gradient} at {far}");
    }
}

#[test]
fn a_query_that_is_no_point_gets_no_number() {
    let distance = auto(&shapes::cuboid("cube", DVec3::ONE, 2).mesh);
    let nowhere = [DVec3::NAN, DVec3::new(f64::INFINITY, 0.0, 0.0), DVec3::ONE * 2.0, DVec3::new(0.0, f64::NAN, 0.0)];
    let samples = distance.sample_all(&nowhere);
    for k in [0, 1, 3] {
        assert!(samples[k].distance.is_nan() && samples[k].gradient == DVec3::ZERO, "{:?}", samples[k]);
    }
    assert_eq!(samples[2], distance.sample(DVec3::ONE * 2.0));
}
