//! What the engine's inside promises: bounds of the coarse search, one tree for any thread count,
//! winding numbers.

use super::bvh::{LANES, Packet, coarse_error, splat};
use super::bvh_nearest::Scratch;
use super::oriented_box::OrientedBox;
use super::*;
use crate::import::TriangleSoup;
use std::f64::consts::PI;

/// A sequence of numbers in [0, 1), the same on every machine.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn point(&mut self) -> DVec3 {
        2.0 * DVec3::new(self.next(), self.next(), self.next()) - 1.0
    }
}

/// Triangles of all sizes and shapes, most of them slivers.
fn slivers(count: usize) -> CheckedMesh {
    let mut numbers = Numbers(7);
    let mut soup = TriangleSoup::default();
    for triangle in 0..count as u32 {
        let size = 10f64.powf(-4.0 * numbers.next());
        let width = 10f64.powf(-9.0 * numbers.next());
        let (a, along) = (numbers.point(), size * numbers.point());
        let across = width * size * numbers.point();
        soup.positions.extend([a, a + along, a + numbers.next() * along + across]);
        soup.triangles.push([0, 1, 2].map(|corner| 3 * triangle + corner));
    }
    CheckedMesh::new(soup).unwrap()
}

/// A bumpy closed surface.
fn bumpy_sphere(rings: u32, sectors: u32) -> CheckedMesh {
    let mut soup = TriangleSoup::default();
    for ring in 0..=rings {
        for sector in 0..sectors {
            let (polar, azimuth) =
                (PI * f64::from(ring) / f64::from(rings), 2.0 * PI * f64::from(sector) / f64::from(sectors));
            let radius = 1.0 + 0.2 * libm::sin(5.0 * azimuth) * libm::sin(4.0 * polar);
            let (sin, cos) = (if ring % rings == 0 { 0.0 } else { libm::sin(polar) }, libm::cos(polar));
            let direction = DVec3::new(sin * libm::cos(azimuth), sin * libm::sin(azimuth), cos);
            soup.positions.push(if sin == 0.0 { cos * DVec3::Z } else { radius * direction });
        }
    }
    for ring in 0..rings {
        for sector in 0..sectors {
            let next = (sector + 1) % sectors;
            let [a, b] = [sector, next].map(|sector| ring * sectors + sector);
            let [c, d] = [a + sectors, b + sectors];
            soup.triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    CheckedMesh::new(soup).unwrap()
}

#[test]
fn the_coarse_distance_keeps_its_bound() {
    let mesh = bvh_build::build(&LocalMesh::new(&slivers(20_000))).mesh;
    let mut numbers = Numbers(1);
    let mut worst: f64 = 0.0;
    for start in (0..mesh.triangles.len() - LANES).step_by(LANES) {
        let packet = Packet::new(&mesh, start..start + LANES);
        for round in 0..24 {
            // Everywhere, beside the triangle, and in its plane, which is worst for the face.
            let corners = mesh.corners((start + round % LANES) as u32);
            let mix =
                corners[0] + numbers.next() * (corners[1] - corners[0]) + numbers.next() * (corners[2] - corners[0]);
            let point = match round % 3 {
                0 => numbers.point() * 10f64.powf(3.0 * numbers.next() - 1.0),
                1 => mix,
                _ => mix + numbers.point() * 10f64.powf(-6.0 * numbers.next()),
            };
            let error = coarse_error(point);
            let coarse = packet.distances_squared(splat(point)).to_array();
            for (lane, coarse) in coarse.into_iter().enumerate() {
                let exact = triangle::closest_point(point, mesh.corners((start + lane) as u32));
                let excess = f64::from(coarse).sqrt() - exact.distance_squared.sqrt();
                let is_thin = packet.thin_lanes() & (1 << lane) != 0;
                worst = worst.max(if is_thin { -excess } else { excess.abs() } / error);
            }
        }
    }
    // Not by a hair: the proof is about constants, and this is its check.
    assert!(worst < 0.75, "the bound is used up to {worst}");
    assert!(worst > 0.01, "the bound is far too generous: {worst}");
}

#[test]
fn oriented_boxes_hold_their_triangles() {
    let finder = bvh_build::build(&LocalMesh::new(&bumpy_sphere(40, 60)));
    let mut numbers = Numbers(2);
    for (index, node) in finder.bvh.nodes.iter().enumerate() {
        for _ in 0..4 {
            let point = 3.0 * numbers.point();
            let bounds = node.distances_squared(splat(point)).to_array();
            for (lane, bound) in bounds.into_iter().enumerate() {
                if let Some(bvh::Child::Packet(packet)) = node.child(lane) {
                    let distances = finder.bvh.packets[packet]
                        .triangles()
                        .map(|triangle| triangle::distance_squared(point, finder.mesh.corners(triangle)).sqrt());
                    let least = distances.fold(f64::INFINITY, f64::min);
                    let bound = f64::from(bound).sqrt() - coarse_error(point);
                    assert!(bound <= least, "node {index}, lane {lane}: {bound} above {least}");
                }
            }
        }
    }
}

#[test]
fn oriented_boxes_are_flatter_than_axis_aligned_ones() {
    let finder = bvh_build::build(&LocalMesh::new(&bumpy_sphere(80, 120)));
    let (mut oriented, mut aligned) = (0.0, 0.0);
    for start in (0..finder.mesh.triangles.len()).step_by(LANES) {
        let range = start..start + LANES;
        let bounds = range.clone().map(|triangle| finder.mesh.bounds(triangle as u32));
        let bounds = bounds.reduce(local_mesh::Bounds::joined).unwrap();
        let volume = |half: [f32; 3]| f64::from(half[0]) * f64::from(half[1]) * f64::from(half[2]);
        aligned += volume([0, 1, 2].map(|axis| 0.5 * (bounds.max[axis] - bounds.min[axis])));
        oriented += volume(OrientedBox::around(&finder.mesh, &bvh_fold::Tree::leaf(bounds, range)).half);
    }
    assert!(oriented < 0.5 * aligned, "{oriented} against {aligned}");
}

#[test]
fn neither_seed_nor_grouping_bears_on_the_answer() {
    for mesh in [slivers(3000), bumpy_sphere(30, 40)] {
        let finder = bvh_build::build(&LocalMesh::new(&mesh));
        let mut numbers = Numbers(3);
        let mut scratch = Scratch::new();
        // Dense clusters, which are grouped, and lone points, which are not.
        let mut points = Vec::new();
        for cluster in 0..40 {
            let centre = 1.5 * numbers.point();
            let radius = 10f64.powf(-4.0 * numbers.next());
            let count = if cluster % 4 == 0 { 1 } else { 100 };
            points.extend((0..count).map(|_| centre + radius * numbers.point()));
        }
        neighbours::nearest_of_each(&finder, &points, |k, found| {
            let seed = (numbers.next() * mesh.triangles.len() as f64) as u32;
            let alone = finder.nearest(points[k], seed, &mut scratch);
            assert_eq!((found.triangle, found.closest), (alone.triangle, alone.closest), "point {k}");
        });
    }
}

#[test]
fn equal_distances_go_to_the_first_triangle() {
    let mesh = bumpy_sphere(30, 40);
    let finder = bvh_build::build(&LocalMesh::new(&mesh));
    let mut scratch = Scratch::new();
    let mut ties = 0;
    for &position in &mesh.positions {
        let point = finder.mesh.frame.to_local(position);
        let found = finder.nearest(point, 0, &mut scratch);
        let all = (0..finder.mesh.triangles.len() as u32)
            .filter(|&t| triangle::distance_squared(point, finder.mesh.corners(t)) == 0.0)
            .map(|t| finder.mesh.numbers[t as usize]);
        let all: Vec<u32> = all.collect();
        ties += usize::from(all.len() > 1);
        assert_eq!(all.iter().min(), Some(&finder.mesh.numbers[found.triangle as usize]));
    }
    assert!(ties > 1000, "every vertex is a tie: {ties}");
}

#[test]
fn the_tree_does_not_depend_on_threads() {
    let mesh = bumpy_sphere(120, 120);
    let order_with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let finder = pool.install(|| bvh_build::build(&LocalMesh::new(&mesh)));
        (finder.mesh.numbers, finder.bvh.nodes.len(), finder.bvh.packets.len())
    };
    assert_eq!(order_with(1), order_with(4));
}

#[test]
fn coincident_triangles_do_not_deepen_the_tree() {
    let soup = TriangleSoup { positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y], triangles: vec![[0, 1, 2]; 5000] };
    let mesh = CheckedMesh::new(soup).unwrap();
    let distance = SignedDistance::new(&mesh, SignMethod::Winding);
    assert_eq!(distance.sample(DVec3::new(0.2, 0.2, 3.0)).distance.abs(), 3.0);
}

