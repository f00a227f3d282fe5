//! What of a polynomial octree cannot be checked in constant time (SPEC.md §12.2 to §12.6).

use crate::error::Error;
use crate::lattice::Leaf;
use crate::layout::section::{RECORDS, SHAPES};
use crate::layout::{kind, leaf, polynomial, record, shape};
use crate::polynomial_leaf::{Bits, OverlapCodes, Shape};
use crate::polynomial_octree::{Node, PolynomialOctree, Record};
use crate::region::Region;
use crate::section;

/// Checks every shape, every node and every leaf of a file.
///
/// The order of the file makes it a tree without any memory of what was seen: the next record and the next byte of a
/// leaf are always known.
pub(crate) fn octree(bytes: &[u8], octree: &PolynomialOctree<'_>) -> Result<(), Error> {
    if !section::find_bytes(bytes, SHAPES)?.len().is_multiple_of(shape::LENGTH) {
        return Err(Error::ShapeOrder);
    }
    check_shapes(octree)?;
    let root_count = octree.lattice.root_count() as usize;
    if octree.roots.len() != root_count {
        return Err(Error::RootLength);
    }

    let mut next = Next::default();
    for root in 0..root_count {
        match octree.root(root) {
            Node::Inner(_) if octree.lattice.depth == 0 => return Err(Error::NodeDepth),
            Node::Inner(number) => next.record(number)?,
            Node::Leaf(place) => next.leaf(octree, place)?,
        }
    }

    let (mut level, mut level_end) = (0, next.record);
    for (number, bytes) in (0..).zip(octree.records) {
        if number == level_end {
            (level, level_end) = (level + 1, next.record);
        }
        if number >= next.record {
            return Err(Error::RecordOrder);
        }
        check_record(octree, Record(bytes), level + 1 == octree.lattice.depth, &mut next)?;
    }

    if next.record as usize != octree.records.len() {
        return Err(Error::RecordOrder);
    }
    let records = section::find_bytes(bytes, RECORDS)?;
    check_rest(records.as_chunks::<{ record::LENGTH }>().1, 0)?;
    let end = next.place as usize;
    let length = (end + leaf::PADDING).next_multiple_of(4);
    if octree.leaves.len() != length {
        return Err(Error::LeafLength);
    }
    check_rest(octree.leaves.get(end..).unwrap_or(&[]), 0)?;
    if next.leaf_count != octree.leaf_count() {
        return Err(Error::LeafCount);
    }
    if octree.overlap() == 0.0 { Ok(()) } else { octree.leaves().try_for_each(|leaf| check_overlap(octree, &leaf)) }
}

/// What comes next in the order of the file.
#[derive(Default)]
struct Next {
    record: u32,
    place: u32,
    leaf_count: u32,
}

impl Next {
    fn record(&mut self, number: u32) -> Result<(), Error> {
        if number != self.record {
            return Err(Error::RecordOrder);
        }
        self.record += 1;
        Ok(())
    }

    fn leaf(&mut self, octree: &PolynomialOctree<'_>, place: u32) -> Result<(), Error> {
        if place != self.place {
            return Err(Error::LeafOrder);
        }
        self.place += check_leaf(octree, place)?;
        self.leaf_count += 1;
        Ok(())
    }
}

fn check_shapes(octree: &PolynomialOctree<'_>) -> Result<(), Error> {
    if octree.shapes.len() > octree.shape_mask as usize + 1 || !octree.shapes.is_sorted_by(|a, b| a < b) {
        return Err(Error::ShapeOrder);
    }
    let is_sound = |bytes: &[u8; shape::LENGTH]| {
        let shape = Shape::new(*bytes);
        let kind = shape.byte(shape::KIND);
        let [first, second] = [0, 1].map(|polynomial| shape.byte(shape::DEGREES.start + polynomial));
        let widths: [u8; 4] = [0, 1, 2, 3].map(|degree| shape.byte(shape::WIDTHS.start + degree));
        let most = |degree: u8| match degree {
            0 => shape::MAX_CONSTANT_BITS,
            _ if degree <= first.max(second) => shape::MAX_COEFFICIENT_BITS,
            _ => 0,
        };
        kind <= kind::MAX
            && first.max(second) <= polynomial::MAX_DEGREE
            && (second == 0 || kind != kind::SINGLE)
            && shape.byte(shape::EXPONENT) <= shape::MAX_EXPONENT
            && widths.iter().zip(0..).all(|(&width, degree)| width <= most(degree))
    };
    if octree.shapes.iter().all(is_sound) { Ok(()) } else { Err(Error::Shape) }
}

