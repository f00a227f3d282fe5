//! Every rule of the specification, broken once.

use std::vec::Vec;

use super::file::{
    ALL, CORNERS, File, block, divided, halves, inner, lattice, leaf, open, seal, three_levels, trilinear,
};
use crate::layout::{header, interpolant, octree, precision, section_entry};
use crate::{Aabb, Continuity, Error, ErrorContract, Family, Field, Interpolant, SignMethod, crc32c};

/// Offset of the entry of a section, in the order of the file.
fn entry(index: usize) -> usize {
    header::LENGTH + index * section_entry::LENGTH
}

/// Offset of the octree parameters.
const PARAMETERS: usize = header::LENGTH + 3 * section_entry::LENGTH;

/// The error for valid bytes after a change, with the checksums made right again.
fn error_after(change: impl FnOnce(&mut Vec<u8>)) -> Option<Error> {
    let mut bytes = three_levels().bytes();
    change(&mut bytes);
    let checksum = crc32c(&bytes[PARAMETERS..PARAMETERS + octree::LENGTH]).to_le_bytes();
    bytes[entry(0)..][section_entry::CHECKSUM].copy_from_slice(&checksum);
    seal(&mut bytes);
    Field::open(&bytes).err()
}

fn put(bytes: &mut [u8], at: usize, value: &[u8]) {
    bytes[at..at + value.len()].copy_from_slice(value);
}

#[test]
fn header_rules() {
    let set = |at: usize, value: u8| error_after(|bytes| bytes[at] = value);
    let float = |at: usize, value: f32| error_after(|bytes| put(bytes, at, &value.to_le_bytes()));
    assert_eq!(error_after(|_| ()), None);
    assert_eq!(set(0, b'N'), Some(Error::Magic));
    assert_eq!(set(header::VERSION_MAJOR.start, 2), Some(Error::Version));
    assert_eq!(set(header::VERSION_MINOR.start, 1), Some(Error::Version), "from the future");
    assert_eq!(set(header::FILE_LENGTH.start, 1), Some(Error::FileLength));
    assert_eq!(set(header::RESERVED, 1), Some(Error::Reserved));
    assert_eq!(set(header::FAMILY, 4), Some(Error::Family));
    assert_eq!(set(header::SIGN_METHOD, 5), Some(Error::SignMethod));
    assert_eq!(set(header::UNUSED.start, 255), None, "unused bits are ignored");

    for value in [f32::NAN, f32::INFINITY, 1e19, -1e19] {
        assert_eq!(float(header::BOX_MAX.start, value), Some(Error::Bounds));
        assert_eq!(float(header::BOX_MIN.start + 8, value), Some(Error::Bounds));
    }
    for field in [header::DIAGONAL, header::TARGET_ERROR, header::LIPSCHITZ, header::SEAM_MAX] {
        for value in [f32::NAN, f32::INFINITY, 1e19, -1.0] {
            assert_eq!(float(field.start, value), Some(Error::Quantity));
        }
        assert_eq!(float(field.start, 1e18), None);
    }
    for field in [header::UNIFORM_RMSE, header::UNIFORM_P99, header::BAND_RMSE, header::BAND_P99] {
        assert_eq!(float(field.start, 1.0), Some(Error::Contract), "above a maximum of 0");
    }
}

#[test]
fn a_wrong_header_checksum_is_an_error() {
    let mut bytes = three_levels().bytes();
    bytes[header::MESH_HASH.start] ^= 1;
    assert_eq!(Field::open(&bytes).err(), Some(Error::HeaderChecksum));
}

#[test]
fn short_files_are_truncated_unless_they_are_something_else() {
    let bytes = three_levels().bytes();
    assert_eq!(Field::open(&[]).err(), Some(Error::Truncated));
    assert_eq!(Field::open(&bytes[..5]).err(), Some(Error::Truncated));
    assert_eq!(Field::open(&bytes[..100]).err(), Some(Error::Truncated));
    assert_eq!(Field::open(b"solid cube").err(), Some(Error::Magic));
    assert_eq!(Field::open(&bytes[..150]).err(), Some(Error::FileLength));
}

