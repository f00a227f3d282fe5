//! Files that every reader must refuse, each for one reason, and the name of the reason (§13).
//!
//! Each is a valid file with one change, under the right checksums unless the checksum is the change.

use super::invalid_grids;
use super::invalid_polynomials;
use super::lods;
use super::samples::{Block, CENTRE, F16, F32, PACKED32, PARENT_CORNERS, Random};
use super::valid::three_levels;
use super::writer::{Cell, File, Octree, TRICUBIC, TRILINEAR, entry, put, seal};

/// A file, and the reason to refuse it.
pub(crate) struct Invalid {
    pub(crate) name: String,
    pub(crate) error: &'static str,
    pub(crate) bytes: Vec<u8>,
}

/// One for each rule at least.
pub(crate) fn all() -> Vec<Invalid> {
    let mut vectors = Vectors::default();
    preamble(&mut vectors);
    header(&mut vectors);
    sections(&mut vectors);
    parameters(&mut vectors);
    nodes(&mut vectors);
    blocks(&mut vectors);
    sample_data(&mut vectors);
    let families = invalid_grids::all().into_iter().chain(invalid_polynomials::all());
    for (name, error, file) in families.chain(lods::invalid()) {
        vectors.add(&name, error, file.bytes());
    }
    vectors.0
}

#[derive(Default)]
struct Vectors(Vec<Invalid>);

impl Vectors {
    fn add(&mut self, name: &str, error: &'static str, bytes: Vec<u8>) {
        self.0.push(Invalid { name: name.to_owned(), error, bytes });
    }

    /// A change of the finished bytes.
    fn bytes(&mut self, name: &str, error: &'static str, change: impl FnOnce(&mut Vec<u8>)) {
        let mut bytes = tricubic().file().bytes();
        change(&mut bytes);
        self.add(name, error, bytes);
    }

    /// A change of header or table, sealed again.
    fn sealed(&mut self, name: &str, error: &'static str, change: impl FnOnce(&mut Vec<u8>)) {
        self.bytes(name, error, |bytes| {
            change(bytes);
            seal(bytes);
        });
    }

    /// A change of the file before its lengths and checksums are known.
    fn file(&mut self, name: &str, error: &'static str, change: impl FnOnce(&mut File)) {
        let mut file = tricubic().file();
        change(&mut file);
        self.add(name, error, file.bytes());
    }

    /// A change of the octree. The box stays.
    fn octree(&mut self, name: &str, error: &'static str, change: impl FnOnce(&mut Octree)) {
        self.changed(name, error, tricubic(), change);
    }

    fn changed(&mut self, name: &str, error: &'static str, octree: Octree, change: impl FnOnce(&mut Octree)) {
        let (mut octree, file) = (octree.clone(), octree.file());
        change(&mut octree);
        self.add(name, error, File { sections: octree.file().sections, ..file }.bytes());
    }
}

/// A leaf, a cell of eight leaves, and one of seven leaves and eight smaller ones. Words of its nodes: 0 to 2 the roots,
/// from 3 the eight leaves, from 11 the mixed group, from 19 the smaller leaves.
fn tricubic() -> Octree {
    let mut random = Random::new(20);
    Octree::new(TRICUBIC, three_levels(), |present| {
        random.block(Block { interpolant: TRICUBIC, precision: PACKED32, present, full: 0, base: -2000 })
    })
}

fn one_leaf(interpolant: u8, precision: u32, full: u32) -> Octree {
    let mut random = Random::new(21);
    Octree::new(interpolant, vec![Cell::Leaf], |present| {
        random.block(Block { interpolant, precision, present, full, base: -2000 })
    })
}

/// A cell of eight leaves whose block holds the parent's corners and the centre, and implies the others.
fn implied() -> Octree {
    let mut random = Random::new(22);
    let present = PARENT_CORNERS | CENTRE;
    Octree::new(TRICUBIC, vec![Cell::divided()], |_| {
        random.block(Block { interpolant: TRICUBIC, precision: PACKED32, present, full: 0, base: -2000 })
    })
}