/// The winding number by the definition: all solid angles, one by one.
fn winding_number(mesh: &CheckedMesh, point: DVec3) -> f64 {
    let solid_angle = |triangle| {
        let [a, b, c] = mesh.corners(triangle).map(|corner| corner - point);
        let [la, lb, lc] = [a, b, c].map(DVec3::length);
        let denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        2.0 * libm::atan2(a.dot(b.cross(c)), denominator)
    };
    (0..mesh.triangles.len()).map(solid_angle).sum::<f64>() / (4.0 * PI)
}

/// Parts of a sphere, by name.
fn open_surfaces() -> [(&'static str, CheckedMesh); 3] {
    let closed = bumpy_sphere(40, 60);
    let part_of = |keep: &dyn Fn(usize) -> bool| {
        let kept = closed.triangles.iter().enumerate().filter(|(number, _)| keep(*number));
        let triangles = kept.map(|(_, triangle)| *triangle).collect();
        CheckedMesh::new(TriangleSoup { positions: closed.positions.clone(), triangles }).unwrap()
    };
    [
        ("a quarter gone", part_of(&|number| 4 * number < 3 * closed.triangles.len())),
        ("many holes", part_of(&|number| number % 7 != 0)),
        ("loose", part_of(&|number| number % 40 == 0)),
    ]
}

#[test]
fn winding_numbers_match_the_sum_of_solid_angles() {
    for (name, mesh) in open_surfaces() {
        let finder = find_in(&mesh);
        let Signs::Open(surface) = Signs::new(&finder, SignMethod::Winding) else { panic!("the surface has a rim") };
        let (mut numbers, mut worst) = (Numbers(4), 0.0f64);
        for _ in 0..2000 {
            let point = 1.5 * numbers.point();
            let local = finder.mesh.frame.to_local(point);
            let found = surface.number(&finder, local, &surface.lids.winding(local));
            worst = worst.max((found - winding_number(&mesh, point)).abs());
        }

        println!("{name}: off by at most {worst:.1e}");
        assert!(worst < sign::NUMBER_ERROR, "{name}: off by {worst}");
    }
}

#[test]
fn signs_that_are_carried_are_those_of_points_alone() {
    for (name, mesh) in open_surfaces() {
        let distance = SignedDistance::new(&mesh, SignMethod::Winding);
        let mut numbers = Numbers(5);
        let mut points = Vec::new();
        for _ in 0..100 {
            // From far outside into the middle, through the surface or a hole; and all around a point.
            let (start, end) = (4.0 * numbers.point().normalize(), 0.2 * numbers.point());
            points.extend((0..100).map(|step| start.lerp(end, f64::from(step) / 100.0)));
            let (centre, radius) = (1.2 * numbers.point(), 10f64.powf(-3.0 * numbers.next()));
            points.extend((0..100).map(|_| centre + radius * numbers.point()));
        }
        // A few at a time, so that each follows the one before along its line.
        for points in points.chunks(100) {
            for (sample, &point) in distance.sample_all(points).iter().zip(points) {
                assert_eq!(sample.distance, distance.sample(point).distance, "{name}, {point}");
            }
        }
    }
}
