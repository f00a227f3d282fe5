//! The shapes that the leaves of a file share.
//!
//! A leaf may be written in any shape of its kind, degrees and exponent that is at least as wide as its
//! codes. Each shape that is dropped saves nothing by itself, but half as many shapes save a bit a leaf.

use crate::quantize::piece::Coded;
use crate::sampling::cell::Kind;
use nearfield::layout::{kind, polynomial, shape};
use std::collections::BTreeMap;

/// A shape as in the file.
pub(super) type Shape = [u8; shape::LENGTH];

/// The shapes of a file, in its order.
pub(super) struct Shapes {
    pub(super) all: Vec<Shape>,
    /// Bits of the number of a shape.
    pub(super) bits: u32,
    chosen: BTreeMap<Shape, usize>,
}

impl Shapes {
    /// Chooses the shapes that make the leaves least, in all.
    pub(super) fn choose<'a>(leaves: impl Iterator<Item = &'a Coded>, longest: u32) -> Self {
        let mut counts: BTreeMap<Shape, Group> = BTreeMap::new();
        for leaf in leaves {
            let group = counts.entry(narrowest(leaf)).or_insert(Group { leaves: 0, terms: terms(leaf) });
            group.leaves += 1;
        }
        let groups: Vec<(Shape, Group)> = counts.into_iter().collect();
        let table = Table::new(&groups, longest);
        table.shrink()
    }

    /// The number of the shape in which a leaf is written, and its widths.
    pub(super) fn of(&self, leaf: &Coded) -> (usize, [u8; 4]) {
        let number = self.chosen[&narrowest(leaf)];
        (number, widths(&self.all[number]))
    }
}

/// Leaves of one shape.
#[derive(Clone, Copy)]
struct Group {
    leaves: u32,
    /// Coefficients of each degree.
    terms: [u32; 4],
}

/// Shapes on their way to fewer.
struct Table<'a> {
    groups: &'a [(Shape, Group)],
    longest: u32,
    /// For each group, the shape that its leaves use now: the index of another group whose shape is kept.
    uses: Vec<usize>,
}

impl<'a> Table<'a> {
    fn new(groups: &'a [(Shape, Group)], longest: u32) -> Self {
        Self { groups, longest, uses: (0..groups.len()).collect() }
    }

    /// Drops the shape that costs least, again and again, and goes back to where the sum was least.
    fn shrink(mut self) -> Shapes {
        let mut kept: Vec<usize> = (0..self.groups.len()).collect();
        let leaves: u64 = self.groups.iter().map(|(_, group)| u64::from(group.leaves)).sum();
        let mut best: Option<(u64, Vec<usize>)> = None;
        let mut widening = 0;
        let mut costs: Vec<Option<(u64, usize)>> =
            kept.iter().map(|&shape| self.cost_of_dropping(shape, &kept)).collect();
        loop {
            let bits = bits_for(kept.len());
            if bits <= u32::from(polynomial::MAX_SHAPE_BITS) {
                let total = widening + leaves * u64::from(bits) + 64 * kept.len() as u64;
                if best.as_ref().is_none_or(|(least, _)| total < *least) {
                    best = Some((total, self.uses.clone()));
                }
            }
            let cheapest = kept.iter().filter_map(|&shape| costs[shape].map(|(cost, into)| (cost, shape, into))).min();
            let Some((cost, dropped, into)) = cheapest else {
                break;
            };
            widening += cost;
            kept.retain(|&shape| shape != dropped);
            self.uses.iter_mut().filter(|shape| **shape == dropped).for_each(|shape| *shape = into);
            for &shape in &kept {
                if shape == into || costs[shape].is_some_and(|(_, target)| target == dropped) {
                    costs[shape] = self.cost_of_dropping(shape, &kept);
                }
            }
        }
        let (_, uses) = best.expect("some table fits, for wide shapes hold all others of their kind");
        self.uses = uses;
        self.finish()
    }

    fn finish(self) -> Shapes {
        let mut all: Vec<Shape> = self.uses.iter().map(|&shape| self.groups[shape].0).collect();
        all.sort_unstable();
        all.dedup();
        let chosen = self.groups.iter().zip(&self.uses).map(|((shape, _), &used)| {
            let number = all.binary_search(&self.groups[used].0).expect("it is among them");
            (*shape, number)
        });
        Shapes { chosen: chosen.collect(), bits: bits_for(all.len()), all }
    }