#[test]
fn section_rules() {
    let word = |index: usize, at: usize, change: fn(u32) -> u32| {
        error_after(|bytes| {
            let at = entry(index) + at;
            let value = u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
            put(bytes, at, &change(value).to_le_bytes());
        })
    };
    let (kind, offset) = (section_entry::KIND.start, section_entry::OFFSET.start);
    let length = section_entry::SECTION_LENGTH.start;
    assert_eq!(word(1, offset, |value| value + 4), Some(Error::SectionTable));
    assert_eq!(word(1, offset, |_| u32::MAX), Some(Error::SectionTable));
    assert_eq!(word(1, length, |value| value - 4), Some(Error::SectionTable));
    assert_eq!(word(2, length, |value| value - 4), Some(Error::SectionTable), "bytes left over");
    assert_eq!(word(2, length, |_| u32::MAX), Some(Error::SectionTable));
    assert_eq!(word(2, length, |value| value + 1), Some(Error::SectionTable));
    assert_eq!(word(2, kind, |_| crate::layout::section::NODES), Some(Error::SectionDuplicate));
    for index in 0..3 {
        assert_eq!(word(index, kind, |_| 1), Some(Error::SectionMissing));
    }
    assert_eq!(error_after(|bytes| bytes[header::SECTION_COUNT] = 17), Some(Error::SectionTable));

    // A damaged section opens unless it holds the parameters, and does not validate.
    let bytes = three_levels().bytes();
    for (index, opens) in [false, true, true].into_iter().enumerate() {
        let mut damaged = bytes.clone();
        damaged[entry(index) + section_entry::CHECKSUM.start] ^= 1;
        seal(&mut damaged);
        let error = match Field::open(&damaged) {
            Ok(field) => field.validate(),
            Err(error) => Err(error),
        };
        assert_eq!(error, Err(Error::SectionChecksum));
        assert_eq!(Field::open(&damaged).is_ok(), opens);
    }
}

#[test]
fn sections_of_unknown_kinds_are_ignored() {
    // A fourth section after the others.
    let mut bytes = three_levels().bytes();
    let contents = *b"anything";
    for index in 0..3 {
        let at = entry(index) + section_entry::OFFSET.start;
        let offset = u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
        put(&mut bytes, at, &(offset + section_entry::LENGTH as u32).to_le_bytes());
    }
    let start = (bytes.len() + section_entry::LENGTH) as u32;
    let table_entry = [u32::from_le_bytes(*b"NOTE"), start, 8, crc32c(&contents)];
    let entry_bytes: Vec<u8> = table_entry.into_iter().flat_map(u32::to_le_bytes).collect();
    bytes.splice(PARAMETERS..PARAMETERS, entry_bytes);
    bytes.extend(contents);
    bytes[header::SECTION_COUNT] = 4;
    let length = bytes.len() as u32;
    put(&mut bytes, header::FILE_LENGTH.start, &length.to_le_bytes());
    seal(&mut bytes);
    let field = open(&bytes);
    let last = field.sections().last().expect("a section");
    assert_eq!(bytes[last.range], contents);
}

#[test]
fn octree_parameter_rules() {
    let set = |at: usize, value: &[u8]| error_after(|bytes| put(bytes, PARAMETERS + at, value));
    let float = |at: usize, value: f32| set(at, &value.to_le_bytes());
    assert_eq!(set(octree::ROOT_CELLS.start, &[0, 0]), Some(Error::OctreeLattice));
    assert_eq!(set(octree::ROOT_CELLS.start, &[0, 255]), Some(Error::NodeLength));
    assert_eq!(set(octree::DEPTH, &[17]), Some(Error::OctreeLattice));
    assert_eq!(set(octree::DEPTH, &[255]), Some(Error::OctreeLattice));
    assert_eq!(set(octree::INTERPOLANT, &[2]), Some(Error::Interpolant));
    assert_eq!(set(octree::CONTINUITY, &[3]), Some(Error::Continuity));
    for byte in octree::RESERVED {
        assert_eq!(set(byte, &[1]), Some(Error::Reserved));
    }
    for value in [f32::NAN, f32::INFINITY, 0.0, -2.0, 1e-13, 1e19] {
        assert_eq!(float(octree::ROOT_EDGE.start, value), Some(Error::OctreeScale));
    }
    for value in [f32::NAN, f32::INFINITY, 0.0, -1.0, 1e-25, 2.5] {
        assert_eq!(float(octree::QUANTUM.start, value), Some(Error::OctreeScale));
    }
    assert_eq!(float(octree::ROOT_EDGE.start, 2.001), Some(Error::OctreeBounds));
    assert_eq!(float(octree::ROOT_EDGE.start, 2.000_000_2), None, "a rounding");

    let mut wide = three_levels();
    wide.root_cells = [17, 1, 1];
    wide.depth = 16;
    assert_eq!(Field::open(&wide.bytes()).err(), Some(Error::OctreeLattice));
    let without_nodes = File { nodes: Vec::new(), ..three_levels() };
    assert_eq!(Field::open(&without_nodes.bytes()).err(), Some(Error::NodeLength));
}

/// The error that [`Field::validate`] finds in a file that opens.
fn invalid(file: &File) -> Error {
    let bytes = file.bytes();
    let field = Field::open(&bytes).expect("the file opens");
    field.validate().expect_err("the file is not valid")
}

