//! Every offset, size, code and limit of the file format, once.
//!
//! The reader and the baker both use these constants, and a test compares them with the tables of
//! `format-spec/SPEC.md`. All numbers in a file are little-endian; all offsets are in bytes from the
//! start of the file unless a name says otherwise.

use core::ops::Range;

/// First eight bytes of every file. The high bit and the line endings expose a transfer that
/// treated the file as text.
pub const MAGIC: [u8; 8] = *b"\x89NFD\r\n\x1a\n";
/// Readers of this version accept files of exactly this major version…
pub const VERSION_MAJOR: u16 = 1;
/// …and of a minor version up to this one.
pub const VERSION_MINOR: u16 = 0;

/// Byte ranges of the header's fields.
pub mod header {
    use super::Range;

    /// [`MAGIC`](super::MAGIC).
    pub const MAGIC: Range<usize> = 0..8;
    /// `u16`.
    pub const VERSION_MAJOR: Range<usize> = 8..10;
    /// `u16`.
    pub const VERSION_MINOR: Range<usize> = 10..12;
    /// `u32`, bytes of the whole file.
    pub const FILE_LENGTH: Range<usize> = 12..16;
    /// `u8`, one of [`family`](super::family).
    pub const FAMILY: usize = 16;
    /// `u8`, one of [`sign_method`](super::sign_method).
    pub const SIGN_METHOD: usize = 17;
    /// `u8`, entries of the section table.
    pub const SECTION_COUNT: usize = 18;
    /// `u8`, reserved.
    pub const RESERVED: usize = 19;
    /// `u32`, CRC-32C of the header, with this field as zero, and the section table.
    pub const CHECKSUM: Range<usize> = 20..24;
    /// Three `f32`, mesh units, mesh frame.
    pub const BOX_MIN: Range<usize> = 24..36;
    /// Three `f32`, mesh units, mesh frame.
    pub const BOX_MAX: Range<usize> = 36..48;
    /// `f32`, diagonal of the mesh's bounding box, mesh units.
    pub const DIAGONAL: Range<usize> = 48..52;
    /// `f32`, the error asked for, mesh units.
    pub const TARGET_ERROR: Range<usize> = 52..56;
    /// `f32`, upper bound of the slope of the reconstruction inside the box.
    pub const LIPSCHITZ: Range<usize> = 56..60;
    /// `f32`, mesh units: root mean square error over uniform points of the mesh's box.
    pub const UNIFORM_RMSE: Range<usize> = 60..64;
    /// `f32`, mesh units.
    pub const UNIFORM_P99: Range<usize> = 64..68;
    /// `f32`, mesh units.
    pub const UNIFORM_MAX: Range<usize> = 68..72;
    /// `f32`, mesh units: root mean square error over points of the band.
    pub const BAND_RMSE: Range<usize> = 72..76;
    /// `f32`, mesh units.
    pub const BAND_P99: Range<usize> = 76..80;
    /// `f32`, mesh units.
    pub const BAND_MAX: Range<usize> = 80..84;
    /// `f32`, mesh units: largest jump of the value across a face between leaves.
    pub const SEAM_MAX: Range<usize> = 84..88;
    /// `u32`, points measured, uniform and again in the band.
    pub const SAMPLE_COUNT: Range<usize> = 88..92;
    /// `u32`, measured points whose sign the sign method could not vouch for.
    pub const DOUBTFUL_SIGNS: Range<usize> = 92..96;
    /// 16 bytes: hash of the welded mesh.
    pub const MESH_HASH: Range<usize> = 96..112;
    /// 8 bytes: hash of the settings.
    pub const SETTINGS_HASH: Range<usize> = 112..120;
    /// `u32`: baker version, `major << 16 | minor << 8 | patch`.
    pub const BAKER_VERSION: Range<usize> = 120..124;
    /// Unused: written zero, ignored.
    pub const UNUSED: Range<usize> = 124..128;

    /// Bytes of the header. The section table follows at once.
    pub const LENGTH: usize = UNUSED.end;
}

/// Byte ranges within one entry of the section table.
pub mod section_entry {
    use super::Range;

    /// `u32`, one of [`section`](super::section).
    pub const KIND: Range<usize> = 0..4;
    /// `u32`, a multiple of four.
    pub const OFFSET: Range<usize> = 4..8;
    /// `u32`, bytes, a multiple of four.
    pub const SECTION_LENGTH: Range<usize> = 8..12;
    /// `u32`, CRC-32C of the section's bytes.
    pub const CHECKSUM: Range<usize> = 12..16;