/// §2, §3.1 to §3.4.
fn preamble(vectors: &mut Vectors) {
    vectors.bytes("empty", "Truncated", Vec::clear);
    vectors.bytes("ends_in_magic", "Truncated", |bytes| bytes.truncate(7));
    vectors.bytes("ends_in_header", "Truncated", |bytes| bytes.truncate(127));
    vectors.bytes("ends_in_table", "Truncated", |bytes| {
        bytes.truncate(entry(2));
        put(bytes, 12, entry(2) as u32);
    });
    vectors.bytes("ends_early", "FileLength", |bytes| bytes.truncate(bytes.len() - 1));
    vectors.bytes("ends_a_word_early", "FileLength", |bytes| bytes.truncate(bytes.len() - 4));
    vectors.bytes("trailing_byte", "FileLength", |bytes| bytes.push(0));
    vectors.bytes("magic_of_something_else", "Magic", |bytes| bytes[1] = b'M');
    vectors.bytes("magic_after_text_transfer", "Magic", |bytes| {
        bytes.remove(4);
    });
    vectors.file("version_0_0", "Version", |file| file.version = [0, 0]);
    vectors.file("version_1_1", "Version", |file| file.version = [1, 1]);
    vectors.file("version_2_0", "Version", |file| file.version = [2, 0]);
    vectors.sealed("length_of_0", "FileLength", |bytes| put(bytes, 12, 0));
    vectors.sealed("length_of_4_gib", "FileLength", |bytes| put(bytes, 12, u32::MAX));
    vectors.bytes("header_checksum_wrong", "HeaderChecksum", |bytes| bytes[20] ^= 1);
    vectors.bytes("header_changed", "HeaderChecksum", |bytes| bytes[100] ^= 0x10);
    vectors.bytes("table_changed", "HeaderChecksum", |bytes| bytes[entry(1) + 12] ^= 0x80);
    vectors.bytes("unused_bits_changed", "HeaderChecksum", |bytes| bytes[127] = 1);
}

/// §3.5 to §3.9.
fn header(vectors: &mut Vectors) {
    for bit in 0..8 {
        vectors.file(&format!("header_reserved_bit_{bit}"), "Reserved", |file| file.reserved = 1 << bit);
    }
    vectors.file("family_0", "Family", |file| file.family = 0);
    vectors.file("family_255", "Family", |file| file.family = 255);
    vectors.file("sign_method_255", "SignMethod", |file| file.sign_method = 255);

    // The box.
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        vectors.file(&format!("box_min_{name}_nan"), "Bounds", |file| file.box_min[axis] = f32::NAN);
        vectors.file(&format!("box_max_{name}_nan"), "Bounds", |file| file.box_max[axis] = f32::NAN);
        vectors.file(&format!("box_flat_in_{name}"), "Bounds", |file| file.box_max[axis] = file.box_min[axis]);
        vectors.file(&format!("box_not_the_root_grid_in_{name}"), "OctreeBounds", |file| file.box_max[axis] += 0.01);
    }
    vectors.file("box_min_infinite", "Bounds", |file| file.box_min[1] = f32::NEG_INFINITY);
    vectors.file("box_max_infinite", "Bounds", |file| file.box_max[1] = f32::INFINITY);
    vectors.file("box_min_too_far", "Bounds", |file| file.box_min[0] = -above(two_to(60)));
    vectors.file("box_max_too_far", "Bounds", |file| file.box_max[2] = above(two_to(60)));
    vectors.file("box_inside_out", "Bounds", |file| std::mem::swap(&mut file.box_min, &mut file.box_max));

    // Quantities and contract.
    let wrong =
        [("nan", f32::NAN), ("negative", -1e-30), ("infinite", f32::INFINITY), ("too_large", above(two_to(60)))];
    for (kind, number) in wrong {
        for (index, name) in ["diagonal", "target_error", "lipschitz"].into_iter().enumerate() {
            vectors.file(&format!("{name}_{kind}"), "Quantity", |file| file.quantities[index] = number);
        }
    }
    let contract = ["uniform_rmse", "uniform_p99", "uniform_max", "band_rmse", "band_p99", "band_max", "seam_max"];
    for (index, name) in contract.into_iter().enumerate() {
        vectors.file(&format!("{name}_nan"), "Quantity", |file| file.contract[index] = f32::NAN);
        vectors.file(&format!("{name}_negative"), "Quantity", |file| file.contract[index] = -0.01);
        if !name.ends_with("max") {
            vectors.file(&format!("{name}_above_max"), "Contract", |file| file.contract[index] = 0.06);
        }
    }
}

