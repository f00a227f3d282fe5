//! Makes queries of one kind, for a profiler to count their instructions: `docs/measurements/reader.md` says how.
//!
//! `queries FILE KIND [COUNT]`, where the kind is one of [`KINDS`].

use std::hint::black_box;
use std::process::ExitCode;

use nearfield::Field;

const KINDS: &str = "distance, gradient, unblended, row-distance, row-gradient, cursor-distance, cursor-gradient, \
                     centre-distance, centre-gradient, sorted-gradient, batch-distance, batch-gradient, \
                     row-batch-distance, row-batch-gradient, sorted-batch-gradient";

/// Points of a row across the box, and of a walk about the middle of a leaf.
const ROW: usize = 1000;
const WALK: usize = 100;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let (Some(file), Some(kind)) = (arguments.get(1), arguments.get(2)) else {
        eprintln!("queries FILE KIND [COUNT], where KIND is one of {KINDS}");
        return ExitCode::from(2);
    };
    let count = arguments.get(3).map_or(Ok(20_000), |count| count.parse());
    let (Ok(bytes), Ok(count)) = (std::fs::read(file), count) else {
        eprintln!("cannot read {file}, or COUNT is not a number");
        return ExitCode::FAILURE;
    };
    let Ok(field) = Field::open(&bytes) else {
        eprintln!("{file} is not a field");
        return ExitCode::FAILURE;
    };

    match kind.as_str() {
        "distance" => every(&scattered(&field, count), |point| field.distance(point)),
        "gradient" => every(&scattered(&field, count), |point| field.distance_and_gradient(point)),
        "row-distance" => every(&rows(&field, count), |point| field.distance(point)),
        "row-gradient" => every(&rows(&field, count), |point| field.distance_and_gradient(point)),
        "sorted-gradient" => every(&sorted(&field, count), |point| field.distance_and_gradient(point)),
        "sorted-batch-gradient" => batch(&field, &sorted(&field, count), true),
        "batch-distance" => batch(&field, &scattered(&field, count), false),
        "batch-gradient" => batch(&field, &scattered(&field, count), true),
        "row-batch-distance" => batch(&field, &rows(&field, count), false),
        "row-batch-gradient" => batch(&field, &rows(&field, count), true),
        "unblended" | "centre-distance" | "centre-gradient" if field.polynomial_octree().is_none() => {
            eprintln!("{kind} asks for an octree of polynomials");
            return ExitCode::FAILURE;
        }
        "unblended" => {
            let octree = field.polynomial_octree().expect("an octree of polynomials");
            every(&scattered(&field, count), |point| octree.unblended(point));
        }
        _ => {
            let points = if kind.starts_with("centre") { centres(&field, count) } else { rows(&field, count) };
            let mut cursor = field.cursor();
            match kind.as_str() {
                "cursor-distance" | "centre-distance" => every(&points, |point| cursor.distance(point)),
                "cursor-gradient" | "centre-gradient" => every(&points, |point| cursor.distance_and_gradient(point)),
                _ => {
                    eprintln!("the kinds are {KINDS}");
                    return ExitCode::from(2);
                }
            }
        }
    }
    ExitCode::SUCCESS
}

/// All points in one call.
fn batch(field: &Field<'_>, points: &[[f32; 3]], with_gradient: bool) {
    let (mut distances, mut gradients) = (vec![0.0; points.len()], vec![[0.0; 3]; points.len()]);
    every(&[[0.0; 3]], |_| {
        if with_gradient {
            field.distances_and_gradients(points, &mut distances, &mut gradients)
        } else {
            field.distances(points, &mut distances)
        }
    });
}

/// What is counted: the queries and their loop.
#[inline(never)]
fn every<T>(points: &[[f32; 3]], mut query: impl FnMut([f32; 3]) -> T) {
    for &point in points {
        black_box(query(black_box(point)));
    }
}

/// The same numbers from 0 to 1 on any machine (Steele, Lea and Flood 2014).
fn numbers() -> impl FnMut() -> f32 {
    let mut state = 0_u64;
    move || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (state ^ state >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        (mixed >> 40) as f32 / (1 << 24) as f32
    }
}

/// A point of the box by its parts of the box.
fn within(field: &Field<'_>, parts: [f32; 3]) -> [f32; 3] {
    let bounds = field.header().bounds;
    [0, 1, 2].map(|axis: usize| bounds.min[axis] + parts[axis] * (bounds.max[axis] - bounds.min[axis]))
}

/// Points anywhere in the box.
fn scattered(field: &Field<'_>, count: usize) -> Vec<[f32; 3]> {
    let mut number = numbers();
    (0..count).map(|_| within(field, [number(), number(), number()])).collect()
}

/// The same, those of a cube of 1/64 of the box after one another.
fn sorted(field: &Field<'_>, count: usize) -> Vec<[f32; 3]> {
    let bounds = field.header().bounds;
    let mut points = scattered(field, count);
    let cube = |point: &[f32; 3]| {
        [2, 1, 0]
            .map(|axis: usize| (64.0 * (point[axis] - bounds.min[axis]) / (bounds.max[axis] - bounds.min[axis])) as u8)
    };
    // The bits of the axes by turns, the highest first (Morton 1966).
    points.sort_by_key(|point| {
        let cube = cube(point);
        (0..6).rev().fold(0_u32, |key, bit| cube.iter().fold(key, |key, part| key << 1 | u32::from(part >> bit & 1)))
    });
    points
}

/// Points of rows along x anywhere in the box.
fn rows(field: &Field<'_>, count: usize) -> Vec<[f32; 3]> {
    let mut number = numbers();
    let starts: Vec<[f32; 2]> = (0..count.div_ceil(ROW)).map(|_| [number(), number()]).collect();
    let part = |index: usize| (index % ROW) as f32 / ROW as f32;
    (0..count).map(|index| within(field, [part(index), starts[index / ROW][0], starts[index / ROW][1]])).collect()
}

/// Points about the middle of leaves, where they are alone; many of a leaf one after the other.
fn centres(field: &Field<'_>, count: usize) -> Vec<[f32; 3]> {
    let octree = field.polynomial_octree().expect("an octree of polynomials");
    let leaves: Vec<nearfield::Leaf> = octree.leaves().collect();
    let lattice = octree.lattice().map(|cells| cells as f32);
    let mut number = numbers();
    let mut point = |index: usize| {
        let leaf = leaves[index / WALK * 97 % leaves.len()];
        let mut cells = |axis: usize| leaf.cell[axis] as f32 + (0.4 + 0.2 * number()) * leaf.edge as f32;
        within(field, [cells(0) / lattice[0], cells(1) / lattice[1], cells(2) / lattice[2]])
    };
    (0..count).map(&mut point).collect()
}
