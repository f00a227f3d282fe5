//! Clean meshes are broken in every way that artists and exporters know, and the inside must stay where
//! it was: at points farther than 0.5 % of the diagonal from both surfaces.

use crate::shapes;
use glam::DVec3;
use nearfield_bake::distance::{SignChoice, SignDecision, SignMethod, SignedDistance};
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::import::TriangleSoup;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::random::Draws;

const POINTS: u64 = 20_000;
/// Farther than this from the surface, in diagonals, a sign counts.
const CLEAR: f64 = 5e-3;

fn clean() -> [(&'static str, CheckedMesh); 3] {
    [("sphere", shapes::sphere(4).0), ("bob", shapes::read("bob_small.ply")), ("spot", shapes::read("spot.ply"))]
}

fn soup(mesh: &CheckedMesh) -> TriangleSoup {
    TriangleSoup { positions: mesh.positions.clone(), triangles: mesh.triangles.clone() }
}

fn checked(soup: TriangleSoup) -> CheckedMesh {
    CheckedMesh::new(soup).expect("a broken mesh is still a mesh")
}

fn chance(item: usize) -> f64 {
    Draws::new(17, 0, item as u64).unit()
}

/// What has no neighbours to be welded to: every triangle has corners of its own, moved a little.
fn cracked(mesh: &CheckedMesh) -> TriangleSoup {
    let crack = 1e-6 * mesh.bounds.diagonal();
    let mut soup = TriangleSoup::default();
    for triangle in 0..mesh.triangles.len() {
        let first = soup.positions.len() as u32;
        let moved = (0u64..)
            .zip(mesh.corners(triangle))
            .map(|(corner, position)| position + crack * Draws::new(18, corner, triangle as u64).direction());
        soup.positions.extend(moved);
        soup.triangles.push([first, first + 1, first + 2]);
    }
    soup
}

fn flip(soup: &mut TriangleSoup, share: f64) {
    let flipped = soup.triangles.iter_mut().enumerate().filter(|(number, _)| chance(*number) < share);
    flipped.for_each(|(_, triangle)| triangle.swap(1, 2));
}

/// Without the triangles whose centre is in the cap around +z that has this share of a sphere's area.
fn with_hole(mesh: &CheckedMesh, share: f64) -> CheckedMesh {
    let (centre, half) = (mesh.bounds.centre(), 0.5 * mesh.bounds.size());
    let mut soup = soup(mesh);
    soup.triangles.retain(|triangle| {
        let middle = triangle.iter().map(|&vertex| mesh.positions[vertex as usize]).sum::<DVec3>() / 3.0;
        ((middle - centre) / half).normalize().z < 1.0 - 2.0 * share
    });
    checked(soup)
}

/// Percent of points whose sign differs from the truth's, and what was chosen.
fn wrong(broken: &CheckedMesh, inside: impl Fn(DVec3) -> f64) -> (f64, SignDecision) {
    let (distance, decision) = SignedDistance::choose(broken, SignChoice::Auto);
    (percent_wrong(&distance, broken, inside), decision)
}

fn percent_wrong(distance: &SignedDistance, broken: &CheckedMesh, inside: impl Fn(DVec3) -> f64) -> f64 {
    let bounds = broken.bounds.grown(0.1 * broken.bounds.size().max_element());
    let points: Vec<DVec3> = (0..POINTS)
        .map(|number| {
            let mut draws = Draws::new(19, 0, number);
            bounds.min + DVec3::new(draws.unit(), draws.unit(), draws.unit()) * bounds.size()
        })
        .collect();
    let clear = CLEAR * broken.bounds.diagonal();
    let (mut counted, mut wrong) = (0, 0);
    for (&point, sample) in points.iter().zip(distance.sample_all(&points)) {
        let truth = inside(point);
        if truth.abs() > clear && sample.distance.abs() > clear {
            counted += 1;
            wrong += u32::from((truth < 0.0) != (sample.distance < 0.0));
        }
    }
    assert!(counted > POINTS / 2, "only {counted} points count");
    100.0 * f64::from(wrong) / counted as f64
}

#[track_caller]
fn expect(name: &str, broken: &CheckedMesh, truth: impl Fn(DVec3) -> f64, at_most: f64, method: SignMethod) {
    let (share, decision) = wrong(broken, truth);
    println!("{name}: {share:.3} % wrong, {:?}, {}", decision.method, decision.reason);
    assert!(share <= at_most, "{name}: {share} % of the signs are wrong");
    assert_eq!(decision.method, method, "{name}");
}

/// Breaks each clean mesh; the inside is that of the clean one.
#[track_caller]
fn expect_inside_kept(name: &str, method: SignMethod, broken: impl Fn(&CheckedMesh) -> TriangleSoup) {
    for (shape, mesh) in clean() {
        let truth = SignedDistance::new(&mesh, SignMethod::Pseudonormal);
        let inside = |point| truth.sample(point).distance;
        expect(&format!("{shape}, {name}"), &checked(broken(&mesh)), inside, 0.0, method);
    }
}

#[test]
fn flipped_triangles_are_turned_back() {
    for share in [0.1, 0.3, 0.5] {
        expect_inside_kept(&format!("{share} flipped"), SignMethod::Pseudonormal, |mesh| {
            let mut broken = soup(mesh);
            flip(&mut broken, share);
            broken
        });
    }
}

#[test]
fn inverted_meshes_are_turned_over() {
    expect_inside_kept("inverted", SignMethod::Pseudonormal, |mesh| {
        let mut broken = soup(mesh);
        flip(&mut broken, 2.0);
        broken
    });
}

#[test]
fn cracks_do_not_matter() {
    expect_inside_kept("cracked", SignMethod::Winding, cracked);
}

#[test]
fn rays_vote_where_triangles_without_neighbours_face_all_ways() {
    expect_inside_kept("cracked, 0.3 flipped", SignMethod::Rays, |mesh| {
        let mut broken = cracked(mesh);
        flip(&mut broken, 0.3);
        broken
    });
}

#[test]
fn copies_count_once() {
    expect_inside_kept("duplicated", SignMethod::Pseudonormal, |mesh| {
        let mut broken = soup(mesh);
        broken.triangles.extend(mesh.triangles.iter().enumerate().filter(|(k, _)| chance(*k) < 0.4).map(|(_, t)| *t));
        broken
    });
    expect_inside_kept("double-sided", SignMethod::Pseudonormal, |mesh| {
        let mut broken = soup(mesh);
        broken.triangles.extend(mesh.triangles.iter().map(|&[a, b, c]| [a, c, b]));
        broken
    });
}

#[test]
fn pinholes_do_not_matter() {
    expect_inside_kept("pinholes", SignMethod::Winding, |mesh| {
        let mut broken = soup(mesh);
        let mut number = 0;
        broken.triangles.retain(|_| {
            number += 1;
            number % 400 != 7
        });
        broken
    });
}

#[test]
fn stray_sheets_enclose_nothing() {
    expect_inside_kept("stray sheets", SignMethod::Winding, |mesh| {
        let mut broken = soup(mesh);
        let (centre, size) = (mesh.bounds.centre(), mesh.bounds.size().max_element());
        for place in 0..8u64 {
            let mut draws = Draws::new(20, 0, place);
            let [middle, along] = [centre + 0.6 * size * draws.direction(), 0.03 * size * draws.direction()];
            let across = 0.03 * size * along.any_orthonormal_vector();
            let first = broken.positions.len() as u32;
            broken.positions.extend([middle, middle + along, middle + across]);
            broken.triangles.push([first, first + 1, first + 2]);
        }
        broken
    });
}

#[test]
fn holes_are_closed_by_what_is_around_them() {
    let (sphere, _) = shapes::sphere(4);
    let inside = |point: DVec3| point.length() - 1.0;
    expect("2 % hole", &with_hole(&sphere, 0.02), inside, 0.04, SignMethod::Winding);
    expect("15 % hole", &with_hole(&sphere, 0.15), inside, 2.2, SignMethod::Winding);
}

#[test]
fn half_a_sphere_is_closed_by_a_disc() {
    let half = with_hole(&shapes::sphere(4).0, 0.5);
    expect("half sphere", &half, |point| (point.length() - 1.0).max(point.z), 0.0, SignMethod::Winding);
    let mut turned = soup(&half);
    flip(&mut turned, 2.0);
    let turned = checked(turned);
    expect("inverted half sphere", &turned, |point| (point.length() - 1.0).max(point.z), 0.0, SignMethod::Winding);
}

/// Two spheres of these radii, the second moved and its triangles turned over if asked.
fn two_spheres(radius: f64, offset: DVec3, turned: bool) -> CheckedMesh {
    let (sphere, _) = shapes::sphere(4);
    let mut both = soup(&sphere);
    let first = both.positions.len() as u32;
    both.positions.extend(sphere.positions.iter().map(|&position| radius * position + offset));
    both.triangles.extend(sphere.triangles.iter().map(|&[a, b, c]| {
        let [b, c] = if turned { [c, b] } else { [b, c] };
        [a + first, b + first, c + first]
    }));
    checked(both)
}

#[test]
fn shells_in_shells_are_solid_or_hollow_as_they_face() {
    let solid = two_spheres(0.6, DVec3::ZERO, false);
    expect("nested", &solid, |point| point.length() - 1.0, 0.0, SignMethod::Winding);
    let hollow = two_spheres(0.6, DVec3::ZERO, true);
    let cavity = |point: DVec3| (point.length() - 1.0).max(0.6 - point.length());
    expect("hollow", &hollow, cavity, 0.0, SignMethod::Pseudonormal);

    // Inside out as a whole.
    let mut turned = soup(&hollow);
    flip(&mut turned, 2.0);
    expect("hollow, inverted", &checked(turned), cavity, 0.0, SignMethod::Pseudonormal);
}

#[test]
fn overlapping_parts_are_one() {
    let offset = DVec3::new(0.8, 0.3, 0.1);
    let union = |point: DVec3| (point.length() - 1.0).min(point.distance(offset) - 0.9);
    for turned in [false, true] {
        let both = two_spheres(0.9, offset, turned);
        expect(&format!("overlap, one inverted: {turned}"), &both, union, 0.0, SignMethod::Winding);
    }
}

#[test]
fn walls_between_parts_are_inside() {
    // Two cubes that share a face, which each of them has.
    let corner = |k: u32| DVec3::new(f64::from(k % 3), f64::from(k / 3 % 2), f64::from(k / 6));
    let cube = |x: u32| {
        let [a, b, c, d, e, f, g, h] = [0, 1, 3, 4, 6, 7, 9, 10].map(|k| k + x);
        let faces = [[a, c, d, b], [e, f, h, g], [a, b, f, e], [c, g, h, d], [a, e, g, c], [b, d, h, f]];
        faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
    };
    let triangles: Vec<[u32; 3]> = cube(0).chain(cube(1)).collect();
    let broken = checked(TriangleSoup { positions: (0..12).map(corner).collect(), triangles });
    let inside = |point: DVec3| ((point - DVec3::new(1.0, 0.5, 0.5)).abs() - DVec3::new(1.0, 0.5, 0.5)).max_element();
    expect("two cubes with a wall", &broken, inside, 0.0, SignMethod::Winding);
}

#[test]
fn a_sheet_is_as_thick_as_asked_and_has_no_inside() {
    let sheet = with_hole(&shapes::sphere(3).0, 0.5);
    let thick = SignedDistance::new(&sheet, SignMethod::Sheet { thickness: 0.1 });
    let plain = SignedDistance::new(&sheet, SignMethod::Sheet { thickness: 0.0 });
    for number in 0..1000 {
        let mut draws = Draws::new(21, 0, number);
        let point = 1.5 * draws.unit() * draws.direction();
        let (thick, plain) = (thick.sample(point), plain.sample(point));
        assert!(plain.distance >= 0.0, "inside at {point}");
        assert_eq!(thick.distance, plain.distance - 0.05, "at {point}");
        assert_eq!(thick.gradient, plain.gradient, "at {point}");
    }
}

#[test]
fn no_method_bears_on_the_distance() {
    for (_, mesh) in clean() {
        let mut broken = cracked(&mesh);
        flip(&mut broken, 0.3);
        broken.triangles.truncate(broken.triangles.len() * 9 / 10);
        let broken = checked(broken);
        let points: Vec<DVec3> = (0..500).map(|k| 2.0 * Draws::new(22, 0, k).direction()).collect();
        let by = |method| {
            let samples = SignedDistance::new(&broken, method).sample_all(&points);
            samples.into_iter().map(|sample| sample.distance.abs()).collect::<Vec<_>>()
        };
        let expected = by(SignMethod::Pseudonormal);
        assert_eq!(by(SignMethod::Winding), expected);
        assert_eq!(by(SignMethod::Rays), expected);
    }
}