/// §4.
fn sections(vectors: &mut Vectors) {
    vectors.file("no_sections", "SectionMissing", |file| file.sections.clear());
    for (index, name) in ["octr", "node", "samp"].into_iter().enumerate() {
        vectors.file(&format!("section_{name}_missing"), "SectionMissing", |file| drop(file.sections.remove(index)));
        vectors.file(&format!("section_{name}_twice"), "SectionDuplicate", |file| {
            file.sections.push(file.sections[index].clone());
        });
        vectors.sealed(&format!("section_{name}_checksum_wrong"), "SectionChecksum", |bytes| {
            bytes[entry(index) + 12] ^= 1;
        });
        vectors.bytes(&format!("section_{name}_changed"), "SectionChecksum", |bytes| {
            let start = [entry(3), entry(3) + 24, bytes.len() - 4][index];
            bytes[start] ^= 1;
        });
    }
    let with_unknown = |kind: [u8; 4], count: u8| {
        let mut file = tricubic().file();
        file.sections.extend((0..count).map(|index| ([kind[0], kind[1], kind[2], kind[3] + index], vec![index; 4])));
        file
    };
    vectors.add("seventeen_sections", "SectionTable", with_unknown(*b"X00A", 14).bytes());
    let mut twice = with_unknown(*b"X00A", 2);
    twice.sections[4].0 = *b"X00A";
    vectors.add("unknown_section_twice", "SectionDuplicate", twice.bytes());
    let mut unknown = with_unknown(*b"X00A", 1).bytes();
    *unknown.last_mut().expect("bytes") ^= 1;
    vectors.add("unknown_section_changed", "SectionChecksum", unknown);

    // Places.
    let offset = |index: usize| entry(index) + 4;
    let length = |index: usize| entry(index) + 8;
    let shift = |bytes: &mut [u8], at: usize, by: i32| {
        let word = u32::from_le_bytes(bytes[at..at + 4].try_into().expect("a word"));
        put(bytes, at, word.wrapping_add_signed(by));
    };
    vectors.sealed("first_section_over_table", "SectionTable", |bytes| shift(bytes, offset(0), -4));
    vectors.sealed("first_section_at_0", "SectionTable", |bytes| put(bytes, offset(0), 0));
    vectors.sealed("first_section_late", "SectionTable", |bytes| {
        shift(bytes, offset(0), 4);
        shift(bytes, length(0), -4);
    });
    vectors.sealed("sections_overlap", "SectionTable", |bytes| {
        shift(bytes, offset(2), -4);
        shift(bytes, length(2), 4);
    });
    vectors.sealed("sections_apart", "SectionTable", |bytes| {
        shift(bytes, offset(2), 4);
        shift(bytes, length(2), -4);
    });
    vectors.sealed("sections_swapped", "SectionTable", |bytes| {
        let (one, two) = (bytes[entry(1)..entry(2)].to_vec(), bytes[entry(2)..entry(3)].to_vec());
        bytes[entry(1)..entry(3)].copy_from_slice(&[two, one].concat());
    });
    vectors.sealed("section_not_whole_words", "SectionTable", |bytes| {
        shift(bytes, length(1), 2);
        shift(bytes, offset(2), 2);
        shift(bytes, length(2), -2);
    });
    vectors.sealed("last_section_beyond_file", "SectionTable", |bytes| shift(bytes, length(2), 4));
    vectors.sealed("last_section_short_of_file", "SectionTable", |bytes| shift(bytes, length(2), -4));
    vectors.sealed("section_length_overflows", "SectionTable", |bytes| put(bytes, length(2), u32::MAX - 3));
    vectors.sealed("section_offset_overflows", "SectionTable", |bytes| put(bytes, offset(2), u32::MAX - 3));
}

