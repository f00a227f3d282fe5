//! Leaves that overlap: a partition of unity (SPEC.md §12.6, §12.7).
//!
//! Every leaf has a weight that falls smoothly to 0 at the edge of its support. What is there to answer is the mean of the
//! leaves by their weights, so it is as continuous as the weights are (Babuška and Melenk 1997).

use crate::lattice::{Leaf, Position};
use crate::layout::leaf;
use crate::legendre::Lanes;
use crate::math;
use crate::polynomial_leaf::{Bits, OverlapCodes, Polynomials};
use crate::polynomial_octree::{Node, Place, PolynomialOctree};
use crate::region::Region;

/// The weight of a leaf at a point, and its derivatives by the leaf's local coordinates.
#[derive(Clone, Copy)]
struct Weight {
    value: f32,
    slope: [f32; 3],
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
        Self { value: x * yz, slope: [slope[0] * yz, slope[1] * xz, slope[2] * xy] }
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
    /// Value of the leaf that holds the point: the values that are summed are differences to it, which loses less to
    /// rounding.
    own: f32,
    weight: f32,
    weight_slope: [f32; 3],
    value: f32,
    /// Of the gradients by the weights, and of the values by the slopes of the weights.
    slope: [f32; 3],
}

impl Sums {
    #[inline]
    fn add(&mut self, weight: Weight, per_half: f32, value: f32, gradient: [f32; 3]) {
        self.weight += weight.value;
        self.value += weight.value * value;
        for (axis, part) in gradient.into_iter().enumerate() {
            let slope = weight.slope[axis] * per_half;
            self.weight_slope[axis] += slope;
            self.slope[axis] += weight.value * part + slope * value;
        }
    }
}

impl Sums {
    /// Value and gradient of the mean by weight.
    #[inline]
    fn mean(&self) -> (f32, [f32; 3]) {
        let per_weight = 1.0 / self.weight;
        let change = self.value * per_weight;
        let gradient = [0, 1, 2].map(|axis: usize| (self.slope[axis] - change * self.weight_slope[axis]) * per_weight);
        (self.own + change, gradient)
    }
}

/// A leaf near a place: where it is, its edge as a power of two of finest cells, and one of those that it holds.
struct Other {
    leaf: u32,
    shift: u32,
    cell: [u32; 4],
}

/// Of a leaf next to another, whether it alone is there, or finer ones may be.
enum Neighbour {
    Alone,
    Among,
}

