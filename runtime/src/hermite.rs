//! Values and gradients between eight corners.
//!
//! The tensor product is evaluated an axis at a time: x takes the cube's corners to a face, y the
//! face to an edge, z the edge to the point. Each step is a weighted sum whose weights are exactly
//! 0 and 1 at the ends, so on a face of the cube the answer depends on that face's corners alone
//! and comes out the same, bit for bit, from the neighbour of equal size. The derivative along an
//! axis is the same sum with the derivatives of that axis's weights.

/// A number for each corner of a cube, at `4 x + 2 y + z`.
pub(crate) type Corners = [f32; 8];

/// Weights of the values and slopes at the two ends of an axis.
#[derive(Clone, Copy)]
struct Weights {
    value: [f32; 2],
    slope: [f32; 2],
}

impl Weights {
    /// The cubic Hermite basis at `t`.
    #[inline]
    fn value(t: f32) -> Self {
        let rest = 1.0 - t;
        let end = t * t * (3.0 - 2.0 * t);
        Self { value: [1.0 - end, end], slope: [t * (rest * rest), -(t * t) * rest] }
    }

    /// Its derivative.
    #[inline]
    fn derivative(t: f32) -> Self {
        let end = 6.0 * t * (1.0 - t);
        let slope = [(1.0 - t) * (1.0 - 3.0 * t), t * (3.0 * t - 2.0)];
        Self { value: [-end, end], slope }
    }

    /// Weighted sum of the values and slopes at both ends.
    #[inline]
    fn blend<const N: usize>(&self, values: [[f32; N]; 2], slopes: [[f32; N]; 2]) -> [f32; N] {
        let mut sum = mix(self.value, values);
        for (sum, slope) in sum.iter_mut().zip(mix(self.slope, slopes)) {
            *sum += slope;
        }
        sum
    }
}

/// Weighted sum of two ends.
#[inline]
fn mix<const N: usize>(weights: [f32; 2], ends: [[f32; N]; 2]) -> [f32; N] {
    let [mut sum, other] = ends;
    for (sum, other) in sum.iter_mut().zip(other) {
        *sum = *sum * weights[0] + other * weights[1];
    }
    sum
}

/// The ends along x of a cube, each a face along y and z.
#[inline]
fn along_x([a, b, c, d, e, f, g, h]: Corners) -> [[f32; 4]; 2] {
    [[a, b, c, d], [e, f, g, h]]
}

/// The ends along y of a face, each an edge along z.
#[inline]
fn along_y([a, b, c, d]: [f32; 4]) -> [[f32; 2]; 2] {
    [[a, b], [c, d]]
}

/// The ends along z of an edge.
#[inline]
fn along_z([a, b]: [f32; 2]) -> [[f32; 1]; 2] {
    [[a], [b]]
}

/// Distances and first derivatives at the corners of a leaf. All derivatives are by local
/// coordinates, in mesh units.
pub(crate) struct Tricubic {
    pub(crate) distance: Corners,
    /// By x, y, z.
    pub(crate) gradient: [Corners; 3],
}

/// Mixed derivatives at the corners of a leaf: by xy, xz, yz, xyz.
pub(crate) type Mixed = [Corners; 4];

/// A [`Tricubic`] with x given: distances and derivatives by y, z and yz at `2 y + z`.
#[derive(Clone, Copy)]
struct Face {
    distance: [f32; 4],
    y: [f32; 4],
    z: [f32; 4],
    yz: [f32; 4],
}

/// A [`Face`] with y given.
#[derive(Clone, Copy)]
struct Edge {
    distance: [f32; 2],
    z: [f32; 2],
}

impl Tricubic {
    /// Value at local coordinates, mesh units; `mixed` is `None` if all mixed derivatives are zero.
    #[inline]
    pub(crate) fn value(&self, mixed: Option<&Mixed>, [x, y, z]: [f32; 3]) -> f32 {
        let face = self.at_x(mixed, &Weights::value(x));
        face.at_y(&Weights::value(y)).at_z(&Weights::value(z))
    }

    /// Value and derivatives by local coordinates, mesh units. The value has the bits of
    /// [`value`](Self::value).
    #[inline]
    pub(crate) fn value_and_derivatives(&self, mixed: Option<&Mixed>, [x, y, z]: [f32; 3]) -> (f32, [f32; 3]) {
        let (y_weights, z_weights) = (Weights::value(y), Weights::value(z));
        let face = self.at_x(mixed, &Weights::value(x));
        let edge = face.at_y(&y_weights);

        let by_x = self.at_x(mixed, &Weights::derivative(x)).at_y(&y_weights).at_z(&z_weights);
        let by_y = face.at_y(&Weights::derivative(y)).at_z(&z_weights);
        let by_z = edge.at_z(&Weights::derivative(z));
        (edge.at_z(&z_weights), [by_x, by_y, by_z])
    }

    #[inline]
    fn at_x(&self, mixed: Option<&Mixed>, weights: &Weights) -> Face {
        let [by_x, by_y, by_z] = self.gradient.map(along_x);
        let distance = weights.blend(along_x(self.distance), by_x);
        let mut y = mix(weights.value, by_y);
        let mut z = mix(weights.value, by_z);
        let mut yz = [0.0; 4];
        if let Some(mixed) = mixed {
            let [xy, xz, by_yz, xyz] = mixed.map(along_x);
            y = weights.blend(by_y, xy);
            z = weights.blend(by_z, xz);
            yz = weights.blend(by_yz, xyz);
        }
        Face { distance, y, z, yz }
    }
}

impl Face {
    #[inline]
    fn at_y(&self, weights: &Weights) -> Edge {
        Edge {
            distance: weights.blend(along_y(self.distance), along_y(self.y)),
            z: weights.blend(along_y(self.z), along_y(self.yz)),
        }
    }
}

impl Edge {
    #[inline]
    fn at_z(&self, weights: &Weights) -> f32 {
        let [value] = weights.blend(along_z(self.distance), along_z(self.z));
        value
    }
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

#[inline]
fn trilinear_sum(distance: &Corners, x: [f32; 2], y: [f32; 2], z: [f32; 2]) -> f32 {
    let [value] = mix(z, along_z(mix(y, along_y(mix(x, along_x(*distance))))));
    value
}
