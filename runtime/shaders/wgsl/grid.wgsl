// Uniform grids (SPEC.md §11).

// A polynomial around a sample by local coordinates of a cell, mesh units.
struct Polynomial {
    constant: f32,
    // x, y, z.
    first: vec3<f32>,
    // xx, yy, zz, and xy, xz, yz.
    square: vec3<f32>,
    cross: vec3<f32>,
    // xxx, yyy, zzz, then xxy, xxz, xyy, then xzz, yyz, yzz, then xyz.
    cube: vec3<f32>,
    mixed: vec3<f32>,
    more: vec3<f32>,
    xyz: f32,
}

fn evaluate_grid(field: Field, position: vec3<f32>) -> Answer {
    let cell = min(vec3<u32>(position), field.cells - 1u);
    let local = position - vec3<f32>(cell);
    let is_hermite = field.reconstruction == RECONSTRUCTION_HERMITE;
    let factors = factors_of(field);

    // What each reconstruction makes of a sample. A branch of its own for each would read it in several places, and
    // compilers of shaders write all of the reading out at each.
    var weighted: Corners;
    var jets: Jets;
    var quintics = Answer(0.0, vec3(0.0));
    for (var corner = 0u; corner < 8u; corner++) {
        let end = vec3(corner >> 2u, (corner >> 1u) & 1u, corner & 1u);
        let sample = read_polynomial(field, cell + end);
        if !is_hermite {
            let here = polynomial_at(sample, local - vec3<f32>(end), factors);
            weighted.at[corner] = vec4(here.gradient, here.distance);
        } else if field.order == 1u {
            let plain = vec4(sample.constant, sample.first.z, sample.first.y, 0.0);
            jets.corners[corner] = Jet(plain, vec4(sample.first.x, 0.0, 0.0, 0.0));
        } else {
            let part = quintic_part(sample, local, end);
            quintics = Answer(quintics.distance + part.distance, quintics.gradient + part.gradient);
        }
    }

    var answer = quintics;
    if !is_hermite {
        answer = weighted_answer(field, weighted, local);
    } else if field.order == 1u {
        answer = tricubic(&jets, local);
    }
    answer.gradient *= field.cells_per_unit;
    return answer;
}

// The polynomials of eight samples, weighted trilinearly, smoothly, or by which is nearest.
fn weighted_answer(field: Field, corners: Corners, local: vec3<f32>) -> Answer {
    let x = weights_of(field, local.x);
    let y = weights_of(field, local.y);
    let z = weights_of(field, local.z);
    let sum = weighted_sum(corners, x.xy, y.xy, z.xy);
    let by_x = weighted_sum(corners, x.zw, y.xy, z.xy).w;
    let by_y = weighted_sum(corners, x.xy, y.zw, z.xy).w;
    let by_z = weighted_sum(corners, x.xy, y.xy, z.zw).w;
    return Answer(sum.w, vec3(by_x, by_y, by_z) + sum.xyz);
}

// Weights of both ends of an axis, and their derivatives: those of a smooth step vanish up to the samples' order.
fn weights_of(field: Field, t: f32) -> vec4<f32> {
    let smoothness = select(0u, field.order, field.reconstruction == RECONSTRUCTION_BLEND);
    let rest = 1.0 - t;
    var end = t;
    var slope = 1.0;
    if field.reconstruction == RECONSTRUCTION_NEAREST {
        // A point midway belongs to the greater sample.
        end = select(0.0, 1.0, t >= 0.5);
        slope = 0.0;
    } else if smoothness == 1u {
        end = t * t * (3.0 - 2.0 * t);
        slope = 6.0 * t * rest;
    } else if smoothness == 2u {
        end = t * t * t * (10.0 - t * (15.0 - 6.0 * t));
        slope = 30.0 * (t * t) * (rest * rest);
    } else if smoothness == 3u {
        let square = t * t;
        let cube = t * rest * (t * rest) * (t * rest);
        end = square * square * (35.0 - t * (84.0 - t * (70.0 - 20.0 * t)));
        slope = 140.0 * cube;
    }
    return vec4(1.0 - end, end, -slope, slope);
}