impl PolynomialOctree<'_> {
    /// Value and gradient at a place near a face of its leaf, where the leaf alone would answer `own`.
    #[inline(never)]
    pub(crate) fn blend(
        &self,
        place: &Place,
        codes: OverlapCodes,
        local: &Lanes,
        own: (f32, [f32; 3]),
    ) -> (f32, [f32; 3]) {
        if codes.reach == 0 {
            return self.blend_all(place, codes, local, own);
        }
        let (axes, beyond) = self.near_sides(place, codes, local);
        if axes == 0 {
            return own;
        }

        // The leaf beyond each near face, edge and corner: each set of axes but the empty one.
        let mut sums = self.sums_of(place, codes, local, own);
        let alone = (sums.weight, sums.weight_slope);
        let mut seen = [place.leaf; 8];
        let mut crossed = axes;
        while crossed != 0 {
            let mut cell = place.cell;
            for axis in 0..3 {
                if crossed >> axis & 1 == 1 {
                    cell[axis] = beyond[axis];
                }
            }
            let other = self.leaf_beside(place, cell);
            if other.shift <= place.shift || !seen.contains(&other.leaf) {
                let along = if other.shift < place.shift { !crossed } else { 0 };
                if let Neighbour::Among = self.add(&mut sums, &other, along, place) {
                    return self.blend_all(place, codes, local, own);
                }
                seen[crossed as usize & 7] = other.leaf;
            }
            crossed = (crossed - 1) & axes;
        }
        // Near the end of a support the weight is lost in the sum while its slope is not.
        if (sums.weight, sums.weight_slope) == alone { own } else { sums.mean() }
    }

    /// The same where leaves are so small that there may be more of them than directions.
    #[cold]
    #[inline(never)]
    fn blend_all(&self, place: &Place, codes: OverlapCodes, local: &Lanes, own: (f32, [f32; 3])) -> (f32, [f32; 3]) {
        let mut sums = self.sums_of(place, codes, local, own);
        for Leaf { cell: [x, y, z], edge, place: leaf, .. } in self.around(place, codes.reach) {
            if leaf != place.leaf {
                let other = Other { leaf, shift: edge.trailing_zeros(), cell: [x, y, z, 0] };
                self.add(&mut sums, &other, 0, place);
            }
        }
        sums.mean()
    }

    /// Along which axes a place is near a face with a neighbour, a bit for each, and the cell beyond the nearer face.
    #[inline]
    fn near_sides(&self, place: &Place, codes: OverlapCodes, local: &Lanes) -> (u32, [u32; 3]) {
        let within = self.alone_within(codes.reach);
        let (mut axes, mut beyond) = (0, [0; 3]);
        for axis in 0..3 {
            let low = place.cell[axis] >> place.shift << place.shift;
            let is_high = local[axis] > 0.0;
            // One less than 0 is beyond the lattice too.
            beyond[axis] = if is_high { low + (1 << place.shift) } else { low.wrapping_sub(1) };
            let is_near = (local[axis].abs() > within) & (beyond[axis] < self.lattice.root_cells[axis] << self.depth());
            axes |= u32::from(is_near) << axis;
        }
        (axes, beyond)
    }

    /// The leaf of a cell, from the node that holds that and a place.
    #[inline]
    fn leaf_beside(&self, place: &Place, cell: [u32; 4]) -> Other {
        let [x, y, z, _] = cell;
        let depth = u32::from(self.lattice.depth);
        let different = (x ^ place.cell[0]) | (y ^ place.cell[1]) | (z ^ place.cell[2]);
        let shift = u32::BITS - different.leading_zeros();
        let (node, shift) = if shift > depth {
            (self.root(self.lattice.root_of([x, y, z])), depth)
        } else {
            (Node::Inner(place.path[shift.wrapping_sub(1) as usize & 15]), shift)
        };
        let (leaf, shift) = self.descend([x, y, z], node, shift, |_, _| ());
        Other { leaf, shift, cell }
    }

    /// The sums over the leaf of a place alone.
    #[inline]
    fn sums_of(&self, place: &Place, codes: OverlapCodes, local: &Lanes, own: (f32, [f32; 3])) -> Sums {
        let mut sums = Sums { own: own.0, ..Sums::default() };
        let weight = Weight::at(local, self.steepness(codes.support));
        sums.add(weight, self.lattice.per_half(place.shift), 0.0, own.1);
        sums
    }

    /// Adds another leaf. It may not be alone if its own neighbours reach the place along one of the axes `along`.
    #[inline(never)]
    fn add(&self, sums: &mut Sums, other: &Other, along: u32, place: &Place) -> Neighbour {
        let bits = Bits::at(self, other.leaf);
        let codes = bits.overlap_codes(self);
        let mut local = [0.0; 4];
        self::local(&other.cell, other.shift, &place.position, &mut local);
        let within = self.alone_within(codes.reach);
        let is_among = |axis: usize| (along >> axis & 1 == 1) & (local[axis].abs() > within);
        if is_among(0) | is_among(1) | is_among(2) {
            return Neighbour::Among;
        }
        let weight = Weight::at(&local, self.steepness(codes.support));
        if weight.value > 0.0 {
            let mut polynomials = Polynomials::default();
            bits.decode(self, &mut polynomials);
            let per_half = self.lattice.per_half(other.shift);
            let (value, gradient) = polynomials.evaluate(&local, per_half);
            sums.add(weight, per_half, value - sums.own, gradient);
        }
        Neighbour::Alone
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
