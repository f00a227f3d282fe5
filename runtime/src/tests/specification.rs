//! The tables of the specification against the constants of the reader.

use core::ops::Range;
use std::collections::BTreeMap;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::layout::{
    self, block, continuity, family, grid, header, interpolant, kind, leaf, limit, node, octree, packed_sample,
    polynomial, precision, range, reconstruction, record, root_word, section, section_entry, shape, sign_method,
};
use crate::sample::decode_gradient;

const SPECIFICATION: &str = include_str!("../../../format-spec/SPEC.md");

/// The cells of every row of the tables under a heading, without code quotes.
fn rows(heading: &str) -> Vec<Vec<String>> {
    let from = SPECIFICATION.split_once(heading).expect("the heading is there").1;
    let until = from.split("\n#").next().unwrap_or(from);
    let tables = until.lines().map(str::trim).filter(|line| line.starts_with('|'));
    let cells = tables.map(|line| {
        let inner = line.trim_matches('|').split('|');
        inner.map(|cell| cell.trim().replace('`', "")).collect()
    });
    cells.filter(|cells: &Vec<String>| !cells[0].starts_with('-')).collect()
}

/// Offset and size by name, from a table of byte ranges.
fn ranges(heading: &str) -> BTreeMap<String, Range<usize>> {
    let mut end = 0;
    let mut ranges = BTreeMap::new();
    for cells in rows(heading).iter().filter(|cells| cells.len() == 5).skip(1) {
        let start: usize = cells[0].parse().expect("an offset");
        let size: usize = cells[1].parse().expect("a size");
        let size_of_type = match cells[2].as_str() {
            "u8" => 1,
            "u16" => 2,
            "u32" | "f32" => 4,
            "3 u16" => 6,
            "3 f32" => 12,
            "bytes" => size,
            other => panic!("unknown type {other}"),
        };
        assert_eq!(size, size_of_type, "{cells:?}");
        assert_eq!(start, end, "{cells:?} does not follow the field before it");
        end = start + size;
        ranges.insert(cells[3].clone(), start..end);
    }
    ranges
}

fn expect_ranges(heading: &str, expected: &[(&str, Range<usize>)], length: usize) {
    let found = ranges(heading);
    let expected: BTreeMap<_, _> = expected.iter().map(|(name, range)| (name.to_string(), range.clone())).collect();
    assert_eq!(found, expected, "{heading}");
    assert_eq!(found.values().map(|range| range.end).max(), Some(length), "{heading}");
}

/// Expects the rows of a table of values and names.
fn expect_values(heading: &str, expected: &[(&str, u32)]) {
    let found: Vec<_> = rows(heading)
        .iter()
        .filter(|cells| cells[0].parse::<u32>().is_ok() && cells.len() == 3)
        .filter(|cells| !cells[1].contains(" at "))
        .map(|cells| (cells[1].clone(), cells[0].parse().expect("a value")))
        .collect();
    let expected: Vec<_> = expected.iter().map(|&(name, value)| (name.to_string(), value)).collect();
    assert_eq!(found, expected, "{heading}");
}

