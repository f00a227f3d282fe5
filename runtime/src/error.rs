//! Why bytes are not a field.

use core::fmt;

/// Why bytes are not a valid field: one variant per rule of `SPEC.md` that a reader must enforce.
///
/// [`Field::open`](crate::Field::open) reports the rules that can be checked in constant time,
/// [`Field::validate`](crate::Field::validate) the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Error {
    /// The file is shorter than its header and section table (§2).
    Truncated,
    /// The first eight bytes are not the magic number (§3.1).
    Magic,
    /// The version is outside the window of this reader (§3.2).
    Version,
    /// The file length in the header is not the number of bytes (§3.3).
    FileLength,
    /// A reserved bit is set (§1.3).
    Reserved,
    /// The checksum of the header and the section table does not match (§3.4).
    HeaderChecksum,
    /// The field family is unknown, or not the one that was asked for (§3.5).
    Family,
    /// The sign method is unknown (§3.6).
    SignMethod,
    /// The box is empty, not finite or too large (§3.7).
    Bounds,
    /// A length or slope in the header is negative, not finite or too large (§3.8).
    Quantity,
    /// A root mean square or 99th percentile exceeds its maximum (§3.9).
    Contract,
    /// The section table is too long, or its sections do not tile the rest of the file (§4).
    SectionTable,
    /// Two sections are of the same kind (§4).
    SectionDuplicate,
    /// A section that the family requires is missing (§4).
    SectionMissing,
    /// The checksum of a section does not match (§4).
    SectionChecksum,
    /// The levels of detail are none, too many, or do not tile their section (§4.2).
    LodLength,
    /// A level of detail is of another family or diagonal, or has levels of its own (§4.2).
    LodHeader,
    /// A level of detail is not coarser than the next (§4.2).
    LodOrder,
    /// The section of octree parameters has the wrong length (§5).
    OctreeLength,
    /// The root grid is empty, or the lattice or the tree too large (§5.1).
    OctreeLattice,
    /// The interpolant is unknown (§5.2).
    Interpolant,
    /// The continuity is unknown (§5.3).
    Continuity,
    /// The edge of a root cell or the distance quantum is out of range (§5.4).
    OctreeScale,
    /// The box is not the root grid (§5.4).
    OctreeBounds,
    /// The node section is not the root grid and whole groups of eight (§6).
    NodeLength,
    /// The tag of a node word is unknown (§6).
    NodeTag,
    /// A group of children is not where its order puts it (§6.1).
    NodeOrder,
    /// A node lies below the deepest level (§6.1).
    NodeDepth,
    /// The leaf count is not the number of leaves (§6.1).
    LeafCount,
    /// A sample block is not where its order puts it, or exceeds its section (§7).
    BlockOrder,
    /// A sample that a leaf needs is not present (§7.1).
    BlockPresent,
    /// A full sample is not present, or the interpolant knows no full samples (§7.1).
    BlockFull,
    /// The precision of a block is unknown (§7.1).
    BlockPrecision,
    /// The base distance of a block is out of range (§7.1).
    BlockBase,
    /// The section of grid parameters has the wrong length (§11.1).
    GridLength,
    /// A grid has fewer than two samples along an axis, or its sections hold too few (§11.1, §11.2).
    GridResolution,
    /// The order or the reconstruction of a grid is unknown, or they do not go together (§11.1).
    GridReconstruction,
    /// The precision or the range of a grid is unknown, or they do not go together (§11.1).
    GridPrecision,
    /// The spacing or the distance quantum of a grid is out of range (§11.1).
    GridScale,
    /// The box is not the one that the samples of a grid span (§11.1).
    GridBounds,
    /// A section of a grid is longer than its samples or bricks (§11.2).
    GridSamples,
    /// The bits of a shape are none or too many (§12.1).
    ShapeBits,
    /// The overlap is neither 0 nor in its range (§12.1).
    Overlap,
    /// The section of root words is longer than the root grid (§12.2).
    RootLength,
    /// A root word or a record names another record than its order does, or there are more records (§12.3).
    RecordOrder,
    /// A root word or a record names another byte for a leaf than its order does (§12.3).
    LeafOrder,
    /// A leaf is too long, or the section of leaves is not as long as they and the padding (§12.5).
    LeafLength,
    /// A leaf names a shape that there is not (§12.5).
    LeafShape,
    /// The kind, a degree, a width or the exponent of a shape is out of range (§12.4).
    Shape,
    /// The shapes are too many or not in ascending order (§12.4).
    ShapeOrder,
    /// Leaves that overlap touch at levels too far apart (§12.6).
    LevelsApart,
    /// The support or the reach of a leaf is not what the tree makes it (§12.6).
    OverlapCodes,
    /// A gradient code is not one that a writer may write (§8).
    GradientCode,
    /// A floating-point component of a sample is not finite or too large (§8).
    SampleValue,
}

