//! Union–find with path halving, where the smaller number is the root, and members may be opposed.

pub(crate) struct DisjointSets {
    /// Twice the parent, plus one if the item is opposed to it.
    parent: Vec<u32>,
    pub(crate) count: usize,
}

impl DisjointSets {
    /// Sets of one item each, at most 2³¹.
    pub(crate) fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).map(|item| item << 1).collect(), count }
    }

    pub(crate) fn root(&mut self, item: u32) -> u32 {
        self.root_and_parity(item).0
    }

    /// The root of an item's set, and whether the item is opposed to it.
    pub(crate) fn root_and_parity(&mut self, mut item: u32) -> (u32, bool) {
        let mut opposed = 0;
        loop {
            let up = self.parent[item as usize];
            if up >> 1 == item {
                return (item, opposed == 1);
            }
            let grandparent = self.parent[(up >> 1) as usize] ^ (up & 1);
            self.parent[item as usize] = grandparent;
            opposed ^= grandparent & 1;
            item = grandparent >> 1;
        }
    }

    pub(crate) fn join(&mut self, a: u32, b: u32) {
        self.join_with(a, b, false);
    }

    /// Joins the sets of two items that are opposed, or not. Items of one set stay as they are.
    pub(crate) fn join_with(&mut self, a: u32, b: u32, are_opposed: bool) {
        let ((a, a_opposed), (b, b_opposed)) = (self.root_and_parity(a), self.root_and_parity(b));
        if a != b {
            let parity = u32::from(a_opposed ^ b_opposed ^ are_opposed);
            self.parent[a.max(b) as usize] = (a.min(b) << 1) | parity;
            self.count -= 1;
        }
    }
}
