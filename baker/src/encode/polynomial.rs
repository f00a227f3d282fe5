//! The sections of a polynomial octree, breadth first: parameters, root words, shapes, records, leaves.

use super::EncodeError;
use super::container::{Section, put};
use super::shapes::Shapes;
use crate::polynomial::cells::Content;
use crate::polynomial::{MAX_BITS, PolynomialOctree};
use nearfield::layout::{continuity, leaf, polynomial as layout, record, root_word, section};

/// The sections in file order.
pub(super) fn sections(octree: &PolynomialOctree) -> Result<Vec<Section>, EncodeError> {
    let shapes = Shapes::choose(octree.cells.leaves().map(|(_, _, coded)| coded), MAX_BITS);
    let mut writer = Writer { octree, shapes: &shapes, leaves: Vec::new(), inner: 0 };
    let (roots, records) = writer.write()?;
    let mut leaves = writer.leaves;

    leaves.resize((leaves.len() + leaf::PADDING).next_multiple_of(4), 0);
    Ok(vec![
        Section { kind: section::POLYNOMIAL, bytes: parameters(octree, &shapes) },
        Section { kind: section::ROOTS, bytes: roots },
        Section { kind: section::SHAPES, bytes: shapes.all.as_flattened().to_vec() },
        Section { kind: section::RECORDS, bytes: records },
        Section { kind: section::LEAVES, bytes: leaves },
    ])
}

fn parameters(octree: &PolynomialOctree, shapes: &Shapes) -> Vec<u8> {
    let domain = &octree.cells.domain;
    let root_cells = domain.root_cells.to_array().map(|cells| (cells as u16).to_le_bytes());
    let leaves = octree.cells.leaves().count() as u32;

    let mut bytes = vec![0; layout::LENGTH];
    put(&mut bytes, layout::ROOT_CELLS, root_cells.as_flattened());
    bytes[layout::DEPTH] = domain.depth;
    bytes[layout::SHAPE_BITS] = shapes.bits as u8;
    bytes[layout::CONTINUITY] = if octree.overlap > 0.0 { continuity::C1 } else { continuity::NONE };
    put(&mut bytes, layout::ROOT_EDGE, &(domain.root_edge as f32).to_le_bytes());
    put(&mut bytes, layout::QUANTUM, &octree.steps.quantum().to_le_bytes());
    put(&mut bytes, layout::OVERLAP, &(octree.overlap as f32).to_le_bytes());
    put(&mut bytes, layout::LEAF_COUNT, &leaves.to_le_bytes());
    bytes
}

struct Writer<'a> {
    octree: &'a PolynomialOctree,
    shapes: &'a Shapes,
    leaves: Vec<u8>,
    /// Inner nodes that have a number.
    inner: usize,
}

impl Writer<'_> {
    /// The bytes of the root words and of the records.
    fn write(&mut self) -> Result<(Vec<u8>, Vec<u8>), EncodeError> {
        let cells = &self.octree.cells;
        let mut queue = Vec::new();
        let mut roots = Vec::new();
        for place in 0..cells.roots() {
            let word = match cells.all[place].content {
                Content::Inner(first) => {
                    queue.push(first);
                    self.number()?
                }
                Content::Leaf(_) => self.leaf(place)? | root_word::LEAF,
            };
            roots.extend(word.to_le_bytes());
        }
        let mut records = Vec::new();
        let mut written = 0;
        while let Some(&first) = queue.get(written) {
            self.record(first, &mut records, &mut queue)?;
            written += 1;
        }
        records.resize(records.len().next_multiple_of(4), 0);
        Ok((roots, records))
    }

    /// Appends the record of an inner node with these children.
    fn record(&mut self, first: u32, records: &mut Vec<u8>, queue: &mut Vec<u32>) -> Result<(), EncodeError> {
        let (first_inner, first_leaf) = (self.inner, self.leaves.len());
        let mut bytes = [0; record::LENGTH];
        for child in 0..8 {
            let place = first as usize + child;
            let start = match self.octree.cells.all[place].content {
                Content::Inner(first) => {
                    bytes[record::INNER] |= 1 << child;
                    queue.push(first);
                    self.number()? as usize - first_inner
                }
                Content::Leaf(_) => self.leaf(place)? as usize - first_leaf,
            };
            if child > 0 {
                bytes[record::STARTS.start + child - 1] =
                    u8::try_from(start).expect("seven leaves of the most bits fit");
            }
        }
        let first = (first_inner as u64) | (first_leaf as u64) << record::CHILD_BITS;
        bytes[record::FIRST].copy_from_slice(&first.to_le_bytes()[..6]);
        records.extend(bytes);
        Ok(())
    }

    /// The number of the next inner node.
    fn number(&mut self) -> Result<u32, EncodeError> {
        let number = self.inner;
        self.inner += 1;
        if number < 1 << record::CHILD_BITS { Ok(number as u32) } else { Err(EncodeError::TooLarge) }
    }

    /// Appends a leaf and gives the byte where it starts.
    fn leaf(&mut self, place: usize) -> Result<u32, EncodeError> {
        let start = self.leaves.len();
        let Content::Leaf(coded) = &self.octree.cells.all[place].content else {
            unreachable!("the caller has seen a leaf");
        };
        let (number, widths) = self.shapes.of(coded);
        let mut bits = Bits::default();
        bits.push(number as u32, self.shapes.bits);
        if self.octree.overlap > 0.0 {
            let reach = self.octree.reaches[place];
            bits.push(u32::from(reach.support), leaf::SUPPORT_BITS);
            bits.push(u32::from(reach.reach), leaf::REACH_BITS);
        }
        for (degree, code) in coded.stored() {
            let width = u32::from(widths[usize::from(degree)]);
            if width > 0 {
                bits.push((code + (1 << (width - 1))).cast_unsigned(), width);
            }
        }
        bits.append_to(&mut self.leaves);
        if start < 1 << record::LEAF_BITS { Ok(start as u32) } else { Err(EncodeError::TooLarge) }
    }
}

/// A string of bits, least first.
#[derive(Default)]
struct Bits {
    bytes: Vec<u8>,
    pending: u64,
    count: u32,
}

impl Bits {
    fn push(&mut self, number: u32, width: u32) {
        self.pending |= u64::from(number) << self.count;
        self.count += width;
        while self.count >= 8 {
            self.bytes.push(self.pending as u8);
            self.pending >>= 8;
            self.count -= 8;
        }
    }

    /// Appends the string, padded with zeros to whole bytes.
    fn append_to(mut self, bytes: &mut Vec<u8>) {
        if self.count > 0 {
            self.bytes.push(self.pending as u8);
        }
        bytes.extend(self.bytes);
    }
}
