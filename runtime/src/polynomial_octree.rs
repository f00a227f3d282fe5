//! The octree of polynomials: its parameters, and from a point to the leaf that holds it (SPEC.md §12).

use crate::blend::{self, Sides};
use crate::bytes::{Words, f32_at, u8_at, u16x3_at, u32_at};
use crate::error::Error;
use crate::header::Aabb;
use crate::lattice::{Lattice, Leaf, Position, padded};
use crate::layout::{continuity, leaf, limit, octree, polynomial as at, record, root_word, section, shape};
use crate::octree::Continuity;
use crate::polynomial_leaf::{Answer, Bits, OverlapCodes, Polynomials, Question, Workspace};
use crate::section as sections;

/// An octree whose leaves are polynomials, blended where they overlap.
#[derive(Clone, Copy, Debug)]
pub struct PolynomialOctree<'a> {
    pub(crate) roots: Words<'a>,
    pub(crate) records: &'a [[u8; record::LENGTH]],
    pub(crate) shapes: &'a [[u8; shape::LENGTH]],
    pub(crate) leaves: &'a [u8],
    pub(crate) lattice: Lattice,
    /// Step of coefficients of exponent 0, mesh units.
    pub(crate) quantum: f32,
    overlap: f32,
    /// Half the edge of a leaf over twice the distance by which it reaches beyond its cell, if its support code is 0.
    pub(crate) steepness: f32,
    leaf_count: u32,
    pub(crate) shape_mask: u32,
    pub(crate) shape_bits: u8,
    /// Bits of a leaf before its coefficients.
    pub(crate) header_bits: u8,
}

/// What the tree has for a cell: a leaf, or an inner node and the number of its record.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Node {
    Leaf(u32),
    Inner(u32),
}

/// The record of an inner node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record<'a>(pub(crate) &'a [u8; record::LENGTH]);

/// Records of the nodes that hold a leaf, by the power of two of their children's edge.
pub(crate) type Path = [u32; octree::MAX_DEPTH as usize];

/// A point of the box, its leaf, and the way to it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Place {
    pub(crate) position: Position,
    /// The finest cell, and 0.
    pub(crate) cell: [u32; 4],
    /// Edge of the leaf, as a power of two of finest cells.
    pub(crate) shift: u32,
    /// Byte of the leaf.
    pub(crate) leaf: u32,
    pub(crate) path: Path,
}

/// The last place that was asked about, and what is known of its leaf.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Visit {
    known: Known,
    place: Place,
    codes: OverlapCodes,
    polynomials: Polynomials,
}

/// What is known of a leaf. Its polynomials are not read until a second query asks for them: reading and evaluating at
/// once is faster.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Known {
    #[default]
    Nothing,
    Place,
    Polynomials,
}

/// How far the supports of others reach into a leaf, by its reach code: in overlaps, where half an edge of the leaf is 1.
/// With a code of 0 everywhere.
const REACH: [f32; 1 << leaf::REACH_BITS] = [2.0 / at::MIN_OVERLAP, 2.0, 1.0, 0.5];

impl Record<'_> {
    #[inline]
    pub(crate) fn is_inner(self, octant: u32) -> bool {
        u32::from(self.0[record::INNER]) >> octant & 1 == 1
    }

    /// Where a child is, counted from the first of its kind.
    #[inline]
    pub(crate) fn start(self, octant: u32) -> u32 {
        // Child 0 has none: the mask is in its place. A branch would be hard to predict.
        u32::from(self.0[octant as usize & 7]) & u32::from(octant == 0).wrapping_sub(1)
    }

    /// Number of the record of the first inner child.
    #[inline]
    pub(crate) fn first_child(self) -> u32 {
        self.first() as u32 & ((1 << record::CHILD_BITS) - 1)
    }

    /// Byte of the first leaf.
    #[inline]
    pub(crate) fn first_leaf(self) -> u32 {
        (self.first() >> record::CHILD_BITS) as u32
    }

    #[inline]
    fn first(self) -> u64 {
        u64::from_le_bytes(*self.0.last_chunk().unwrap_or(&[0; 8])) >> 16
    }

    #[inline]
    pub(crate) fn child(self, octant: u32) -> Node {
        let start = self.start(octant);
        if self.is_inner(octant) {
            Node::Inner(self.first_child() + start)
        } else {
            Node::Leaf(self.first_leaf() + start)
        }
    }
}