/// §5.
fn parameters(vectors: &mut Vectors) {
    vectors.file("parameters_short", "OctreeLength", |file| file.sections[0].1.truncate(20));
    vectors.file("parameters_long", "OctreeLength", |file| file.sections[0].1.extend([0; 4]));
    vectors.file("parameters_empty", "OctreeLength", |file| file.sections[0].1.clear());

    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        vectors.octree(&format!("no_root_cells_in_{name}"), "OctreeLattice", |octree| octree.root_cells[axis] = 0);
        vectors.octree(&format!("reserved_byte_{axis}_of_parameters"), "Reserved", |octree| octree.reserved[axis] = 1);
    }
    vectors.octree("depth_17", "OctreeLattice", |octree| octree.depth = 17);
    vectors.octree("depth_255", "OctreeLattice", |octree| octree.depth = 255);
    vectors.octree("lattice_too_wide", "OctreeLattice", |octree| (octree.root_cells, octree.depth) = ([17, 1, 1], 16));
    vectors.octree("interpolant_255", "Interpolant", |octree| octree.interpolant = 255);
    vectors.octree("continuity_255", "Continuity", |octree| octree.continuity = 255);

    // Scale.
    let wrong = [("nan", f32::NAN), ("zero", 0.0), ("negative", -2.0), ("infinite", f32::INFINITY)];
    for (kind, number) in wrong {
        vectors.octree(&format!("root_edge_{kind}"), "OctreeScale", |octree| octree.root_edge = number);
        vectors.octree(&format!("quantum_{kind}"), "OctreeScale", |octree| octree.quantum = number);
    }
    vectors.octree("root_edge_too_large", "OctreeScale", |octree| octree.root_edge = above(two_to(60)));
    vectors.octree("root_edge_too_small", "OctreeScale", |octree| {
        (octree.root_edge, octree.quantum) = (below(two_to(-40)), two_to(-50));
    });
    vectors.octree("quantum_too_small", "OctreeScale", |octree| octree.quantum = below(two_to(-80)));
    vectors.octree("quantum_above_root_edge", "OctreeScale", |octree| octree.quantum = above(octree.root_edge));
    vectors.octree("root_edge_of_another_box", "OctreeBounds", |octree| octree.root_edge = 2.01);
}

/// §6.
fn nodes(vectors: &mut Vectors) {
    vectors.octree("fewer_nodes_than_root_cells", "NodeLength", |octree| octree.nodes.truncate(2));
    vectors.octree("no_nodes", "NodeLength", |octree| octree.nodes.clear());
    vectors.octree("half_a_group", "NodeLength", |octree| octree.nodes.truncate(23));
    vectors.octree("tag_15", "NodeTag", |octree| octree.nodes[4] |= 15 << 28);
    vectors.octree("tag_15_of_a_root_cell", "NodeTag", |octree| octree.nodes[0] |= 15 << 28);

    // Order.
    vectors.octree("groups_swapped", "NodeOrder", |octree| octree.nodes.swap(1, 2));
    vectors.octree("group_used_twice", "NodeOrder", |octree| octree.nodes[2] = octree.nodes[1]);
    vectors.octree("group_not_aligned", "NodeOrder", |octree| octree.nodes[2] += 1);
    vectors.octree("inner_refers_to_root", "NodeOrder", |octree| octree.nodes[14] = 0);
    vectors.octree("inner_refers_to_its_own_group", "NodeOrder", |octree| octree.nodes[14] = 11);
    vectors.octree("inner_refers_beyond_section", "NodeOrder", |octree| octree.nodes[14] = (1 << 28) - 1);
    vectors.octree("last_group_missing", "NodeOrder", |octree| {
        octree.nodes.truncate(19);
        octree.leaf_count -= 8;
    });
    vectors.octree("group_that_nothing_refers_to", "NodeOrder", |octree| {
        let last = octree.nodes[19..].to_vec();
        octree.nodes.extend(last);
        octree.leaf_count += 8;
    });
    vectors.changed("group_that_refers_to_itself", "NodeOrder", one_leaf(TRICUBIC, PACKED32, 0), |octree| {
        // As many groups as inner words, each where its order puts it, and still no tree.
        octree.nodes.push(1);
        octree.nodes.extend([1 << 28; 7]);
        (octree.depth, octree.leaf_count) = (1, 8);
    });
    vectors.octree("inner_at_depth", "NodeDepth", |octree| octree.depth = 1);
    vectors.changed("inner_at_depth_0", "NodeDepth", implied(), |octree| octree.depth = 0);
    vectors.octree("leaf_count_above", "LeafCount", |octree| octree.leaf_count += 1);
    vectors.octree("leaf_count_below", "LeafCount", |octree| octree.leaf_count -= 1);
    vectors.octree("leaf_count_of_all_nodes", "LeafCount", |octree| octree.leaf_count = u32::MAX);
}

