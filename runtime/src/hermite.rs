//! Values and gradients between eight corners.
//!
//! The tensor product is evaluated an axis at a time: x takes the cube's corners to a face, y the
//! face to an edge, z the edge to the point. Each step is a weighted sum whose weights are exactly
//! 0 and 1 at the ends, so on a face of the cube the answer depends on that face's corners alone
//! and comes out the same, bit for bit, from the neighbour of equal size. The derivative along an
//! axis is the same sum with the derivatives of that axis's weights.

/// A number for each corner of a cube, at `4 x + 2 y + z`.
pub(crate) type Corners = [f32; 8];

/// The value and the derivatives at a point by local coordinates of the leaf, mesh units, `4 x + 2 y + z` counting
/// derivations by each: `[f, fz, fy, fyz, fx, fxz, fxy, fxyz]`.
pub(crate) type Jet = [f32; 8];

/// The jets at the corners of a cube, at `4 x + 2 y + z`.
pub(crate) type Jets = [Jet; 8];

/// What is left of the jets of a cube's corners when x is given, at `2 y + z`: for each y the values and derivatives by z
/// of both ends along z, then the same of the derivatives by y.
struct Face {
    value: [[f32; 4]; 2],
    slope: [[f32; 4]; 2],
}

/// What is left when x and y are given: value and derivative by z of both ends along z.
type Edge = [f32; 4];

/// For x, y, z and nothing: weights of the values at both ends of an axis, then of the slopes.
pub(crate) type Weights = [[f32; 4]; 4];

// The functions that follow stay apart and end in memory: so compilers find their four-wide form, which they lose where
// they inline them. Coordinates come in registers: processors wait for what is written one by one and read together.

/// The cubic Hermite basis.
#[inline(never)]
pub(crate) fn basis(x: f32, y: f32, z: f32, weights: &mut Weights) {
    let local = [x, y, z, 0.0];
    for axis in 0..4 {
        let t = local[axis];
        let rest = 1.0 - t;
        let end = t * t * (3.0 - 2.0 * t);
        weights[0][axis] = 1.0 - end;
        weights[1][axis] = end;
        weights[2][axis] = t * (rest * rest);
        weights[3][axis] = -(t * t) * rest;
    }
}

/// Its derivative.
#[inline(never)]
pub(crate) fn basis_derivative(x: f32, y: f32, z: f32, weights: &mut Weights) {
    let local = [x, y, z, 0.0];
    for axis in 0..4 {
        let t = local[axis];
        let end = 6.0 * t * (1.0 - t);
        weights[0][axis] = -end;
        weights[1][axis] = end;
        weights[2][axis] = (1.0 - t) * (1.0 - 3.0 * t);
        weights[3][axis] = t * (3.0 * t - 2.0);
    }
}

/// Weighted sum of the values and slopes at both ends of an axis.
#[inline]
fn blend(weights: &Weights, axis: usize, values: [f32; 2], slopes: [f32; 2]) -> f32 {
    let [near, far, near_slope, far_slope] = weights;
    (values[0] * near[axis] + values[1] * far[axis]) + (slopes[0] * near_slope[axis] + slopes[1] * far_slope[axis])
}

#[inline(never)]
fn at_x(jets: &Jets, weights: &Weights, face: &mut Face) {
    for y in 0..2 {
        for z in 0..2 {
            let (near, far) = (&jets[2 * y + z], &jets[4 + 2 * y + z]);
            let at = |index: usize| blend(weights, 0, [near[index], far[index]], [near[4 + index], far[4 + index]]);
            face.value[y][2 * z] = at(0);
            face.value[y][2 * z + 1] = at(1);
            face.slope[y][2 * z] = at(2);
            face.slope[y][2 * z + 1] = at(3);
        }
    }
}

#[inline(never)]
fn at_y(Face { value, slope }: &Face, weights: &Weights, edge: &mut Edge) {
    for (index, edge) in edge.iter_mut().enumerate() {
        *edge = blend(weights, 1, [value[0][index], value[1][index]], [slope[0][index], slope[1][index]]);
    }
}

#[inline]
fn at_z(&[near, near_slope, far, far_slope]: &Edge, weights: &Weights) -> f32 {
    blend(weights, 2, [near, far], [near_slope, far_slope])
}

impl Face {
    const ZERO: Self = Self { value: [[0.0; 4]; 2], slope: [[0.0; 4]; 2] };
}

/// Value at local coordinates, mesh units.
#[inline]
pub(crate) fn tricubic(jets: &Jets, [x, y, z]: [f32; 3]) -> f32 {
    let (mut weights, mut face, mut edge) = (Weights::default(), Face::ZERO, Edge::default());
    basis(x, y, z, &mut weights);
    at_x(jets, &weights, &mut face);
    at_y(&face, &weights, &mut edge);
    at_z(&edge, &weights)
}

/// Value and derivatives by local coordinates, mesh units. The value has the bits of [`tricubic`].
#[inline]
pub(crate) fn tricubic_and_derivatives(jets: &Jets, [x, y, z]: [f32; 3]) -> (f32, [f32; 3]) {
    let (mut weights, mut slopes) = (Weights::default(), Weights::default());
    basis(x, y, z, &mut weights);
    basis_derivative(x, y, z, &mut slopes);

    let (mut edge, mut by_x, mut by_y) = (Edge::default(), Edge::default(), Edge::default());
    let mut face = Face::ZERO;
    at_x(jets, &weights, &mut face);
    at_y(&face, &weights, &mut edge);
    at_y(&face, &slopes, &mut by_y);
    // In the same room, for the stacks of microcontrollers.
    at_x(jets, &slopes, &mut face);
    at_y(&face, &weights, &mut by_x);

    let derivatives = [at_z(&by_x, &weights), at_z(&by_y, &weights), at_z(&edge, &slopes)];
    (at_z(&edge, &weights), derivatives)
}

/// Weighted sum of two ends.
#[inline]
pub(crate) fn mix(weights: [f32; 2], ends: [f32; 2]) -> f32 {
    ends[0] * weights[0] + ends[1] * weights[1]
}

/// Trilinear value at local coordinates, mesh units.
#[inline]
pub(crate) fn trilinear(distance: &Corners, [x, y, z]: [f32; 3]) -> f32 {
    trilinear_sum(distance, linear(x), linear(y), linear(z))
}

/// Trilinear value and derivatives by local coordinates, mesh units.
#[inline]
pub(crate) fn trilinear_and_derivatives(distance: &Corners, [x, y, z]: [f32; 3]) -> (f32, [f32; 3]) {
    const DERIVATIVE: [f32; 2] = [-1.0, 1.0];
    let (x, y, z) = (linear(x), linear(y), linear(z));
    let by_x = trilinear_sum(distance, DERIVATIVE, y, z);
    let by_y = trilinear_sum(distance, x, DERIVATIVE, z);
    let by_z = trilinear_sum(distance, x, y, DERIVATIVE);
    (trilinear_sum(distance, x, y, z), [by_x, by_y, by_z])
}

#[inline]
fn linear(t: f32) -> [f32; 2] {
    [1.0 - t, t]
}

/// Weighted sum of the corners: the product of the weights along each axis.
#[inline]
pub(crate) fn trilinear_sum(&[a, b, c, d, e, f, g, h]: &Corners, x: [f32; 2], y: [f32; 2], z: [f32; 2]) -> f32 {
    let [a, b, c, d] = [mix(x, [a, e]), mix(x, [b, f]), mix(x, [c, g]), mix(x, [d, h])];
    mix(z, [mix(y, [a, c]), mix(y, [b, d])])
}