#[test]
fn node_rules() {
    let node = |at: usize, word: u32| {
        let mut file = three_levels();
        file.nodes[at] = word;
        invalid(&file)
    };
    assert_eq!(node(4, 2 << 28), Error::NodeTag);
    assert_eq!(node(2, inner(3)), Error::NodeOrder, "a group with two parents");
    assert_eq!(node(2, inner(19)), Error::NodeOrder, "a group too early");
    assert_eq!(node(14, inner(4)), Error::NodeOrder, "a loop");
    assert_eq!(node(14, three_levels().nodes[13]), Error::NodeOrder, "an orphan");
    assert_eq!(node(20, inner(27)), Error::NodeDepth);
    assert_eq!(node(4, leaf(0)), Error::BlockOrder, "the block of another parent");

    let mut file = three_levels();
    file.nodes.push(leaf(0));
    assert_eq!(invalid(&file), Error::NodeLength);
    let mut file = three_levels();
    file.nodes.extend([leaf(0); 8]);
    assert_eq!(invalid(&file), Error::NodeOrder, "a group without a parent");
    let mut file = three_levels();
    file.nodes.truncate(19);
    assert_eq!(invalid(&file), Error::NodeOrder, "a group that is not there");

    let mut bytes = three_levels().bytes();
    bytes[PARAMETERS + octree::LEAF_COUNT.start] += 1;
    let checksum = crc32c(&bytes[PARAMETERS..PARAMETERS + octree::LENGTH]).to_le_bytes();
    bytes[entry(0)..][section_entry::CHECKSUM].copy_from_slice(&checksum);
    seal(&mut bytes);
    assert_eq!(Field::open(&bytes).expect("opens").validate(), Err(Error::LeafCount));
}

#[test]
fn block_rules() {
    let packed = |present: u32, full: u32, base: i32, count: usize| {
        let samples = block(present, full, precision::PACKED32, base, std::vec![0; count]);
        divided(samples)
    };
    open(&packed(ALL, 0, 0, 27).bytes());
    open(&packed(ALL, 1, 0, 30).bytes());
    assert_eq!(invalid(&packed(ALL, 0, 0, 28)), Error::BlockOrder, "a word left over");
    assert_eq!(invalid(&packed(ALL, 0, 0, 26)), Error::BlockOrder, "a word missing");
    assert_eq!(invalid(&File { samples: Vec::new(), ..packed(ALL, 0, 0, 0) }), Error::BlockOrder);
    assert_eq!(invalid(&packed(ALL ^ 1 << 13, 0, 0, 26)), Error::BlockPresent);
    assert_eq!(invalid(&packed(ALL, 0, (1 << 27) - 4095, 27)), Error::BlockBase);
    assert_eq!(invalid(&packed(ALL, 0, -(1 << 27) - 1, 27)), Error::BlockBase);
    open(&packed(ALL, 0, (1 << 27) - 4096, 27).bytes());

    let word = |at: usize, change: fn(u32) -> u32| {
        let mut file = packed(ALL, 0, 0, 27);
        file.samples[at] = change(file.samples[at]);
        invalid(&file)
    };
    assert_eq!(word(0, |word| word | 3 << 27), Error::BlockPrecision);
    assert_eq!(word(0, |word| word | 1 << 29), Error::Reserved);
    assert_eq!(word(1, |word| word | 1 << 27), Error::Reserved);
    assert_eq!(word(8, |_| 1023), Error::GradientCode);
    assert_eq!(word(29, |_| 1023 << 10), Error::GradientCode);

    // A full sample where there is none.
    let one = |samples| File::one_leaf(interpolant::TRICUBIC, samples);
    let missing = block(CORNERS, 1 << 2, precision::PACKED32, 0, [0; 11]);
    assert_eq!(invalid(&one(missing)), Error::BlockFull);
}

#[test]
fn sample_value_rules() {
    let one = |precision, full, base, data: &[u32]| {
        let samples = block(CORNERS, full, precision, base, data.iter().copied());
        File::one_leaf(interpolant::TRICUBIC, samples)
    };
    let mut half = halves(&[0.0, 1.0, 0.0, 0.0]).repeat(8);
    open(&one(precision::F16, 0, 7, &half).bytes());
    half[0] |= 0xFFFF;
    open(&one(precision::F16, 0, 7, &half).bytes());
    for (at, infinity) in [(0, 0x7C00 << 16), (3, 0x7C00), (15, 0xFC00 << 16)] {
        let mut wrong = half.clone();
        wrong[at] = infinity;
        assert_eq!(invalid(&one(precision::F16, 0, 7, &wrong)), Error::SampleValue);
    }

    let mut packed = std::vec![0; 11];
    open(&one(precision::PACKED32, 1, 7, &packed).bytes());
    packed[3] = 0x7E00;
    assert_eq!(invalid(&one(precision::PACKED32, 1, 7, &packed)), Error::SampleValue);

    let mut single = std::vec![0; 36];
    open(&one(precision::F32, 1, 0, &single).bytes());
    assert_eq!(invalid(&one(precision::F32, 1, 7, &single)), Error::Reserved, "base unused");
    single[35] = 1e19_f32.to_bits();
    assert_eq!(invalid(&one(precision::F32, 1, 0, &single)), Error::SampleValue);
}