fn check_record(
    octree: &PolynomialOctree<'_>,
    record: Record<'_>,
    is_last_level: bool,
    next: &mut Next,
) -> Result<(), Error> {
    // Also where there are no children of the kind.
    if record.first_child() != next.record {
        return Err(Error::RecordOrder);
    }
    if record.first_leaf() != next.place {
        return Err(Error::LeafOrder);
    }
    for octant in 0..8 {
        match record.child(octant) {
            Node::Inner(_) if is_last_level => return Err(Error::NodeDepth),
            Node::Inner(number) => next.record(number)?,
            Node::Leaf(place) => next.leaf(octree, place)?,
        }
    }
    Ok(())
}

/// Checks the leaf at a byte; returns its length in bytes.
fn check_leaf(octree: &PolynomialOctree<'_>, place: u32) -> Result<u32, Error> {
    let bytes = octree.leaves.get(place as usize..).unwrap_or(&[]);
    if bytes.len() < leaf::PADDING {
        return Err(Error::LeafLength);
    }
    let bits = Bits::at(octree, place);
    if bits.shape_number(octree) >= octree.shapes.len() {
        return Err(Error::LeafShape);
    }
    let length = bits.length(octree);
    let whole = length.div_ceil(8);
    if whole as usize > leaf::MAX_LENGTH {
        return Err(Error::LeafLength);
    }
    let last = bytes.get(whole as usize - 1).copied().unwrap_or(0);
    check_rest(&[last], length - 8 * (whole - 1))?;
    Ok(whole)
}

/// Checks that bytes are zero from a bit of the first on.
fn check_rest(bytes: &[u8], bit: u32) -> Result<(), Error> {
    let is_zero = match bytes {
        [] => true,
        [first, others @ ..] => u32::from(*first) >> bit == 0 && others.iter().all(|&byte| byte == 0),
    };
    if is_zero { Ok(()) } else { Err(Error::Reserved) }
}

/// Checks a leaf against those that it touches.
fn check_overlap(octree: &PolynomialOctree<'_>, leaf: &Leaf) -> Result<(), Error> {
    let codes = Bits::at(octree, leaf.place).overlap_codes(octree);
    let mut deepest = leaf.level;
    // The greatest support of a leaf that it touches, in finest cells and without the overlap.
    let mut greatest = 0.0_f32;
    for other in touching(octree, leaf) {
        deepest = deepest.max(other.level);
        if u32::from(deepest - leaf.level) > leaf::MAX_LEVELS_APART {
            return Err(Error::LevelsApart);
        }
        let its_support = Bits::at(octree, other.place).overlap_codes(octree).support;
        greatest = greatest.max(other.edge as f32 / (1 << its_support) as f32);
    }

    let support = u32::from(deepest - leaf.level).min(leaf::MAX_SUPPORT);
    let reaches = |code: &u32| greatest <= leaf.edge as f32 / (1 << (code - 1)) as f32;
    let reach = (1..=leaf::MAX_REACH).rev().find(reaches).unwrap_or(0);
    if codes == (OverlapCodes { support, reach }) { Ok(()) } else { Err(Error::OverlapCodes) }
}

/// The leaves that touch a leaf.
fn touching(octree: &PolynomialOctree<'_>, leaf: &Leaf) -> impl Iterator<Item = Leaf> {
    let low = leaf.cell.map(|cell| cell.saturating_sub(1));
    let high = octree.lattice.clamp(leaf.cell.map(|cell| cell + leaf.edge));
    let own = leaf.cell;
    Region::new(octree, low, high, 0).filter(move |other| other.cell != own)
}
