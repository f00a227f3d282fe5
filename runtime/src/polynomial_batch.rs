//! Many points at once: those that follow one another in a leaf of a polynomial octree are evaluated side by side.
//!
//! Every number is worked out as for a point alone, so the bits are the same. What differs is that a leaf is read once for
//! all points that it has a say at, and that a vector holds a number of four points rather than four of one.

use crate::blend::Other;
use crate::lattice::Position;
use crate::polynomial_leaf::{Answer, Bits, Polynomials};
use crate::polynomial_octree::{Place, PolynomialOctree};
use crate::polynomial_rows::{Answers, POINTS, Row, Sums, holds, locals};

/// Fewer are faster one by one.
const LEAST_POINTS: usize = 12;

/// Fewer that a neighbour may have a say at are blended one by one.
const LEAST_ASKED: u32 = 3;

/// A set of points, a bit for each.
type Points = u32;

/// All of them.
const ALL: Points = (1 << POINTS) - 1;

/// Where answers go: those that there is room for.
struct Output<'o> {
    values: &'o mut [f32],
    gradients: Option<&'o mut [[f32; 3]]>,
}

impl Output<'_> {
    #[inline]
    fn store(&mut self, at: usize, answer: Answer) {
        let (value, gradient) = answer.split();
        if let Some(place) = self.values.get_mut(at) {
            *place = value;
        }
        if let Some(place) = self.gradients.as_mut().and_then(|gradients| gradients.get_mut(at)) {
            *place = gradient;
        }
    }
}

/// Points of a leaf, and which neighbours may have a say at them.
struct Group<'g> {
    place: &'g Place,
    positions: &'g [Row; 3],
    /// Along each axis, the points to which a face with a neighbour is near, and of all points those nearer to the greater face.
    near: [Points; 3],
    greater: [Points; 3],
    /// The cells beyond the lesser and the greater faces.
    beyond: [[u32; 4]; 2],
    /// Points beyond which leaves are finer, or so many that they are not known by directions.
    alone: Points,
}

impl<'a> PolynomialOctree<'a> {
    /// Values and, if asked for, gradients at points of the box.
    pub(crate) fn query_each(&self, points: &[[f32; 3]], values: &mut [f32], gradients: Option<&mut [[f32; 3]]>) {
        let mut output = Output { values, gradients };
        let mut done = 0;
        while let Some(rest) = points.get(done..)
            && let Some(&first) = rest.first()
        {
            let mut place = Place::default();
            let [x, y, z] = first;
            self.lattice.locate(x, y, z, &mut place.position, &mut place.cell, &mut [0; 4]);
            self.find(&mut place);
            let is_run = rest.get(LEAST_POINTS - 1).is_some_and(|&point| self.position_within(&place, point).is_some());
            if is_run {
                done += self.query_run(&mut place, rest, done, &mut output);
            } else {
                output.store(done, self.query_at(&place, output.gradients.is_some()));
                done += 1;
            }
        }
    }

    /// The first points that lie in the leaf of a place; returns how many these are.
    #[inline(never)]
    fn query_run(&self, place: &mut Place, points: &[[f32; 3]], done: usize, output: &mut Output<'_>) -> usize {
        // The first again where there are no more.
        let [x, y, z, _] = place.position;
        let mut positions = [[x; POINTS], [y; POINTS], [z; POINTS]];
        let mut count = 1;
        for &point in points.iter().take(POINTS).skip(1) {
            let Some(position) = self.position_within(place, point) else { break };
            for (row, part) in positions.iter_mut().zip(position) {
                row[count & (POINTS - 1)] = part;
            }
            count += 1;
        }
        let mut answers = Answers::default();
        self.answer_group(place, &positions, count, output.gradients.is_some(), &mut answers);
        (0..count).for_each(|lane| output.store(done + lane, answers.at(lane)));
        count
    }

    /// Where a point is, if in the leaf of a place.
    #[inline]
    fn position_within(&self, place: &Place, point: [f32; 3]) -> Option<Position> {
        let (mut position, mut cell) = ([0.0; 4], [0; 4]);
        let [x, y, z] = point;
        self.lattice.locate(x, y, z, &mut position, &mut cell, &mut [0; 4]);
        let different = (cell[0] ^ place.cell[0]) | (cell[1] ^ place.cell[1]) | (cell[2] ^ place.cell[2]);
        (different >> place.shift == 0).then_some(position)
    }

    /// What the field answers at the points of a leaf.
    fn answer_group(
        &self,
        place: &mut Place,
        positions: &[Row; 3],
        count: usize,
        with_gradient: bool,
        answers: &mut Answers,
    ) {
        let bits = Bits::at(self, place.leaf);
        let codes = bits.overlap_codes(self);
        let (mut local, mut polynomials) = ([[0.0; POINTS]; 3], Polynomials::default());
        bits.decode(self, &mut polynomials);
        locals(positions, &place.cell, place.shift, &mut local);
        let per_half = self.lattice.per_half(place.shift);
        polynomials.evaluate_each(&local, per_half, answers);

        let mut group = self.group(place, positions, &local, self.alone_within(codes.reach));
        let near = group.near[0] | group.near[1] | group.near[2];
        if near == 0 {
            return;
        }
        let own = *answers;
        if codes.reach == 0 {
            group.alone = near;
        } else {
            let (mut sums, mut blended) = (Sums::default(), [0.0; POINTS]);
            let none = Answers { value: [0.0; POINTS], ..own };
            sums.add(&local, self.steepness(codes.support), per_half, &none, &[1.0; POINTS]);
            self.add_neighbours(&mut group, &own, &mut sums, &mut blended);
            sums.add_mean_to(&blended, answers);
        }
        let alone = group.alone;
        for lane in (0..count.min(POINTS)).filter(|lane| alone >> lane & 1 == 1) {
            let [x, y, z] = positions.each_ref().map(|row| row[lane & (POINTS - 1)]);
            place.position = [x, y, z, 0.0];
            let [x, y, z] = self.lattice.cell_of(place.position);
            place.cell = [x, y, z, 0];
            let answer = self.answer(place, codes, with_gradient, |_, _, answer| *answer = own.at(lane));
            answers.set(lane, answer.split());
        }
    }

