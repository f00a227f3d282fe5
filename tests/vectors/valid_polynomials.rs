//! Polynomial octrees that every reader must accept (§12).

use super::polynomial::{Cell, Leaf, MAX, MIN, PolynomialOctree, SINGLE, Shape};
use super::samples::Random;
use super::writer::File;

/// Names and files.
pub(super) fn all() -> Vec<(String, File)> {
    let mut vectors = Vec::new();
    let mut add = |name: &str, file: File| vectors.push((format!("polynomial_{name}"), file));

    // Each kind and degree.
    for degree in 0..=3 {
        let leaf = |random: &mut Random| leaf(random, SINGLE, [degree, 0], [12, 11, 9, 7]);
        add(&format!("degree_{degree}"), one_leaf(leaf, 60).file());
    }
    for (name, kind) in [("min", MIN), ("max", MAX)] {
        for degrees in [[0, 0], [1, 1], [2, 1], [1, 2], [0, 3]] {
            let leaf = |random: &mut Random| leaf(random, kind, degrees, [12, 10, 7, 5]);
            add(&format!("{name}_{}_{}", degrees[0], degrees[1]), one_leaf(leaf, 61).file());
        }
    }
    add("widest", one_leaf(|random| leaf(random, SINGLE, [2, 0], [24, 16, 16, 0]), 62).file());
    add("longest_leaf", one_leaf(|random| leaf(random, MIN, [3, 3], [4, 9, 8, 8]), 62).file());
    add("without_bits", one_leaf(|random| leaf(random, MIN, [3, 3], [0; 4]), 62).file());
    add("some_degrees_without_bits", one_leaf(|random| leaf(random, MAX, [3, 2], [9, 0, 6, 0]), 62).file());

    // Trees, with leaves of any shape.
    add("eight_leaves", tree([1; 3], vec![divided(63)], 0.0).file());
    for (name, overlap) in [("least", 1.0 / 64.0), ("usual", 0.2), ("greatest", 0.25)] {
        add(&format!("overlap_{name}"), tree([3, 1, 1], three_levels(64), overlap).file());
    }
    add("root_grid", tree([3, 2, 2], (0..12).map(|index| any(65 + index)).collect(), 0.2).file());
    add("three_levels", tree([3, 1, 1], three_levels(66), 0.0).file());
    add("deepest_tree", tree([1; 3], vec![chain(16, 67)], 0.125).file());
    add("deepest_tree_without_overlap", tree([1; 3], vec![chain(16, 68)], 0.0).file());
    for levels in 1..=5 {
        let cells = vec![any(69), chain(levels, 70)];
        add(&format!("levels_apart_{levels}"), tree([2, 1, 1], cells, 0.25).file());
    }

    // The parameters.
    let eight = || tree([1; 3], vec![divided(71)], 0.2);
    add("far_from_the_origin", PolynomialOctree { box_min: [1.0e6, -2.0e6, 3.0e6], root_edge: 4.0, ..eight() }.file());
    let (least, most) = (2.0_f32.powi(-40), 2.0_f32.powi(60));
    add(
        "smallest_cells",
        PolynomialOctree { box_min: [0.0; 3], root_edge: least, quantum: least * least, ..eight() }.file(),
    );
    let largest = PolynomialOctree { box_min: [-most / 2.0; 3], root_edge: most, quantum: most, ..eight() };
    add("largest_cells", largest.file());
    let unused = Shape { kind: MAX, degrees: [3, 3], exponent: 15, widths: [24, 16, 16, 16] };
    for (name, shapes) in [("more_shape_bits_than_shapes", None), ("unused_shape", Some(unused))] {
        let mut octree = eight();
        octree.shapes.extend(shapes);
        octree.shape_bits = 10;
        octree.number();
        add(name, octree.file());
    }
    let mut reordered = eight().file();
    reordered.sections.reverse();
    add("sections_reordered", reordered);
    vectors
}

pub(super) fn tree(root_cells: [u16; 3], roots: Vec<Cell>, overlap: f32) -> PolynomialOctree {
    PolynomialOctree::new(root_cells, roots, overlap)
}

pub(super) fn one_leaf(leaf: impl FnOnce(&mut Random) -> Leaf, seed: u64) -> PolynomialOctree {
    tree([1; 3], vec![Cell::Leaf(leaf(&mut Random::new(seed)))], 0.0)
}

/// A leaf with coefficients of any code.
pub(super) fn leaf(random: &mut Random, kind: u8, degrees: [u8; 2], widths: [u8; 4]) -> Leaf {
    let highest = degrees[0].max(degrees[1]);
    let widths = [0, 1, 2, 3].map(|degree: usize| if degree <= usize::from(highest) { widths[degree] } else { 0 });
    let shape = Shape { kind, degrees, exponent: (random.word() % 3) as u8, widths };
    let code = |width: u8, word: u32| match width {
        0 => 0,
        _ => (word & ((1 << width) - 1)).cast_signed() - (1 << (width - 1)),
    };
    let coefficients = shape.widths().map(|width| code(width, random.word())).collect();
    Leaf { shape, coefficients }
}

/// A leaf of one of a few shapes.
pub(super) fn any(seed: u64) -> Cell {
    let mut random = Random::new(seed);
    let degrees = [[0, 0], [1, 0], [2, 0], [3, 0], [1, 1], [2, 1], [2, 2], [1, 2]][(seed % 8) as usize];
    let kind = if seed % 8 < 4 { SINGLE } else { MIN + (seed / 8 % 2) as u8 };
    Cell::Leaf(leaf(&mut random, kind, degrees, [11, 9, 7, 5]))
}

/// Eight leaves.
pub(super) fn divided(seed: u64) -> Cell {
    Cell::with_children(|child| any(seed * 8 + child as u64))
}

/// A leaf, a cell of eight leaves, and one of seven leaves and eight smaller ones.
pub(super) fn three_levels(seed: u64) -> Vec<Cell> {
    let mixed = Cell::with_children(|child| if child == 3 { divided(seed) } else { any(seed + child as u64) });
    vec![any(seed + 10), divided(seed + 1), mixed]
}

/// Divided again and again toward the least corner.
pub(super) fn chain(levels: u64, seed: u64) -> Cell {
    match levels {
        0 => any(seed),
        _ => Cell::with_children(|child| match child {
            0 => chain(levels - 1, seed + 1),
            _ => any(seed * 8 + child as u64),
        }),
    }
}
