//! What a leaf's corners hold once continuity has had its say (Pujol and Chica 2023, section 6).
//!
//! A vertex *hangs* where it lies on a face or an edge of a leaf without being one of that leaf's
//! corners. There the finer leaves must repeat what the coarser one interpolates: for tricubic leaves
//! all eight derivatives (the paper's appendix), for trilinear ones the value. Every other vertex
//! holds the sample taken there.

use super::interpolant::Patch;
use super::lattice::{Lattice, VertexId};
use super::tree::{Node, NodeId, Tree};
use crate::corner::Corner;
use crate::quantize::rounding::Rounding;
use crate::settings::{Continuity, Settings};
use glam::UVec3;
use rayon::prelude::*;

/// A vertex that is the corner of some leaf.
#[derive(Clone, Copy, Debug)]
pub struct Vertex {
    /// The derivatives: rounded where they are a sample, as interpolated where the vertex hangs.
    pub corner: Corner,
    /// Whether a coarser leaf decides the derivatives.
    pub hangs: bool,
}

/// The settled vertices of a tree.
pub struct Corners {
    continuity: Continuity,
    rounding: Rounding,
    /// Position in `vertices` by vertex, or [`UNSETTLED`].
    position: Vec<u32>,
    vertices: Vec<Vertex>,
}

const UNSETTLED: u32 = u32::MAX;

impl Corners {
    /// No vertex is settled yet.
    pub fn new(settings: &Settings, rounding: Rounding) -> Self {
        Self { continuity: settings.continuity, rounding, position: Vec::new(), vertices: Vec::new() }
    }

    /// A settled vertex.
    pub fn vertex(&self, id: VertexId) -> &Vertex {
        &self.vertices[self.position[id.index()] as usize]
    }

    /// Whether a vertex has been settled.
    pub fn is_settled(&self, id: VertexId) -> bool {
        self.position.get(id.index()).is_some_and(|&position| position != UNSETTLED)
    }

    /// The interpolant of a node whose corners are settled.
    pub fn patch(&self, tree: &Tree, node: &Node) -> Patch {
        Patch::new(self.rounding.interpolant(), &node.corners.map(|id| self.vertex(id).corner), tree.edge(node))
    }

    /// Settles vertices whose coarsest leaf, among those that have them as a corner, is of this
    /// level. Vertices on coarser leaves must be settled before.
    pub fn settle(&mut self, tree: &Tree, lattice: &Lattice, ids: &[VertexId], level: u8) {
        let settled: Vec<Vertex> = ids.par_iter().map(|&id| self.settled(tree, lattice, id, level)).collect();
        self.position.resize(lattice.sample_count(), UNSETTLED);
        for (&id, vertex) in ids.iter().zip(settled) {
            match self.position[id.index()] {
                UNSETTLED => {
                    self.position[id.index()] = self.vertices.len() as u32;
                    self.vertices.push(vertex);
                }
                position => self.vertices[position as usize] = vertex,
            }
        }
    }

    fn settled(&self, tree: &Tree, lattice: &Lattice, id: VertexId, level: u8) -> Vertex {
        match self.hangs_on(tree, lattice.vertex(id)) {
            Some(leaf) => Vertex { corner: self.derivatives_at(tree, leaf, lattice.vertex(id)), hangs: true },
            None => Vertex { corner: self.rounding.sample(lattice.sample(id), level), hangs: false },
        }
    }

    /// The coarsest leaf around a vertex, where the vertex hangs on it. Where it is a corner of the
    /// coarsest, it is a corner of all; where it hangs on several, they agree there.
    fn hangs_on(&self, tree: &Tree, vertex: UVec3) -> Option<NodeId> {
        if self.continuity == Continuity::None {
            return None;
        }
        let coarsest = tree.coarsest_leaf_at(vertex);
        let node = tree.node(coarsest);
        let misaligned = (vertex - node.origin) % tree.lattice_edge(node) != UVec3::ZERO;
        misaligned.then_some(coarsest)
    }

    /// What a leaf interpolates at a vertex of its closure.
    fn derivatives_at(&self, tree: &Tree, leaf: NodeId, vertex: UVec3) -> Corner {
        let node = tree.node(leaf);
        let local = (vertex - node.origin).as_dvec3() / f64::from(tree.lattice_edge(node));
        self.patch(tree, node).derivatives(local)
    }

    /// The coarsest leaf on which a vertex hangs, where it misses the sample there by more than the tolerance.
    pub fn leaf_in_the_way(&self, tree: &Tree, lattice: &Lattice, id: VertexId, tolerance: f64) -> Option<NodeId> {
        let vertex = lattice.vertex(id);
        let leaf = self.hangs_on(tree, vertex)?;
        let found = self.derivatives_at(tree, leaf, vertex).distance();
        ((found - lattice.sample(id).distance).abs() > tolerance).then_some(leaf)
    }
}
