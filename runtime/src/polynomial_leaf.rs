//! From the bits of a leaf of a polynomial octree to its value and derivatives (SPEC.md §12.4, §12.5).

use crate::layout::{kind, leaf, shape};
use crate::legendre::{Coefficients, Lanes};
use crate::polynomial_octree::PolynomialOctree;

/// The bytes that a leaf may take, and enough after them to load eight from any.
pub(crate) type Window = [u8; leaf::PADDING];

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
    fn degree(self, polynomial: usize) -> u32 {
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
    fn is_single(self) -> bool {
        self.byte(shape::KIND) == kind::SINGLE
    }

    /// What one of the polynomials answers, in steps and local coordinates.
    #[inline]
    fn evaluate(self, polynomial: usize, coefficients: &Coefficients, question: &Question, answer: &mut Answer) {
        let Question { local, with_gradient, .. } = question;
        answer.value = coefficients.evaluate(self.degree(polynomial), local, *with_gradient, &mut answer.gradient);
    }

    /// Chooses between the answer of polynomial A and that of B.
    #[inline(never)]
    fn choose(self, second: &Coefficients, question: &Question, answer: &mut Answer) {
        let mut other = Answer::default();
        self.evaluate(1, second, question, &mut other);
        let is_min = self.byte(shape::KIND) == kind::MIN;
        if if is_min { other.value < answer.value } else { other.value > answer.value } {
            *answer = other;
        }
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
    shape: Shape,
    /// Step of the coefficients, mesh units.
    step: f32,
    first: Coefficients,
    second: Coefficients,
}

impl Polynomials {
    #[inline]
    pub(crate) fn evaluate(&self, question: &Question, answer: &mut Answer) {
        self.shape.evaluate(0, &self.first, question, answer);
        if !self.shape.is_single() {
            self.shape.choose(&self.second, question, answer);
        }
        answer.scale(self.step, question.per_half);
    }
}

impl<'a> Bits<'a> {
    /// The leaf at a byte of the section of leaves.
    #[inline]
    pub(crate) fn at(octree: &PolynomialOctree<'a>, place: u32) -> Self {
        let window = octree.leaves.get(place as usize..).and_then(<[u8]>::first_chunk).unwrap_or(NOTHING);
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
    pub(crate) fn evaluate(&self, octree: &PolynomialOctree<'_>, question: &Question, answer: &mut Answer) {
        let mut first = Coefficients::default();
        let at = self.read_first(octree, &mut first);
        self.shape.evaluate(0, &first, question, answer);
        if !self.shape.is_single() {
            self.choose(at, question, answer);
        }
        answer.scale(octree.quantum * self.shape.factor(), question.per_half);
    }

    /// Chooses between the answer of polynomial A and that of B, which starts at a bit.
    #[inline(never)]
    fn choose(&self, at: u32, question: &Question, answer: &mut Answer) {
        let mut second = Coefficients::default();
        self.read_second(at, &mut second);
        self.shape.choose(&second, question, answer);
    }

    /// Writes the polynomials.
    #[inline]
    pub(crate) fn decode(&self, octree: &PolynomialOctree<'_>, polynomials: &mut Polynomials) {
        polynomials.shape = self.shape;
        polynomials.step = octree.quantum * self.shape.factor();
        let at = self.read_first(octree, &mut polynomials.first);
        if !self.shape.is_single() {
            self.read_second(at, &mut polynomials.second);
        }
    }

    /// Writes the coefficients of polynomial A; returns the bit after them.
    #[inline]
    fn read_first(&self, octree: &PolynomialOctree<'_>, coefficients: &mut Coefficients) -> u32 {
        let width = Width::new(self.shape.width(0));
        coefficients.constant = width.number((self.head >> octree.header_bits) as u32);
        self.read(self.shape.degree(0), u32::from(octree.header_bits) + width.bits, coefficients)
    }

    /// Writes the coefficients of polynomial B, which start at a bit.
    #[inline]
    fn read_second(&self, at: u32, coefficients: &mut Coefficients) {
        let width = Width::new(self.shape.width(0));
        coefficients.constant = width.number(load(self.window, at) as u32);
        self.read(self.shape.degree(1), at + width.bits, coefficients);
    }

    /// Writes the coefficients of a polynomial but the constant, of which those of degree 1 start at a bit; returns the bit after them.
    #[inline(never)]
    fn read(&self, degree: u32, at: u32, coefficients: &mut Coefficients) -> u32 {
        if degree == 0 {
            return at;
        }
        let width = Width::new(self.shape.width(1));
        width.three(load(self.window, at), &mut coefficients.linear);
        let at = at + 3 * width.bits;
        if degree == 1 {
            return at;
        }

        let width = Width::new(self.shape.width(2));
        let step = 3 * width.bits;
        width.three(load(self.window, at), &mut coefficients.square);
        width.three(load(self.window, at + step), &mut coefficients.cross);
        let at = at + 2 * step;
        if degree == 2 {
            return at;
        }

        let width = Width::new(self.shape.width(3));
        let step = 3 * width.bits;
        width.three(load(self.window, at), &mut coefficients.cube);
        width.three(load(self.window, at + step), &mut coefficients.next);
        width.three(load(self.window, at + 2 * step), &mut coefficients.previous);
        coefficients.product = width.number(load(self.window, at + 3 * step) as u32);
        at + 3 * step + width.bits
    }
}

/// How many bits the coefficients of a degree have.
#[derive(Clone, Copy)]
struct Width {
    bits: u32,
    mask: u32,
    /// The code of 0.
    half: i32,
}

impl Width {
    #[inline]
    fn new(bits: u32) -> Self {
        Self { bits, mask: (1 << bits) - 1, half: (1_u32 << bits >> 1).cast_signed() }
    }

    /// The number whose code is in the lowest bits.
    #[inline]
    fn number(self, bits: u32) -> f32 {
        ((bits & self.mask).cast_signed() - self.half) as f32
    }

    /// Three numbers whose codes are in the lowest bits. The last lane is not of use: four alike make better code.
    #[inline]
    fn three(self, bits: u64, numbers: &mut Lanes) {
        let (second, third) = ((bits >> self.bits) as u32, (bits >> self.bits >> self.bits) as u32);
        for (code, number) in [bits as u32, second, third, 0].into_iter().zip(numbers) {
            *number = ((code & self.mask).cast_signed() - self.half) as f32;
        }
    }
}

/// At least 57 bits from a bit on.
#[inline]
fn load(window: &Window, bit: u32) -> u64 {
    // The mask shows the compiler that no index can fail.
    let byte = (bit >> 3) as usize & 63;
    let bytes = window.get(byte..).and_then(<[u8]>::first_chunk).copied().unwrap_or_default();
    u64::from_le_bytes(bytes) >> (bit & 7)
}