#[test]
fn byte_ranges() {
    let byte = |at: usize| at..at + 1;
    expect_ranges(
        "## 3. Header",
        &[
            ("MAGIC", header::MAGIC),
            ("VERSION_MAJOR", header::VERSION_MAJOR),
            ("VERSION_MINOR", header::VERSION_MINOR),
            ("FILE_LENGTH", header::FILE_LENGTH),
            ("FAMILY", byte(header::FAMILY)),
            ("SIGN_METHOD", byte(header::SIGN_METHOD)),
            ("SECTION_COUNT", byte(header::SECTION_COUNT)),
            ("RESERVED", byte(header::RESERVED)),
            ("CHECKSUM", header::CHECKSUM),
            ("BOX_MIN", header::BOX_MIN),
            ("BOX_MAX", header::BOX_MAX),
            ("DIAGONAL", header::DIAGONAL),
            ("TARGET_ERROR", header::TARGET_ERROR),
            ("LIPSCHITZ", header::LIPSCHITZ),
            ("UNIFORM_RMSE", header::UNIFORM_RMSE),
            ("UNIFORM_P99", header::UNIFORM_P99),
            ("UNIFORM_MAX", header::UNIFORM_MAX),
            ("BAND_RMSE", header::BAND_RMSE),
            ("BAND_P99", header::BAND_P99),
            ("BAND_MAX", header::BAND_MAX),
            ("SEAM_MAX", header::SEAM_MAX),
            ("SAMPLE_COUNT", header::SAMPLE_COUNT),
            ("DOUBTFUL_SIGNS", header::DOUBTFUL_SIGNS),
            ("MESH_HASH", header::MESH_HASH),
            ("SETTINGS_HASH", header::SETTINGS_HASH),
            ("BAKER_VERSION", header::BAKER_VERSION),
            ("UNUSED", header::UNUSED),
        ],
        header::LENGTH,
    );
    expect_ranges(
        "## 4. Section table",
        &[
            ("KIND", section_entry::KIND),
            ("OFFSET", section_entry::OFFSET),
            ("SECTION_LENGTH", section_entry::SECTION_LENGTH),
            ("CHECKSUM", section_entry::CHECKSUM),
        ],
        section_entry::LENGTH,
    );
    expect_ranges(
        "## 5. Octree parameters",
        &[
            ("ROOT_CELLS", octree::ROOT_CELLS),
            ("DEPTH", byte(octree::DEPTH)),
            ("INTERPOLANT", byte(octree::INTERPOLANT)),
            ("CONTINUITY", byte(octree::CONTINUITY)),
            ("RESERVED", octree::RESERVED),
            ("ROOT_EDGE", octree::ROOT_EDGE),
            ("QUANTUM", octree::QUANTUM),
            ("LEAF_COUNT", octree::LEAF_COUNT),
        ],
        octree::LENGTH,
    );
    expect_ranges(
        "### 11.1 Grid parameters",
        &[
            ("RESOLUTION", grid::RESOLUTION),
            ("ORDER", byte(grid::ORDER)),
            ("RECONSTRUCTION", byte(grid::RECONSTRUCTION)),
            ("PRECISION", byte(grid::PRECISION)),
            ("RANGE", byte(grid::RANGE)),
            ("RESERVED", grid::RESERVED),
            ("SPACING", grid::SPACING),
            ("QUANTUM", grid::QUANTUM),
        ],
        grid::LENGTH,
    );
    expect_ranges(
        "### 12.1 Parameters",
        &[
            ("ROOT_CELLS", polynomial::ROOT_CELLS),
            ("DEPTH", byte(polynomial::DEPTH)),
            ("SHAPE_BITS", byte(polynomial::SHAPE_BITS)),
            ("CONTINUITY", byte(polynomial::CONTINUITY)),
            ("RESERVED", polynomial::RESERVED),
            ("ROOT_EDGE", polynomial::ROOT_EDGE),
            ("QUANTUM", polynomial::QUANTUM),
            ("OVERLAP", polynomial::OVERLAP),
            ("LEAF_COUNT", polynomial::LEAF_COUNT),
        ],
        polynomial::LENGTH,
    );
    expect_ranges(
        "### 12.3 Records",
        &[("INNER", byte(record::INNER)), ("STARTS", record::STARTS), ("FIRST", record::FIRST)],
        record::LENGTH,
    );
    expect_ranges(
        "### 12.4 Shapes",
        &[
            ("KIND", byte(shape::KIND)),
            ("DEGREES", shape::DEGREES),
            ("EXPONENT", byte(shape::EXPONENT)),
            ("WIDTHS", shape::WIDTHS),
        ],
        shape::LENGTH,
    );
}

