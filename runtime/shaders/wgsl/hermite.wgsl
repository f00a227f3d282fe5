// Values and gradients between the eight corners of a cube (SPEC.md §9.3, §9.4), an axis at a time.

// Value and derivatives by local coordinates at a point, mesh units.
struct Jet {
    // f, fz, fy, fyz.
    plain: vec4<f32>,
    // fx, fxz, fxy, fxyz.
    by_x: vec4<f32>,
}

// For each corner 4 x + 2 y + z of a cube.
struct Jets {
    corners: array<Jet, 8>,
}

// Weights of the values at both ends of an axis, then of the slopes.
fn cubic(t: f32) -> vec4<f32> {
    let rest = 1.0 - t;
    let end = t * t * (3.0 - 2.0 * t);
    return vec4(1.0 - end, end, t * (rest * rest), -(t * t) * rest);
}

// Their derivatives.
fn cubic_slope(t: f32) -> vec4<f32> {
    let end = 6.0 * t * (1.0 - t);
    return vec4(-end, end, (1.0 - t) * (1.0 - 3.0 * t), t * (3.0 * t - 2.0));
}

// What is left of the four edges along x, at 2 y + z: F, Fz, Fy, Fyz.
struct Face {
    corners: array<vec4<f32>, 4>,
}

fn at_x(jets: ptr<function, Jets>, weights: vec4<f32>) -> Face {
    var face: Face;
    for (var edge = 0; edge < 4; edge++) {
        let near = (*jets).corners[edge];
        let far = (*jets).corners[edge + 4];
        face.corners[edge] =
            (near.plain * weights.x + far.plain * weights.y) + (near.by_x * weights.z + far.by_x * weights.w);
    }
    return face;
}

// Value and slope at both ends along z: near, near slope, far, far slope.
fn at_y(face: Face, weights: vec4<f32>) -> vec4<f32> {
    let near_y = vec4(face.corners[0].xy, face.corners[1].xy);
    let far_y = vec4(face.corners[2].xy, face.corners[3].xy);
    let near_y_slope = vec4(face.corners[0].zw, face.corners[1].zw);
    let far_y_slope = vec4(face.corners[2].zw, face.corners[3].zw);
    return (near_y * weights.x + far_y * weights.y) + (near_y_slope * weights.z + far_y_slope * weights.w);
}

fn at_z(edge: vec4<f32>, weights: vec4<f32>) -> f32 {
    return (edge.x * weights.x + edge.z * weights.y) + (edge.y * weights.z + edge.w * weights.w);
}

// The tensor product of cubics; derivatives by local coordinates.
fn tricubic(jets: ptr<function, Jets>, local: vec3<f32>) -> Answer {
    let face = at_x(jets, cubic(local.x));
    let along_y = cubic(local.y);
    let along_z = cubic(local.z);
    let edge = at_y(face, along_y);
    let by_x = at_z(at_y(at_x(jets, cubic_slope(local.x)), along_y), along_z);
    let by_y = at_z(at_y(face, cubic_slope(local.y)), along_z);
    let by_z = at_z(edge, cubic_slope(local.z));
    return Answer(at_z(edge, along_z), vec3(by_x, by_y, by_z));
}

// Something for each corner 4 x + 2 y + z of a cube.
struct Corners {
    at: array<vec4<f32>, 8>,
}

// Sum of the corners by the products of the weights of both ends of each axis.
fn weighted_sum(corners: Corners, x: vec2<f32>, y: vec2<f32>, z: vec2<f32>) -> vec4<f32> {
    let a = corners.at[0] * x.x + corners.at[4] * x.y;
    let b = corners.at[1] * x.x + corners.at[5] * x.y;
    let c = corners.at[2] * x.x + corners.at[6] * x.y;
    let d = corners.at[3] * x.x + corners.at[7] * x.y;
    return (a * y.x + c * y.y) * z.x + (b * y.x + d * y.y) * z.y;
}