// Share of its terms of each degree that a sample contributes.
fn factors_of(field: Field) -> vec4<f32> {
    if field.reconstruction != RECONSTRUCTION_HALF {
        return vec4(1.0);
    }
    switch field.order {
        case 1u: { return vec4(1.0, 0.5, 0.0, 0.0); }
        case 2u: { return vec4(1.0, 2.0 / 3.0, 1.0 / 3.0, 0.0); }
        default: { return vec4(1.0, 0.75, 0.5, 0.25); }
    }
}

// The sample at a vertex: the coefficients up to its order, the others zero.
fn read_polynomial(field: Field, vertex: vec3<u32>) -> Polynomial {
    let number = vertex.x + field.counts.x * (vertex.y + field.counts.y * vertex.z);
    let count = coefficients_of(field);
    let is_float = field.sample_precision == PRECISION_F32;
    // Of packed samples above order 0, a word is distance and gradient: four coefficients in two halves.
    let is_packed = field.sample_precision == PRECISION_PACKED32 && field.order > 0u;

    // As stored. The halves of a packed sample are its word's, then those of coefficients 4 and up.
    var stored: array<f32, 20>;
    var first = 0u;
    let skipped = select(0u, 2u, is_packed);
    for (var half = 0u; half < count - skipped; half++) {
        let place = number * (count - skipped) + half;
        let bits = word(field.samples + select(place / 2u, place, is_float)) >> select(16u * (place & 1u), 0u, is_float);
        if half == 0u {
            first = bits;
        }
        stored[half + skipped] = decode_half(bits);
        if is_float {
            stored[half] = decode_float(bits);
        }
    }
    if is_packed {
        let gradient = decode_gradient(first);
        stored[1] = gradient.x;
        stored[2] = gradient.y;
        stored[3] = gradient.z;
    }
    if !is_float {
        let code = select(first & 0xFFFFu, first >> DISTANCE_SHIFT, is_packed);
        stored[0] = decode_distance(base_of(field, vertex), code, field.quantum);
    }

    var sample: Polynomial;
    sample.constant = stored[0];
    sample.first = vec3(stored[1], stored[2], stored[3]);
    sample.square = vec3(stored[4], stored[5], stored[6]);
    sample.cross = vec3(stored[7], stored[8], stored[9]);
    sample.cube = vec3(stored[10], stored[11], stored[12]);
    sample.mixed = vec3(stored[13], stored[14], stored[15]);
    sample.more = vec3(stored[16], stored[17], stored[18]);
    sample.xyz = stored[19];

    // To local coordinates.
    let s = field.spacing;
    let r = s / max(max(s.x, s.y), s.z);
    sample.first *= s;
    sample.square *= s * r;
    sample.cross *= s.xxy * r.yzz;
    sample.cube *= s * r * r;
    sample.mixed *= s.xxx * r.xxy * r.yzy;
    sample.more *= s.xyy * r.zyz * r.zzz;
    sample.xyz *= s.x * r.y * r.z;
    return sample;
}

// Base distance of the sample at a vertex, in quanta.
fn base_of(field: Field, vertex: vec3<u32>) -> i32 {
    var brick = 0u;
    if field.range == RANGE_BRICK {
        let bricks = (field.counts + (BRICK_EDGE - 1u)) / BRICK_EDGE;
        let at = vertex / BRICK_EDGE;
        brick = at.x + bricks.x * (at.y + bricks.y * at.z);
    }
    return bitcast<i32>(word(field.nodes + brick));
}

// Coefficients of a sample.
fn coefficients_of(field: Field) -> u32 {
    switch field.order {
        case 0u: { return 1u; }
        case 1u: { return 4u; }
        case 2u: { return 10u; }
        default: { return 20u; }
    }
}