    /// Bytes of an entry.
    pub const LENGTH: usize = CHECKSUM.end;
}

/// Most entries that a section table may hold.
pub const MAX_SECTIONS: usize = 16;
/// Most levels of detail beside the field itself.
pub const MAX_LODS: usize = 8;

/// Limits that keep the arithmetic of every query within the range of `f32`.
pub mod limit {
    /// Largest magnitude of a coordinate, a length or a stored `f32` of a sample: 2⁶⁰.
    pub const MAX_MAGNITUDE: f32 = (1_u64 << 60) as f32;
    /// Smallest edge of a root cell, mesh units: 2⁻⁴⁰.
    pub const MIN_ROOT_EDGE: f32 = 1.0 / (1_u64 << 40) as f32;
    /// Smallest distance quantum at level 0, mesh units: 2⁻⁸⁰. Divided by sixteen and scaled to
    /// the deepest level it is still a normal number. The largest is the edge of a root cell.
    pub const MIN_QUANTUM: f32 = MIN_ROOT_EDGE * MIN_ROOT_EDGE;
    /// `BOX_MAX` may differ from `BOX_MIN + ROOT_CELLS · ROOT_EDGE`, evaluated in `f32`, by this
    /// share of the largest of the three terms' magnitudes: 2⁻²⁰, some eight roundings.
    pub const BOX_TOLERANCE: f32 = 1.0 / (1 << 20) as f32;
}

/// Field families (`header::FAMILY`).
pub mod family {
    /// A uniform lattice of samples (Bán and Valasek 2020; Valasek and Bán 2022).
    pub const GRID: u8 = 1;
    /// Adaptive cells (Pujol and Chica 2023).
    pub const OCTREE: u8 = 2;
    /// Adaptive cells of quantized polynomials (after Koschier et al. 2016).
    pub const POLYNOMIAL: u8 = 3;
}

/// How the baker found the sign (`header::SIGN_METHOD`).
pub mod sign_method {
    /// The field did not come from a mesh.
    pub const NONE: u8 = 0;
    /// Angle-weighted pseudonormals (Bærentzen and Aanæs 2005).
    pub const PSEUDONORMAL: u8 = 1;
    /// Generalized winding numbers (Jacobson et al. 2013).
    pub const WINDING: u8 = 2;
    /// Majority of rays that count crossings.
    pub const RAYS: u8 = 3;
    /// No inside: the unsigned distance less half the thickness of a sheet.
    pub const SHEET: u8 = 4;
}

/// Section kinds: four ASCII letters, read as a little-endian `u32`.
pub mod section {
    /// Parameters of an octree.
    pub const OCTREE: u32 = u32::from_le_bytes(*b"OCTR");
    /// Node words of an octree.
    pub const NODES: u32 = u32::from_le_bytes(*b"NODE");
    /// Sample blocks of an octree, or samples of a grid.
    pub const SAMPLES: u32 = u32::from_le_bytes(*b"SAMP");
    /// Parameters of a grid.
    pub const GRID: u32 = u32::from_le_bytes(*b"GRID");
    /// Base distances of the bricks of a grid.
    pub const BASES: u32 = u32::from_le_bytes(*b"BASE");
    /// Parameters of a polynomial octree.
    pub const POLYNOMIAL: u32 = u32::from_le_bytes(*b"PTRE");
    /// Root words of a polynomial octree.
    pub const ROOTS: u32 = u32::from_le_bytes(*b"ROOT");
    /// Shapes of the leaves of a polynomial octree.
    pub const SHAPES: u32 = u32::from_le_bytes(*b"SHPE");
    /// Records of the inner nodes of a polynomial octree.
    pub const RECORDS: u32 = u32::from_le_bytes(*b"TREE");
    /// Leaves of a polynomial octree.
    pub const LEAVES: u32 = u32::from_le_bytes(*b"LEAF");
    /// Levels of detail: whole files of coarser fields.
    pub const LODS: u32 = u32::from_le_bytes(*b"LODS");
}

/// Byte ranges within the section of octree parameters.
pub mod octree {
    use super::Range;