/// §7.
fn blocks(vectors: &mut Vectors) {
    // Order.
    vectors.octree("leaf_refers_beyond_section", "BlockOrder", |octree| octree.nodes[0] |= (1 << 28) - 1);
    vectors.octree("leaf_refers_to_another_block", "BlockOrder", |octree| octree.nodes[4] -= 1);
    vectors.octree("leaf_refers_to_an_earlier_block", "BlockOrder", |octree| octree.nodes[19] = octree.nodes[0]);
    vectors.octree("groups_share_a_block", "BlockOrder", |octree| {
        let shared = octree.nodes[3];
        octree.nodes[11..14].fill(shared);
        octree.nodes[15..19].fill(shared);
    });
    vectors.changed("first_block_late", "BlockOrder", one_leaf(TRICUBIC, PACKED32, 0), |octree| {
        octree.samples.insert(0, 0);
        octree.nodes[0] += 1;
    });
    vectors.octree("words_after_last_block", "BlockOrder", |octree| octree.samples.push(0));
    vectors.octree("last_block_cut", "BlockOrder", |octree| {
        octree.samples.pop();
    });
    vectors.octree("last_block_header_cut", "BlockOrder", |octree| {
        let start = octree.nodes[19] as usize & 0xFFF;
        octree.samples.truncate(start + 2);
    });
    vectors.octree("no_samples", "BlockOrder", |octree| octree.samples.clear());
    for (name, precision) in [("packed32", PACKED32), ("f16", F16), ("f32", F32)] {
        vectors.changed(&format!("trilinear_{name}_cut"), "BlockOrder", one_leaf(TRILINEAR, precision, 0), |octree| {
            octree.samples.pop();
        });
        vectors.changed(&format!("tricubic_{name}_cut"), "BlockOrder", one_leaf(TRICUBIC, precision, 1), |octree| {
            octree.samples.pop();
        });
    }

    // The header.
    for bit in 29..32 {
        vectors.octree(&format!("reserved_bit_{bit}_of_word_0"), "Reserved", |octree| octree.samples[0] |= 1 << bit);
    }
    for bit in 27..32 {
        vectors.octree(&format!("reserved_bit_{bit}_of_word_1"), "Reserved", |octree| octree.samples[1] |= 1 << bit);
    }
    vectors.octree("precision_3", "BlockPrecision", |octree| octree.samples[0] |= 3 << 27);
    vectors.octree("base_too_low", "BlockBase", |octree| octree.samples[2] = (-(1 << 27) - 1_i32).cast_unsigned());
    vectors.octree("base_too_high", "BlockBase", |octree| octree.samples[2] = (1 << 27) - (1 << 12) + 1);
    for (name, interpolant) in [("trilinear", TRILINEAR), ("tricubic", TRICUBIC)] {
        let leaf = one_leaf(interpolant, F32, 0);
        vectors.changed(&format!("base_of_{name}_f32"), "Reserved", leaf, |octree| octree.samples[2] = 1);
    }
    vectors.changed("full_sample_not_present", "BlockFull", one_leaf(TRICUBIC, PACKED32, 0), |octree| {
        octree.samples[1] = 1 << 2;
    });
    vectors.changed("full_sample_of_trilinear", "BlockFull", one_leaf(TRILINEAR, PACKED32, 0), |octree| {
        octree.samples[1] = 1;
    });

    // What is neither present nor implied. The block keeps its length.
    vectors.changed("corner_of_root_leaf_missing", "BlockPresent", one_leaf(TRICUBIC, PACKED32, 0), |octree| {
        move_present(octree, 1, 2);
    });
    vectors.changed("centre_missing", "BlockPresent", implied(), |octree| move_present(octree, 13, 1));
    vectors.changed("corner_of_parent_missing", "BlockPresent", implied(), |octree| move_present(octree, 26, 1));
    vectors.changed("face_beside_a_present_edge", "BlockPresent", implied(), |octree| {
        octree.samples[0] |= 1 << 1;
        octree.samples.push(0);
    });
}