#[test]
fn codes() {
    let value = u32::from;
    let families =
        [("GRID", value(family::GRID)), ("OCTREE", value(family::OCTREE)), ("POLYNOMIAL", value(family::POLYNOMIAL))];
    expect_values("### 3.5 Family", &families);
    let kinds = [("SINGLE", value(kind::SINGLE)), ("MIN", value(kind::MIN)), ("MAX", value(kind::MAX))];
    expect_values("### 12.4 Shapes", &kinds);
    let ranges = [("FILE", value(range::FILE)), ("BRICK", value(range::BRICK))];
    expect_values("### 11.2 Range", &ranges);
    let reconstructions = [
        ("NEAREST", value(reconstruction::NEAREST)),
        ("LINEAR", value(reconstruction::LINEAR)),
        ("HALF", value(reconstruction::HALF)),
        ("BLEND", value(reconstruction::BLEND)),
        ("HERMITE", value(reconstruction::HERMITE)),
    ];
    expect_values("### 11.4 Reconstruction", &reconstructions);
    let signs = [
        ("NONE", value(sign_method::NONE)),
        ("PSEUDONORMAL", value(sign_method::PSEUDONORMAL)),
        ("WINDING", value(sign_method::WINDING)),
        ("RAYS", value(sign_method::RAYS)),
        ("SHEET", value(sign_method::SHEET)),
    ];
    expect_values("### 3.6 Sign method", &signs);
    let interpolants = [("TRILINEAR", value(interpolant::TRILINEAR)), ("TRICUBIC", value(interpolant::TRICUBIC))];
    expect_values("### 5.2 Interpolant", &interpolants);
    let continuities =
        [("NONE", value(continuity::NONE)), ("C0", value(continuity::C0)), ("C1", value(continuity::C1))];
    expect_values("### 5.3 Continuity", &continuities);
    expect_values("## 6. Nodes", &[("INNER", node::INNER), ("LEAF", node::LEAF)]);
    let precisions = [("PACKED32", precision::PACKED32), ("F16", precision::F16), ("F32", precision::F32)];
    expect_values("### 7.1 Block header", &precisions);

    let kinds: Vec<_> = rows("## 4. Section table")
        .iter()
        .filter(|cells| cells.len() == 3)
        .skip(1)
        .map(|cells| {
            let letters = cells[0].as_bytes().try_into().expect("four letters");
            (cells[1].clone(), u32::from_le_bytes(letters))
        })
        .collect();
    let expected = [
        ("OCTREE".to_string(), section::OCTREE),
        ("NODES".to_string(), section::NODES),
        ("SAMPLES".to_string(), section::SAMPLES),
        ("GRID".to_string(), section::GRID),
        ("BASES".to_string(), section::BASES),
        ("POLYNOMIAL".to_string(), section::POLYNOMIAL),
        ("ROOTS".to_string(), section::ROOTS),
        ("SHAPES".to_string(), section::SHAPES),
        ("RECORDS".to_string(), section::RECORDS),
        ("LEAVES".to_string(), section::LEAVES),
        ("LODS".to_string(), section::LODS),
    ];
    assert_eq!(kinds, expected);
}

#[test]
fn limits() {
    let expected = [
        ("MAX_MAGNITUDE", f64::from(limit::MAX_MAGNITUDE)),
        ("MIN_ROOT_EDGE", f64::from(limit::MIN_ROOT_EDGE)),
        ("MIN_QUANTUM", f64::from(limit::MIN_QUANTUM)),
        ("BOX_TOLERANCE", f64::from(limit::BOX_TOLERANCE)),
        ("MAX_SECTIONS", layout::MAX_SECTIONS as f64),
        ("MAX_LODS", layout::MAX_LODS as f64),
        ("MAX_DEPTH", f64::from(octree::MAX_DEPTH)),
        ("MAX_LATTICE", f64::from(octree::MAX_LATTICE)),
        ("MIN_BASE", f64::from(block::MIN_BASE)),
        ("MAX_BASE", f64::from(block::MAX_BASE)),
        ("MAX_ORDER", f64::from(grid::MAX_ORDER)),
        ("MIN_RESOLUTION", f64::from(grid::MIN_RESOLUTION)),
        ("BRICK_EDGE", f64::from(grid::BRICK_EDGE)),
        ("MAX_ANISOTROPY", f64::from(grid::MAX_ANISOTROPY)),
        ("MAX_SHAPE_BITS", f64::from(polynomial::MAX_SHAPE_BITS)),
        ("MIN_OVERLAP", f64::from(polynomial::MIN_OVERLAP)),
        ("MAX_OVERLAP", f64::from(polynomial::MAX_OVERLAP)),
        ("MAX_DEGREE", f64::from(polynomial::MAX_DEGREE)),
        ("MAX_EXPONENT", f64::from(shape::MAX_EXPONENT)),
        ("MAX_CONSTANT_BITS", f64::from(shape::MAX_CONSTANT_BITS)),
        ("MAX_COEFFICIENT_BITS", f64::from(shape::MAX_COEFFICIENT_BITS)),
        ("MAX_LEVELS_APART", f64::from(leaf::MAX_LEVELS_APART)),
        ("MAX_LENGTH", leaf::MAX_LENGTH as f64),
        ("PADDING", leaf::PADDING as f64),
    ];
    let found: Vec<_> = rows("### 1.4 Limits")
        .iter()
        .skip(1)
        .map(|cells| {
            let value = match cells[1].split_once('^') {
                Some((_, exponent)) => 2.0_f64.powi(exponent.parse().expect("an exponent")),
                None => cells[1].parse().expect("a number"),
            };
            (cells[0].clone(), value)
        })
        .collect();
    assert_eq!(found, expected.map(|(name, value)| (name.to_string(), value)));
}

