//! What cannot be checked in constant time: every section, every node, every sample.

use crate::bytes::Words;
use crate::error::Error;
use crate::implied::is_implied;
use crate::layout::{block, node, packed_sample as packed, precision};
use crate::leaf::{Block, CORNER_MASK, lattice_bit, strides};
use crate::octree::{Interpolant, Octree};
use crate::{sample, section};

/// Checks the checksum of every section (SPEC.md §4).
pub(crate) fn sections(bytes: &[u8]) -> Result<(), Error> {
    section::sections(bytes).try_for_each(|section| section::check_sum(bytes, &section))
}

/// Checks every node and every sample block (SPEC.md §6, §7).
///
/// The order of the file makes it a tree without any memory of what was seen: the groups of
/// children follow each other as their parents do, and so do the blocks, so the place of the next
/// one is always known.
pub(crate) fn octree(octree: &Octree<'_>) -> Result<(), Error> {
    let nodes = octree.nodes;
    let root_count = octree.root_count();
    if !(nodes.len() - root_count).is_multiple_of(8) {
        return Err(Error::NodeLength);
    }

    let (mut level, mut level_end) = (0, root_count);
    let (mut next_group, mut next_block) = (root_count, 0);
    let mut leaf_count = 0;
    let mut start = 0;
    while start < nodes.len() {
        if start == level_end {
            (level, level_end) = (level + 1, next_group);
        }
        if start >= next_group {
            return Err(Error::NodeOrder);
        }

        // Siblings share a block; a root cell is an only child.
        let siblings = if level == 0 { 1 } else { 8 };
        let mut needed = 0;
        for octant in 0..siblings {
            let word = nodes.word(start + octant as usize);
            let offset = (word & node::OFFSET_MASK) as usize;
            match word >> node::OFFSET_BITS {
                node::INNER if level == octree.depth() => return Err(Error::NodeDepth),
                node::INNER if offset != next_group || offset + 8 > nodes.len() => {
                    return Err(Error::NodeOrder);
                }
                node::INNER => next_group += 8,
                node::LEAF if offset != next_block => return Err(Error::BlockOrder),
                node::LEAF => {
                    needed |= CORNER_MASK << lattice_bit(octant);
                    leaf_count += 1;
                }
                _ => return Err(Error::NodeTag),
            }
        }
        if needed != 0 {
            next_block += check_block(octree, next_block, needed, level > 0)?;
        }
        start += siblings as usize;
    }

    if next_group != nodes.len() {
        return Err(Error::NodeOrder);
    }
    if next_block != octree.samples.len() {
        return Err(Error::BlockOrder);
    }
    if leaf_count == octree.leaf_count() { Ok(()) } else { Err(Error::LeafCount) }
}

/// Checks the block at a word of the sample section; returns its length in words.
fn check_block(octree: &Octree<'_>, at: usize, needed: u32, may_imply: bool) -> Result<usize, Error> {
    let words = octree.samples.tail(at);
    if words.len() < block::HEADER_WORDS {
        return Err(Error::BlockOrder);
    }
    if words.word(block::PRESENT_WORD) >> block::PRECISION_SHIFT > block::PRECISION_MASK
        || words.word(block::FULL_WORD) > block::LATTICE_MASK
    {
        return Err(Error::Reserved);
    }

    let block = Block::at(octree.samples, at as u32);
    let trilinear = octree.interpolant() == Interpolant::Trilinear;
    if block.precision > precision::F32 {
        return Err(Error::BlockPrecision);
    }
    let mut absent = (0..block::LATTICE).filter(|bit| (needed & !block.present) >> bit & 1 == 1);
    if !absent.all(|bit| may_imply && is_implied(bit, block.present)) {
        return Err(Error::BlockPresent);
    }
    if block.full & !block.present != 0 || trilinear && block.full != 0 {
        return Err(Error::BlockFull);
    }
    if !(block::MIN_BASE..=block::MAX_BASE).contains(&block.base) {
        return Err(Error::BlockBase);
    }
    if block.precision == precision::F32 && block.base != 0 {
        return Err(Error::Reserved);
    }

    let length = if trilinear { check_distances(&block) } else { check_samples(&block) }?;
    Ok(block::HEADER_WORDS + length)
}

/// Checks the distances of a trilinear block; returns their length in words.
fn check_distances(block: &Block<'_>) -> Result<usize, Error> {
    let count = block.present.count_ones() as usize;
    if block.precision == precision::F32 {
        let distances = block.data.head(count).ok_or(Error::BlockOrder)?;
        check_singles(distances)?;
        return Ok(count);
    }

    let length = count.div_ceil(2);
    let codes = block.data.head(length).ok_or(Error::BlockOrder)?;
    if !count.is_multiple_of(2) && codes.word(length - 1) >> 16 != 0 {
        return Err(Error::Reserved);
    }
    Ok(length)
}

/// Checks the samples of a tricubic block; returns their length in words.
fn check_samples(block: &Block<'_>) -> Result<usize, Error> {
    let (stride, full_stride) = strides(block.precision);
    let mut length = 0;
    for bit in 0..block::LATTICE {
        if block.present >> bit & 1 == 0 {
            continue;
        }
        let is_full = block.full >> bit & 1 == 1;
        let size = if is_full { full_stride } else { stride } as usize;
        let words = block.data.tail(length).head(size).ok_or(Error::BlockOrder)?;
        match (block.precision, is_full) {
            (precision::PACKED32, false) => check_gradient_code(words.word(0))?,
            (precision::F32, _) => check_singles(words)?,
            _ => check_halves(words)?,
        }
        length += size;
    }
    Ok(length)
}

pub(crate) fn check_gradient_code(word: u32) -> Result<(), Error> {
    let mask = (1 << packed::GRADIENT_BITS) - 1;
    let largest = (word & mask).max(word >> packed::GRADIENT_BITS & mask);
    if largest <= packed::GRADIENT_MAX { Ok(()) } else { Err(Error::GradientCode) }
}

/// Checks half floats, of which the first is a distance code.
fn check_halves(words: Words<'_>) -> Result<(), Error> {
    let finite = |half: u32| half & 0x7C00 != 0x7C00;
    let first_is_finite = finite(words.word(0) >> 16);
    let mut others = words.tail(1).iter();
    if first_is_finite && others.all(|word| finite(word) && finite(word >> 16)) {
        Ok(())
    } else {
        Err(Error::SampleValue)
    }
}

pub(crate) fn check_singles(words: Words<'_>) -> Result<(), Error> {
    let valid = words.iter().all(|word| sample::is_sample(f32::from_bits(word)));
    if valid { Ok(()) } else { Err(Error::SampleValue) }
}
