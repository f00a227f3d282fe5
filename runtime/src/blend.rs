//! Leaves that overlap: a partition of unity (SPEC.md §12.6, §12.7).
//!
//! Every leaf has a weight that falls smoothly to 0 at the edge of its support. What is there to answer is the mean of the
//! leaves by their weights, so it is as continuous as the weights are (Babuška and Melenk 1997).

use crate::lattice::{Leaf, Position};
use crate::layout::leaf;
use crate::legendre::Lanes;
use crate::math;
use crate::polynomial_leaf::{Answer, Bits, OverlapCodes, Question};
use crate::polynomial_octree::{Node, Path, Place, PolynomialOctree};
use crate::region::Region;

/// The weight of a leaf at a point, and its derivatives by the leaf's local coordinates.
#[derive(Clone, Copy)]
struct Weight {
    value: f32,
    slope: Lanes,
}

impl Weight {
    /// The weight at local coordinates, -1 to 1 within the leaf. `steepness` is half the leaf's edge over twice the
    /// distance by which it reaches beyond its cell.
    #[inline]
    fn at(local: &Lanes, steepness: f32) -> Self {
        let (mut step, mut slope) = ([0.0; 4], [0.0; 4]);
        steps(local, steepness, &mut step, &mut slope);
        let [x, y, z, _] = step;
        let (yz, xz, xy) = (y * z, x * z, x * y);
        Self { value: x * yz, slope: [slope[0] * yz, slope[1] * xz, slope[2] * xy, 0.0] }
    }
}

/// The smooth step of each axis, and its derivative.
#[inline(never)]
fn steps(local: &Lanes, steepness: f32, step: &mut Lanes, slope: &mut Lanes) {
    for (lane, &part) in local.iter().enumerate() {
        let inside = 0.5 + (1.0 - part.abs()) * steepness;
        let inside = if inside > 0.0 { inside } else { 0.0 };
        let inside = if inside < 1.0 { inside } else { 1.0 };
        step[lane] = (inside * inside) * (3.0 - 2.0 * inside);
        slope[lane] = (6.0 * inside * (1.0 - inside)) * (-steepness).copysign(-part);
    }
}

/// Sums over leaves.
#[derive(Clone, Copy, Default)]
struct Sums {
    weight: f32,
    weight_slope: Lanes,
    /// Of the values by the weights. They are differences to that of the leaf that holds the point, which loses less to
    /// rounding.
    value: f32,
    /// Of the gradients by the weights, and of the values by the slopes of the weights.
    slope: Lanes,
}

impl Sums {
    #[inline]
    fn add(&mut self, weight: &Weight, value: f32, question: &Question, gradient: &Lanes) {
        self.weight += weight.value;
        self.value += weight.value * value;
        if question.with_gradient {
            self.add_slopes(weight, value, question.per_half, gradient);
        }
    }