    /// The points of the leaf of a place, by their local coordinates.
    fn group<'g>(&self, place: &'g Place, positions: &'g [Row; 3], local: &[Row; 3], within: f32) -> Group<'g> {
        let mut group = Group { place, positions, near: [0; 3], greater: [0; 3], beyond: [[0; 4]; 2], alone: 0 };
        for (axis, row) in local.iter().enumerate() {
            let low = place.cell[axis] & (u32::MAX << place.shift);
            let high = low.wrapping_add(1 << place.shift);
            (group.beyond[0][axis], group.beyond[1][axis]) = (low.wrapping_sub(1), high);
            let (mut far, mut greater) = (0, 0);
            compare(row, within, &mut far, &mut greater);
            let lesser_there = if low > 0 { !greater } else { 0 };
            let greater_there = if (high.cast_signed() as f32) < self.lattice.extent[axis] { greater } else { 0 };
            (group.near[axis], group.greater[axis]) = (far & (lesser_there | greater_there), greater);
        }
        group
    }

    /// Adds the leaf beyond each near face, edge and corner, as for one point; `blended` is 1 where one had a say.
    fn add_neighbours(&self, group: &mut Group<'_>, own: &Answers, sums: &mut Sums, blended: &mut Row) {
        let place = group.place;
        // Leaves met, and at which points.
        let (mut seen, mut polynomials) = ([(place.leaf, ALL); 27], Polynomials::default());
        let mut met = 1;
        for crossed in 1..8_u32 {
            let of = |axis: usize, points: Points| if crossed >> axis & 1 == 1 { points } else { ALL };
            let near = of(0, group.near[0]) & of(1, group.near[1]) & of(2, group.near[2]);
            let mut pending = near & !group.alone;
            while pending != 0 {
                // The points beyond the same sides of which the same leaf is.
                let first = pending.trailing_zeros();
                let (mut asked, mut cell) = (pending, [0; 4]);
                for ((part, greater), axis) in cell.iter_mut().zip(group.greater).zip(0..) {
                    let side = greater >> first & 1;
                    *part = group.beyond[side as usize & 1][axis & 3];
                    asked &= of(axis, greater ^ side.wrapping_sub(1));
                }
                pending &= !asked;
                if asked.count_ones() < LEAST_ASKED {
                    group.alone |= asked;
                    continue;
                }

                let mut other = Other::default();
                self.leaf_beside(place, crossed, &cell, &mut other);
                if other.shift < place.shift {
                    group.alone |= asked;
                    continue;
                }
                if other.shift > place.shift {
                    let is_met = |&&(leaf, _): &&(u32, Points)| leaf == other.leaf;
                    let points = seen.iter().take(met).filter(is_met).fold(0, |points, &(_, at)| points | at);
                    asked &= !points;
                }
                if let Some(entry) = seen.get_mut(met) {
                    *entry = (other.leaf, asked);
                    met += 1;
                }
                if asked != 0 {
                    self.add_group(group.positions, &other, asked, own, &mut polynomials, sums, blended);
                }
            }
        }
    }

    /// Adds another leaf at those points that it has a say at.
    #[expect(clippy::too_many_arguments, reason = "rows are worked on where they are")]
    fn add_group(
        &self,
        positions: &[Row; 3],
        other: &Other,
        asked: Points,
        own: &Answers,
        polynomials: &mut Polynomials,
        sums: &mut Sums,
        blended: &mut Row,
    ) {
        let bits = Bits::at(self, other.leaf);
        let steepness = self.steepness(bits.overlap_codes(self).support);
        let (mut local, mut share) = ([[0.0; POINTS]; 3], [0.0; POINTS]);
        locals(positions, &other.cell, other.shift, &mut local);
        for (lane, share) in share.iter_mut().enumerate() {
            *share = (asked >> lane & 1) as f32;
        }
        holds(&local, steepness, &mut share);
        if share == [0.0; POINTS] {
            return;
        }
        bits.decode(self, polynomials);
        let per_half = self.lattice.per_half(other.shift);
        let mut answers = Answers::default();
        polynomials.evaluate_each(&local, per_half, &mut answers);
        for lane in 0..POINTS {
            answers.value[lane] -= own.value[lane];
            blended[lane] += share[lane];
        }
        sums.add(&local, steepness, per_half, &answers, &share);
    }
}

/// The points of which a local coordinate is farther from the middle than `within`, and those of which it is greater.
#[inline(never)]
fn compare(local: &Row, within: f32, far: &mut Points, greater: &mut Points) {
    let (mut is_far, mut is_greater) = ([0; POINTS], [0; POINTS]);
    for lane in 0..POINTS {
        is_far[lane] = if local[lane].abs() > within { 1 << lane } else { 0 };
        is_greater[lane] = if local[lane] > 0.0 { 1 << lane } else { 0 };
    }
    *far = is_far.into_iter().fold(0, |points, point| points | point);
    *greater = is_greater.into_iter().fold(0, |points, point| points | point);
}