#[test]
fn bit_fields() {
    // Rows such as "10 at 20".
    let bits = |heading: &str, name: &str| {
        let of_name = |cells: &Vec<String>| cells.iter().any(|cell| cell == name);
        let row = rows(heading).into_iter().find(of_name).expect("a row of that name");
        let field = row.iter().find_map(|cell| cell.split_once(" at ")).expect("a bit field");
        let number = |text: &str| text.parse::<u32>().expect("a number");
        (number(field.0), number(field.1))
    };
    assert_eq!(bits("## 6. Nodes", "OFFSET"), (node::OFFSET_BITS, 0));
    assert_eq!(bits("## 6. Nodes", "TAG"), (32 - node::OFFSET_BITS, node::OFFSET_BITS));
    let root_leaf = root_word::LEAF.trailing_zeros();
    assert_eq!(bits("### 12.2 Root words", "OFFSET"), (root_leaf, 0));
    assert_eq!(bits("### 12.2 Root words", "LEAF"), (1, root_leaf));
    let first = std::format!("`CHILD:{0} at 0`, `LEAF:{1} at {0}`", record::CHILD_BITS, record::LEAF_BITS);
    assert!(SPECIFICATION.contains(&first), "{first}");
    assert_eq!(bits("### 7.1 Block header", "PRESENT"), (block::LATTICE, 0));
    let precision_bits = block::PRECISION_MASK.count_ones();
    assert_eq!(bits("### 7.1 Block header", "PRECISION"), (precision_bits, block::PRECISION_SHIFT));
    assert_eq!(bits("### 7.1 Block header", "FULL"), (block::LATTICE, 0));
    let samples = "### 8.1 Tricubic samples";
    assert_eq!(bits(samples, "X"), (packed_sample::GRADIENT_BITS, 0));
    assert_eq!(bits(samples, "Y"), (packed_sample::GRADIENT_BITS, packed_sample::GRADIENT_BITS));
    let distance = (packed_sample::DISTANCE_BITS, packed_sample::DISTANCE_SHIFT);
    assert_eq!(bits(samples, "DISTANCE"), distance);

    let words = rows("### 7.1 Block header");
    let word_of = |name: &str| {
        let row = words.iter().find(|cells| cells.len() == 4 && cells[2] == name);
        row.expect("a row of that name")[0].parse::<usize>().expect("a word")
    };
    assert_eq!(word_of("PRESENT"), block::PRESENT_WORD);
    assert_eq!(word_of("PRECISION"), block::PRESENT_WORD);
    assert_eq!(word_of("FULL"), block::FULL_WORD);
    assert_eq!(word_of("BASE"), block::BASE_WORD);
}

#[test]
fn worked_codes() {
    let rows = rows("### 8.3 Octahedral code");
    assert!(rows.len() > 8, "the table is there");
    for cells in rows.iter().skip(1) {
        let hexadecimal =
            |text: &str| u32::from_str_radix(text.trim_start_matches("0x"), 16).expect("a hexadecimal number");
        let number = |text: &str| text.parse::<u32>().expect("a number");
        let code = hexadecimal(&cells[0]);
        assert_eq!(code, number(&cells[1]) | number(&cells[2]) << packed_sample::GRADIENT_BITS);
        let bits = decode_gradient(code).map(f32::to_bits);
        assert_eq!(bits.as_slice(), [4, 5, 6].map(|cell| hexadecimal(&cells[cell])), "{cells:?}");
    }
}

#[test]
fn version_and_magic() {
    let version = std::format!("Version {}.{}", layout::VERSION_MAJOR, layout::VERSION_MINOR);
    assert!(SPECIFICATION.contains(&version));
    let magic: Vec<_> = layout::MAGIC.iter().map(|byte| std::format!("{byte:02X}")).collect();
    assert!(SPECIFICATION.contains(&magic.join(" ")));
}
