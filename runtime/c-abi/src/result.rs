//! Results, and what they say.

use core::ffi::c_char;
use nearfield::Error;

/// What became of a call. A number keeps its meaning; later versions may add some.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NearfieldResult {
    /// All is well.
    Ok = 0,
    /// The file is shorter than its header and section table (§2).
    Truncated = 1,
    /// The first eight bytes are not the magic number (§3.1).
    Magic = 2,
    /// The version is outside the window of this reader (§3.2).
    Version = 3,
    /// The file length in the header is not the number of bytes (§3.3).
    FileLength = 4,
    /// A reserved bit is set (§1.3).
    Reserved = 5,
    /// The checksum of the header and the section table does not match (§3.4).
    HeaderChecksum = 6,
    /// The field family is unknown, or not the one that was asked for (§3.5).
    Family = 7,
    /// The sign method is unknown (§3.6).
    SignMethod = 8,
    /// The box is empty, not finite or too large (§3.7).
    Bounds = 9,
    /// A length or slope in the header is negative, not finite or too large (§3.8).
    Quantity = 10,
    /// A root mean square or 99th percentile exceeds its maximum (§3.9).
    Contract = 11,
    /// The section table is too long, or its sections do not tile the rest of the file (§4).
    SectionTable = 12,
    /// Two sections are of the same kind (§4).
    SectionDuplicate = 13,
    /// A section that the family requires is missing (§4).
    SectionMissing = 14,
    /// The checksum of a section does not match (§4).
    SectionChecksum = 15,
    /// The section of octree parameters has the wrong length (§5).
    OctreeLength = 16,
    /// The root grid is empty, or the lattice or the tree too large (§5.1).
    OctreeLattice = 17,
    /// The interpolant is unknown (§5.2).
    Interpolant = 18,
    /// The continuity is unknown (§5.3).
    Continuity = 19,
    /// The edge of a root cell or the distance quantum is out of range (§5.4).
    OctreeScale = 20,
    /// The box is not the root grid (§5.4).
    OctreeBounds = 21,
    /// The node section is not the root grid and whole groups of eight (§6).
    NodeLength = 22,
    /// The tag of a node word is unknown (§6).
    NodeTag = 23,
    /// A group of children is not where its order puts it (§6.1).
    NodeOrder = 24,
    /// A node lies below the deepest level (§6.1).
    NodeDepth = 25,
    /// The leaf count is not the number of leaves (§6.1).
    LeafCount = 26,
    /// A sample block is not where its order puts it, or exceeds its section (§7).
    BlockOrder = 27,
    /// A sample that a leaf needs is not present (§7.1).
    BlockPresent = 28,
    /// A full sample is not present, or the interpolant knows no full samples (§7.1).
    BlockFull = 29,
    /// The precision of a block is unknown (§7.1).
    BlockPrecision = 30,
    /// The base distance of a block is out of range (§7.1).
    BlockBase = 31,
    /// The section of grid parameters has the wrong length (§11.1).
    GridLength = 32,
    /// A grid has fewer than two samples along an axis, or its sections hold too few (§11.1, §11.2).
    GridResolution = 33,
    /// The order or the reconstruction of a grid is unknown, or they do not go together (§11.1).
    GridReconstruction = 34,
    /// The precision or the range of a grid is unknown, or they do not go together (§11.1).
    GridPrecision = 35,
    /// The spacing or the distance quantum of a grid is out of range (§11.1).
    GridScale = 36,
    /// The box is not the one that the samples of a grid span (§11.1).
    GridBounds = 37,
    /// A section of a grid is longer than its samples or bricks (§11.2).
    GridSamples = 38,
    /// A gradient code is not one that a writer may write (§8).
    GradientCode = 39,
    /// A floating-point component of a sample is not finite or too large (§8).
    SampleValue = 40,
    /// The bits of a shape are none or too many (§12.1).
    ShapeBits = 41,
    /// The overlap is neither 0 nor in its range (§12.1).
    Overlap = 42,
    /// The section of root words is longer than the root grid (§12.2).
    RootLength = 43,
    /// A root word or a record names another record than its order does, or there are more records (§12.3).
    RecordOrder = 44,
    /// A root word or a record names another byte for a leaf than its order does (§12.3).
    LeafOrder = 45,
    /// A leaf is too long, or the section of leaves is not as long as they and the padding (§12.5).
    LeafLength = 46,
    /// A leaf names a shape that there is not (§12.5).
    LeafShape = 47,
    /// The kind, a degree, a width or the exponent of a shape is out of range (§12.4).
    Shape = 48,
    /// The shapes are too many or not in ascending order (§12.4).
    ShapeOrder = 49,
    /// Leaves that overlap touch at levels too far apart (§12.6).
    LevelsApart = 50,
    /// The support or the reach of a leaf is not what the tree makes it (§12.6).
    OverlapCodes = 51,
    /// The levels of detail are none, too many, or do not tile their section (§4.2).
    LodLength = 52,
    /// A level of detail is of another family or diagonal, or has levels of its own (§4.2).
    LodHeader = 53,
    /// A level of detail is not coarser than the next (§4.2).
    LodOrder = 54,
    /// A pointer is NULL that may not be.
    Null = 256,
    /// The handle of the field is not open.
    NotOpen = 257,
    /// The bytes break a rule that this interface has no number for.
    Other = 258,
    /// A placement is not a rotation or reflection with a uniform scale.
    NotASimilarity = 259,
    /// The field has no such level of detail, or it is damaged.
    NoLod = 260,
}

