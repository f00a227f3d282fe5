//! Refinement to a target error, breadth first (Pujol and Chica 2023, sections 3, 5 and 6).

use super::corners::Corners;
use super::domain::Domain;
use super::lattice::{Lattice, VertexId};
use super::termination::{Criterion, PointError};
use super::tree::{Node, NodeId, Tree, root_origins};
use crate::field_function::FieldFunction;
use crate::progress::Progress;
use crate::quantize::rounding::Rounding;
use crate::settings::{Continuity, Settings};
use rayon::prelude::*;

/// A refined tree with its samples.
pub struct Refined<'a> {
    /// The cells.
    pub tree: Tree,
    /// The samples at their corners, and where the error was estimated.
    pub lattice: Lattice<'a>,
}

/// Splits cells until each leaf is good enough by its estimated error, or the depth ends.
pub fn refine<'a>(
    function: &'a dyn FieldFunction,
    domain: Domain,
    settings: &Settings,
    rounding: Rounding,
    criterion: Criterion,
    progress: &dyn Progress,
) -> Refined<'a> {
    let mut refinement = Refinement::start(function, domain, settings, rounding, criterion, progress);
    let mut undecided: Vec<NodeId> = refinement.tree.roots().collect();
    for level in 0..domain.depth {
        let failing = refinement.failing(&undecided);
        undecided = refinement.split(&failing);
        if settings.continuity != Continuity::None {
            refinement.split_leaves_in_the_way(&failing, level);
        }
    }
    Refined { tree: refinement.tree, lattice: refinement.lattice }
}

struct Refinement<'a, 'p> {
    tree: Tree,
    lattice: Lattice<'a>,
    corners: Corners,
    criterion: Criterion,
    progress: &'p dyn Progress,
}

impl<'a, 'p> Refinement<'a, 'p> {
    fn start(
        function: &'a dyn FieldFunction,
        domain: Domain,
        settings: &Settings,
        rounding: Rounding,
        criterion: Criterion,
        progress: &'p dyn Progress,
    ) -> Self {
        let mut lattice = Lattice::new(function, domain, rounding);
        let edge = domain.lattice_edge(0);
        let origins: Vec<_> = root_origins(&domain).collect();
        lattice.evaluate(origins.par_iter().flat_map_iter(|&origin| Node::corner_vertices(origin, edge)), progress);

        let tree = Tree::new(domain, |vertex| lattice.id(vertex));
        let mut corners = Corners::new(settings, rounding);
        let mut roots: Vec<VertexId> = tree.nodes().iter().flat_map(|root| root.corners).collect();
        roots.sort_unstable();
        roots.dedup();
        corners.settle(&tree, &lattice, &roots, 0);
        Self { tree, lattice, corners, criterion, progress }
    }

    /// The nodes that are not good enough, in the same order.
    fn failing(&mut self, nodes: &[NodeId]) -> Vec<NodeId> {
        self.evaluate_lattices(nodes);
        nodes.par_iter().copied().filter(|&id| !self.criterion.is_met(&self.errors(id))).collect()
    }

    /// Samples the 3 x 3 x 3 lattices of nodes: what the error estimate needs, and the children's corners.
    fn evaluate_lattices(&mut self, nodes: &[NodeId]) {
        let tree = &self.tree;
        let vertices = nodes.par_iter().flat_map_iter(|&id| lattice_vertices(tree, id));
        self.lattice.evaluate(vertices, self.progress);
    }

    /// The errors of a node on its 3 x 3 x 3 lattice.
    fn errors(&self, id: NodeId) -> [PointError; 27] {
        let values = self.corners.patch(&self.tree, self.tree.node(id)).lattice_values();
        let vertices = lattice_vertices(&self.tree, id);
        std::array::from_fn(|i| {
            let distance = self.lattice.sample(self.lattice.id(vertices[i])).distance;
            PointError { error: values[i] - distance, distance }
        })
    }

    /// Splits leaves whose lattices are sampled, in order, and names the children.
    fn split(&mut self, leaves: &[NodeId]) -> Vec<NodeId> {
        let lattices: Vec<[VertexId; 27]> = leaves
            .par_iter()
            .map(|&id| lattice_vertices(&self.tree, id).map(|vertex| self.lattice.id(vertex)))
            .collect();
        let mut children = Vec::with_capacity(8 * leaves.len());
        for (&leaf, lattice) in leaves.iter().zip(&lattices) {
            let NodeId(first) = self.tree.split(leaf, lattice);
            children.extend((first..first + 8).map(NodeId));
        }
        self.settle_children(leaves);
        children
    }

    /// Section 6: where a corner of the children of `parents` hangs on a coarser leaf that misses the
    /// sample there, that leaf is split too, whatever its own error, until it no longer is in the way.
    fn split_leaves_in_the_way(&mut self, parents: &[NodeId], level: u8) {
        let mut hanging: Vec<VertexId> = parents.par_iter().flat_map_iter(|&id| self.child_corners(id)).collect();
        hanging.par_sort_unstable();
        hanging.dedup();

        loop {
            let in_the_way: Vec<(VertexId, NodeId)> =
                hanging.par_iter().filter_map(|&id| Some((id, self.leaf_in_the_way(id)?))).collect();
            let mut leaves: Vec<NodeId> = in_the_way.iter().map(|&(_, leaf)| leaf).collect();
            leaves.par_sort_unstable();
            leaves.dedup();
            if leaves.is_empty() {
                break;
            }
            debug_assert!(leaves.iter().all(|&leaf| self.tree.node(leaf).level <= level), "a leaf is in its own way");
            self.evaluate_lattices(&leaves);
            self.split(&leaves);
            hanging = in_the_way.into_iter().map(|(id, _)| id).collect();
        }
    }

    /// The leaf on which a vertex hangs, where that misses the sample by more than may be.
    fn leaf_in_the_way(&self, id: VertexId) -> Option<NodeId> {
        let tolerance = self.criterion.tolerance(self.lattice.sample(id).distance);
        self.corners.leaf_in_the_way(&self.tree, &self.lattice, id, tolerance)
    }

    /// Settles the corners that freshly split nodes have given their children, coarse levels first,
    /// since fine ones may hang on them. What hung on a split node may do so no longer.
    fn settle_children(&mut self, parents: &[NodeId]) {
        let mut parents = parents.to_vec();
        parents.par_sort_by_key(|&id| self.tree.node(id).level);
        for parents in parents.chunk_by(|&a, &b| self.tree.node(a).level == self.tree.node(b).level) {
            let mut ids: Vec<VertexId> = parents
                .par_iter()
                .flat_map_iter(|&id| {
                    let own = self.tree.node(id).corners;
                    self.child_corners(id).filter(move |id| !own.contains(id))
                })
                .collect();
            ids.par_sort_unstable();
            ids.dedup();
            self.corners.settle(&self.tree, &self.lattice, &ids, self.tree.node(parents[0]).level + 1);
        }
    }

    fn child_corners(&self, parent: NodeId) -> impl Iterator<Item = VertexId> {
        let children = self.tree.children(self.tree.node(parent));
        children.into_iter().flatten().flat_map(|child| self.tree.node(child).corners)
    }
}

fn lattice_vertices(tree: &Tree, id: NodeId) -> [glam::UVec3; 27] {
    let node = tree.node(id);
    Node::lattice_vertices(node.origin, tree.lattice_edge(node))
}
