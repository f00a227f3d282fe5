//! Leaves that overlap: a partition of unity (SPEC.md §12.6, §12.7).
//!
//! Every leaf has a weight that falls smoothly to 0 at the edge of its support. What is there to answer is the mean of the
//! leaves by their weights, so it is as continuous as the weights are (Babuška and Melenk 1997).

use crate::lattice::Leaf;
use crate::layout::leaf;
use crate::math;
use crate::polynomial_leaf::{Bits, Polynomials};
use crate::polynomial_octree::PolynomialOctree;
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
    fn at(local: [f32; 3], steepness: f32) -> Self {
        let inside = local.map(|part| (0.5 + (1.0 - part.abs()) * steepness).clamp(0.0, 1.0));
        let [x, y, z] = inside.map(|s| (s * s) * (3.0 - 2.0 * s));
        let slopes = [0, 1, 2].map(|axis: usize| {
            let s = inside[axis];
            (6.0 * s * (1.0 - s)) * (-steepness).copysign(-local[axis])
        });
        Self { value: x * y * z, slope: [slopes[0] * (y * z), slopes[1] * (x * z), slopes[2] * (x * y)] }
    }
}

/// Sums over leaves. The values are differences to that of the leaf that holds the point, which loses less to rounding.
#[derive(Clone, Copy, Default)]
struct Sums {
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

impl PolynomialOctree<'_> {
    /// Value and gradient at a position where more leaves than the one that holds it may have a say.
    #[inline(never)]
    pub(crate) fn blend(&self, own: &Leaf, position: [f32; 3], polynomials: &Polynomials) -> (f32, [f32; 3]) {
        let (support, reach) = Bits::at(self, own.place).overlap_codes(self);
        let local = local(own, position);
        let (value, slope) = polynomials.evaluate(local);
        let per_half = 2.0 / self.edge(own.level);
        let gradient = slope.map(|part| part * per_half);

        // For each support code: half the edge of a leaf over twice the distance by which it reaches beyond its cell.
        let steepness = 0.25 / self.overlap();
        let steepness = |support: u32| steepness * (1 << support) as f32;
        let mut sums = Sums::default();
        sums.add(Weight::at(local, steepness(support)), per_half, 0.0, gradient);
        let mut is_alone = true;
        let mut other = Polynomials::default();
        for leaf in self.around(own, position, reach) {
            if leaf.place == own.place {
                continue;
            }
            let bits = Bits::at(self, leaf.place);
            let local = self::local(&leaf, position);
            let weight = Weight::at(local, steepness(bits.overlap_codes(self).0));
            if weight.value > 0.0 {
                is_alone = false;
                bits.decode(self, &mut other);
                let (its_value, slope) = other.evaluate(local);
                let per_half = 2.0 / self.edge(leaf.level);
                sums.add(weight, per_half, its_value - value, slope.map(|part| part * per_half));
            }
        }
        if is_alone {
            return (value, gradient);
        }

        let per_weight = 1.0 / sums.weight;
        let change = sums.value * per_weight;
        let gradient = [0, 1, 2].map(|axis: usize| (sums.slope[axis] - change * sums.weight_slope[axis]) * per_weight);
        (value + change, gradient)
    }

    /// The leaves of which the supports can hold a position, and a few more.
    fn around(&self, own: &Leaf, position: [f32; 3], reach: u32) -> Region<'_, '_> {
        // How far supports reach into the leaf, in finest cells. Where one is too fine for the code, as far as they may.
        let share = match reach {
            0 => (1 << (leaf::MAX_LEVELS_APART - leaf::MAX_SUPPORT)) as f32,
            _ => math::power_of_half(reach as u8 - 1),
        };
        let margin = self.overlap() * own.edge as f32 * share;
        let low = position.map(|part| (part - margin) as u32);
        let high = position.map(|part| (part + margin) as u32);
        Region::new(self, self.lattice.clamp(low), self.lattice.clamp(high))
    }
}

/// Local coordinates of a position, -1 to 1 within the leaf.
#[inline]
pub(crate) fn local(leaf: &Leaf, position: [f32; 3]) -> [f32; 3] {
    // Powers of two: both divisions are exact.
    let per_half = f32::from_bits((128 - leaf.edge.trailing_zeros()) << 23);
    [0, 1, 2].map(|axis: usize| (position[axis] - leaf.cell[axis] as f32) * per_half - 1.0)
}
