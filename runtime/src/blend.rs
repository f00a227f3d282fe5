//! Leaves that overlap: a partition of unity (SPEC.md §12.6, §12.7).
//!
//! Every leaf has a weight that falls smoothly to 0 at the edge of its support. What is there to answer is the mean of the
//! leaves by their weights, so it is as continuous as the weights are (Babuška and Melenk 1997).

use crate::lattice::{Leaf, Position};
use crate::layout::leaf;
use crate::legendre::{self, Lanes};
use crate::math;
use crate::polynomial_leaf::{Answer, Bits, OverlapCodes, Question, Workspace};
use crate::polynomial_octree::{Node, Path, Place, PolynomialOctree};
use crate::region::Region;

/// Sums over leaves.
#[derive(Clone, Copy, Default)]
struct Sums {
    weight: f32,
    /// Of the values by the weights. They are differences to that of the leaf that holds the point, which loses less to
    /// rounding.
    value: f32,
    weight_slope: Lanes,
    /// Of the gradients by the weights, and of the values by the slopes of the weights.
    slope: Lanes,
}

/// How fast the weight of a leaf falls along an axis: half the leaf's edge over twice the distance by which it reaches
/// beyond its cell.
pub(crate) type Steepness = f32;

/// The smooth step of an axis at a local coordinate, and its derivative.
#[inline]
pub(crate) fn step(local: f32, steepness: Steepness) -> (f32, f32) {
    let inside = 0.5 + (1.0 - local.abs()) * steepness;
    let inside = if inside > 0.0 { inside } else { 0.0 };
    let inside = if inside < 1.0 { inside } else { 1.0 };
    let slope = (6.0 * inside * (1.0 - inside)) * (-steepness).copysign(-local);
    ((inside * inside) * (3.0 - 2.0 * inside), slope)
}

impl Sums {
    /// Adds a leaf that answers a question with a value, and a gradient if asked for.
    #[inline]
    fn add(&mut self, question: &Question, steepness: Steepness, value: f32, gradient: &Lanes) {
        if question.with_gradient {
            self.add_slopes(&question.local, steepness, question.per_half, value, gradient);
        } else {
            self.add_value(&question.local, steepness, value);
        }
    }

    #[inline(never)]
    fn add_value(&mut self, &[x, y, z, _]: &Lanes, steepness: Steepness, value: f32) {
        let yz = step(y, steepness).0 * step(z, steepness).0;
        let weight = step(x, steepness).0 * yz;
        self.weight += weight;
        self.value += weight * value;
    }

    #[inline(never)]
    fn add_slopes(&mut self, local: &Lanes, steepness: Steepness, per_half: f32, value: f32, gradient: &Lanes) {
        let (mut steps, mut slopes) = ([0.0; 4], [0.0; 4]);
        for lane in 0..4 {
            (steps[lane], slopes[lane]) = step(local[lane], steepness);
        }
        let (next, previous) = (legendre::moved_back(steps), legendre::moved_on(steps));
        let weight = steps[0] * (steps[1] * steps[2]);
        self.weight += weight;
        self.value += weight * value;
        for lane in 0..4 {
            let slope = (slopes[lane] * (next[lane] * previous[lane])) * per_half;
            self.weight_slope[lane] += slope;
            self.slope[lane] += weight * gradient[lane] + slope * value;
        }
    }

    /// Makes the answer of the leaf that holds the point the mean by weight.
    #[inline(never)]
    fn add_mean_to(&self, answer: &mut Answer) {
        let per_weight = 1.0 / self.weight;
        let change = self.value * per_weight;
        answer.value += change;
        for lane in 0..4 {
            answer.gradient[lane] = (self.slope[lane] - change * self.weight_slope[lane]) * per_weight;
        }
    }
}

/// A leaf near a place: where it is, its edge as a power of two of finest cells, and one of those that it holds.
#[derive(Default)]
pub(crate) struct Other {
    pub(crate) leaf: u32,
    pub(crate) shift: u32,
    pub(crate) cell: [u32; 4],
}

/// A place near a face of its leaf, what that leaf answers there, and the sums over it and others.
struct Blend<'b> {
    place: &'b Place,
    /// How the leaf of the place is overlapped, what it is asked and what it answers.
    codes: OverlapCodes,
    question: &'b Question,
    own: &'b Answer,
    /// Nothing until another leaf has a say.
    sums: Sums,
    workspace: &'b mut Workspace,
}

/// What is beyond the faces of a leaf near a position, along each axis.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sides {
    /// 1 if a neighbour beyond the nearer face may have a say.
    near: [u32; 4],
    /// The cell beyond the nearer face.
    cell: [u32; 4],
}

impl Sides {
    /// Axes along which a face is near, a bit for each.
    #[inline]
    pub(crate) fn near(&self) -> u32 {
        let [x, y, z, _] = self.near;
        x | y << 1 | z << 2
    }
}

