//! A field function to an octree of interpolants (Pujol and Chica 2023).

pub mod corners;
pub mod domain;
pub mod interpolant;
pub mod lattice;
pub mod refine;
pub mod termination;
pub mod tree;

use crate::field_function::FieldFunction;
use crate::geometry::Aabb;
use crate::progress::Progress;
use crate::quantize::rounding::Rounding;
use crate::settings::{Continuity, Interpolant, Settings};
use corners::Corners;
use domain::Domain;
use lattice::VertexId;
use rayon::prelude::*;
use refine::{Refined, refine};
use termination::Criterion;
use tree::{Node, Tree};

/// A refined tree whose corners are settled and rounded: all that the file will say of the field.
pub struct Octree {
    /// The cells.
    pub tree: Tree,
    /// What the leaves' corners hold.
    pub corners: Corners,
    /// What holds across levels.
    pub continuity: Continuity,
    /// How distances and derivatives were rounded.
    pub rounding: Rounding,
    /// Upper bound of the gradient's length inside the domain.
    pub lipschitz: f64,
    /// Points at which the function was sampled.
    pub samples: usize,
}

impl Octree {
    /// Builds the octree of a function around a box, to a target error in mesh units.
    pub fn build(
        function: &dyn FieldFunction,
        bounds: &Aabb,
        settings: &Settings,
        target: f64,
        progress: &dyn Progress,
    ) -> Self {
        let domain = Domain::around(bounds, settings);
        let rounding = Rounding::new(settings, domain.root_edge);
        let criterion = Criterion::new(settings, target, bounds.diagonal());
        let Refined { tree, lattice } = refine(function, domain, settings, rounding, criterion, progress);

        // Refinement settled each corner by the tree of its time; the finished tree has the last word.
        let mut corners = Corners::new(settings, rounding);
        for level in 0..=domain.depth {
            let mut ids: Vec<VertexId> = leaves(&tree)
                .filter(|leaf| leaf.level == level)
                .flat_map_iter(|leaf| leaf.corners)
                .filter(|&id| !corners.is_settled(id))
                .collect();
            ids.par_sort_unstable();
            ids.dedup();
            corners.settle(&tree, &lattice, &ids, level);
        }

        let lipschitz = leaves(&tree).map(|leaf| corners.patch(&tree, leaf).slope_bound()).reduce(|| 0.0, f64::max);
        Self { tree, corners, continuity: delivered(settings), rounding, lipschitz, samples: lattice.sample_count() }
    }

    /// Leaves of each level below the root grid.
    pub fn leaves_by_level(&self) -> Vec<usize> {
        let mut leaves = vec![0; usize::from(self.tree.domain.depth) + 1];
        for node in self.tree.nodes().iter().filter(|node| node.is_leaf()) {
            leaves[usize::from(node.level)] += 1;
        }
        leaves
    }
}

/// Tricubic leaves that repeat a coarser one's values repeat its gradients too.
fn delivered(settings: &Settings) -> Continuity {
    match (settings.continuity, settings.interpolant) {
        (Continuity::C0, Interpolant::Tricubic) => Continuity::C1,
        (continuity, _) => continuity,
    }
}

fn leaves(tree: &Tree) -> impl ParallelIterator<Item = &Node> {
    tree.nodes().par_iter().filter(|node| node.is_leaf())
}

#[cfg(test)]
mod tests;
