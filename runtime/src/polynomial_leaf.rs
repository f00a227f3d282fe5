//! From the bits of a leaf of a polynomial octree to its value and derivatives (SPEC.md §12.4, §12.5).

use crate::coefficient_code::{Codes, Window, are_narrow, load, number};
use crate::layout::{kind, leaf, shape};
use crate::legendre::{Coefficients, Lanes};
use crate::polynomial_octree::PolynomialOctree;
/// What a damaged file has instead of a leaf.
const NOTHING: &Window = &[0; leaf::PADDING];

/// The bits of a leaf, and its shape.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bits<'a> {
    window: &'a Window,
    /// The first eight bytes, which hold everything before the linear coefficients.
    head: u64,
    shape: Shape,
}

/// What a leaf says of its neighbours (SPEC.md §12.6).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct OverlapCodes {
    pub(crate) support: u32,
    pub(crate) reach: u32,
}

/// How a leaf is made: the bytes of SPEC.md §12.4.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shape(u64);

impl Shape {
    pub(crate) fn new(bytes: [u8; shape::LENGTH]) -> Self {
        Self(u64::from_le_bytes(bytes))
    }

    #[inline]
    pub(crate) fn byte(self, at: usize) -> u8 {
        (self.0 >> (8 * at)) as u8
    }

    #[inline]
    pub(crate) fn degree(self, polynomial: usize) -> u32 {
        self.byte(shape::DEGREES.start + polynomial).into()
    }

    /// Bits of a coefficient; no more than 31, whatever the file.
    #[inline]
    fn width(self, degree: usize) -> u32 {
        u32::from(self.byte(shape::WIDTHS.start + degree)) & 31
    }

    /// Two to the power of the exponent, which is at most 15.
    #[inline]
    fn factor(self) -> f32 {
        let exponent = u32::from(self.byte(shape::EXPONENT) & shape::MAX_EXPONENT);
        f32::from_bits((127 + exponent) << 23)
    }

    #[inline]
    pub(crate) fn is_single(self) -> bool {
        self.byte(shape::KIND) == kind::SINGLE
    }

    /// Bits of the coefficients of each degree.
    #[inline]
    fn widths(self) -> [u8; 4] {
        ((self.0 >> (8 * shape::WIDTHS.start)) as u32).to_le_bytes()
    }

    /// Whether it takes polynomial B for its value rather than that of A.
    #[inline]
    pub(crate) fn prefers(self, second: f32, first: f32) -> bool {
        if self.byte(shape::KIND) == kind::MIN { second < first } else { second > first }
    }
}

/// What is asked of a leaf: where, and whether with the gradient.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Question {
    /// Local coordinates, -1 to 1 within the leaf.
    pub(crate) local: Lanes,
    /// Halves of the leaf's edge in a mesh unit.
    pub(crate) per_half: f32,
    pub(crate) with_gradient: bool,
}

/// What a leaf answers, or several: value, mesh units, and gradient if asked for. In its last lane is something finite
/// that nobody looks at.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Answer {
    pub(crate) value: f32,
    pub(crate) gradient: Lanes,
}

impl Answer {
    #[inline]
    pub(crate) fn split(self) -> (f32, [f32; 3]) {
        let [x, y, z, _] = self.gradient;
        (self.value, [x, y, z])
    }

    /// Becomes what a polynomial answers, in steps.
    #[inline]
    fn take(&mut self, polynomial: &Coefficients, degree: u32, question: &Question, parts: &mut Lanes) {
        let Question { local, with_gradient, .. } = question;
        self.value = polynomial.evaluate(degree, local, *with_gradient, parts, &mut self.gradient);
    }

    /// Becomes that of polynomial B if the leaf takes that.
    #[inline(never)]
    fn choose(&mut self, shape: Shape, second: &Coefficients, question: &Question, parts: &mut Lanes) {
        let mut other = Answer::default();
        other.take(second, shape.degree(1), question, parts);
        if shape.prefers(other.value, self.value) {
            *self = other;
        }
    }

    /// From steps to mesh units.
    #[inline]
    fn scale(&mut self, step: f32, per_half: f32) {
        self.value *= step;
        let per_unit = step * per_half;
        self.gradient = self.gradient.map(|part| part * per_unit);
    }
}

/// The polynomials of a leaf.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Polynomials {
    pub(crate) shape: Shape,
    /// Step of the coefficients, mesh units.
    pub(crate) step: f32,
    pub(crate) first: Coefficients,
    pub(crate) second: Coefficients,
}

