//! Files with levels of detail (§4.2): those that every reader must accept, and those that it must refuse.

use super::grid::{Grid, LINEAR, Like, WHOLE};
use super::samples::PACKED32;
use super::valid::{octree_of_one_leaf, octree_of_three_levels};
use super::valid_polynomials::{any, divided, three_levels, tree};
use super::writer::File;

const KIND: [u8; 4] = *b"LODS";
const DIAGONAL: usize = 0;
const TARGET: usize = 1;

/// Names and files.
pub(super) fn valid() -> Vec<(String, File)> {
    let mut last = field();
    let levels = last.sections.remove(0);
    last.sections.push(levels);
    let grid = |resolution| {
        let like = Like { order: 1, reconstruction: LINEAR, precision: PACKED32, range: WHOLE, resolution };
        Grid::new(like, 90).file()
    };
    let eight = (91..99).map(|seed| coarser((99 - seed) as i32, tree([1; 3], vec![any(seed)], 0.0).file()));
    let vectors = [
        ("polynomial", field()),
        ("polynomial_last_section", last),
        ("polynomial_eight", with_levels(three_root_cells(), &eight.collect::<Vec<_>>())),
        ("octree", with_levels(octree_of_three_levels().file(), &[coarser(1, octree_of_one_leaf().file())])),
        ("grid", with_levels(grid([5, 4, 3]), &[coarser(1, grid([3, 2, 2]))])),
    ];
    vectors.into_iter().map(|(name, file)| (format!("lods_{name}"), file)).collect()
}

/// Names, reasons and files.
pub(super) fn invalid() -> Vec<(String, &'static str, File)> {
    let mut vectors = Vec::new();
    let mut add = |name: &str, error, file| vectors.push((format!("lods_{name}"), error, file));
    let [coarsest, next] = levels();
    let of = |levels: &[File]| with_levels(three_root_cells(), levels);

    // Number and places.
    add("none", "LodLength", of(&[]));
    let nine: Vec<File> = (1..=9).rev().map(|steps| coarser(steps, three_root_cells())).collect();
    add("nine", "LodLength", of(&nine));
    let tail = |change: fn(&mut Vec<u8>)| {
        let mut file = field();
        change(&mut file.sections[0].1);
        file
    };
    add("word_after_the_last", "LodLength", tail(|bytes| bytes.extend([0; 4])));
    add("word_before_the_first", "LodLength", tail(|bytes| drop(bytes.splice(0..0, [0; 4]))));
    add("last_cut_off", "LodLength", tail(|bytes| bytes.truncate(bytes.len() - 4)));
    add("first_too_long", "LodLength", tail(|bytes| bytes[15] = 0x7F));
    add("first_without_length", "LodLength", tail(|bytes| bytes[12..16].fill(0)));

    // What a level is.
    let other = coarser(1, octree_of_one_leaf().file());
    add("other_family", "LodHeader", of(&[coarsest.clone(), other]));
    let mut other = next.clone();
    other.quantities[DIAGONAL] += 0.5;
    add("other_diagonal", "LodHeader", of(&[coarsest.clone(), other]));
    add("level_with_levels", "LodHeader", of(&[coarser(2, field())]));

    // Order.
    add("finest_first", "LodOrder", of(&[next.clone(), coarsest.clone()]));
    add("level_twice", "LodOrder", of(&[next.clone(), next.clone()]));
    add("level_as_fine_as_the_file", "LodOrder", of(&[coarsest.clone(), coarser(0, three_root_cells())]));

    // Levels that are broken themselves.
    add("level_damaged", "SectionChecksum", tail(|bytes| *bytes.last_mut().expect("bytes") ^= 1));
    add("level_header_damaged", "HeaderChecksum", tail(|bytes| bytes[100] ^= 1));
    let mut without_leaves = next;
    without_leaves.sections.pop();
    add("level_without_leaves", "SectionMissing", of(&[coarsest, without_leaves]));
    vectors
}

/// Three root cells and two levels, of one root cell and of eight leaves.
fn field() -> File {
    with_levels(three_root_cells(), &levels())
}

fn three_root_cells() -> File {
    tree([3, 1, 1], three_levels(100), 0.2).file()
}

/// The coarsest first.
fn levels() -> [File; 2] {
    [coarser(2, tree([1; 3], vec![any(101)], 0.2).file()), coarser(1, tree([1; 3], vec![divided(102)], 0.2).file())]
}

/// The file at a target error of so many powers of four.
fn coarser(steps: i32, mut file: File) -> File {
    file.quantities[TARGET] *= 4.0_f32.powi(steps);
    file
}

fn with_levels(mut file: File, levels: &[File]) -> File {
    file.sections.insert(0, (KIND, levels.iter().flat_map(File::bytes).collect()));
    file
}