    /// Three `u16`, cells of the root grid along x, y, z.
    pub const ROOT_CELLS: Range<usize> = 0..6;
    /// `u8`, levels below the root grid.
    pub const DEPTH: usize = 6;
    /// `u8`, one of [`interpolant`](super::interpolant).
    pub const INTERPOLANT: usize = 7;
    /// `u8`, one of [`continuity`](super::continuity).
    pub const CONTINUITY: usize = 8;
    /// Three bytes, reserved.
    pub const RESERVED: Range<usize> = 9..12;
    /// `f32`, edge of a root cell, mesh units.
    pub const ROOT_EDGE: Range<usize> = 12..16;
    /// `f32`, distance quantum at level 0, mesh units.
    pub const QUANTUM: Range<usize> = 16..20;
    /// `u32`, leaves of the tree.
    pub const LEAF_COUNT: Range<usize> = 20..24;

    /// Bytes of the section.
    pub const LENGTH: usize = LEAF_COUNT.end;

    /// Most levels below the root grid.
    pub const MAX_DEPTH: u8 = 16;
    /// Most finest cells along an axis: `root_cells << depth` may not exceed it, so that lattice
    /// coordinates are exact in `f32`.
    pub const MAX_LATTICE: u32 = 1 << 20;
}

/// Interpolants of octree leaves (`octree::INTERPOLANT`).
pub mod interpolant {
    /// Eight distances.
    pub const TRILINEAR: u8 = 0;
    /// Eight distances with gradients and, at forced corners, mixed derivatives.
    pub const TRICUBIC: u8 = 1;
}

/// Continuity across leaves of different levels (`octree::CONTINUITY`).
pub mod continuity {
    /// Nothing is promised.
    pub const NONE: u8 = 0;
    /// The value is continuous up to rounding.
    pub const C0: u8 = 1;
    /// Value and gradient are continuous up to rounding.
    pub const C1: u8 = 2;
}

/// Node words: the tag in the four high bits, an offset in the others.
pub mod node {
    /// Bits of the offset.
    pub const OFFSET_BITS: u32 = 28;
    /// Mask of the offset.
    pub const OFFSET_MASK: u32 = (1 << OFFSET_BITS) - 1;
    /// Inner node: the offset is the index, in words of the node section, of its first child of eight.
    pub const INNER: u32 = 0;
    /// Leaf: the offset is the index, in words of the sample section, of its block.
    pub const LEAF: u32 = 1;
}

/// Sample blocks: the lattice samples that the leaves among eight siblings need, each once.
pub mod block {
    /// Word 0: which of the 27 lattice samples are present in bits 0..27, the precision in bits 27..29.
    pub const PRESENT_WORD: usize = 0;
    /// Word 1: which of the present samples are full, with mixed derivatives, in bits 0..27.
    pub const FULL_WORD: usize = 1;
    /// Word 2: base distance, `i32`, in distance quanta of the block.
    pub const BASE_WORD: usize = 2;
    /// Words before the first sample.
    pub const HEADER_WORDS: usize = 3;
    /// Least base distance: sixteen times it still fits an `i32`.
    pub const MIN_BASE: i32 = -(1 << 27);
    /// Greatest base distance: sixteen times it, plus any 16-bit code, still fits an `i32`.
    pub const MAX_BASE: i32 = (1 << 27) - (1 << 12);
    /// Lattice samples of a block: 3 along each axis, x fastest.
    pub const LATTICE: u32 = 27;
    /// Mask of the lattice bits in the first two words.
    pub const LATTICE_MASK: u32 = (1 << LATTICE) - 1;
    /// Shift of the precision in word 0.
    pub const PRECISION_SHIFT: u32 = 27;
    /// Mask of the precision after the shift.
    pub const PRECISION_MASK: u32 = 3;
}

/// Precision of the samples of a block.
pub mod precision {
    /// 32 bits a first-order sample: 10 + 10 octahedral gradient, 12 distance. Trilinear: 16 bits.
    pub const PACKED32: u32 = 0;
    /// 16 bits a component.
    pub const F16: u32 = 1;
    /// 32-bit floats.
    pub const F32: u32 = 2;
}