/// Another sample is present in the place of one that was.
fn move_present(octree: &mut Octree, from: u32, to: u32) {
    assert!(octree.samples[0] >> from & 1 == 1 && octree.samples[0] >> to & 1 == 0, "a sample to move");
    octree.samples[0] ^= 1 << from | 1 << to;
}

/// §7.2, §8.
fn sample_data(vectors: &mut Vectors) {
    vectors.changed("gradient_x_1023", "GradientCode", one_leaf(TRICUBIC, PACKED32, 0), |octree| {
        octree.samples[3] |= 0x3FF;
    });
    vectors.changed("gradient_y_1023", "GradientCode", one_leaf(TRICUBIC, PACKED32, 0), |octree| {
        octree.samples[10] |= 0x3FF << 10;
    });
    let mut odd = Random::new(23);
    let odd = Octree::new(TRILINEAR, vec![Cell::divided()], |present| {
        odd.block(Block { interpolant: TRILINEAR, precision: PACKED32, present, full: 0, base: 0 })
    });
    for bit in [16, 31] {
        vectors.changed(&format!("reserved_bit_{bit}_after_last_sample"), "Reserved", odd.clone(), |octree| {
            *octree.samples.last_mut().expect("samples") |= 1 << bit;
        });
    }

    // Half floats: the gradient's x is the upper half of a sample's first word, fxyz that of its fourth.
    for (name, half) in [("nan", 0x7E00), ("infinite", 0x7C00), ("minus_infinite", 0xFC00)] {
        for (place, precision, full, word, shift) in [
            ("gradient_x", F16, 0, 3, 16),
            ("gradient_z", F16, 0, 18, 16),
            ("gradient_x_of_full_packed32", PACKED32, 1, 3, 16),
            ("fxyz_of_full_packed32", PACKED32, 1, 6, 16),
            ("fxy_of_full_f16", F16, 1, 5, 0),
        ] {
            vectors.changed(&format!("{place}_{name}"), "SampleValue", one_leaf(TRICUBIC, precision, full), |octree| {
                octree.samples[word] = octree.samples[word] & !(0xFFFF << shift) | half << shift;
            });
        }
    }

    // Floats.
    let wrong = [
        ("nan", f32::NAN),
        ("infinite", f32::INFINITY),
        ("too_large", above(two_to(60))),
        ("too_low", -above(two_to(60))),
    ];
    for (name, number) in wrong {
        let bits = number.to_bits();
        vectors.changed(&format!("f32_trilinear_{name}"), "SampleValue", one_leaf(TRILINEAR, F32, 0), |octree| {
            octree.samples[10] = bits;
        });
        for (place, word) in [("distance", 3), ("gradient_z", 6), ("fxyz", 10), ("last_gradient_z", 38)] {
            vectors.changed(&format!("f32_{place}_{name}"), "SampleValue", one_leaf(TRICUBIC, F32, 1), |octree| {
                octree.samples[word] = bits;
            });
        }
    }
}

pub(super) fn two_to(power: i32) -> f32 {
    2.0_f32.powi(power)
}

/// The next number up from a positive one.
pub(super) fn above(number: f32) -> f32 {
    f32::from_bits(number.to_bits() + 1)
}

/// The next number down from a positive one.
pub(super) fn below(number: f32) -> f32 {
    f32::from_bits(number.to_bits() - 1)
}
