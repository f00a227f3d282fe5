//! The constants of the format as WGSL, from the reader's own.

use nearfield::layout::{
    MAX_SECTIONS, block, family, grid, header, interpolant, kind, leaf, limit, node, octree, packed_sample, polynomial,
    precision, range, reconstruction, record, root_word, section, section_entry, shape,
};
use std::fmt::Write;

/// Declarations of every offset, size and code that the shaders use.
pub(crate) fn wgsl() -> String {
    let words = [
        ("FAMILY_WORD", word(header::FAMILY)),
        ("FAMILY_BYTE", byte(header::FAMILY)),
        ("SECTION_COUNT_WORD", word(header::SECTION_COUNT)),
        ("SECTION_COUNT_BYTE", byte(header::SECTION_COUNT)),
        ("BOX_MIN_WORD", word(header::BOX_MIN.start)),
        ("BOX_MAX_WORD", word(header::BOX_MAX.start)),
        ("LIPSCHITZ_WORD", word(header::LIPSCHITZ.start)),
        ("UNIFORM_MAX_WORD", word(header::UNIFORM_MAX.start)),
        ("BAND_MAX_WORD", word(header::BAND_MAX.start)),
        ("SAMPLE_COUNT_WORD", word(header::SAMPLE_COUNT.start)),
        ("TABLE_WORD", word(header::LENGTH)),
        ("SECTION_WORDS", word(section_entry::LENGTH)),
        ("MAX_SECTIONS", size(MAX_SECTIONS)),
        ("SECTION_OCTREE", section::OCTREE),
        ("SECTION_NODES", section::NODES),
        ("SECTION_SAMPLES", section::SAMPLES),
        ("SECTION_GRID", section::GRID),
        ("SECTION_BASES", section::BASES),
        ("SECTION_POLYNOMIAL", section::POLYNOMIAL),
        ("SECTION_ROOTS", section::ROOTS),
        ("SECTION_SHAPES", section::SHAPES),
        ("SECTION_RECORDS", section::RECORDS),
        ("SECTION_LEAVES", section::LEAVES),
        ("FAMILY_GRID", family::GRID.into()),
        ("FAMILY_OCTREE", family::OCTREE.into()),
        ("FAMILY_POLYNOMIAL", family::POLYNOMIAL.into()),
        ("MAX_DEPTH", octree::MAX_DEPTH.into()),
        ("INTERPOLANT_TRICUBIC", interpolant::TRICUBIC.into()),
        ("NODE_OFFSET_BITS", node::OFFSET_BITS),
        ("NODE_OFFSET_MASK", node::OFFSET_MASK),
        ("NODE_INNER", node::INNER),
        ("LATTICE_MASK", block::LATTICE_MASK),
        ("PRECISION_SHIFT", block::PRECISION_SHIFT),
        ("PRECISION_PACKED32", precision::PACKED32),
        ("PRECISION_F16", precision::F16),
        ("PRECISION_F32", precision::F32),
        ("GRADIENT_BITS", packed_sample::GRADIENT_BITS),
        ("GRADIENT_MASK", (1 << packed_sample::GRADIENT_BITS) - 1),
        ("DISTANCE_SHIFT", packed_sample::DISTANCE_SHIFT),
        ("RECONSTRUCTION_NEAREST", reconstruction::NEAREST.into()),
        ("RECONSTRUCTION_HALF", reconstruction::HALF.into()),
        ("RECONSTRUCTION_BLEND", reconstruction::BLEND.into()),
        ("RECONSTRUCTION_HERMITE", reconstruction::HERMITE.into()),
        ("RANGE_BRICK", range::BRICK.into()),
        ("BRICK_EDGE", grid::BRICK_EDGE),
        ("ROOT_LEAF", root_word::LEAF),
        ("RECORD_LENGTH", size(record::LENGTH)),
        ("RECORD_FIRST", size(record::FIRST.start)),
        ("RECORD_CHILD_BITS", record::CHILD_BITS),
        ("RECORD_CHILD_MASK", (1 << record::CHILD_BITS) - 1),
        ("RECORD_LEAF_MASK", (1 << record::LEAF_BITS) - 1),
        ("KIND_SINGLE", kind::SINGLE.into()),
        ("KIND_MIN", kind::MIN.into()),
        ("MAX_EXPONENT", shape::MAX_EXPONENT.into()),
        ("SUPPORT_BITS", leaf::SUPPORT_BITS),
        ("OVERLAP_BITS", leaf::SUPPORT_BITS + leaf::REACH_BITS),
        ("MAX_SUPPORT", leaf::MAX_SUPPORT),
        ("MAX_LEVELS_APART", leaf::MAX_LEVELS_APART),
        ("MAX_MAGNITUDE_BITS", limit::MAX_MAGNITUDE.to_bits()),
    ];
    let mut text = String::from("// The constants of the format.\n\n");
    for (name, value) in words {
        let _ = writeln!(text, "const {name}: u32 = {value}u;");
    }
    let centre = packed_sample::GRADIENT_CENTRE;
    let _ = writeln!(text, "const GRADIENT_CENTRE: i32 = {centre};");
    let _ = writeln!(text, "const GRADIENT_STEP: f32 = {:?}f;", 1.0 / centre as f32);
    let _ = writeln!(text, "const MIN_OVERLAP: f32 = {:?}f;", polynomial::MIN_OVERLAP);
    text
}

/// The word that holds a byte.
const fn word(at: usize) -> u32 {
    size(at / 4)
}

/// Which byte of its word it is.
const fn byte(at: usize) -> u32 {
    size(at % 4)
}

#[expect(clippy::cast_possible_truncation, reason = "sizes within a header")]
const fn size(size: usize) -> u32 {
    size as u32
}
