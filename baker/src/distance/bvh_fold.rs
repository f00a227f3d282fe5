//! Folds a binary tree into nodes of up to eight children, at the least expected cost of a search
//! (Ylitie, Karras and Laine 2017, "Efficient incoherent ray traversal on GPUs through compressed
//! wide BVHs", section 3.1).
//!
//! For every subtree and every k up to eight the cheapest *forest* of at most k roots is known: one
//! root for all of it, or a forest for each half.

use super::bvh::{Child, LANES};
use super::local_mesh::Bounds;
use std::ops::Range;

/// Cost of a visit to a node where a visit to a packet costs 1.
const NODE_COST: f32 = 0.6;

/// A binary tree; its leaves are ranges of the builder's triangles.
pub(super) struct Tree {
    pub(super) bounds: Bounds,
    /// Its triangles, in the builder's order.
    pub(super) range: Range<usize>,
    /// `forests[k]` has at most `k + 1` roots.
    forests: [Forest; LANES],
    content: Content,
}

enum Content {
    Leaf,
    /// The halves, and the roots that each gets in the node that holds both.
    Halves(Box<[Tree; 2]>, [u8; 2]),
}

#[derive(Clone, Copy)]
struct Forest {
    cost: f32,
    /// Roots in each half; none for one root above both.
    roots: [u8; 2],
}

impl Tree {
    pub(super) fn leaf(bounds: Bounds, range: Range<usize>) -> Self {
        let whole = Forest { cost: bounds.half_area(), roots: [0; 2] };
        Self { bounds, range, forests: [whole; LANES], content: Content::Leaf }
    }

    pub(super) fn inner(bounds: Bounds, left: Self, right: Self) -> Self {
        // The cheapest way to share out exactly `count` roots, two at least.
        let share = |count: usize| {
            let shares = (1..count).map(|first| Forest {
                cost: left.forests[first - 1].cost + right.forests[count - first - 1].cost,
                roots: [first as u8, (count - first) as u8],
            });
            shares.reduce(cheaper).expect("two roots have one share")
        };

        let node = share(LANES);
        let whole = Forest { cost: bounds.half_area() * NODE_COST + node.cost, roots: [0; 2] };
        let mut forests = [whole; LANES];
        for count in 2..=LANES {
            forests[count - 1] = cheaper(forests[count - 2], share(count));
        }
        let range = left.range.start..right.range.end;
        let content = Content::Halves(Box::new([left, right]), node.roots);
        Self { bounds, range, forests, content }
    }

    /// Adds the roots of the forest of at most `count` roots.
    fn collect<'a>(&'a self, count: u8, roots: &mut Vec<&'a Self>) {
        match (&self.content, self.forests[count as usize - 1].roots) {
            (Content::Leaf, _) | (_, [0, 0]) => roots.push(self),
            (Content::Halves(halves, _), [first, second]) => {
                halves[0].collect(first, roots);
                halves[1].collect(second, roots);
            }
        }
    }
}

fn cheaper(a: Forest, b: Forest) -> Forest {
    if b.cost < a.cost { b } else { a }
}

/// The folded tree.
#[derive(Default)]
pub(super) struct Layout<'a> {
    /// Children of each node: the root first, children after their parents.
    pub(super) nodes: Vec<Vec<(&'a Tree, Child)>>,
    /// Triangles of each packet, in the builder's order.
    pub(super) packets: Vec<Range<usize>>,
}

impl<'a> Layout<'a> {
    pub(super) fn of(tree: &'a Tree) -> Self {
        let mut layout = Self::default();
        layout.add_node(tree);
        layout
    }

    fn add_node(&mut self, tree: &'a Tree) -> Child {
        let mut roots = Vec::with_capacity(LANES);
        match &tree.content {
            Content::Leaf => roots.push(tree),
            Content::Halves(halves, [first, second]) => {
                halves[0].collect(*first, &mut roots);
                halves[1].collect(*second, &mut roots);
            }
        }
        let index = self.nodes.len();
        self.nodes.push(Vec::new());
        self.nodes[index] = roots.into_iter().map(|root| (root, self.add(root))).collect();
        Child::Node(index)
    }

    fn add(&mut self, tree: &'a Tree) -> Child {
        match tree.content {
            Content::Halves(..) => self.add_node(tree),
            Content::Leaf => {
                self.packets.push(tree.range.clone());
                Child::Packet(self.packets.len() - 1)
            }
        }
    }
}