    /// Bits that the leaves of a shape would take more in the best other one, and that one.
    fn cost_of_dropping(&self, dropped: usize, kept: &[usize]) -> Option<(u64, usize)> {
        let users: Vec<usize> = (0..self.groups.len()).filter(|&group| self.uses[group] == dropped).collect();
        let (from, _) = self.groups[dropped];
        kept.iter()
            .filter(|&&into| into != dropped && holds(&self.groups[into].0, &from))
            .filter_map(|&into| {
                let wide = widths(&self.groups[into].0);
                let mut cost = 0;
                for &user in &users {
                    let (_, group) = &self.groups[user];
                    let bits = |widths: [u8; 4]| -> u32 { (0..4).map(|d| u32::from(widths[d]) * group.terms[d]).sum() };
                    if bits(wide) > self.longest {
                        return None;
                    }
                    cost += u64::from(bits(wide) - bits(widths(&from))) * u64::from(group.leaves);
                }
                Some((cost, into))
            })
            .min()
    }
}

/// Bits that tell so many shapes apart, at least one.
fn bits_for(shapes: usize) -> u32 {
    (usize::BITS - shapes.saturating_sub(1).leading_zeros()).max(1)
}

/// Whether leaves of one shape may be written in another.
fn holds(wide: &Shape, narrow: &Shape) -> bool {
    let (head, wide_widths) = wide.split_at(shape::WIDTHS.start);
    let (narrow_head, narrow_widths) = narrow.split_at(shape::WIDTHS.start);
    head == narrow_head && wide_widths.iter().zip(narrow_widths).all(|(wide, narrow)| wide >= narrow)
}

fn widths(shape: &Shape) -> [u8; 4] {
    std::array::from_fn(|degree| shape[shape::WIDTHS.start + degree])
}

/// Coefficients of each degree in a leaf.
fn terms(leaf: &Coded) -> [u32; 4] {
    let mut terms = [0; 4];
    for (degree, _) in leaf.stored() {
        terms[usize::from(degree)] += 1;
    }
    terms
}

/// The shape whose codes are as wide as those of a leaf.
fn narrowest(leaf: &Coded) -> Shape {
    let mut bytes = [0; shape::LENGTH];
    bytes[shape::KIND] = match leaf.kind {
        Kind::Single => kind::SINGLE,
        Kind::Min => kind::MIN,
        Kind::Max => kind::MAX,
    };
    bytes[shape::DEGREES].copy_from_slice(&leaf.degrees);
    bytes[shape::EXPONENT] = leaf.exponent;
    bytes[shape::WIDTHS].copy_from_slice(&leaf.widths);
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::cell::basis::TERMS;

    fn leaf(widths: [u8; 4]) -> Coded {
        let degrees = [if widths[1] > 0 { 1 } else { 0 }, 0];
        Coded { kind: Kind::Single, degrees, exponent: 3, codes: [[0; TERMS]; 2], widths }
    }

    #[test]
    fn rare_shapes_give_way_to_wider_ones_that_are_common() {
        let leaves: Vec<Coded> = std::iter::repeat_n(leaf([10, 5, 0, 0]), 1000)
            .chain([leaf([9, 5, 0, 0]), leaf([8, 4, 0, 0])])
            .chain(std::iter::repeat_n(leaf([7, 0, 0, 0]), 1000))
            .collect();
        let shapes = Shapes::choose(leaves.iter(), 200);
        assert_eq!((shapes.all.len(), shapes.bits), (2, 1));
        for leaf in &leaves {
            let (number, widths) = shapes.of(leaf);
            assert!(holds(&shapes.all[number], &narrowest(leaf)), "{widths:?} for {:?}", leaf.widths);
        }
        assert!(shapes.all.is_sorted(), "the format wants them in order");
    }

    #[test]
    fn no_leaf_grows_beyond_the_longest() {
        let leaves = [leaf([24, 8, 0, 0]), leaf([8, 8, 0, 0]), leaf([8, 8, 0, 0])];
        let shapes = Shapes::choose(leaves.iter(), 40);
        assert_eq!(shapes.of(&leaves[1]).1, [8, 8, 0, 0]);
    }
}
