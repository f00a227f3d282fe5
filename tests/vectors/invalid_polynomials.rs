//! Polynomial octrees that every reader must refuse, each for one reason (§12).

use super::invalid::{above, below, two_to};
use super::polynomial::{Cell, MAX, MIN, PolynomialOctree, SINGLE, Shape};
use super::samples::Random;
use super::valid_polynomials::{any, chain, divided, leaf, one_leaf, three_levels, tree};
use super::writer::File;

const ROOT: usize = 1;
const SHAPES: usize = 2;
const RECORDS: usize = 3;
const LEAVES: usize = 4;

/// Names, reasons and files.
pub(super) fn all() -> Vec<(String, &'static str, File)> {
    let mut vectors = Vectors::default();
    sections(&mut vectors);
    parameters(&mut vectors);
    shapes(&mut vectors);
    order(&mut vectors);
    leaves(&mut vectors);
    overlap(&mut vectors);
    vectors.0
}

#[derive(Default)]
struct Vectors(Vec<(String, &'static str, File)>);

impl Vectors {
    /// A change of the file.
    fn file(&mut self, name: &str, error: &'static str, change: impl FnOnce(&mut File)) {
        let mut file = octree().file();
        change(&mut file);
        self.0.push((format!("polynomial_{name}"), error, file));
    }

    /// A change of the octree. The box stays.
    fn octree(&mut self, name: &str, error: &'static str, change: impl FnOnce(&mut PolynomialOctree)) {
        self.changed(name, error, octree(), change);
    }

    fn changed(
        &mut self,
        name: &str,
        error: &'static str,
        mut octree: PolynomialOctree,
        change: impl FnOnce(&mut PolynomialOctree),
    ) {
        let file = octree.file();
        change(&mut octree);
        self.0.push((format!("polynomial_{name}"), error, File { sections: octree.file().sections, ..file }));
    }
}

/// Three root cells: a leaf, eight leaves, and two levels.
fn octree() -> PolynomialOctree {
    tree([3, 1, 1], three_levels(80), 0.2)
}

/// §4.
fn sections(vectors: &mut Vectors) {
    for (index, name) in ["ptre", "root", "shpe", "tree", "leaf"].into_iter().enumerate() {
        vectors.file(&format!("section_{name}_missing"), "SectionMissing", |file| drop(file.sections.remove(index)));
    }
    vectors.file("that_is_called_an_octree", "SectionMissing", |file| file.family = 2);
}

/// §12.1.
fn parameters(vectors: &mut Vectors) {
    vectors.file("parameters_short", "OctreeLength", |file| file.sections[0].1.truncate(24));
    vectors.file("parameters_long", "OctreeLength", |file| file.sections[0].1.extend([0; 4]));
    for byte in 0..3 {
        vectors.octree(&format!("reserved_{byte}"), "Reserved", |octree| octree.reserved[byte] = 1);
    }
    vectors.octree("no_root_cells", "OctreeLattice", |octree| octree.root_cells[1] = 0);
    vectors.octree("too_deep", "OctreeLattice", |octree| octree.depth = 17);
    vectors.octree("lattice_too_wide", "OctreeLattice", |octree| (octree.depth, octree.root_cells[0]) = (16, 17));
    vectors.octree("more_root_cells_than_words", "NodeLength", |octree| octree.root_cells[2] = 2);
    for (name, edge) in [("nan", f32::NAN), ("too_small", below(two_to(-40))), ("too_large", above(two_to(60)))] {
        vectors.octree(&format!("edge_{name}"), "OctreeScale", |octree| octree.root_edge = edge);
    }
    for (name, quantum) in [("zero", 0.0), ("too_small", below(two_to(-80))), ("too_large", above(2.0))] {
        vectors.octree(&format!("quantum_{name}"), "OctreeScale", |octree| octree.quantum = quantum);
    }
    vectors.file("box_too_long", "OctreeBounds", |file| file.box_max[0] += 0.01);
    for bits in [0, 11, 255] {
        vectors.file(&format!("shape_bits_{bits}"), "ShapeBits", |file| file.sections[0].1[7] = bits);
    }
    for (name, overlap) in
        [("nan", f32::NAN), ("negative", -0.2), ("too_small", below(two_to(-6))), ("too_large", above(0.25))]
    {
        vectors.octree(&format!("overlap_{name}"), "Overlap", |octree| octree.overlap = overlap);
    }
    for continuity in [0, 1, 3] {
        let name = format!("continuity_{continuity}_with_overlap");
        vectors.octree(&name, "Continuity", |octree| octree.continuity = continuity);
    }
    let alone = || tree([1; 3], vec![any(81)], 0.0);
    vectors.changed("continuity_without_overlap", "Continuity", alone(), |octree| octree.continuity = 2);
}

/// §12.4.
fn shapes(vectors: &mut Vectors) {
    let cubic = || one_leaf(|random: &mut Random| leaf(random, MIN, [3, 3], [5, 4, 3, 2]), 82);
    let single = || one_leaf(|random: &mut Random| leaf(random, SINGLE, [1, 0], [5, 4, 0, 0]), 83);
    let of_shape = |bytes: [u8; 8]| move |file: &mut File| file.sections[SHAPES].1 = bytes.to_vec();
    let mut shape = |name: &str, octree: PolynomialOctree, bytes: [u8; 8]| {
        let mut file = octree.file();
        of_shape(bytes)(&mut file);
        vectors.0.push((format!("polynomial_shape_{name}"), "Shape", file));
    };
    shape("kind_3", cubic(), [3, 3, 3, 0, 5, 4, 3, 2]);
    shape("first_degree_4", cubic(), [1, 4, 3, 0, 5, 4, 3, 2]);
    shape("second_degree_4", cubic(), [1, 3, 4, 0, 5, 4, 3, 2]);
    shape("single_with_second_degree", single(), [0, 1, 1, 0, 5, 4, 0, 0]);
    shape("exponent_16", single(), [0, 1, 0, 16, 5, 4, 0, 0]);
    shape("constant_of_25_bits", single(), [0, 1, 0, 0, 25, 4, 0, 0]);
    shape("linear_of_17_bits", single(), [0, 1, 0, 0, 5, 17, 0, 0]);
    shape("square_of_17_bits", cubic(), [1, 3, 3, 0, 5, 4, 17, 2]);
    shape("cubic_of_17_bits", cubic(), [1, 3, 3, 0, 5, 4, 3, 17]);
    shape("bits_of_no_degree", single(), [0, 1, 0, 0, 5, 4, 0, 1]);

    vectors.octree("shapes_out_of_order", "ShapeOrder", |octree| octree.shapes.swap(0, 1));
    vectors.file("shape_twice", "ShapeOrder", |file| {
        let last = file.sections[SHAPES].1.last_chunk::<8>().expect("a shape").to_vec();
        file.sections[SHAPES].1.extend(last);
    });
    vectors.file("half_a_shape", "ShapeOrder", |file| file.sections[SHAPES].1.extend([9, 0, 0, 0]));
    vectors.changed("more_shapes_than_bits", "ShapeOrder", single(), |octree| {
        let widest = |exponent| Shape { kind: MAX, degrees: [3, 3], exponent, widths: [9; 4] };
        octree.shapes.extend([widest(0), widest(1)]);
    });
    vectors.changed("shape_that_is_not_there", "LeafShape", single(), |octree| {
        octree.shapes.insert(0, Shape { kind: SINGLE, degrees: [0, 0], exponent: 0, widths: [5, 0, 0, 0] })
    });
    let (name, error, file) = vectors.0.last_mut().expect("the one before");
    assert_eq!((name.as_str(), *error), ("polynomial_shape_that_is_not_there", "LeafShape"));
    file.sections[SHAPES].1.drain(8..);
}

/// §12.2, §12.3.
fn order(vectors: &mut Vectors) {
    vectors.file("root_word_too_many", "RootLength", |file| file.sections[ROOT].1.extend([0; 4]));
    vectors.octree("root_leaf_elsewhere", "LeafOrder", |octree| octree.roots[0] += 1);
    vectors.octree("root_record_elsewhere", "RecordOrder", |octree| octree.roots[1] += 1);
    vectors.octree("root_record_beyond", "RecordOrder", |octree| octree.roots[1] = 0x7FFF_FFFF);
    vectors.octree("record_of_itself", "RecordOrder", |octree| octree.records[1].child = 1);
    vectors.octree("record_without_inner_child_names_another", "RecordOrder", |octree| octree.records[0].child += 1);
    vectors.octree("first_leaf_elsewhere", "LeafOrder", |octree| octree.records[0].leaf += 1);
    vectors.octree("later_leaf_elsewhere", "LeafOrder", |octree| octree.records[0].starts[3] += 1);
    vectors.octree("inner_child_elsewhere", "RecordOrder", |octree| octree.records[1].starts[2] += 1);
    vectors.octree("leaf_called_inner", "RecordOrder", |octree| octree.records[0].inner = 0x80);
    vectors.octree("record_too_many", "RecordOrder", |octree| octree.records.push(octree.records[2].clone()));
    vectors.octree("record_missing", "RecordOrder", |octree| octree.records.truncate(2));
    vectors.octree("deeper_than_the_depth", "NodeDepth", |octree| octree.depth = 1);
    let far = tree([1; 3], vec![chain(3, 90)], 0.0);
    vectors.changed("deeper_than_a_depth_of_two", "NodeDepth", far, |octree| octree.depth = 2);
    let root = || tree([1; 3], vec![divided(84)], 0.0);
    vectors.changed("root_deeper_than_the_depth", "NodeDepth", root(), |octree| octree.depth = 0);
    vectors.octree("leaf_count_less", "LeafCount", |octree| octree.leaf_count -= 1);
    vectors.octree("leaf_count_more", "LeafCount", |octree| octree.leaf_count += 1);
    vectors.file("record_padding", "Reserved", |file| *file.sections[RECORDS].1.last_mut().expect("bytes") = 1);
}

/// §12.5.
fn leaves(vectors: &mut Vectors) {
    let long = |widths| one_leaf(move |random: &mut Random| leaf(random, MIN, [3, 3], widths), 85);
    vectors.changed("leaf_of_41_bytes", "LeafLength", long([5, 9, 8, 8]), |_| ());
    vectors.file("leaves_without_padding", "LeafLength", |file| {
        let length = file.sections[LEAVES].1.len();
        file.sections[LEAVES].1.truncate(length - 4);
    });
    vectors.file("leaves_with_more_padding", "LeafLength", |file| file.sections[LEAVES].1.extend([0; 4]));
    vectors.file("no_leaves", "LeafLength", |file| file.sections[LEAVES].1.clear());
    vectors.file("padding_not_zero", "Reserved", |file| *file.sections[LEAVES].1.last_mut().expect("bytes") = 1);
    let odd = || one_leaf(|random: &mut Random| leaf(random, SINGLE, [0, 0], [4, 0, 0, 0]), 86);
    let mut file = odd().file();
    file.sections[LEAVES].1[0] |= 0x80;
    vectors.0.push(("polynomial_bit_after_a_leaf".to_owned(), "Reserved", file));
}

/// §12.6.
fn overlap(vectors: &mut Vectors) {
    for (name, leaf) in [("first", 0), ("last", 22)] {
        let support = move |octree: &mut PolynomialOctree| octree.leaves[leaf].support ^= 1;
        vectors.octree(&format!("support_of_{name}_leaf"), "OverlapCodes", support);
        let reach = move |octree: &mut PolynomialOctree| octree.leaves[leaf].reach ^= 1;
        vectors.octree(&format!("reach_of_{name}_leaf"), "OverlapCodes", reach);
    }
    let far = tree([2, 1, 1], vec![any(87), chain(6, 88)], 0.25);
    vectors.changed("six_levels_apart", "LevelsApart", far, |_| ());
    let cell = |random: &mut Random| Cell::Leaf(leaf(random, SINGLE, [0, 0], [4, 0, 0, 0]));
    let alone = tree([1; 3], vec![cell(&mut Random::new(89))], 0.25);
    vectors.changed("reach_of_a_leaf_alone", "OverlapCodes", alone, |octree| octree.leaves[0].reach = 2);
}