impl Polynomials {
    pub(crate) fn evaluate(&self, question: &Question, answer: &mut Answer) {
        let mut parts = Lanes::default();
        answer.take(&self.first, self.shape.degree(0), question, &mut parts);
        if !self.shape.is_single() {
            answer.choose(self.shape, &self.second, question, &mut parts);
        }
        answer.scale(self.step, question.per_half);
    }
}

/// What leaves are evaluated in, one after the other: its contents are of no use afterwards.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Workspace {
    coefficients: Coefficients,
    /// What the terms of a polynomial add up to, axis by axis.
    parts: Lanes,
}

impl<'a> Bits<'a> {
    /// The leaf at a byte of the section of leaves.
    #[inline]
    pub(crate) fn at(octree: &PolynomialOctree<'a>, place: u32) -> Self {
        let place = place as usize;
        let window = octree.leaves.get(place..place.saturating_add(leaf::PADDING));
        let window = window.and_then(|window| window.try_into().ok()).unwrap_or(NOTHING);
        let head = load(window, 0);
        let shape = octree.shapes.get((head as u32 & octree.shape_mask) as usize).copied().unwrap_or_default();
        Self { window, head, shape: Shape::new(shape) }
    }

    /// Its codes, if leaves overlap.
    #[inline]
    pub(crate) fn overlap_codes(&self, octree: &PolynomialOctree<'_>) -> OverlapCodes {
        let codes = (self.head >> octree.shape_bits) as u32;
        OverlapCodes { support: codes & leaf::MAX_SUPPORT, reach: codes >> leaf::SUPPORT_BITS & leaf::MAX_REACH }
    }

    /// Number of the shape.
    pub(crate) fn shape_number(&self, octree: &PolynomialOctree<'_>) -> usize {
        (self.head as u32 & octree.shape_mask) as usize
    }

    /// Bits of the leaf.
    pub(crate) fn length(&self, octree: &PolynomialOctree<'_>) -> u32 {
        const TERMS: [u32; 4] = [1, 3, 6, 10];
        let mut bits = u32::from(octree.header_bits);
        for (terms, degree) in TERMS.into_iter().zip(0..) {
            let is_in_first = degree <= self.shape.degree(0);
            let is_in_second = !self.shape.is_single() && degree <= self.shape.degree(1);
            let polynomials = u32::from(is_in_first) + u32::from(is_in_second);
            bits += polynomials * terms * self.shape.width(degree as usize);
        }
        bits
    }

    /// What the leaf answers.
    #[inline]
    pub(crate) fn evaluate(
        &self,
        octree: &PolynomialOctree<'_>,
        question: &Question,
        workspace: &mut Workspace,
        answer: &mut Answer,
    ) {
        let at = self.evaluate_one(self.shape.degree(0), octree.header_bits.into(), question, workspace, answer);
        if !self.shape.is_single() {
            self.choose(at, question, workspace, answer);
        }
        answer.scale(octree.quantum * self.shape.factor(), question.per_half);
    }

    /// What a polynomial answers, in steps, which starts at a bit; returns the bit after it.
    #[inline(never)]
    fn evaluate_one(
        &self,
        degree: u32,
        at: u32,
        question: &Question,
        workspace: &mut Workspace,
        answer: &mut Answer,
    ) -> u32 {
        let Workspace { coefficients, parts } = workspace;
        let at = self.read(degree, at, coefficients);
        answer.take(coefficients, degree, question, parts);
        at
    }

    /// Makes the answer of polynomial A that of B, which starts at a bit, if the leaf takes that.
    #[inline(never)]
    fn choose(&self, at: u32, question: &Question, workspace: &mut Workspace, answer: &mut Answer) {
        let mut other = Answer::default();
        self.evaluate_one(self.shape.degree(1), at, question, workspace, &mut other);
        if self.shape.prefers(other.value, answer.value) {
            *answer = other;
        }
    }

    /// Writes the polynomials.
    #[inline]
    pub(crate) fn decode(&self, octree: &PolynomialOctree<'_>, polynomials: &mut Polynomials) {
        polynomials.shape = self.shape;
        polynomials.step = octree.quantum * self.shape.factor();
        let at = self.read(self.shape.degree(0), octree.header_bits.into(), &mut polynomials.first);
        if !self.shape.is_single() {
            self.read(self.shape.degree(1), at, &mut polynomials.second);
        }
    }