    #[inline(never)]
    fn add_slopes(&mut self, weight: &Weight, value: f32, per_half: f32, gradient: &Lanes) {
        for (lane, part) in gradient.iter().enumerate() {
            let slope = weight.slope[lane] * per_half;
            self.weight_slope[lane] += slope;
            self.slope[lane] += weight.value * part + slope * value;
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
struct Other {
    leaf: u32,
    shift: u32,
    cell: [u32; 4],
}

/// A place near a face of its leaf, what that leaf answers there, and the sums over it and others.
struct Blend<'b> {
    place: &'b Place,
    codes: OverlapCodes,
    question: &'b Question,
    own: &'b Answer,
    /// Nothing until another leaf has a say.
    sums: Sums,
}

/// What is beyond the faces near a place.
#[derive(Default)]
struct Beyond {
    /// Axes along which a face of the leaf of the place is near, a bit for each.
    faces: u32,
    /// Those, and axes along which a face between two of the leaves beyond is.
    axes: u32,
    /// Along each of them, the cell beyond.
    cell: [u32; 4],
}

/// The subsets of each set of axes, a bit for each.
const SUBSETS: [u32; 8] = [0x01, 0x03, 0x05, 0x0F, 0x11, 0x33, 0x55, 0xFF];

impl PolynomialOctree<'_> {
    /// Makes the answer of the leaf of a place, near a face of it, the mean of all leaves that have a say there.
    #[inline(never)]
    pub(crate) fn blend(&self, place: &Place, codes: OverlapCodes, question: &Question, answer: &mut Answer) {
        let mut blend = Blend { place, codes, question, own: answer, sums: Sums::default() };
        if codes.reach == 0 || !self.add_beside(&mut blend) {
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
    fn add_beside(&self, blend: &mut Blend<'_>) -> bool {
        let place = blend.place;
        let mut beyond = Beyond::default();
        beyond.faces = self.near_sides(&place.cell, place.shift, blend.codes, &blend.question.local, &mut beyond.cell);
        beyond.axes = beyond.faces;
        let (mut seen, mut path) = ([place.leaf; 8], Path::default());
        let mut done = SUBSETS[!beyond.faces as usize & 7];
        loop {
            let pending = SUBSETS[beyond.axes as usize & 7] & !done;
            if pending == 0 {
                return true;
            }
            let crossed = pending.trailing_zeros();
            done |= 1 << crossed;

            let mut cell = place.cell;
            for (axis, part) in cell.iter_mut().enumerate() {
                if crossed >> axis & 1 == 1 {
                    *part = beyond.cell[axis];
                }
            }
            let other = self.leaf_beside(place, cell, &mut path);
            // Beyond faces of the own leaf alone, only a greater one can be met twice.
            let may_be_seen = other.shift > place.shift || beyond.axes != beyond.faces;
            if may_be_seen && seen.contains(&other.leaf) {
                continue;
            }
            seen[crossed as usize & 7] = other.leaf;

            let bits = Bits::at(self, other.leaf);
            let codes = bits.overlap_codes(self);
            let question = self.question(&other.cell, other.shift, &place.position, blend.question.with_gradient);
            if other.shift < place.shift && !self.widen(&mut beyond, place, &other, codes, &question.local, crossed) {
                return false;
            }
            self.add(blend, &bits, codes, &question);
        }
    }

    /// Adds the near faces between a leaf, finer than that of the place, and others of its side. False if they are not known
    /// by one cell along each axis.
    #[inline(never)]
    fn widen(
        &self,
        beyond: &mut Beyond,
        place: &Place,
        other: &Other,
        codes: OverlapCodes,
        local: &Lanes,
        crossed: u32,
    ) -> bool {
        let mut cells = [0; 4];
        let near = self.near_sides(&other.cell, other.shift, codes, local, &mut cells) & !crossed;
        let mut is_known = codes.reach != 0;
        for (axis, cell) in cells.into_iter().enumerate() {
            let is_within = (cell ^ place.cell[axis]) >> place.shift == 0;
            if near >> axis & 1 == 1 && is_within {
                is_known &= beyond.axes >> axis & 1 == 0 || beyond.cell[axis] == cell;
                beyond.axes |= 1 << axis;
                beyond.cell[axis] = cell;
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
                let bits = Bits::at(self, leaf);
                let shift = edge.trailing_zeros();
                let question = self.question(&[x, y, z, 0], shift, &place.position, blend.question.with_gradient);
                self.add(blend, &bits, bits.overlap_codes(self), &question);
            }
        }
    }

    /// Along which axes a place is near a face of a leaf with a neighbour, a bit for each, and the cells beyond the nearer
    /// faces.
    #[inline]
    fn near_sides(
        &self,
        cell: &[u32; 4],
        shift: u32,
        codes: OverlapCodes,
        local: &Lanes,
        beyond: &mut [u32; 4],
    ) -> u32 {
        let mut near = [0; 4];
        self.sides(cell, shift, self.alone_within(codes.reach), local, beyond, &mut near);
        let [x, y, z, _] = near;
        x | y << 1 | z << 2
    }

    #[inline(never)]
    fn sides(
        &self,
        cell: &[u32; 4],
        shift: u32,
        within: f32,
        local: &Lanes,
        beyond: &mut [u32; 4],
        near: &mut [u32; 4],
    ) {
        let (align, edge) = (u32::MAX << shift, 1 << shift);
        for lane in 0..4 {
            let low = cell[lane] & align;
            let next = if local[lane] > 0.0 { low + edge } else { low.wrapping_sub(1) };
            beyond[lane] = next;
            let next = next.cast_signed() as f32;
            let is_near = (local[lane].abs() > within) & (next >= 0.0) & (next < self.lattice.extent[lane]);
            near[lane] = u32::from(is_near);
        }
    }

    /// The leaf of a cell, from the node that holds that and a place.
    #[inline]
    fn leaf_beside(&self, place: &Place, cell: [u32; 4], path: &mut Path) -> Other {
        let [x, y, z, _] = cell;
        let depth = u32::from(self.lattice.depth);
        let different = (x ^ place.cell[0]) | (y ^ place.cell[1]) | (z ^ place.cell[2]);
        let shift = u32::BITS - different.leading_zeros();
        let (node, shift) = if shift > depth {
            (self.root(self.lattice.root_of([x, y, z])), depth)
        } else {
            (Node::Inner(place.path[shift.wrapping_sub(1) as usize & 15]), shift)
        };
        let (leaf, shift) = self.descend(&cell, node, shift, path);
        Other { leaf, shift, cell }
    }

    /// Adds another leaf, and the own one before the first.
    #[inline(never)]
    fn add(&self, blend: &mut Blend<'_>, bits: &Bits<'_>, codes: OverlapCodes, question: &Question) {
        let steepness = self.steepness(codes.support);
        let [x, y, z, _] = question.local.map(f32::abs);
        let xy = if x > y { x } else { y };
        let farthest = if xy > z { xy } else { z };
        if 0.5 + (1.0 - farthest) * steepness <= 0.0 {
            return;
        }
        if blend.sums.weight == 0.0 {
            let weight = Weight::at(&blend.question.local, self.steepness(blend.codes.support));
            blend.sums.add(&weight, 0.0, blend.question, &blend.own.gradient);
        }
        let mut answer = Answer::default();
        bits.evaluate(self, question, &mut answer);
        let weight = Weight::at(&question.local, steepness);
        blend.sums.add(&weight, answer.value - blend.own.value, question, &answer.gradient);
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
        Region::new(self, self.lattice.cell_of(low), self.lattice.cell_of(high))
    }

    /// Half the edge of a leaf over twice the distance by which it reaches beyond its cell.
    #[inline]
    fn steepness(&self, support: u32) -> f32 {
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
