//! The sections of an octree: parameters, node words and sample blocks, breadth first.

use super::EncodeError;
use super::blocks::push_block;
use super::container::{Section, put};
use crate::octree::Octree;
use crate::octree::corners::Vertex;
use crate::octree::tree::{Node, NodeId, lattice_index, lattice_offset, octant};
use crate::settings::{Continuity, Interpolant};
use nearfield::layout::{continuity, interpolant, node, octree as layout, section};

/// The sections in file order.
pub(super) fn sections(octree: &Octree) -> Result<Vec<Section>, EncodeError> {
    let mut writer = Writer { octree, nodes: Vec::new(), samples: Vec::new(), inner: Vec::new() };
    for root in octree.tree.roots() {
        writer.push_root(root)?;
    }
    let mut written = 0;
    while let Some(&parent) = writer.inner.get(written) {
        writer.push_children(parent)?;
        written += 1;
    }

    Ok(vec![
        Section { kind: section::OCTREE, bytes: parameters(octree) },
        Section { kind: section::NODES, bytes: little_endian(writer.nodes) },
        Section { kind: section::SAMPLES, bytes: little_endian(writer.samples) },
    ])
}

fn parameters(octree: &Octree) -> Vec<u8> {
    let domain = &octree.tree.domain;
    let leaves = octree.tree.nodes().iter().filter(|node| node.is_leaf()).count() as u32;
    let root_cells = domain.root_cells.to_array().map(|cells| (cells as u16).to_le_bytes());

    let mut bytes = vec![0; layout::LENGTH];
    put(&mut bytes, layout::ROOT_CELLS, root_cells.as_flattened());
    bytes[layout::DEPTH] = domain.depth;
    bytes[layout::INTERPOLANT] = match octree.rounding.interpolant() {
        Interpolant::Trilinear => interpolant::TRILINEAR,
        Interpolant::Tricubic => interpolant::TRICUBIC,
    };
    bytes[layout::CONTINUITY] = match octree.continuity {
        Continuity::None => continuity::NONE,
        Continuity::C0 => continuity::C0,
        Continuity::C1 => continuity::C1,
    };
    put(&mut bytes, layout::ROOT_EDGE, &(domain.root_edge as f32).to_le_bytes());
    put(&mut bytes, layout::QUANTUM, &octree.rounding.root_quantum().to_le_bytes());
    put(&mut bytes, layout::LEAF_COUNT, &leaves.to_le_bytes());
    bytes
}

fn little_endian(words: Vec<u32>) -> Vec<u8> {
    let words: Vec<u32> = words.into_iter().map(u32::to_le).collect();
    bytemuck::cast_slice(&words).to_vec()
}

/// Writes groups of siblings in the order of their parents, and blocks in the order of the groups.
struct Writer<'a> {
    octree: &'a Octree,
    nodes: Vec<u32>,
    samples: Vec<u32>,
    /// The inner nodes met so far, in the order of their words.
    inner: Vec<NodeId>,
}

impl Writer<'_> {
    /// Writes the word of a root cell, and its block if it is a leaf.
    fn push_root(&mut self, id: NodeId) -> Result<(), EncodeError> {
        let root = self.octree.tree.node(id);
        let word = if root.is_leaf() { self.root_block(root)? } else { self.group(id)? };
        self.nodes.push(word);
        Ok(())
    }

    /// Writes the words of a node's children, and the block of the leaves among them.
    fn push_children(&mut self, parent: NodeId) -> Result<(), EncodeError> {
        let tree = &self.octree.tree;
        let parent = tree.node(parent);
        let children = tree.children(parent).expect("an inner node has children");
        let block = self.block(parent, &children)?;
        for child in children {
            let word = if tree.node(child).is_leaf() { block } else { self.group(child)? };
            self.nodes.push(word);
        }
        Ok(())
    }

    /// The word of an inner node, whose children are to be written after those of all inner nodes before it.
    fn group(&mut self, id: NodeId) -> Result<u32, EncodeError> {
        let roots = self.octree.tree.domain.root_cells.element_product() as usize;
        self.inner.push(id);
        word(node::INNER, roots + 8 * (self.inner.len() - 1))
    }

    /// Writes the block that the leaves among eight siblings share and gives the word of each of them.
    ///
    /// A vertex that hangs between corners of the parent is left out: it hangs on a leaf whose closure
    /// holds the whole edge or face of the parent around it, so that those corners determine it.
    fn block(&mut self, parent: &Node, siblings: &[NodeId; 8]) -> Result<u32, EncodeError> {
        let mut lattice: [Option<&Vertex>; 27] = [None; 27];
        for (child, &id) in siblings.iter().enumerate() {
            let node = self.octree.tree.node(id);
            for (corner, &id) in node.corners.iter().enumerate().filter(|_| node.is_leaf()) {
                let vertex = self.octree.corners.vertex(id);
                let at = lattice_index(child, corner);
                if corner == child || !vertex.hangs {
                    lattice[at] = Some(vertex);
                } else {
                    for around in parent_corners_around(at) {
                        lattice[lattice_index(around, around)] =
                            Some(self.octree.corners.vertex(parent.corners[around]));
                    }
                }
            }
        }
        let offset = self.samples.len();
        if lattice.iter().any(Option::is_some) {
            push_block(&mut self.samples, &self.octree.rounding, parent.level + 1, &lattice);
        }
        word(node::LEAF, offset)
    }

    /// Writes the block of a root cell that is a leaf, as its first octant, and gives the word of the leaf.
    fn root_block(&mut self, root: &Node) -> Result<u32, EncodeError> {
        let mut lattice = [None; 27];
        for (corner, &id) in root.corners.iter().enumerate() {
            lattice[lattice_index(0, corner)] = Some(self.octree.corners.vertex(id));
        }
        let offset = self.samples.len();
        push_block(&mut self.samples, &self.octree.rounding, 0, &lattice);
        word(node::LEAF, offset)
    }
}

/// The corners of a parent between which a vertex of its 3 x 3 x 3 lattice lies.
fn parent_corners_around(at: usize) -> impl Iterator<Item = usize> {
    let twice = lattice_offset(at);
    (0..8).filter(move |&corner| (twice.as_ivec3() - 2 * octant(corner).as_ivec3()).abs().max_element() <= 1)
}

fn word(tag: u32, offset: usize) -> Result<u32, EncodeError> {
    let offset = u32::try_from(offset).ok().filter(|&offset| offset <= node::OFFSET_MASK);
    Ok(tag << node::OFFSET_BITS | offset.ok_or(EncodeError::TooLarge)?)
}