/// For each set of axes, all bits of the lanes that it has. The last lane is not of use.
static CROSSED: [[u32; 4]; 8] = {
    const ALL: u32 = u32::MAX;
    let (none, x, y, xy) = ([0, 0], [ALL, 0], [0, ALL], [ALL, ALL]);
    let mut sets = [[0; 4]; 8];
    let mut set = 0;
    while set < 8 {
        let [x, y] = [none, x, y, xy][set & 3];
        let z = if set >= 4 { ALL } else { 0 };
        sets[set] = [x, y, z, z];
        set += 1;
    }
    sets
};

/// The subsets of each set of axes, a bit for each.
const SUBSETS: [u32; 8] = [0x01, 0x03, 0x05, 0x0F, 0x11, 0x33, 0x55, 0xFF];

impl PolynomialOctree<'_> {
    /// Makes the answer of the leaf of a place, near a face of it, the mean of all leaves that have a say there.
    #[inline(never)]
    pub(crate) fn blend(
        &self,
        place: &Place,
        codes: OverlapCodes,
        question: &Question,
        sides: &mut Sides,
        workspace: &mut Workspace,
        answer: &mut Answer,
    ) {
        let mut blend = Blend { place, codes, question, own: answer, sums: Sums::default(), workspace };
        if codes.reach == 0 || !self.add_beside(&mut blend, sides) {
            self.add_around(&mut blend);
        }
        let sums = blend.sums;
        if sums.weight > 0.0 {
            sums.add_mean_to(answer);
        }
    }

    /// Adds the leaf beyond each near face, edge and corner: each set of axes with a face of the own leaf. Where a leaf
    /// beyond is finer, a face between it and another may be near along one more axis.
    ///
    /// No leaf is missed, because one that has a say touches the own leaf and all that it reaches into. But of the
    /// faces along an axis only one is known; false if there are two, or if leaves are so small that there may be more of
    /// them than directions.
    #[inline]
    fn add_beside(&self, blend: &mut Blend<'_>, sides: &mut Sides) -> bool {
        let place = blend.place;
        // Axes along which a face of the own leaf is near, and those along which one between two leaves beyond is too.
        let faces = sides.near();
        let mut axes = faces;
        let mut seen = [place.leaf; 8];
        let mut done = SUBSETS[!faces as usize & 7];
        loop {
            let pending = SUBSETS[axes as usize & 7] & !done;
            if pending == 0 {
                return true;
            }
            let crossed = pending.trailing_zeros();
            done |= 1 << crossed;

            let mut other = Other::default();
            self.leaf_beside(place, crossed, &sides.cell, &mut other);
            // Beyond faces of the own leaf alone, only a greater one can be met twice.
            let may_be_seen = other.shift > place.shift || axes != faces;
            if may_be_seen && seen.contains(&other.leaf) {
                continue;
            }
            seen[crossed as usize & 7] = other.leaf;

            if other.shift < place.shift && !self.widen(&mut axes, sides, place, &other, crossed) {
                return false;
            }
            self.add(blend, &other);
        }
    }

    /// Adds the near faces between a leaf, finer than that of the place, and others of its side. False if they are not known
    /// by one cell along each axis.
    #[inline(never)]
    fn widen(&self, axes: &mut u32, sides: &mut Sides, place: &Place, other: &Other, crossed: u32) -> bool {
        let codes = Bits::at(self, other.leaf).overlap_codes(self);
        let mut its_sides = Sides::default();
        self.look(&other.cell, other.shift, codes, &place.position, &mut Lanes::default(), &mut its_sides);
        let near = its_sides.near() & !crossed;
        let mut is_known = codes.reach != 0;
        for axis in 0..3 {
            let cell = its_sides.cell[axis];
            let is_within = (cell ^ place.cell[axis]) >> place.shift == 0;
            if near >> axis & 1 == 1 && is_within {
                is_known &= *axes >> axis & 1 == 0 || sides.cell[axis] == cell;
                *axes |= 1 << axis;
                sides.cell[axis] = cell;
            }
        }
        is_known
    }

    /// The same where leaves are so small that there may be more of them than directions.
    #[cold]
    #[inline(never)]
    fn add_around(&self, blend: &mut Blend<'_>) {
        let place = blend.place;
        blend.sums = Sums::default();
        for Leaf { cell: [x, y, z], edge, place: leaf, .. } in self.around(place, blend.codes.reach) {
            if leaf != place.leaf {
                self.add(blend, &Other { leaf, shift: edge.trailing_zeros(), cell: [x, y, z, 0] });
            }
        }
    }

    /// From the leaf that holds a cell: where in it a position is, and what is beyond its sides.
    #[inline]
    pub(crate) fn look(
        &self,
        cell: &[u32; 4],
        shift: u32,
        codes: OverlapCodes,
        position: &Position,
        local: &mut Lanes,
        sides: &mut Sides,
    ) {
        look(cell, shift, self.alone_within(codes.reach), &self.lattice.extent, position, local, sides);
    }

    /// The leaf beyond faces along a set of axes, from the node that holds that and a place. `beyond` is the cell beyond all
    /// three.
    #[inline(never)]
    pub(crate) fn leaf_beside(&self, place: &Place, crossed: u32, beyond: &[u32; 4], other: &mut Other) {
        let crossed = &CROSSED[crossed as usize & 7];
        let mut different = [0; 4];
        for lane in 0..4 {
            different[lane] = (beyond[lane] ^ place.cell[lane]) & crossed[lane];
            other.cell[lane] = place.cell[lane] ^ different[lane];
        }
        let depth = u32::from(self.lattice.depth);
        // Never all zero.
        let shift = u32::BITS - (different[0] | different[1] | different[2] | 1).leading_zeros();
        let (node, shift) = if shift > depth {
            let [x, y, z, _] = other.cell;
            (self.root(self.lattice.root_of([x, y, z])), depth)
        } else {
            (Node::Inner(place.path[(shift - 1) as usize & 15]), shift)
        };
        (other.leaf, other.shift) = self.descend(&other.cell, node, shift, &mut Path::default());
    }

    /// Adds another leaf, and the own one before the first.
    #[inline(never)]
    fn add(&self, blend: &mut Blend<'_>, other: &Other) {
        let bits = Bits::at(self, other.leaf);
        let question = self.question(&other.cell, other.shift, &blend.place.position, blend.question.with_gradient);
        let steepness = self.steepness(bits.overlap_codes(self).support);
        let [x, y, z, _] = question.local.map(f32::abs);
        let xy = if x > y { x } else { y };
        let farthest = if xy > z { xy } else { z };
        if 0.5 + (1.0 - farthest) * steepness <= 0.0 {
            return;
        }
        if blend.sums.weight == 0.0 {
            blend.sums.add(blend.question, self.steepness(blend.codes.support), 0.0, &blend.own.gradient);
        }
        let mut answer = Answer::default();
        bits.evaluate(self, &question, blend.workspace, &mut answer);
        blend.sums.add(&question, steepness, answer.value - blend.own.value, &answer.gradient);
    }

    /// The leaves of which the supports can hold a place, and a few more.
    fn around(&self, place: &Place, reach: u32) -> Region<'_, '_> {
        // How far supports reach into the leaf, in finest cells. Where one is too fine for the code, as far as they may.
        let share = match reach {
            0 => (1 << (leaf::MAX_LEVELS_APART - leaf::MAX_SUPPORT)) as f32,
            _ => math::power_of_half(reach as u8 - 1),
        };
        let margin = self.overlap() * (1_u32 << place.shift) as f32 * share;
        // Never below zero, and never beyond the lattice.
        let low = place.position.map(|part| (part - margin).max(0.0));
        let high = place.position.map(|part| part + margin);
        // No finer leaf touches this one. Without this bound a damaged file could ask for the whole lattice.
        let finest = place.shift.saturating_sub(leaf::MAX_LEVELS_APART);
        Region::new(self, self.lattice.cell_of(low), self.lattice.cell_of(high), finest)
    }

    /// Half the edge of a leaf over twice the distance by which it reaches beyond its cell.
    #[inline]
    pub(crate) fn steepness(&self, support: u32) -> Steepness {
        self.steepness * (1 << support) as f32
    }
}