/// A text with the zero at its end that C wants.
const fn terminated<const LENGTH: usize>(text: &str) -> [u8; LENGTH] {
    let (mut bytes, mut at) = ([0; LENGTH], 0);
    while at < text.len() {
        bytes[at] = text.as_bytes()[at];
        at += 1;
    }
    bytes
}

macro_rules! text {
    ($text:expr) => {{
        const TEXT: &str = $text;
        const BYTES: &[u8] = &terminated::<{ TEXT.len() + 1 }>(TEXT);
        BYTES.as_ptr().cast()
    }};
}

/// One row for each error of the reader, under the same name.
macro_rules! errors {
    ($($name:ident)*) => {
        impl From<Error> for NearfieldResult {
            fn from(error: Error) -> Self {
                match error {
                    $(Error::$name => Self::$name,)*
                    _ => Self::Other,
                }
            }
        }

        fn error_text(result: i32) -> Option<*const c_char> {
            $(if result == NearfieldResult::$name as i32 {
                return Some(text!(Error::$name.text()));
            })*
            None
        }
    };
}

errors! {
    Truncated Magic Version FileLength Reserved HeaderChecksum Family SignMethod Bounds Quantity Contract SectionTable
    SectionDuplicate SectionMissing SectionChecksum OctreeLength OctreeLattice Interpolant Continuity OctreeScale
    OctreeBounds NodeLength NodeTag NodeOrder NodeDepth LeafCount BlockOrder BlockPresent BlockFull BlockPrecision
    BlockBase GridLength GridResolution GridReconstruction GridPrecision GridScale GridBounds GridSamples GradientCode
    SampleValue ShapeBits Overlap RootLength RecordOrder LeafOrder LeafLength LeafShape Shape ShapeOrder LevelsApart
    OverlapCodes LodLength LodHeader LodOrder
}

/// A result in words, zero-terminated, for ever. Never NULL, whatever the number.
#[unsafe(no_mangle)]
pub extern "C" fn nearfield_result_text(result: i32) -> *const c_char {
    const OK: i32 = NearfieldResult::Ok as i32;
    const NULL: i32 = NearfieldResult::Null as i32;
    const NOT_OPEN: i32 = NearfieldResult::NotOpen as i32;
    const NOT_A_SIMILARITY: i32 = NearfieldResult::NotASimilarity as i32;
    const NO_LOD: i32 = NearfieldResult::NoLod as i32;
    match result {
        OK => text!("no error"),
        NULL => text!("a pointer is NULL"),
        NOT_OPEN => text!("the field is not open"),
        NOT_A_SIMILARITY => text!("the placement is not a rotation or reflection with a uniform scale"),
        NO_LOD => text!("the field has no such level of detail"),
        _ => error_text(result).unwrap_or(text!("the bytes are not a field that this version can read")),
    }
}
