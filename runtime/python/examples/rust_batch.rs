//! What `measure.py` puts beside Python: the reader's batches over the same points, without Python.
//!
//!     rust_batch FIELD POINTS
//!
//! POINTS holds `f32` triples. Prints nanoseconds of processor time a point, the least of several passes, as JSON. A pass makes
//! its arrays as a call from Python does.

use cpu_time::ThreadTime;
use std::hint::black_box;
use std::{env, fs};

const PASSES: usize = 6;

fn main() {
    let [field, points] = [1, 2].map(|index| env::args().nth(index).expect("usage: rust_batch FIELD POINTS"));
    let bytes = fs::read(field).expect("the field is readable");
    let field = reader::Field::open(&bytes).expect("the field is sound");
    let points: Vec<[f32; 3]> = fs::read(points)
        .expect("the points are readable")
        .as_chunks::<12>()
        .0
        .iter()
        .map(|triple| {
            [0, 4, 8].map(|at| f32::from_le_bytes([triple[at], triple[at + 1], triple[at + 2], triple[at + 3]]))
        })
        .collect();

    let nanoseconds = |pass: &dyn Fn()| {
        let passes = (0..PASSES).map(|_| {
            let start = ThreadTime::now();
            pass();
            start.elapsed().as_secs_f64() * 1e9 / points.len() as f64
        });
        passes.fold(f64::INFINITY, f64::min)
    };
    let distances = nanoseconds(&|| {
        let mut distances = vec![0.0; points.len()];
        field.distances(&points, &mut distances);
        black_box(distances);
    });
    let distances_and_gradients = nanoseconds(&|| {
        let (mut distances, mut gradients) = (vec![0.0; points.len()], vec![[0.0; 3]; points.len()]);
        field.distances_and_gradients(&points, &mut distances, &mut gradients);
        black_box((distances, gradients));
    });
    println!("{{\"distances\": {distances}, \"distances_and_gradients\": {distances_and_gradients}}}");
}