/// Local coordinates of a position, -1 to 1 within the leaf that holds a cell.
#[inline(never)]
pub(crate) fn local(cell: &[u32; 4], shift: u32, position: &Position, local: &mut Lanes) {
    // A power of two: the product is exact.
    let per_half = f32::from_bits((128 - shift) << 23);
    let align = u32::MAX << shift;
    for (lane, part) in local.iter_mut().enumerate() {
        *part = (position[lane] - (cell[lane] & align).cast_signed() as f32) * per_half - 1.0;
    }
}

/// [`PolynomialOctree::look`]: apart and in memory, which makes four-wide code.
#[inline(never)]
fn look(
    cell: &[u32; 4],
    shift: u32,
    within: f32,
    extent: &Position,
    position: &Position,
    local: &mut Lanes,
    sides: &mut Sides,
) {
    // A power of two: the product is exact.
    let per_half = f32::from_bits((128 - shift) << 23);
    let (align, edge) = (u32::MAX << shift, 1 << shift);
    for lane in 0..4 {
        let low = cell[lane] & align;
        let part = (position[lane] - low.cast_signed() as f32) * per_half - 1.0;
        local[lane] = part;
        let next = if part > 0.0 { low.wrapping_add(edge) } else { low.wrapping_sub(1) };
        sides.cell[lane] = next;
        let next = next.cast_signed() as f32;
        let is_near = (part.abs() > within) & (next >= 0.0) & (next < extent[lane]);
        sides.near[lane] = u32::from(is_near);
    }
}