impl<'a> PolynomialOctree<'a> {
    /// The octree of a file whose header has been checked (SPEC.md §12.1).
    pub(crate) fn open(bytes: &'a [u8], bounds: Aabb) -> Result<Self, Error> {
        let parameter_section = sections::find(bytes, section::POLYNOMIAL)?;
        let parameters = sections::find_bytes(bytes, section::POLYNOMIAL)?;
        let roots = Words::new(sections::find_bytes(bytes, section::ROOTS)?);
        let shapes = sections::find_bytes(bytes, section::SHAPES)?.as_chunks().0;
        let records = sections::find_bytes(bytes, section::RECORDS)?.as_chunks().0;
        let leaves = sections::find_bytes(bytes, section::LEAVES)?;

        // Small enough to be summed in constant time, and every query rests on it.
        if parameters.len() != at::LENGTH {
            return Err(Error::OctreeLength);
        }
        sections::check_sum(bytes, &parameter_section)?;
        if parameters.get(at::RESERVED) != Some(&[0; 3]) {
            return Err(Error::Reserved);
        }

        let root_edge = f32_at(parameters, at::ROOT_EDGE);
        let root_cells = u16x3_at(parameters, at::ROOT_CELLS);
        let lattice = Lattice::new(root_cells, u8_at(parameters, at::DEPTH), root_edge, bounds)?;
        if lattice.root_count() > roots.len() as u64 {
            return Err(Error::NodeLength);
        }
        let quantum = f32_at(parameters, at::QUANTUM);
        if !(limit::MIN_QUANTUM..=root_edge).contains(&quantum) {
            return Err(Error::OctreeScale);
        }
        lattice.check_bounds()?;

        let shape_bits = u8_at(parameters, at::SHAPE_BITS);
        if !(1..=at::MAX_SHAPE_BITS).contains(&shape_bits) {
            return Err(Error::ShapeBits);
        }
        let overlap = f32_at(parameters, at::OVERLAP);
        let expected = if overlap == 0.0 { continuity::NONE } else { continuity::C1 };
        if overlap != 0.0 && !(at::MIN_OVERLAP..=at::MAX_OVERLAP).contains(&overlap) {
            return Err(Error::Overlap);
        }
        if u8_at(parameters, at::CONTINUITY) != expected {
            return Err(Error::Continuity);
        }

        let codes = if overlap == 0.0 { 0 } else { leaf::SUPPORT_BITS + leaf::REACH_BITS };
        Ok(Self {
            roots,
            records,
            shapes,
            leaves,
            lattice,
            quantum,
            overlap,
            steepness: if overlap == 0.0 { 0.0 } else { 0.25 / overlap },
            shape_bits,
            shape_mask: (1 << shape_bits) - 1,
            header_bits: shape_bits + codes as u8,
            leaf_count: u32_at(parameters, at::LEAF_COUNT),
        })
    }

    /// Cells of the root grid along x, y, z; each at least 1.
    pub fn root_cells(&self) -> [u32; 3] {
        self.lattice.root_cells
    }

    /// Levels below the root grid, at most 16: a root cell is `1 << depth` finest cells wide.
    pub fn depth(&self) -> u8 {
        self.lattice.depth
    }

    /// Edge of a cell at a level, mesh units.
    pub fn edge(&self, level: u8) -> f32 {
        self.lattice.edge(level)
    }

    /// Finest step of a coefficient, mesh units.
    pub fn quantum(&self) -> f32 {
        self.quantum
    }

    /// How far leaves reach beyond their cells and are blended, as a share of the cell's edge: 0 if they are not,
    /// otherwise 1/64 to 1/4.
    pub fn overlap(&self) -> f32 {
        self.overlap
    }

    /// What is promised across faces between leaves: value and gradient are continuous if leaves overlap, except where
    /// a leaf holds a crease, whose gradient jumps.
    pub fn continuity(&self) -> Continuity {
        if self.overlap == 0.0 { Continuity::None } else { Continuity::C1 }
    }

    /// Leaves of the tree.
    pub fn leaf_count(&self) -> u32 {
        self.leaf_count
    }

    /// Inner nodes of the tree.
    pub fn inner_count(&self) -> usize {
        self.records.len()
    }

    /// The box that the root grid fills.
    pub fn bounds(&self) -> Aabb {
        self.lattice.bounds()
    }

