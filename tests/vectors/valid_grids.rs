//! Grids that every reader must accept, most of which the baker would never write.

use super::grid::{BLEND, BRICK, Grid, HALF, HERMITE, LINEAR, Like, NEAREST, WHOLE};
use super::samples::{F16, F32, PACKED32};
use super::writer::File;

const RECONSTRUCTIONS: [(&str, u8, &[u8]); 5] = [
    ("nearest", NEAREST, &[0, 1, 2, 3]),
    ("linear", LINEAR, &[0, 1, 2, 3]),
    ("half", HALF, &[1, 2, 3]),
    ("blend", BLEND, &[1, 2, 3]),
    ("hermite", HERMITE, &[1, 2]),
];

/// Names and files.
pub(super) fn all() -> Vec<(String, File)> {
    let mut vectors = Vec::new();
    let mut add = |name: &str, file: File| vectors.push((format!("grid_{name}"), file));

    // Each order with each reconstruction that it allows.
    for (name, reconstruction, orders) in RECONSTRUCTIONS {
        for &order in orders {
            let like = Like { order, reconstruction, resolution: small(order), ..LIKE };
            add(&format!("{name}_order_{order}"), Grid::new(like, 30).file());
        }
    }

    // Each precision and range.
    for (name, precision) in [("packed32", PACKED32), ("f16", F16), ("f32", F32)] {
        for order in 0..=3 {
            let like = Like { order, precision, resolution: small(order), ..LIKE };
            if precision != PACKED32 {
                add(&format!("linear_order_{order}_{name}"), Grid::new(like, 31).file());
            }
            if precision != F32 {
                let resolution = if order < 2 { [9, 4, 5] } else { [5, 3, 2] };
                let like = Like { range: BRICK, resolution, ..like };
                add(&format!("bricks_order_{order}_{name}"), Grid::new(like, 32).file());
            }
        }
    }
    add("bricks_along_every_axis", Grid::new(Like { order: 0, range: BRICK, resolution: [5; 3], ..LIKE }, 33).file());

    // Shapes.
    for order in 0..=3 {
        add(&format!("two_samples_order_{order}"), Grid::new(Like { order, resolution: [2; 3], ..LIKE }, 34).file());
    }
    add("half_word_after_last_sample", Grid::new(Like { order: 0, resolution: [3; 3], ..LIKE }, 35).file());
    let moved = |box_min, spacing, quantum| {
        let like = Like { order: 3, resolution: [3, 2, 2], precision: F16, reconstruction: BLEND, ..LIKE };
        Grid { box_min, spacing, quantum, ..Grid::new(like, 36) }.file()
    };
    add("spacings_far_apart", moved([0.0; 3], [1024.0, 1.0, 32.0], 1.0 / 64.0));
    add("negative_coordinates", moved([-900.0, -50.5, -7.25], [0.3, 0.2, 0.1], 1.0 / 64.0));
    add("far_from_the_origin", moved([1.0e6, -2.0e6, 3.0e6], [4.0, 2.0, 8.0], 1.0 / 64.0));
    add("largest_coordinates", moved([-two_to(59); 3], [two_to(59); 3], two_to(60)));
    add("smallest_spacing", moved([0.0; 3], [two_to(-40); 3], two_to(-80)));

    // Extreme numbers.
    for (name, base) in [("least_base", -(1 << 27)), ("greatest_base", (1 << 27) - (1 << 12))] {
        add(name, Grid { bases: Some(vec![base]), ..Grid::new(LIKE, 37) }.file());
    }
    let mut largest = Grid::new(Like { order: 2, resolution: [2; 3], precision: F32, ..LIKE }, 38);
    for word in &mut largest.samples {
        *word = *word & 1 << 31 | two_to(60).to_bits();
    }
    add("largest_samples", largest.file());

    // The container.
    let mut reordered = Grid::new(LIKE, 39).file();
    reordered.sections.reverse();
    add("sections_reordered", reordered);
    let mut unknown = Grid::new(LIKE, 39).file();
    unknown.sections.insert(1, (*b"WHAT", b"ever".to_vec()));
    unknown.sections.push((*b"NODE", b"none".to_vec()));
    add("sections_of_no_grid", unknown);
    let bases = Some(vec![i32::MIN; 2]);
    add("bases_that_floats_ignore", Grid { bases, ..Grid::new(Like { precision: F32, ..LIKE }, 39) }.file());
    vectors
}

const LIKE: Like = Like { resolution: [5, 4, 3], order: 1, reconstruction: LINEAR, precision: PACKED32, range: WHOLE };

/// Few samples where they are large.
fn small(order: u8) -> [u16; 3] {
    match order {
        0 | 1 => [5, 4, 3],
        2 => [4, 3, 2],
        _ => [2, 3, 2],
    }
}

fn two_to(power: i32) -> f32 {
    2.0_f32.powi(power)
}
