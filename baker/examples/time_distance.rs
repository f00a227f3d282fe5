//! Times the exact distance on one thread, by sign method: `time_distance MESH`.
//!
//! The answers are checked against every triangle before anything is timed.

use cpu_time::ThreadTime;
use glam::{DVec3, UVec3};
use nearfield_bake::distance::triangle::closest_point;
use nearfield_bake::distance::{SignChoice, SignMethod, SignedDistance};
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::import;
use nearfield_bake::mesh::CheckedMesh;
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: time_distance MESH")?;
    let mesh = CheckedMesh::new(import::read(path)?)?;
    let started = Instant::now();
    let (distance, decision) = SignedDistance::choose(&mesh, SignChoice::Auto);
    println!("{} triangles, {:?}, built in {:.0?}", mesh.triangles.len(), decision.method, started.elapsed());

    let random = random_points(&mesh, 200_000);
    let rows = lattice(&mesh, 128, UVec3::new(0, 0, 56), UVec3::new(128, 128, 16));
    let dense: Vec<DVec3> = (0..500).flat_map(|k| cell_near_surface(&mesh, 7919 * k)).collect();
    check(&mesh, &distance, &random[..100]);
    check(&mesh, &distance, &dense[..100]);

    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for method in [SignMethod::Pseudonormal, SignMethod::Winding, SignMethod::Rays] {
        println!("{method:?}");
        let distance = SignedDistance::new(&mesh, method);
        pool.install(|| {
            let one_by_one = || random.iter().map(|&point| distance.sample(point).distance).sum();
            time("random, one by one", random.len(), one_by_one);
            for (name, points) in [("rows of a lattice of 128^3", &rows), ("cells of 8^3 at 1/2048", &dense)] {
                time(name, points.len(), || distance.sample_all(points).iter().map(|s| s.distance).sum());
            }
        });
    }
    Ok(())
}

/// The best of five rounds: what else the machine does only ever adds.
fn time(name: &str, count: usize, work: impl Fn() -> f64) {
    let round = || {
        let started = ThreadTime::now();
        black_box(work());
        started.elapsed().as_secs_f64()
    };
    let best = (0..5).map(|_| round()).fold(f64::INFINITY, f64::min);
    println!("  {name}: {:.3} us a point", best * 1e6 / count as f64);
}

fn check(mesh: &CheckedMesh, distance: &SignedDistance, points: &[DVec3]) {
    for (&point, sample) in points.iter().zip(distance.sample_all(points)) {
        let squared = |triangle| closest_point(point, mesh.corners(triangle)).distance_squared;
        let least = (0..mesh.triangles.len()).map(squared).fold(f64::INFINITY, f64::min).sqrt();
        let error = (sample.distance.abs() - least).abs() / mesh.bounds.diagonal();
        assert!(error < 1e-10, "{} for {least} at {point}", sample.distance);
    }
}

fn random_points(mesh: &CheckedMesh, count: usize) -> Vec<DVec3> {
    let mut state = 1u64;
    let mut unit = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count).map(|_| mesh.bounds.min + mesh.bounds.size() * DVec3::new(unit(), unit(), unit())).collect()
}

/// Points of a lattice over the mesh's box, row by row.
fn lattice(mesh: &CheckedMesh, resolution: u32, from: UVec3, size: UVec3) -> Vec<DVec3> {
    let mut points = Vec::new();
    for z in from.z..from.z + size.z {
        for y in from.y..from.y + size.y {
            for x in from.x..from.x + size.x {
                let place = (DVec3::new(x.into(), y.into(), z.into()) + 0.5) / f64::from(resolution);
                points.push(mesh.bounds.min + mesh.bounds.size() * place);
            }
        }
    }
    points
}

/// The lattice of a small cell on the surface, as the deepest level of a tree asks for it.
fn cell_near_surface(mesh: &CheckedMesh, triangle: usize) -> Vec<DVec3> {
    let corner = mesh.corners(triangle % mesh.triangles.len())[0];
    let place = (corner - mesh.bounds.min) / mesh.bounds.size() * 2048.0;
    lattice(mesh, 2048, place.as_uvec3().saturating_sub(UVec3::splat(4)), UVec3::splat(8))
}