    /// Finest cells along x, y, z, at most 2²⁰.
    pub fn lattice(&self) -> [u32; 3] {
        self.lattice.cells()
    }

    /// The leaf that holds a finest cell; cells beyond the lattice count as its last.
    #[inline]
    pub fn leaf_at(&self, cell: [u32; 3]) -> Leaf {
        let [x, y, z] = self.lattice.clamp(cell);
        let node = self.root(self.lattice.root_of([x, y, z]));
        let (place, shift) = self.descend(&[x, y, z, 0], node, self.lattice.depth.into(), &mut Path::default());
        let align = u32::MAX << shift;
        Leaf {
            level: self.lattice.depth - shift as u8,
            cell: [x & align, y & align, z & align],
            edge: 1 << shift,
            place,
            octant: 0,
        }
    }

    /// The leaves: the root grid x fastest, below it depth first, the octants of a cell in the order of their numbers.
    pub fn leaves(&self) -> impl Iterator<Item = Leaf> + use<'a> {
        let octree = *self;
        let after = move |leaf: &Leaf| octree.lattice.cell_after(leaf).map(|cell| octree.leaf_at(cell));
        core::iter::successors(Some(octree.leaf_at([0; 3])), after)
    }

    /// Value and gradient of a leaf alone, without its neighbours, at local coordinates, 0 to 1 along each axis.
    ///
    /// The value is in mesh units, the gradient without unit. A leaf answers beyond its cell too,
    /// by extrapolation; finite coordinates of a few cells give finite answers.
    pub fn evaluate(&self, leaf: &Leaf, local: [f32; 3]) -> (f32, [f32; 3]) {
        let question = Question {
            local: padded(local.map(|part| 2.0 * part - 1.0)),
            per_half: self.lattice.per_half(leaf.edge.trailing_zeros()),
            with_gradient: true,
        };
        let mut answer = Answer::default();
        Bits::at(self, leaf.place).evaluate(self, &question, &mut Workspace::default(), &mut answer);
        answer.split()
    }

    /// What the leaf that holds a point of the box answers alone, distance and gradient: faster than
    /// [`Field::distance_and_gradient`](crate::Field::distance_and_gradient), which blends leaves where they overlap, and with
    /// jumps on their faces. `None` outside the box.
    pub fn unblended(&self, [x, y, z]: [f32; 3]) -> Option<(f32, [f32; 3])> {
        let (mut place, mut outside) = (Place::default(), [0; 4]);
        self.lattice.locate(x, y, z, &mut place.position, &mut place.cell, &mut outside);
        if outside[0] | outside[1] | outside[2] != 0 {
            return None;
        }
        self.find(&mut place);
        let bits = Bits::at(self, place.leaf);
        let question = self.question(&place.cell, place.shift, &place.position, true);
        let mut answer = Answer::default();
        bits.evaluate(self, &question, &mut Workspace::default(), &mut answer);
        Some(answer.split())
    }

    /// Value and, if asked for, gradient at a point of the box.
    #[inline(never)]
    pub(crate) fn query(&self, [x, y, z]: [f32; 3], with_gradient: bool) -> Answer {
        let mut place = Place::default();
        self.lattice.locate(x, y, z, &mut place.position, &mut place.cell, &mut [0; 4]);
        self.find(&mut place);
        self.answer_at(&place, with_gradient)
    }

    /// The same at a place, by a call.
    #[inline(never)]
    pub(crate) fn query_at(&self, place: &Place, with_gradient: bool) -> Answer {
        self.answer_at(place, with_gradient)
    }

    #[inline(always)]
    fn answer_at(&self, place: &Place, with_gradient: bool) -> Answer {
        let bits = Bits::at(self, place.leaf);
        self.answer(place, bits.overlap_codes(self), with_gradient, |question, workspace, answer| {
            bits.evaluate(self, question, workspace, answer);
        })
    }

    /// The same from the last visit, which it changes.
    #[inline(never)]
    pub(crate) fn query_from(&self, [x, y, z]: [f32; 3], with_gradient: bool, visit: &mut Visit) -> Answer {
        let Visit { known, place, codes, polynomials } = visit;
        let last = place.cell;
        self.lattice.locate(x, y, z, &mut place.position, &mut place.cell, &mut [0; 4]);
        let [x, y, z, _] = place.cell;
        let different = (x ^ last[0]) | (y ^ last[1]) | (z ^ last[2]);
        let is_same = *known != Known::Nothing && different >> place.shift == 0;
        if !is_same {
            self.find(place);
            (*known, *codes) = (Known::Place, Bits::at(self, place.leaf).overlap_codes(self));
        } else if *known == Known::Place {
            Bits::at(self, place.leaf).decode(self, polynomials);
            *known = Known::Polynomials;
        }
        self.answer(place, *codes, with_gradient, |question, workspace, answer| {
            if *known == Known::Polynomials {
                polynomials.evaluate(question, answer);
            } else {
                Bits::at(self, place.leaf).evaluate(self, question, workspace, answer);
            }
        })
    }

    /// The answer at a place: that of its leaf, blended with others that may have a say there.
    #[inline(always)]
    pub(crate) fn answer(
        &self,
        place: &Place,
        codes: OverlapCodes,
        with_gradient: bool,
        evaluate: impl Fn(&Question, &mut Workspace, &mut Answer),
    ) -> Answer {
        let mut question = self.question_beyond(place.shift, with_gradient);
        let (mut sides, mut workspace, mut answer) = (Sides::default(), Workspace::default(), Answer::default());
        self.look(&place.cell, place.shift, codes, &place.position, &mut question.local, &mut sides);
        evaluate(&question, &mut workspace, &mut answer);
        if sides.near() != 0 {
            self.blend(place, codes, &question, &mut sides, &mut workspace, &mut answer);
        }
        answer
    }

    /// Finds the leaf of a place.
    #[inline(never)]
    pub(crate) fn find(&self, place: &mut Place) {
        let [x, y, z, _] = place.cell;
        let node = self.root(self.lattice.root_of([x, y, z]));
        let depth = u32::from(self.lattice.depth);
        (place.leaf, place.shift) = self.descend(&place.cell, node, depth, &mut place.path);
    }

    /// What to ask the leaf that holds a cell.
    #[inline]
    pub(crate) fn question(&self, cell: &[u32; 4], shift: u32, position: &Position, with_gradient: bool) -> Question {
        let mut question = self.question_beyond(shift, with_gradient);
        blend::local(cell, shift, position, &mut question.local);
        question
    }

    /// What to ask a leaf of an edge, but where.
    #[inline]
    fn question_beyond(&self, shift: u32, with_gradient: bool) -> Question {
        Question { local: [0.0; 4], per_half: self.lattice.per_half(shift), with_gradient }
    }

    /// Beyond which local coordinate of a leaf others may have a say, -1 to 1 being the leaf.
    #[inline]
    pub(crate) fn alone_within(&self, reach: u32) -> f32 {
        1.0 - self.overlap * REACH[reach as usize & 3]
    }

    /// Number of the root word of a finest cell of the lattice, as a node.
    #[inline]
    pub(crate) fn root(&self, number: usize) -> Node {
        let word = self.roots.word(number);
        if word & root_word::LEAF != 0 { Node::Leaf(word & !root_word::LEAF) } else { Node::Inner(word) }
    }

    /// A record; one of leaves without bits if there is none of that number.
    #[inline]
    pub(crate) fn record(&self, number: u32) -> Record<'a> {
        Record(self.records.get(number as usize).unwrap_or(&[0; record::LENGTH]))
    }

    /// From a node whose edge is 2^`shift` to the leaf in it that holds a finest cell: its place, and its edge as a power
    /// of two. Writes the records on the way, by the power of two of their children's edge.
    #[inline]
    pub(crate) fn descend(
        &self,
        &[x, y, z, _]: &[u32; 4],
        mut node: Node,
        mut shift: u32,
        path: &mut Path,
    ) -> (u32, u32) {
        // All three coordinates at once: a product gathers a bit of each.
        let digits = u64::from(x) | u64::from(y) << 21 | u64::from(z) << 42;
        while let Node::Inner(record) = node
            && shift > 0
        {
            shift -= 1;
            path[shift as usize & 15] = record;
            let bits = digits >> shift & (1 | 1 << 21 | 1 << 42);
            let octant = (bits.wrapping_mul(1 << 42 | 1 << 22 | 1 << 2) >> 42) as u32 & 7;
            node = self.record(record).child(octant);
        }
        let (Node::Leaf(leaf) | Node::Inner(leaf)) = node;
        (leaf, shift)
    }
}
