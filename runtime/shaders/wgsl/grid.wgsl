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
    var answer: Answer;
    if field.reconstruction == RECONSTRUCTION_NEAREST {
        let upper = local >= vec3(0.5);
        let nearest = cell + select(vec3(0u), vec3(1u), upper);
        answer = polynomial_at(read_polynomial(field, nearest), local - select(vec3(0.0), vec3(1.0), upper), vec4(1.0));
    } else if field.reconstruction != RECONSTRUCTION_HERMITE {
        answer = weighted_polynomials(field, cell, local);
    } else if field.order == 1u {
        answer = hermite_of_samples(field, cell, local);
    } else {
        answer = triquintic(field, cell, local);
    }
    answer.gradient *= field.cells_per_unit;
    return answer;
}

fn vertex_of(cell: vec3<u32>, corner: u32) -> vec3<u32> {
    return cell + vec3(corner >> 2u, (corner >> 1u) & 1u, corner & 1u);
}

// The polynomials of eight samples, weighted trilinearly or smoothly.
fn weighted_polynomials(field: Field, cell: vec3<u32>, local: vec3<f32>) -> Answer {
    let smoothness = select(0u, field.order, field.reconstruction == RECONSTRUCTION_BLEND);
    let factors = factors_of(field);
    // Slopes by local coordinates, then the value.
    var corners: Corners;
    for (var corner = 0u; corner < 8u; corner++) {
        let polynomial = read_polynomial(field, vertex_of(cell, corner));
        let here = polynomial_at(polynomial, local - vec3<f32>(vertex_of(vec3(0u), corner)), factors);
        corners.at[corner] = vec4(here.gradient, here.distance);
    }

    let x = weights_of(smoothness, local.x);
    let y = weights_of(smoothness, local.y);
    let z = weights_of(smoothness, local.z);
    let sum = weighted_sum(corners, x.xy, y.xy, z.xy);
    let by_x = weighted_sum(corners, x.zw, y.xy, z.xy).w;
    let by_y = weighted_sum(corners, x.xy, y.zw, z.xy).w;
    let by_z = weighted_sum(corners, x.xy, y.xy, z.zw).w;
    return Answer(sum.w, vec3(by_x, by_y, by_z) + sum.xyz);
}

// Weights of both ends of an axis whose derivatives vanish there up to the `smoothness`-th, and their derivatives.
fn weights_of(smoothness: u32, t: f32) -> vec4<f32> {
    let rest = 1.0 - t;
    var end = t;
    var slope = 1.0;
    if smoothness == 1u {
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

// Tricubic interpolation of distances and gradients.
fn hermite_of_samples(field: Field, cell: vec3<u32>, local: vec3<f32>) -> Answer {
    var jets: Jets;
    for (var corner = 0u; corner < 8u; corner++) {
        let sample = read_polynomial(field, vertex_of(cell, corner));
        jets.corners[corner] =
            Jet(vec4(sample.constant, sample.first.z, sample.first.y, 0.0), vec4(sample.first.x, 0.0, 0.0, 0.0));
    }
    return tricubic(&jets, local);
}

// The sample at a vertex: the coefficients up to its order, the others zero.
fn read_polynomial(field: Field, vertex: vec3<u32>) -> Polynomial {
    var sample: Polynomial;
    let number = vertex.x + field.counts.x * (vertex.y + field.counts.y * vertex.z);
    sample.constant = read_constant(field, vertex, number);
    if field.order == 0u {
        return sample;
    }

    // As stored.
    if field.sample_precision == PRECISION_PACKED32 {
        sample.first = decode_gradient(word(coefficient(field, number, 0u).x));
    } else {
        sample.first = read_three(field, number, 1u);
    }
    if field.order >= 2u {
        sample.square = read_three(field, number, 4u);
        sample.cross = read_three(field, number, 7u);
    }
    if field.order >= 3u {
        sample.cube = read_three(field, number, 10u);
        sample.mixed = read_three(field, number, 13u);
        sample.more = read_three(field, number, 16u);
        sample.xyz = read_number(field, number, 19u);
    }

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

// The distance of a sample, mesh units.
fn read_constant(field: Field, vertex: vec3<u32>, number: u32) -> f32 {
    let place = coefficient(field, number, 0u);
    if field.sample_precision == PRECISION_F32 {
        return sample_float(place.x);
    }
    var brick = 0u;
    if field.range == RANGE_BRICK {
        let bricks = (field.counts + (BRICK_EDGE - 1u)) / BRICK_EDGE;
        let at = vertex / BRICK_EDGE;
        brick = at.x + bricks.x * (at.y + bricks.y * at.z);
    }
    var code = (word(place.x) >> place.y) & 0xFFFFu;
    if field.sample_precision == PRECISION_PACKED32 && field.order > 0u {
        code = word(place.x) >> DISTANCE_SHIFT;
    }
    return decode_distance(bitcast<i32>(word(field.nodes + brick)), code, field.quantum);
}

fn read_three(field: Field, number: u32, first: u32) -> vec3<f32> {
    return vec3(
        read_number(field, number, first), read_number(field, number, first + 1u), read_number(field, number, first + 2u)
    );
}

// A coefficient of degree 1 or more as stored.
fn read_number(field: Field, number: u32, index: u32) -> f32 {
    let place = coefficient(field, number, index);
    if field.sample_precision == PRECISION_F32 {
        return sample_float(place.x);
    }
    return decode_half(word(place.x) >> place.y);
}

// The word and the bit in it where a coefficient of a sample starts.
fn coefficient(field: Field, number: u32, index: u32) -> vec2<u32> {
    // Coefficients of a sample.
    var count = 1u;
    switch field.order {
        case 0u: {}
        case 1u: { count = 4u; }
        case 2u: { count = 10u; }
        default: { count = 20u; }
    }
    if field.sample_precision == PRECISION_F32 {
        return vec2(field.samples + number * count + index, 0u);
    }
    var half = number * count + index;
    if field.sample_precision == PRECISION_PACKED32 && field.order > 0u {
        // Distance and gradient take two halves together.
        half = number * (count - 2u) + max(index, 2u) - 2u;
    }
    return vec2(field.samples + half / 2u, 16u * (half & 1u));
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

// Triquintic interpolation of samples of order 2, derivatives that they do not have being zero.
fn triquintic(field: Field, cell: vec3<u32>, local: vec3<f32>) -> Answer {
    var sum = Answer(0.0, vec3(0.0));
    for (var corner = 0u; corner < 8u; corner++) {
        let sample = read_polynomial(field, vertex_of(cell, corner));
        let end = vertex_of(vec3(0u), corner);
        let x = quintic(local.x, end.x);
        let y = quintic(local.y, end.y);
        let z = quintic(local.z, end.z);
        sum.distance += quintic_product(sample, x, y, z);
        sum.gradient.x += quintic_product(sample, quintic_slope(local.x, end.x), y, z);
        sum.gradient.y += quintic_product(sample, x, quintic_slope(local.y, end.y), z);
        sum.gradient.z += quintic_product(sample, x, y, quintic_slope(local.z, end.z));
    }
    return sum;
}

fn quintic_product(p: Polynomial, x: vec3<f32>, y: vec3<f32>, z: vec3<f32>) -> f32 {
    return ((p.constant * x.x + p.first.x * x.y + p.square.x * x.z) * y.x
        + (p.first.y * x.x + p.cross.x * x.y) * y.y + p.square.y * x.x * y.z) * z.x
        + ((p.first.z * x.x + p.cross.y * x.y) * y.x + p.cross.z * x.x * y.y) * z.y
        + p.square.z * x.x * y.x * z.z;
}