/// The 32-bit first-order sample: `x | y << 10 | distance << 20`.
pub mod packed_sample {
    /// Bits of each octahedral coordinate.
    pub const GRADIENT_BITS: u32 = 10;
    /// Largest code of an octahedral coordinate. The code `GRADIENT_CENTRE` is exactly zero, so
    /// that the six axis directions are exact; the code 1023 is not written.
    pub const GRADIENT_MAX: u32 = 1022;
    /// Code of zero.
    pub const GRADIENT_CENTRE: u32 = 511;
    /// Bits of the distance.
    pub const DISTANCE_BITS: u32 = 12;
    /// Largest distance code.
    pub const DISTANCE_MAX: u32 = (1 << DISTANCE_BITS) - 1;
    /// Shift of the distance.
    pub const DISTANCE_SHIFT: u32 = 20;
}

/// Byte ranges within the section of grid parameters.
pub mod grid {
    use super::Range;

    /// Three `u16`, samples along x, y, z.
    pub const RESOLUTION: Range<usize> = 0..6;
    /// `u8`, order of the samples, 0 to [`MAX_ORDER`].
    pub const ORDER: usize = 6;
    /// `u8`, one of [`reconstruction`](super::reconstruction).
    pub const RECONSTRUCTION: usize = 7;
    /// `u8`, one of [`precision`](super::precision).
    pub const PRECISION: usize = 8;
    /// `u8`, one of [`range`](super::range).
    pub const RANGE: usize = 9;
    /// Two bytes, reserved.
    pub const RESERVED: Range<usize> = 10..12;
    /// Three `f32`, distance between samples along x, y, z, mesh units.
    pub const SPACING: Range<usize> = 12..24;
    /// `f32`, distance quantum, mesh units.
    pub const QUANTUM: Range<usize> = 24..28;

    /// Bytes of the section.
    pub const LENGTH: usize = QUANTUM.end;

    /// Highest order of a sample.
    pub const MAX_ORDER: u8 = 3;
    /// Fewest samples along an axis.
    pub const MIN_RESOLUTION: u16 = 2;
    /// Samples along an edge of a brick.
    pub const BRICK_EDGE: u32 = 4;
    /// Largest ratio of the spacings along two axes.
    pub const MAX_ANISOTROPY: f32 = 1024.0;
}

/// How a grid answers between its samples (`grid::RECONSTRUCTION`).
pub mod reconstruction {
    /// The polynomial of the nearest sample.
    pub const NEAREST: u8 = 0;
    /// The polynomials of eight samples, weighted trilinearly.
    pub const LINEAR: u8 = 1;
    /// The same of reduced polynomials, which makes it exact one degree higher.
    pub const HALF: u8 = 2;
    /// The polynomials of eight samples, weighted by smooth steps of their order.
    pub const BLEND: u8 = 3;
    /// Tensor-product Hermite interpolation of the derivatives.
    pub const HERMITE: u8 = 4;
}

/// What the distance codes of a grid count from (`grid::RANGE`).
pub mod range {
    /// One base for the file.
    pub const FILE: u8 = 0;
    /// A base for each brick.
    pub const BRICK: u8 = 1;
}

/// Byte ranges within the section of the parameters of a polynomial octree. Lattice and root edge have the limits of
/// [`octree`].
pub mod polynomial {
    use super::Range;

    /// Three `u16`, cells of the root grid along x, y, z.
    pub const ROOT_CELLS: Range<usize> = 0..6;
    /// `u8`, levels below the root grid.
    pub const DEPTH: usize = 6;
    /// `u8`, bits of the shape of a leaf, 1 to [`MAX_SHAPE_BITS`].
    pub const SHAPE_BITS: usize = 7;
    /// `u8`, one of [`continuity`](super::continuity).
    pub const CONTINUITY: usize = 8;
    /// Three bytes, reserved.
    pub const RESERVED: Range<usize> = 9..12;
    /// `f32`, edge of a root cell, mesh units.
    pub const ROOT_EDGE: Range<usize> = 12..16;
    /// `f32`, step of a coefficient of exponent 0, mesh units.
    pub const QUANTUM: Range<usize> = 16..20;
    /// `f32`, how far a leaf reaches beyond its cell, as a share of the cell's edge; 0 if it does not.
    pub const OVERLAP: Range<usize> = 20..24;
    /// `u32`, leaves of the tree.
    pub const LEAF_COUNT: Range<usize> = 24..28;

    /// Bytes of the section.
    pub const LENGTH: usize = LEAF_COUNT.end;

