//! Files that every reader must accept, most of which the baker would never write.

use super::lods;
use super::samples::{ALL, Block, CENTRE, F16, F32, PACKED32, PARENT_CORNERS, Random};
use super::valid_grids;
use super::valid_polynomials;
use super::writer::{Cell, File, Octree, TRICUBIC, TRILINEAR, corners};

const INTERPOLANTS: [(&str, u8); 2] = [("trilinear", TRILINEAR), ("tricubic", TRICUBIC)];
const PRECISIONS: [(&str, u32); 3] = [("packed32", PACKED32), ("f16", F16), ("f32", F32)];

/// Names and bytes.
pub(crate) fn all() -> Vec<(String, Vec<u8>)> {
    let mut vectors = Vec::new();
    let mut add = |name: &str, file: File| vectors.push((name.to_owned(), file.bytes()));

    // Each payload.
    for (interpolant_name, interpolant) in INTERPOLANTS {
        for (precision_name, precision) in PRECISIONS {
            let octree = |cell, seed| octree(interpolant, vec![cell], Like { precision, ..Like::default() }, seed);
            let name = format!("{interpolant_name}_{precision_name}");
            add(&format!("one_leaf_{name}"), octree(Cell::Leaf, 1).file());
            add(&format!("eight_leaves_{name}"), octree(Cell::divided(), 2).file());
        }
    }
    for (name, precision) in PRECISIONS {
        // Full samples shift those after them, so let some be.
        let like = Like { precision, full: 0o_123_456_707, ..Like::default() };
        add(&format!("full_samples_{name}"), octree(TRICUBIC, vec![Cell::divided()], like, 3).file());
        let like = Like { precision, full: ALL, ..Like::default() };
        add(&format!("all_samples_full_{name}"), octree(TRICUBIC, vec![Cell::Leaf], like, 4).file());
    }
    add("precision_of_each_block", precision_of_each_block().file());

    // Implied samples.
    for (name, interpolant) in INTERPOLANTS {
        let implied = |absent| Like { absent, ..Like::default() };
        let middles = ALL & !PARENT_CORNERS & !CENTRE;
        let divided = || vec![Cell::divided()];
        add(&format!("implied_edge_{name}"), octree(interpolant, divided(), implied(1 << 1), 5).file());
        add(&format!("implied_face_{name}"), octree(interpolant, divided(), implied(0b010_111_010), 6).file());
        add(&format!("implied_middles_{name}"), octree(interpolant, divided(), implied(middles), 7).file());
    }
    for (name, precision) in PRECISIONS {
        let like = Like { precision, full: PARENT_CORNERS, absent: ALL & !PARENT_CORNERS & !CENTRE, ..Like::default() };
        add(&format!("implied_by_full_samples_{name}"), octree(TRICUBIC, vec![Cell::divided()], like, 8).file());
    }

    // Trees.
    add("three_levels", octree_of_three_levels().file());
    add("samples_that_no_leaf_needs", samples_that_no_leaf_needs().file());
    add("deepest_tree", octree(TRICUBIC, vec![chain(16)], Like::default(), 11).file());
    add("root_grid", Octree { root_cells: [3, 2, 2], ..octree(TRICUBIC, vec![Cell::Leaf; 12], small(), 12) }.file());
    add("widest_lattice", widest_lattice().file());

    // Extreme numbers.
    for (name, base) in [("least_base", -(1 << 27)), ("greatest_base", (1 << 27) - (1 << 12))] {
        let like = Like { base, ..Like::default() };
        add(&format!("{name}_tricubic"), octree(TRICUBIC, vec![Cell::Leaf], like, 13).file());
        add(&format!("{name}_trilinear"), octree(TRILINEAR, vec![Cell::Leaf], like, 13).file());
    }
    add("negative_coordinates", moved([-900.0, -50.5, -7.25], 2.0, 1.0 / 64.0).file());
    add("far_from_the_origin", moved([1.0e6, -2.0e6, 3.0e6], 4.0, 1.0 / 64.0).file());
    add("largest_coordinates", moved([-two_to(59); 3], two_to(60), two_to(60)).file());
    add("smallest_cells", moved([0.0; 3], two_to(-40), two_to(-80)).file());
    add("largest_samples", largest_samples().file());
    add("subnormal_halves", subnormal_halves().file());

    // The container.
    for (name, continuity) in [("c0", 1), ("c1", 2)] {
        add(&format!("continuity_{name}"), Octree { continuity, ..octree_of_one_leaf() }.file());
    }
    for (name, sign_method) in [("none", 0), ("winding", 2), ("rays", 3), ("sheet", 4)] {
        add(&format!("sign_method_{name}"), File { sign_method, ..octree_of_one_leaf().file() });
    }
    let unmeasured = File { contract: [0.0; 7], sample_count: 0, doubtful_signs: 0, ..octree_of_one_leaf().file() };
    add("unmeasured", unmeasured);
    add("unused_bits_set", File { unused: u32::MAX, ..octree_of_one_leaf().file() });
    let mut reordered = octree_of_one_leaf().file();
    reordered.sections.reverse();
    add("sections_reordered", reordered);
    let mut unknown = octree_of_one_leaf().file();
    unknown.sections.insert(1, (*b"WHAT", b"ever".to_vec()));
    unknown.sections.push((*b"NONE", Vec::new()));
    add("unknown_sections", unknown);
    let mut many = octree_of_one_leaf().file();
    many.sections.extend((0..13).map(|index| ([b'X', b'0', b'0', b'A' + index], vec![index; 4])));
    add("sixteen_sections", many);

    for (name, file) in valid_grids::all().into_iter().chain(valid_polynomials::all()).chain(lods::valid()) {
        add(&name, file);
    }

    vectors
}