// Value and derivatives at an offset from the sample, the terms of each degree times a factor.
fn polynomial_at(p: Polynomial, at: vec3<f32>, factors: vec4<f32>) -> Answer {
    let x = at.x;
    let y = at.y;
    let z = at.z;
    let first = p.first.x * x + p.first.y * y + p.first.z * z;
    let second = (p.square.x * x + p.cross.x * y + p.cross.y * z) * x + (p.square.y * y + p.cross.z * z) * y
        + p.square.z * (z * z);
    let third = ((p.cube.x * x + p.mixed.x * y + p.mixed.y * z) * x + (p.mixed.z * y + p.xyz * z) * y
        + p.more.x * (z * z)) * x
        + ((p.cube.y * y + p.more.y * z) * y + p.more.z * (z * z)) * y
        + p.cube.z * (z * z * z);
    let value = p.constant * factors.x + first * factors.y + second * factors.z + third * factors.w;

    let by_x = p.first.x * factors.y + (2.0 * p.square.x * x + p.cross.x * y + p.cross.y * z) * factors.z
        + ((3.0 * p.cube.x * x + 2.0 * (p.mixed.x * y + p.mixed.y * z)) * x + (p.mixed.z * y + p.xyz * z) * y
            + p.more.x * (z * z)) * factors.w;
    let by_y = p.first.y * factors.y + (2.0 * p.square.y * y + p.cross.x * x + p.cross.z * z) * factors.z
        + ((3.0 * p.cube.y * y + 2.0 * (p.mixed.z * x + p.more.y * z)) * y + (p.mixed.x * x + p.xyz * z) * x
            + p.more.z * (z * z)) * factors.w;
    let by_z = p.first.z * factors.y + (2.0 * p.square.z * z + p.cross.y * x + p.cross.z * y) * factors.z
        + ((3.0 * p.cube.z * z + 2.0 * (p.more.x * x + p.more.z * y)) * z + (p.mixed.y * x + p.xyz * y) * x
            + p.more.y * (y * y)) * factors.w;
    return Answer(value, vec3(by_x, by_y, by_z));
}

// Weights of a value, a slope and half a second derivative at one end of an axis.
fn quintic(t: f32, end: u32) -> vec3<f32> {
    let rest = 1.0 - t;
    let cube = t * t * t;
    let rest_cube = rest * rest * rest;
    let far = cube * (10.0 - t * (15.0 - 6.0 * t));
    let near_weights = vec3(1.0 - far, t * rest_cube * (1.0 + 3.0 * t), t * t * rest_cube);
    let far_weights = vec3(far, -cube * rest * (4.0 - 3.0 * t), cube * (rest * rest));
    return select(near_weights, far_weights, vec3(end == 1u));
}

// Their derivatives.
fn quintic_slope(t: f32, end: u32) -> vec3<f32> {
    let rest = 1.0 - t;
    let square = t * t;
    let rest_square = rest * rest;
    let far = 30.0 * square * rest_square;
    let near_weights =
        vec3(-far, rest_square * (1.0 + t * (2.0 - 15.0 * t)), t * rest_square * (2.0 - 5.0 * t));
    let far_weights = vec3(far, square * (t * (28.0 - 15.0 * t) - 12.0), square * rest * (3.0 - 5.0 * t));
    return select(near_weights, far_weights, vec3(end == 1u));
}

// What a sample of order 2 adds to the triquintic, derivatives that it does not have being zero.
fn quintic_part(sample: Polynomial, local: vec3<f32>, end: vec3<u32>) -> Answer {
    let x = quintic(local.x, end.x);
    let y = quintic(local.y, end.y);
    let z = quintic(local.z, end.z);
    let by_x = quintic_product(sample, quintic_slope(local.x, end.x), y, z);
    let by_y = quintic_product(sample, x, quintic_slope(local.y, end.y), z);
    let by_z = quintic_product(sample, x, y, quintic_slope(local.z, end.z));
    return Answer(quintic_product(sample, x, y, z), vec3(by_x, by_y, by_z));
}

fn quintic_product(p: Polynomial, x: vec3<f32>, y: vec3<f32>, z: vec3<f32>) -> f32 {
    return ((p.constant * x.x + p.first.x * x.y + p.square.x * x.z) * y.x
        + (p.first.y * x.x + p.cross.x * x.y) * y.y + p.square.y * x.x * y.z) * z.x
        + ((p.first.z * x.x + p.cross.y * x.y) * y.x + p.cross.z * x.x * y.y) * z.y
        + p.square.z * x.x * y.x * z.z;
}
