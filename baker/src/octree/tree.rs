//! The cells of an octree: an arena of nodes, and which leaves touch a vertex.

use super::domain::Domain;
use super::lattice::VertexId;
use glam::UVec3;

/// Index of a node in its tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u32);

/// A cell, leaf or not.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Smallest corner, lattice coordinates.
    pub origin: UVec3,
    /// Level below the root grid.
    pub level: u8,
    /// First of eight children, x fastest; none for a leaf.
    pub children: Option<NodeId>,
    /// The corners, x fastest.
    pub corners: [VertexId; 8],
}

impl Node {
    /// Whether the node is a leaf.
    pub fn is_leaf(&self) -> bool {
        self.children.is_none()
    }

    /// The eight corners of a cell of this edge at this origin, x fastest.
    pub fn corner_vertices(origin: UVec3, lattice_edge: u32) -> [UVec3; 8] {
        std::array::from_fn(|i| origin + lattice_edge * octant(i))
    }

    /// The vertices of the 3 x 3 x 3 lattice of a cell, x fastest.
    pub fn lattice_vertices(origin: UVec3, lattice_edge: u32) -> [UVec3; 27] {
        std::array::from_fn(|i| origin + lattice_edge / 2 * lattice_offset(i))
    }
}

/// Offsets of the octant, x fastest: bit 0 of the index is x.
pub fn octant(index: usize) -> UVec3 {
    let index = index as u32;
    UVec3::new(index & 1, index >> 1 & 1, index >> 2 & 1)
}

/// Offsets in a 3 x 3 x 3 lattice, x fastest.
pub fn lattice_offset(index: usize) -> UVec3 {
    let index = index as u32;
    UVec3::new(index % 3, index / 3 % 3, index / 9)
}

/// Index in the 3 x 3 x 3 lattice of a corner of a child.
pub fn lattice_index(child: usize, corner: usize) -> usize {
    let at = octant(child) + octant(corner);
    (at.x + 3 * at.y + 9 * at.z) as usize
}

/// A forest over a root grid.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The box that it covers.
    pub domain: Domain,
    nodes: Vec<Node>,
}

impl Tree {
    /// A tree of root cells only, given the corners of each (x fastest).
    pub fn new(domain: Domain, id: impl Fn(UVec3) -> VertexId) -> Self {
        let edge = domain.lattice_edge(0);
        let nodes = root_origins(&domain)
            .map(|origin| Node {
                origin,
                level: 0,
                children: None,
                corners: Node::corner_vertices(origin, edge).map(&id),
            })
            .collect();
        Self { domain, nodes }
    }

    /// The node with this identity.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// The children of a node; none for a leaf.
    pub fn children(&self, node: &Node) -> Option<[NodeId; 8]> {
        node.children.map(|NodeId(first)| std::array::from_fn(|i| NodeId(first + i as u32)))
    }

    /// The root cells, x fastest.
    pub fn roots(&self) -> impl Iterator<Item = NodeId> + use<> {
        (0..self.domain.root_cells.element_product()).map(NodeId)
    }

    /// Every node, each after its parent.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Edge of a node, mesh units.
    pub fn edge(&self, node: &Node) -> f64 {
        self.domain.edge(node.level)
    }

    /// Edge of a node, lattice units.
    pub fn lattice_edge(&self, node: &Node) -> u32 {
        self.domain.lattice_edge(node.level)
    }

    /// Splits a leaf, given the vertices of its 3 x 3 x 3 lattice, and names the first child.
    pub fn split(&mut self, leaf: NodeId, lattice: &[VertexId; 27]) -> NodeId {
        let parent = *self.node(leaf);
        let half = self.lattice_edge(&parent) / 2;
        let first = NodeId(u32::try_from(self.nodes.len()).expect("fewer than 2^32 nodes"));
        self.nodes.extend((0..8).map(|child| Node {
            origin: parent.origin + half * octant(child),
            level: parent.level + 1,
            children: None,
            corners: std::array::from_fn(|corner| lattice[lattice_index(child, corner)]),
        }));
        self.nodes[leaf.0 as usize].children = Some(first);
        first
    }

    /// The coarsest leaf whose closure holds a vertex; among equals, the one nearest the origin.
    pub fn coarsest_leaf_at(&self, vertex: UVec3) -> NodeId {
        self.leaves_at(vertex).min_by_key(|&leaf| self.node(leaf).level).expect("a vertex of the domain touches a leaf")
    }

    /// The leaves whose closure holds a vertex, one for each octant around it inside the domain.
    pub fn leaves_at(&self, vertex: UVec3) -> impl Iterator<Item = NodeId> {
        (0..8)
            .map(move |side| (vertex + octant(side)).wrapping_sub(UVec3::ONE))
            .filter(|cell| cell.cmplt(self.domain.lattice_size()).all())
            .map(|cell| self.leaf_containing(cell))
    }

    /// The leaf that holds a unit cell of the lattice.
    fn leaf_containing(&self, cell: UVec3) -> NodeId {
        let root = cell >> u32::from(self.domain.depth);
        let cells = self.domain.root_cells;
        let mut id = NodeId(root.x + cells.x * (root.y + cells.y * root.z));
        let mut shift = self.domain.depth;
        while let Some(NodeId(first)) = self.node(id).children {
            shift -= 1;
            let bit = (cell >> u32::from(shift)) & 1;
            id = NodeId(first + (bit.x | bit.y << 1 | bit.z << 2));
        }
        id
    }
}

/// Origins of the root cells, x fastest.
pub fn root_origins(domain: &Domain) -> impl Iterator<Item = UVec3> + Clone + use<> {
    let (cells, edge) = (domain.root_cells, domain.lattice_edge(0));
    (0..cells.z)
        .flat_map(move |z| (0..cells.y).flat_map(move |y| (0..cells.x).map(move |x| edge * UVec3::new(x, y, z))))
}