    /// Writes the coefficients of a polynomial, which starts at a bit; returns the bit after it. Never
    /// inlined, for the coefficients to be in memory: that makes four-wide code.
    #[inline(always)]
    fn read(&self, degree: u32, at: u32, coefficients: &mut Coefficients) -> u32 {
        if !are_narrow(self.shape.widths()) {
            return self.read_wide(degree, at, coefficients);
        }
        let width = self.shape.width(0);
        let bits = load(self.window, at);
        coefficients.constant = number(width, bits);
        let at = at + width;
        if degree == 0 {
            return at;
        }

        let bits = bits >> width;
        let width = self.shape.width(1) & 15;
        Codes::of(width).three(bits, &mut coefficients.linear);
        let at = at + 3 * width;
        if degree == 1 {
            return at;
        }

        let width = self.shape.width(2) & 15;
        let codes = Codes::of(width);
        let bits = load(self.window, at);
        codes.three(bits, &mut coefficients.square);
        codes.three(bits >> (3 * width), &mut coefficients.cross);
        let at = at + 6 * width;
        if degree == 2 {
            return at;
        }

        let width = self.shape.width(3) & 15;
        let codes = Codes::of(width);
        let bits = load(self.window, at);
        codes.three(bits, &mut coefficients.cube);
        codes.three(bits >> (3 * width), &mut coefficients.next);
        codes.three(bits >> (6 * width), &mut coefficients.previous);
        coefficients.product = codes.one(bits >> (9 * width));
        at + 10 * width
    }

    /// The same for codes of any width, one after the other.
    #[inline(never)]
    fn read_wide(&self, degree: u32, mut at: u32, coefficients: &mut Coefficients) -> u32 {
        let mut next = |of: usize| {
            let width = self.shape.width(of);
            let number = number(width, load(self.window, at));
            at += width;
            number
        };
        coefficients.constant = next(0);
        let Coefficients { linear, square, cross, cube, next: by_next, previous, .. } = coefficients;
        for (of, three) in [(1, linear), (2, square), (2, cross), (3, cube), (3, by_next), (3, previous)] {
            if of as u32 <= degree {
                three.iter_mut().take(3).for_each(|number| *number = next(of));
            }
        }
        if degree >= 3 {
            coefficients.product = next(3);
        }
        at
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    #[test]
    fn a_shape_is_its_bytes() {
        let shape = Shape::new([kind::MAX, 3, 2, 5, 24, 10, 9, 5]);
        assert_eq!([shape.degree(0), shape.degree(1)], [3, 2]);
        assert_eq!(shape.factor(), 32.0);
        assert_eq!(shape.widths(), [24, 10, 9, 5]);
        assert_eq!([0, 1, 2, 3].map(|degree| shape.width(degree)), [24, 10, 9, 5]);
        assert!(!shape.is_single());
    }

    /// Every number that a polynomial has, and where it ends.
    fn numbers(read: impl Fn(&mut Coefficients) -> u32) -> (Vec<f32>, u32) {
        let mut all = Coefficients::default();
        let end = read(&mut all);
        let threes = [all.linear, all.square, all.cross, all.cube, all.next, all.previous];
        let numbers = threes.iter().flat_map(|three| &three[..3]);
        (numbers.copied().chain([all.constant, all.product]).collect(), end)
    }

    #[test]
    fn narrow_codes_are_read_as_codes_of_any_width() {
        let window: Window = core::array::from_fn(|byte| (byte * 73 + 41) as u8);
        for widths in [[24, 10, 9, 5], [1, 1, 1, 1], [12, 7, 3, 2], [17, 10, 5, 0], [9, 4, 0, 0], [6, 0, 0, 0]] {
            let shape = Shape(u64::from(u32::from_le_bytes(widths)) << 32);
            let bits = Bits { window: &window, head: 0, shape };
            for (degree, at) in (0..4).flat_map(|degree| (0..30).map(move |at| (degree, at))) {
                let narrow = numbers(|all| bits.read(degree, at, all));
                let wide = numbers(|all| bits.read_wide(degree, at, all));
                assert_eq!(narrow, wide, "degree {degree} of widths {widths:?} from bit {at}");
            }
        }
    }

    /// Their gradients may differ (SPEC.md §12.7).
    #[test]
    fn of_two_equal_polynomials_the_first_is_taken() {
        for (kind, lesser) in [(kind::MIN, true), (kind::MAX, false)] {
            let shape = Shape::new([kind, 1, 1, 0, 1, 1, 1, 1]);
            assert_eq!(shape.prefers(1.0, 2.0), lesser);
            assert_eq!(shape.prefers(2.0, 1.0), !lesser);
            assert!(!shape.prefers(1.0, 1.0) && !shape.prefers(0.0, -0.0) && !shape.prefers(-0.0, 0.0));
        }
    }
}