    /// Most bits of the shape of a leaf.
    pub const MAX_SHAPE_BITS: u8 = 10;
    /// Least overlap that is not 0.
    pub const MIN_OVERLAP: f32 = 1.0 / 64.0;
    /// Greatest overlap.
    pub const MAX_OVERLAP: f32 = 0.25;
    /// Highest total degree of a polynomial.
    pub const MAX_DEGREE: u8 = 3;
}

/// Root words of a polynomial octree.
pub mod root_word {
    /// Bit of a leaf. The others are the byte of the leaf in the section of leaves, or the number of the record.
    pub const LEAF: u32 = 1 << 31;
}

/// Byte ranges within the record of an inner node of a polynomial octree.
pub mod record {
    use super::Range;

    /// `u8`: bit i is set if child i = x | y << 1 | z << 2 is an inner node.
    pub const INNER: usize = 0;
    /// Seven `u8`, for children 1 to 7: how many children before it are inner nodes if it is one, otherwise how many
    /// bytes the leaves before it take.
    pub const STARTS: Range<usize> = 1..8;
    /// 48 bits: [`CHILD_BITS`] of the number of the record of the first inner child, then the byte of the first leaf
    /// in the section of leaves.
    pub const FIRST: Range<usize> = 8..14;

    /// Bytes of a record.
    pub const LENGTH: usize = FIRST.end;

    /// Bits of the number of a record.
    pub const CHILD_BITS: u32 = 21;
    /// Bits of the byte of a leaf.
    pub const LEAF_BITS: u32 = 27;
}

/// Byte ranges within a shape: how the leaves that name it are made.
pub mod shape {
    use super::Range;

    /// `u8`, one of [`kind`](super::kind).
    pub const KIND: usize = 0;
    /// Two `u8`, total degrees of the first and the second polynomial.
    pub const DEGREES: Range<usize> = 1..3;
    /// `u8`: the step of the coefficients is the quantum times two to this power.
    pub const EXPONENT: usize = 3;
    /// Four `u8`, bits of the coefficients of degree 0 to 3.
    pub const WIDTHS: Range<usize> = 4..8;

    /// Bytes of a shape.
    pub const LENGTH: usize = WIDTHS.end;

    /// Greatest exponent.
    pub const MAX_EXPONENT: u8 = 15;
    /// Most bits of a coefficient of degree 0.
    pub const MAX_CONSTANT_BITS: u8 = 24;
    /// Most bits of another.
    pub const MAX_COEFFICIENT_BITS: u8 = 16;
}

/// What a leaf makes of its polynomials (`shape::KIND`).
pub mod kind {
    /// It has only one.
    pub const SINGLE: u8 = 0;
    /// The lesser of two.
    pub const MIN: u8 = 1;
    /// The greater of two.
    pub const MAX: u8 = 2;
}

/// Leaves of a polynomial octree: bit strings.
pub mod leaf {
    /// Bits of the support code, after the shape, if leaves overlap.
    pub const SUPPORT_BITS: u32 = 2;
    /// Greatest support code.
    pub const MAX_SUPPORT: u32 = (1 << SUPPORT_BITS) - 1;
    /// Bits of the reach code, after the support code, if leaves overlap.
    pub const REACH_BITS: u32 = 2;
    /// Greatest reach code.
    pub const MAX_REACH: u32 = (1 << REACH_BITS) - 1;
    /// How many times finer a leaf may be than one that it touches, if leaves overlap, in levels.
    pub const MAX_LEVELS_APART: u32 = 5;
    /// Most bytes of a leaf.
    pub const MAX_LENGTH: usize = 40;
    /// Zero bytes after the last leaf, so that a reader may load more than a leaf at once.
    pub const PADDING: usize = 72;
}

const _: () = assert!(polynomial::LENGTH.is_multiple_of(4), "sections are whole words");
const _: () = assert!(record::CHILD_BITS + record::LEAF_BITS == 48, "the last six bytes of a record");
const _: () = assert!(grid::LENGTH.is_multiple_of(4), "sections are whole words");
const _: () = assert!(header::LENGTH <= 128, "design: a header of at most 128 bytes");
const _: () = assert!(header::LENGTH.is_multiple_of(4), "sections start on words");
const _: () = assert!(octree::LENGTH.is_multiple_of(4), "sections are whole words");
const _: () =
    assert!(2 * packed_sample::GRADIENT_BITS + packed_sample::DISTANCE_BITS == 32, "a first-order sample is 32 bits");