#[test]
fn trilinear_block_rules() {
    let mut file = trilinear(|_| 1.0);
    file.samples[1] = 1;
    assert_eq!(invalid(&file), Error::BlockFull);
    let mut file = trilinear(|_| 1.0);
    file.samples[3] = f32::NAN.to_bits();
    assert_eq!(invalid(&file), Error::SampleValue);

    let codes = lattice(ALL).step_by(2).map(|_| 0x10001).collect::<Vec<u32>>();
    let mut file = divided(block(ALL, 0, precision::PACKED32, 0, codes));
    file.interpolant = interpolant::TRILINEAR;
    assert_eq!(invalid(&file), Error::Reserved, "the half after the last code");
    *file.samples.last_mut().expect("a word") = 1;
    open(&file.bytes());
    file.samples.pop();
    assert_eq!(invalid(&file), Error::BlockOrder);
}

#[test]
fn the_header_is_read_as_written() {
    let mut bytes = three_levels().bytes();
    for (index, byte) in bytes[header::UNIFORM_RMSE.start..header::UNUSED.start].iter_mut().enumerate() {
        *byte = index as u8;
    }
    let floats = [0.25, 0.5, 1.0, 0.125, 0.25, 2.0, 3.0_f32];
    for (index, value) in floats.into_iter().enumerate() {
        put(&mut bytes, header::UNIFORM_RMSE.start + 4 * index, &value.to_le_bytes());
    }
    put(&mut bytes, header::TARGET_ERROR.start, &0.75_f32.to_le_bytes());
    put(&mut bytes, header::BAKER_VERSION.start, &0x0102_0304_u32.to_le_bytes());
    bytes[header::SIGN_METHOD] = 2;
    seal(&mut bytes);

    let field = open(&bytes);
    let found = field.header();
    assert_eq!(found.version, [1, 0]);
    assert_eq!(found.family, Family::Octree);
    assert_eq!(found.sign_method, SignMethod::Winding);
    assert_eq!(found.bounds, Aabb { min: [1.0, 2.0, 3.0], max: [7.0, 4.0, 5.0] });
    assert_eq!((found.diagonal, found.target_error, found.lipschitz), (1.0, 0.75, 1.0));
    assert_eq!(found.baker_version, [0x0102, 3, 4]);
    assert_eq!(found.mesh_hash, core::array::from_fn(|index| 36 + index as u8));
    assert_eq!(found.settings_hash, core::array::from_fn(|index| 52 + index as u8));

    let contract = field.contract();
    assert_eq!([contract.uniform.rmse, contract.uniform.p99, contract.uniform.max], [0.25, 0.5, 1.0]);
    assert_eq!([contract.band.rmse, contract.band.p99, contract.band.max], [0.125, 0.25, 2.0]);
    assert_eq!(contract.seam_max, 3.0);
    assert_eq!(contract.sample_count, 0x1F1E_1D1C);
    assert_eq!(contract.doubtful_signs, 0x2322_2120);
    assert_eq!(contract.max_error(), 2.0);
    assert_eq!(ErrorContract::default().max_error(), f32::INFINITY, "nothing was measured");

    let octree = field.octree().expect("an octree");
    assert_eq!((octree.root_cells(), octree.depth(), octree.root_edge()), ([3, 1, 1], 2, 2.0));
    assert_eq!((octree.edge(2), octree.quantum(1)), (0.5, 1.0 / 128.0));
    assert_eq!(octree.interpolant(), Interpolant::Tricubic);
    assert_eq!(octree.continuity(), Continuity::None);
    assert_eq!(field.sections().count(), 3);
}

#[test]
fn a_family_that_was_not_asked_for_is_refused() {
    let bytes = three_levels().bytes();
    let field = open(&bytes);
    let octree = Field::open_octree(&bytes).expect("an octree");
    assert_eq!(octree.validate(), Ok(()));
    assert_eq!(Field::open_grid(&bytes).err(), Some(Error::Family));

    let point = [0.3, 0.7, 0.2];
    let bits = |(distance, gradient): (f32, [f32; 3])| (distance.to_bits(), gradient.map(f32::to_bits));
    assert_eq!(bits(octree.distance_and_gradient(point)), bits(field.distance_and_gradient(point)));
    assert_eq!(octree.cursor().distance(point).to_bits(), field.distance(point).to_bits());
}
