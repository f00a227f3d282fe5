//! Why bytes are not a field.

use core::fmt;

/// Declares the rules, each with its documentation and its words.
macro_rules! errors {
    ($($(#[$documentation:meta])* $rule:ident: $text:literal,)*) => {
        /// Why bytes are not a valid field: one variant per rule of `SPEC.md` that a reader must enforce.
        ///
        /// [`Field::open`](crate::Field::open) reports the rules that can be checked in constant time,
        /// [`Field::validate`](crate::Field::validate) the others.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Error {
            $($(#[$documentation])* $rule,)*
        }

        impl Error {
            /// Every rule, in the order of the variants: for those who give them numbers or words of their own.
            pub const ALL: &[Self] = &[$(Self::$rule,)*];

            /// The rule in words: no capital at the start, no full stop at the end.
            pub const fn text(self) -> &'static str {
                match self {
                    $(Self::$rule => $text,)*
                }
            }
        }
    };
}

errors! {
    /// The file is shorter than its header and section table (§2).
    Truncated: "the file is shorter than its header and section table",
    /// The first eight bytes are not the magic number (§3.1).
    Magic: "the file does not start with the magic number of a Nearfield field",
    /// The version is outside the window of this reader (§3.2).
    Version: "the file's version is not one that this reader knows",
    /// The file length in the header is not the number of bytes (§3.3).
    FileLength: "the file is not as long as its header says",
    /// A reserved bit is set (§1.3).
    Reserved: "a reserved bit is set",
    /// The checksum of the header and the section table does not match (§3.4).
    HeaderChecksum: "the checksum of the header does not match",
    /// The field family is unknown, or not the one that was asked for (§3.5).
    Family: "the field family is unknown, or not the one that was asked for",
    /// The sign method is unknown (§3.6).
    SignMethod: "the sign method is unknown",
    /// The box is empty, not finite or too large (§3.7).
    Bounds: "the box is empty, not finite or too large",
    /// A length or slope in the header is negative, not finite or too large (§3.8).
    Quantity: "a quantity in the header is negative, not finite or too large",
    /// A root mean square or 99th percentile exceeds its maximum (§3.9).
    Contract: "the error contract contradicts itself",
    /// The section table is too long, or its sections do not tile the rest of the file (§4).
    SectionTable: "the sections do not tile the file",
    /// Two sections are of the same kind (§4).
    SectionDuplicate: "two sections are of the same kind",
    /// A section that the family requires is missing (§4).
    SectionMissing: "a required section is missing",
    /// The checksum of a section does not match (§4).
    SectionChecksum: "the checksum of a section does not match",
    /// The levels of detail are none, too many, or do not tile their section (§4.2).
    LodLength: "the levels of detail are none, too many, or do not tile their section",
    /// A level of detail is of another family or diagonal, or has levels of its own (§4.2).
    LodHeader: "a level of detail is not one of this field",
    /// A level of detail is not coarser than the next (§4.2).
    LodOrder: "a level of detail is not coarser than the next",
    /// The section of octree parameters has the wrong length (§5).
    OctreeLength: "the octree parameters have the wrong length",
    /// The root grid is empty, or the lattice or the tree too large (§5.1).
    OctreeLattice: "the root grid is empty or the octree too large",
    /// The interpolant is unknown (§5.2).
    Interpolant: "the interpolant is unknown",
    /// The continuity is unknown (§5.3).
    Continuity: "the continuity is unknown",
    /// The edge of a root cell or the distance quantum is out of range (§5.4).
    OctreeScale: "the cell edge or the distance quantum is out of range",
    /// The box is not the root grid (§5.4).
    OctreeBounds: "the box is not the root grid of the octree",
    /// The node section is not the root grid and whole groups of eight (§6).
    NodeLength: "the node section is not a root grid and whole groups of nodes",
    /// The tag of a node word is unknown (§6).
    NodeTag: "the tag of a node is unknown",
    /// A group of children is not where its order puts it (§6.1).
    NodeOrder: "a group of nodes is out of order",
    /// A node lies below the deepest level (§6.1).
    NodeDepth: "a node lies below the deepest level",
    /// The leaf count is not the number of leaves (§6.1).
    LeafCount: "the leaf count is not the number of leaves",
    /// A sample block is not where its order puts it, or exceeds its section (§7).
    BlockOrder: "a sample block is out of order or exceeds its section",
    /// A sample that a leaf needs is not present (§7.1).
    BlockPresent: "a sample that a leaf needs is missing",
    /// A full sample is not present, or the interpolant knows no full samples (§7.1).
    BlockFull: "a full sample is not allowed where it is",
    /// The precision of a block is unknown (§7.1).
    BlockPrecision: "the precision of a sample block is unknown",
    /// The base distance of a block is out of range (§7.1).
    BlockBase: "the base distance of a sample block is out of range",
    /// The section of grid parameters has the wrong length (§11.1).
    GridLength: "the grid parameters have the wrong length",
    /// A grid has fewer than two samples along an axis, or its sections hold too few (§11.1, §11.2).
    GridResolution: "the grid has too few samples",
    /// The order or the reconstruction of a grid is unknown, or they do not go together (§11.1).
    GridReconstruction: "the order or the reconstruction of the grid is unknown, or they do not match",
    /// The precision or the range of a grid is unknown, or they do not go together (§11.1).
    GridPrecision: "the precision or the range of the grid is unknown, or they do not match",
    /// The spacing or the distance quantum of a grid is out of range (§11.1).
    GridScale: "the spacing or the distance quantum of the grid is out of range",
    /// The box is not the one that the samples of a grid span (§11.1).
    GridBounds: "the box is not the one that the grid spans",
    /// A section of a grid is longer than its samples or bricks (§11.2).
    GridSamples: "a section of the grid is longer than it should be",
    /// The bits of a shape are none or too many (§12.1).
    ShapeBits: "the shapes of the leaves have no bits or too many",
    /// The overlap is neither 0 nor in its range (§12.1).
    Overlap: "the overlap of the leaves is out of range",
    /// The section of root words is longer than the root grid (§12.2).
    RootLength: "the section of root words is longer than the root grid",
    /// A root word or a record names another record than its order does, or there are more records (§12.3).
    RecordOrder: "a record of the tree is out of order",
    /// A root word or a record names another byte for a leaf than its order does (§12.3).
    LeafOrder: "a leaf is out of order",
    /// A leaf is too long, or the section of leaves is not as long as they and the padding (§12.5).
    LeafLength: "a leaf is too long, or its section is not as long as its leaves",
    /// A leaf names a shape that there is not (§12.5).
    LeafShape: "a leaf has an unknown shape",
    /// The kind, a degree, a width or the exponent of a shape is out of range (§12.4).
    Shape: "the shape of a leaf is out of range",
    /// The shapes are too many or not in ascending order (§12.4).
    ShapeOrder: "the shapes of the leaves are too many or out of order",
    /// Leaves that overlap touch at levels too far apart (§12.6).
    LevelsApart: "leaves that overlap are too different in size",
    /// The support or the reach of a leaf is not what the tree makes it (§12.6).
    OverlapCodes: "the support or the reach of a leaf does not fit the tree",
    /// A gradient code is not one that a writer may write (§8).
    GradientCode: "a gradient code is out of range",
    /// A floating-point component of a sample is not finite or too large (§8).
    SampleValue: "a sample is not finite or too large",
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.text())
    }
}

impl core::error::Error for Error {}