/// What the blocks of a file have in common. They hold what their leaves need, without those that are absent.
#[derive(Clone, Copy)]
struct Like {
    precision: u32,
    full: u32,
    absent: u32,
    base: i32,
}

impl Default for Like {
    fn default() -> Self {
        Self { precision: PACKED32, full: 0, absent: 0, base: -2000 }
    }
}

fn small() -> Like {
    Like { precision: F16, base: -100, ..Like::default() }
}

fn octree(interpolant: u8, roots: Vec<Cell>, like: Like, seed: u64) -> Octree {
    let mut random = Random::new(seed);
    Octree::new(interpolant, roots, |needed| {
        let Like { precision, full, absent, base } = like;
        let present = needed & !absent;
        random.block(Block { interpolant, precision, present, full: full & present, base })
    })
}

pub(super) fn octree_of_one_leaf() -> Octree {
    octree(TRICUBIC, vec![Cell::Leaf], Like::default(), 1)
}

pub(super) fn octree_of_three_levels() -> Octree {
    octree(TRICUBIC, three_levels(), Like::default(), 9)
}

/// A leaf, a cell of eight leaves, and one of seven leaves and eight smaller ones.
pub(super) fn three_levels() -> Vec<Cell> {
    let mixed = Cell::with_children(|child| if child == 3 { Cell::divided() } else { Cell::Leaf });
    vec![Cell::Leaf, Cell::divided(), mixed]
}

/// Divided again and again toward the least corner.
fn chain(levels: u32) -> Cell {
    match levels {
        0 => Cell::Leaf,
        _ => Cell::with_children(|child| if child == 0 { chain(levels - 1) } else { Cell::Leaf }),
    }
}

/// Blocks of one file differ in precision.
fn precision_of_each_block() -> Octree {
    let mut random = Random::new(10);
    let mut precisions = [F32, PACKED32, F16, F32].into_iter();
    Octree::new(TRICUBIC, three_levels(), |present| {
        let precision = precisions.next().expect("four blocks");
        let full = present & 0o_070_707_070;
        random.block(Block { interpolant: TRICUBIC, precision, present, full, base: -1000 })
    })
}

/// One leaf among inner siblings, and a block with all samples.
fn samples_that_no_leaf_needs() -> Octree {
    let mut random = Random::new(10);
    let mixed = Cell::with_children(|child| if child == 5 { Cell::Leaf } else { Cell::divided() });
    Octree::new(TRILINEAR, vec![mixed], |_| {
        random.block(Block { interpolant: TRILINEAR, precision: PACKED32, present: ALL, full: 0, base: -1000 })
    })
}

/// 2²⁰ finest cells along x, in 64 leaves.
fn widest_lattice() -> Octree {
    Octree { depth: 14, ..octree(TRILINEAR, vec![Cell::Leaf; 64], Like::default(), 14) }
}

/// Eight leaves elsewhere, of another size.
fn moved(box_min: [f32; 3], root_edge: f32, quantum: f32) -> Octree {
    Octree { box_min, root_edge, quantum, ..octree(TRICUBIC, vec![Cell::divided()], Like::default(), 15) }
}

/// Distances, slopes and mixed derivatives of ±2⁶⁰.
fn largest_samples() -> Octree {
    let most = two_to(60).to_bits();
    let samples = [corners(0) | F32 << 27, corners(0), 0];
    let numbers = (0..64_u32).map(|index| most | (index.count_ones() % 2) << 31);
    let octree = octree_of_one_leaf();
    Octree { root_edge: 1.0, samples: samples.into_iter().chain(numbers).collect(), ..octree }
}

/// Gradients that are the smallest half floats.
fn subnormal_halves() -> Octree {
    let mut octree = octree(TRICUBIC, vec![Cell::Leaf], Like { precision: F16, base: 0, ..Like::default() }, 16);
    for (index, sample) in octree.samples[3..].chunks_mut(2).enumerate() {
        let tiny = 1 + index as u32;
        sample.copy_from_slice(&[tiny << 16, (0x8000 | tiny) | (0x3FF - tiny) << 16]);
    }
    octree
}

fn two_to(power: i32) -> f32 {
    2.0_f32.powi(power)
}