impl Error {
    /// The rule in words: no capital at the start, no full stop at the end.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Truncated => "the file is shorter than its header and section table",
            Self::Magic => "the file does not start with the magic number of a Nearfield field",
            Self::Version => "the file's version is not one that this reader knows",
            Self::FileLength => "the file is not as long as its header says",
            Self::Reserved => "a reserved bit is set",
            Self::HeaderChecksum => "the checksum of the header does not match",
            Self::Family => "the field family is unknown, or not the one that was asked for",
            Self::SignMethod => "the sign method is unknown",
            Self::Bounds => "the box is empty, not finite or too large",
            Self::Quantity => "a quantity in the header is negative, not finite or too large",
            Self::Contract => "the error contract contradicts itself",
            Self::SectionTable => "the sections do not tile the file",
            Self::SectionDuplicate => "two sections are of the same kind",
            Self::SectionMissing => "a required section is missing",
            Self::SectionChecksum => "the checksum of a section does not match",
            Self::LodLength => "the levels of detail are none, too many, or do not tile their section",
            Self::LodHeader => "a level of detail is not one of this field",
            Self::LodOrder => "a level of detail is not coarser than the next",
            Self::OctreeLength => "the octree parameters have the wrong length",
            Self::OctreeLattice => "the root grid is empty or the octree too large",
            Self::Interpolant => "the interpolant is unknown",
            Self::Continuity => "the continuity is unknown",
            Self::OctreeScale => "the cell edge or the distance quantum is out of range",
            Self::OctreeBounds => "the box is not the root grid of the octree",
            Self::NodeLength => "the node section is not a root grid and whole groups of nodes",
            Self::NodeTag => "the tag of a node is unknown",
            Self::NodeOrder => "a group of nodes is out of order",
            Self::NodeDepth => "a node lies below the deepest level",
            Self::LeafCount => "the leaf count is not the number of leaves",
            Self::BlockOrder => "a sample block is out of order or exceeds its section",
            Self::BlockPresent => "a sample that a leaf needs is missing",
            Self::BlockFull => "a full sample is not allowed where it is",
            Self::BlockPrecision => "the precision of a sample block is unknown",
            Self::BlockBase => "the base distance of a sample block is out of range",
            Self::GridLength => "the grid parameters have the wrong length",
            Self::GridResolution => "the grid has too few samples",
            Self::GridReconstruction => "the order or the reconstruction of the grid is unknown, or they do not match",
            Self::GridPrecision => "the precision or the range of the grid is unknown, or they do not match",
            Self::GridScale => "the spacing or the distance quantum of the grid is out of range",
            Self::GridBounds => "the box is not the one that the grid spans",
            Self::GridSamples => "a section of the grid is longer than it should be",
            Self::ShapeBits => "the shapes of the leaves have no bits or too many",
            Self::Overlap => "the overlap of the leaves is out of range",
            Self::RootLength => "the section of root words is longer than the root grid",
            Self::RecordOrder => "a record of the tree is out of order",
            Self::LeafOrder => "a leaf is out of order",
            Self::LeafLength => "a leaf is too long, or its section is not as long as its leaves",
            Self::LeafShape => "a leaf has an unknown shape",
            Self::Shape => "the shape of a leaf is out of range",
            Self::ShapeOrder => "the shapes of the leaves are too many or out of order",
            Self::LevelsApart => "leaves that overlap are too different in size",
            Self::OverlapCodes => "the support or the reach of a leaf does not fit the tree",
            Self::GradientCode => "a gradient code is out of range",
            Self::SampleValue => "a sample is not finite or too large",
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.text())
    }
}

impl core::error::Error for Error {}
