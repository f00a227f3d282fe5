//! `nearfield-peers MESH...`: microseconds of CPU a query, ours beside those of other crates, on one thread.
//!
//! Every answer is compared before anything is timed: ours with a search through all triangles in double precision, theirs
//! with ours. Peers answer in single precision; none is timed whose answers are wrong.

mod peers;

use cpu_time::ThreadTime;
use glam::DVec3;
use nearfield_bake::distance::triangle::closest_point;
use nearfield_bake::distance::{SignChoice, SignedDistance};
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::import;
use nearfield_bake::mesh::CheckedMesh;
use peers::{BvhCrate, Parry, Peer};
use std::error::Error;
use std::hint::black_box;

/// Points anywhere in the mesh's box.
const RANDOM: usize = 50_000;
/// Samples along each axis of a lattice over the mesh's box, and how many of its layers are sampled, about the middle.
const LATTICE: usize = 128;
const LAYERS: usize = 8;
/// Points that are compared with all triangles.
const CHECKED: usize = 200;
/// Rounds, the best of which counts: what else the machine does only ever adds.
const ROUNDS: usize = 3;
/// What answers may be off by, as a fraction of the diagonal: ours, and those of single precision.
const OURS: f64 = 1e-12;
const THEIRS: f64 = 1e-5;

fn main() -> Result<(), Box<dyn Error>> {
    let paths: Vec<String> = std::env::args().skip(1).collect();
    if paths.is_empty() {
        return Err("usage: nearfield-peers MESH...".into());
    }
    println!("| mesh | engine | sign | random us | lattice us |");
    println!("| --- | --- | --- | --- | --- |");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for path in paths {
        let mesh = CheckedMesh::new(import::read(&path)?)?;
        let name = path.rsplit('/').next().unwrap_or(&path);
        pool.install(|| compare(name, &mesh));
    }
    Ok(())
}

/// A row for each engine.
fn compare(name: &str, mesh: &CheckedMesh) {
    let (distance, decision) = SignedDistance::choose(mesh, SignChoice::Auto);
    let sets = [random_points(mesh), lattice(mesh)];
    let exact =
        sets.each_ref().map(|points| distance.sample_all(points).iter().map(|s| s.distance).collect::<Vec<_>>());
    for (points, exact) in sets.iter().zip(&exact) {
        check(mesh, points, exact);
    }

    let one_by_one = |points: &[DVec3]| points.iter().map(|&point| distance.sample(point).distance).sum::<f64>();
    let batch = |points: &[DVec3]| distance.sample_all(points).iter().map(|s| s.distance).sum::<f64>();
    let times = [time(&sets[0], one_by_one), time(&sets[1], batch)];
    println!("| {name} | Nearfield | {:?} | {:.2} | {:.2} |", decision.method, times[0], times[1]);

    let peers: [Option<Box<dyn Peer>>; 3] = [
        Parry::unsigned(mesh).map(|peer| Box::new(peer) as _),
        Parry::signed(mesh).map(|peer| Box::new(peer) as _),
        Some(Box::new(BvhCrate::new(mesh))),
    ];
    for peer in peers.iter().flatten() {
        let wrong = sets.iter().zip(&exact).map(|(points, exact)| disagreements(peer.as_ref(), mesh, points, exact));
        let wrong: usize = wrong.sum();
        let sign = if peer.is_signed() { "pseudonormal" } else { "none" };
        if wrong > 0 {
            println!("| {name} | {} | {sign} | wrong at {wrong} points | |", peer.name());
            continue;
        }
        let all = |points: &[DVec3]| points.iter().map(|&point| peer.distance(point)).sum::<f64>();
        let times = [time(&sets[0], all), time(&sets[1], all)];
        println!("| {name} | {} | {sign} | {:.2} | {:.2} |", peer.name(), times[0], times[1]);
    }
}

/// Points whose distance, or sign if there is one, a peer tells otherwise.
fn disagreements(peer: &dyn Peer, mesh: &CheckedMesh, points: &[DVec3], exact: &[f64]) -> usize {
    let tolerance = THEIRS * mesh.bounds.diagonal();
    let disagrees = |&(&point, &exact): &(&DVec3, &f64)| {
        let expected = if peer.is_signed() { exact } else { exact.abs() };
        (peer.distance(point) - expected).abs() > tolerance
    };
    points.iter().zip(exact).filter(disagrees).count()
}

fn check(mesh: &CheckedMesh, points: &[DVec3], exact: &[f64]) {
    for (&point, exact) in points.iter().zip(exact).step_by(points.len() / CHECKED) {
        let squared = |triangle| closest_point(point, mesh.corners(triangle)).distance_squared;
        let least = (0..mesh.triangles.len()).map(squared).fold(f64::INFINITY, f64::min).sqrt();
        let error = (exact.abs() - least).abs();
        assert!(error <= OURS * mesh.bounds.diagonal(), "{exact} for {least} at {point}");
    }
}

/// Microseconds a point.
fn time(points: &[DVec3], work: impl Fn(&[DVec3]) -> f64) -> f64 {
    let round = || {
        let started = ThreadTime::now();
        black_box(work(black_box(points)));
        started.elapsed().as_secs_f64()
    };
    let best = (0..ROUNDS).map(|_| round()).fold(f64::INFINITY, f64::min);
    best * 1e6 / points.len() as f64
}

fn random_points(mesh: &CheckedMesh) -> Vec<DVec3> {
    let mut state = 1u64;
    let mut unit = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..RANDOM).map(|_| mesh.bounds.min + mesh.bounds.size() * DVec3::new(unit(), unit(), unit())).collect()
}

/// The middle layers of the lattice, row by row.
fn lattice(mesh: &CheckedMesh) -> Vec<DVec3> {
    let first = (LATTICE - LAYERS) / 2;
    let places = (first..first + LAYERS).flat_map(|z| {
        (0..LATTICE).flat_map(move |y| (0..LATTICE).map(move |x| DVec3::new(x as f64, y as f64, z as f64)))
    });
    places.map(|place| mesh.bounds.min + mesh.bounds.size() * (place + 0.5) / LATTICE as f64).collect()
}
