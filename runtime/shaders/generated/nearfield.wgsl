// Made from the parts in `runtime/shaders/wgsl` by `cargo run` there. Do not edit.

// The bytes of a file, as they are, in a storage buffer.

@group(0) @binding(0) var<storage, read> words: array<u32>;

// Little-endian word of the file; 0 beyond its end.
fn word(index: u32) -> u32 {
    if index < arrayLength(&words) {
        return words[index];
    }
    return 0u;
}

// The door: the bytes of a file in, distance and gradient out.
//
//     let field = nearfield_open();                      once an invocation
//     let answer = nearfield_evaluate(field, point);     as often as needed
//
// The file must have been checked before (`Field::open` and `Field::validate`, or a trusted source): a shader can neither
// sum a file nor refuse it. Every loop ends, but a file that breaks the rules may make one long.

// What a query needs to know of a file.
struct Field {
    // One of FAMILY_.
    family: u32,
    // The box, mesh units, mesh frame.
    low: vec3<f32>,
    high: vec3<f32>,
    // Cells of the root grid along each axis; of a grid, samples.
    counts: vec3<u32>,
    // Finest cells along each axis; of a grid, those between its samples.
    cells: vec3<u32>,
    // The same per mesh unit.
    cells_per_unit: vec3<f32>,
    // Edge of a root cell along each axis, mesh units; of a grid, distance between its samples.
    spacing: vec3<f32>,
    // Unit of stored distances or coefficients, mesh units.
    quantum: f32,
    // Levels below the root grid.
    depth: u32,
    // One of INTERPOLANT_; of a grid, one of RECONSTRUCTION_.
    reconstruction: u32,
    // Of a grid: order and PRECISION_ of the samples, and one of RANGE_.
    order: u32,
    sample_precision: u32,
    range: u32,
    // Of a polynomial octree: bits of a shape's number, and how far leaves overlap, as a share of their edges.
    shape_bits: u32,
    overlap: f32,
    // Words where sections start: nodes, bases or root words; samples or leaves; shapes; records.
    nodes: u32,
    samples: u32,
    shapes: u32,
    records: u32,
}

// Signed distance, mesh units, negative inside, and gradient, without unit. Inside the box the gradient is the derivative
// of the reconstruction, near 1 in length; outside it is the unit vector from the nearest point of the box.
struct Answer {
    distance: f32,
    gradient: vec3<f32>,
}

// Reads the parameters of the file. A few dozen words, the same for all invocations.
fn nearfield_open() -> Field {
    var field: Field;
    field.family = byte_of(word(FAMILY_WORD), FAMILY_BYTE);
    field.low = vec3(float(BOX_MIN_WORD), float(BOX_MIN_WORD + 1u), float(BOX_MIN_WORD + 2u));
    field.high = vec3(float(BOX_MAX_WORD), float(BOX_MAX_WORD + 1u), float(BOX_MAX_WORD + 2u));

    var parameters = 0u;
    let count = byte_of(word(SECTION_COUNT_WORD), SECTION_COUNT_BYTE);
    for (var index = 0u; index < min(count, MAX_SECTIONS); index++) {
        let entry = TABLE_WORD + SECTION_WORDS * index;
        let start = word(entry + 1u) / 4u;
        switch word(entry) {
            case SECTION_OCTREE: { if field.family == FAMILY_OCTREE { parameters = start; } }
            case SECTION_GRID: { if field.family == FAMILY_GRID { parameters = start; } }
            case SECTION_POLYNOMIAL: { if field.family == FAMILY_POLYNOMIAL { parameters = start; } }
            case SECTION_NODES: { if field.family == FAMILY_OCTREE { field.nodes = start; } }
            case SECTION_BASES: { if field.family == FAMILY_GRID { field.nodes = start; } }
            case SECTION_ROOTS: { if field.family == FAMILY_POLYNOMIAL { field.nodes = start; } }
            case SECTION_SAMPLES: { if field.family != FAMILY_POLYNOMIAL { field.samples = start; } }
            case SECTION_LEAVES: { if field.family == FAMILY_POLYNOMIAL { field.samples = start; } }
            case SECTION_SHAPES: { field.shapes = start; }
            case SECTION_RECORDS: { field.records = start; }
            default: {}
        }
    }

    let first = word(parameters);
    let second = word(parameters + 1u);
    let third = word(parameters + 2u);
    field.counts = vec3(first & 0xFFFFu, first >> 16u, second & 0xFFFFu);
    if field.family == FAMILY_GRID {
        field.order = byte_of(second, 2u);
        field.reconstruction = byte_of(second, 3u);
        field.sample_precision = byte_of(third, 0u);
        field.range = byte_of(third, 1u);
        field.cells = field.counts - 1u;
        field.spacing = vec3(float(parameters + 3u), float(parameters + 4u), float(parameters + 5u));
        field.cells_per_unit = 1.0 / field.spacing;
        field.quantum = float(parameters + 6u);
    } else {
        field.depth = min(byte_of(second, 2u), MAX_DEPTH);
        field.reconstruction = byte_of(second, 3u);
        field.shape_bits = byte_of(second, 3u);
        field.cells = field.counts << vec3(field.depth);
        field.spacing = vec3(float(parameters + 3u));
        field.cells_per_unit = vec3(f32(1u << field.depth) / field.spacing.x);
        field.quantum = float(parameters + 4u);
        if field.family == FAMILY_POLYNOMIAL {
            field.overlap = float(parameters + 5u);
        }
    }
    return field;
}

// Upper bound of the slope of the field inside its box.
fn nearfield_slope() -> f32 {
    return float(LIPSCHITZ_WORD);
}

// How far the field was found to be from the mesh at most, mesh units; 0 if nobody measured.
fn nearfield_error() -> f32 {
    if word(SAMPLE_COUNT_WORD) == 0u {
        return 0.0;
    }
    return max(float(UNIFORM_MAX_WORD), float(BAND_MAX_WORD));
}

// Signed distance at a point, mesh units.
fn nearfield_distance(field: Field, point: vec3<f32>) -> f32 {
    return nearfield_evaluate(field, point).distance;
}

// Signed distance and gradient at a point.
fn nearfield_evaluate(field: Field, point: vec3<f32>) -> Answer {
    let bits = bitcast<vec3<u32>>(point) & vec3(0x7FFFFFFFu);
    if any(bits >= vec3(0x7F800000u)) {
        return answer_without_end(bits, point);
    }

    let nearest = min(max(point, field.low), field.high);
    var answer = answer_inside(field, nearest);
    if any(nearest != point) {
        let away = length_and_direction(point - nearest);
        answer.distance = finite(answer.distance + away.distance);
        answer.gradient = away.gradient;
    }
    return answer;
}

// The answer at a point of the box.
fn answer_inside(field: Field, point: vec3<f32>) -> Answer {
    return answer_at(field, min((point - field.low) * field.cells_per_unit, vec3<f32>(field.cells)));
}

// The answer at a point with a coordinate that is infinite or not a number. Told apart by their bits: compilers of
// shaders may take it that there are none.
fn answer_without_end(bits: vec3<u32>, point: vec3<f32>) -> Answer {
    if any(bits > vec3(0x7F800000u)) {
        let nan = bitcast<f32>(max(max(bits.x, bits.y), bits.z));
        return Answer(nan, vec3(nan));
    }
    let signs = bitcast<vec3<u32>>(point) & vec3(0x80000000u);
    let ones = bitcast<vec3<f32>>(signs | vec3(0x3F800000u));
    let toward = select(vec3(0.0), ones, bits == vec3(0x7F800000u));
    return Answer(bitcast<f32>(max(max(bits.x, bits.y), bits.z)), length_and_direction(toward).gradient);
}

// The answer at a position in the box, in finest cells from its least corner.
fn answer_at(field: Field, position: vec3<f32>) -> Answer {
    switch field.family {
        case FAMILY_GRID: { return evaluate_grid(field, position); }
        case FAMILY_OCTREE: { return evaluate_octree(field, position); }
        default: { return evaluate_polynomial_octree(field, position); }
    }
}

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

// Octrees of interpolants (SPEC.md §5 to §7, §9).

// A sample block: its header, and the word after it.
struct Block {
    // Which lattice samples are there, and which of them are full.
    present: u32,
    full: u32,
    sample_precision: u32,
    base: i32,
    first: u32,
    // Units of the samples of the leaf: of distances, and of derivatives by local coordinates.
    quantum: f32,
    edge: f32,
}

fn evaluate_octree(field: Field, position: vec3<f32>) -> Answer {
    // Down the tree.
    let cell = min(vec3<u32>(position), field.cells - 1u);
    var node = word(field.nodes + root_of(field, cell));
    var shift = field.depth;
    var octant = 0u;
    while node >> NODE_OFFSET_BITS == NODE_INNER && shift > 0u {
        shift -= 1u;
        octant = octant_of(cell, shift);
        node = word(field.nodes + (node & NODE_OFFSET_MASK) + octant);
    }
    let local = (position - vec3<f32>((cell >> vec3(shift)) << vec3(shift))) * power_of_half(shift);
    let level = field.depth - shift;

    let start = field.samples + (node & NODE_OFFSET_MASK);
    var block: Block;
    let first = word(start);
    block.present = first & LATTICE_MASK;
    block.sample_precision = (first >> PRECISION_SHIFT) & 3u;
    block.full = word(start + 1u) & LATTICE_MASK;
    block.base = bitcast<i32>(word(start + 2u));
    block.first = start + 3u;
    block.quantum = field.quantum * power_of_half(level);
    block.edge = field.spacing.x * power_of_half(level);

    var jets = read_corners(field.reconstruction, block, octant);
    var answer: Answer;
    if field.reconstruction == INTERPOLANT_TRICUBIC {
        answer = tricubic(&jets, local);
    } else {
        answer = trilinear(jets, local);
    }
    answer.gradient *= 1.0 / block.edge;
    return answer;
}

fn trilinear(jets: Jets, local: vec3<f32>) -> Answer {
    var corners: Corners;
    for (var corner = 0; corner < 8; corner++) {
        corners.at[corner] = jets.corners[corner].plain;
    }
    let x = vec2(1.0 - local.x, local.x);
    let y = vec2(1.0 - local.y, local.y);
    let z = vec2(1.0 - local.z, local.z);
    let slope = vec2(-1.0, 1.0);
    let by_x = weighted_sum(corners, slope, y, z).x;
    let by_y = weighted_sum(corners, x, slope, z).x;
    let by_z = weighted_sum(corners, x, y, slope).x;
    return Answer(weighted_sum(corners, x, y, z).x, vec3(by_x, by_y, by_z));
}

// The jets at the corners of a leaf; of a trilinear one only the distances.
fn read_corners(interpolant: u32, block: Block, octant: u32) -> Jets {
    var jets: Jets;
    var implied = 0u;
    for (var corner = 0u; corner < 8u; corner++) {
        let along = vec3(corner >> 2u, (corner >> 1u) & 1u, corner & 1u);
        let at = along + vec3(octant & 1u, (octant >> 1u) & 1u, octant >> 2u);
        var source = 1u << (at.x + 3u * at.y + 9u * at.z);
        if (block.present & source) == 0u {
            // Implied: the parent's corner on the same side is where to start from.
            implied |= 1u << corner;
            source = 1u << (2u * along.x + 6u * along.y + 18u * along.z);
        }
        jets.corners[corner] = read_jet(interpolant, block, source);
    }
    if implied != 0u {
        settle(&jets, implied, octant, 0u);
        settle(&jets, implied, octant, 1u);
        settle(&jets, implied, octant, 2u);
    }
    return jets;
}

// The sample of a lattice bit.
fn read_jet(interpolant: u32, block: Block, source: u32) -> Jet {
    let before = source - 1u;
    let rank = count_bits(block.present & before);
    let full_rank = count_bits(block.full & before);
    let is_full = (block.full & source) != 0u;
    let is_float = block.sample_precision == PRECISION_F32;
    let is_trilinear = interpolant != INTERPOLANT_TRICUBIC;

    // Its words.
    let stride = select(select(1u, 2u, block.sample_precision == PRECISION_F16), 4u, is_float);
    let full_stride = select(4u, 8u, is_float);
    var place = rank * stride + full_rank * (full_stride - stride);
    var count = select(stride, full_stride, is_full);
    if is_trilinear {
        place = select(rank / 2u, rank, is_float);
        count = 1u;
    }
    var words: array<u32, 8>;
    for (var index = 0u; index < count; index++) {
        words[index] = word(block.first + place + index);
    }

    var distance: f32;
    var gradient = vec3(0.0);
    // xy, xz, yz, xyz.
    var mixed = vec4(0.0);
    if is_float {
        distance = decode_float(words[0]);
        gradient = vec3(decode_float(words[1]), decode_float(words[2]), decode_float(words[3]));
        mixed = vec4(decode_float(words[4]), decode_float(words[5]), decode_float(words[6]), decode_float(words[7]));
    } else if block.sample_precision == PRECISION_PACKED32 && !is_full && !is_trilinear {
        distance = decode_distance(block.base, words[0] >> DISTANCE_SHIFT, block.quantum);
        gradient = decode_gradient(words[0]);
    } else {
        let half = words[0] >> select(0u, 16u * (rank & 1u), is_trilinear);
        distance = decode_distance(16 * block.base, half & 0xFFFFu, block.quantum * 0.0625);
        gradient = vec3(decode_half(words[0] >> 16u), decode_halves(words[1]));
        mixed = vec4(decode_halves(words[2]), decode_halves(words[3]));
    }
    if is_trilinear {
        return Jet(vec4(distance, 0.0, 0.0, 0.0), vec4(0.0));
    }
    gradient *= block.edge;
    mixed *= block.edge;
    return Jet(vec4(distance, gradient.z, gradient.y, mixed.z), vec4(gradient.x, mixed.y, mixed.x, mixed.w));
}

// Moves the implied corners away from the parent's own along an axis to the middle of the parent's edge (§7.3).
fn settle(jets: ptr<function, Jets>, implied: u32, octant: u32, axis: u32) {
    let bit = 4u >> axis;
    let end = select(bit, 0u, ((octant >> axis) & 1u) == 1u);
    for (var corner = 0u; corner < 8u; corner++) {
        if (corner & bit) == end && ((implied >> corner) & 1u) == 1u {
            let near = (*jets).corners[corner & ~bit];
            let far = (*jets).corners[corner | bit];
            (*jets).corners[corner] = middle(near, far, axis);
        }
    }
}

// The jet in the middle of a cubic that spans two leaves, from those at its ends.
fn middle(near: Jet, far: Jet, axis: u32) -> Jet {
    let sum = Jet(near.plain + far.plain, near.by_x + far.by_x);
    let change = Jet(near.plain - far.plain, near.by_x - far.by_x);
    if axis == 0u {
        return Jet(0.5 * sum.plain + 0.25 * change.by_x, -0.25 * sum.by_x + -0.75 * change.plain);
    }
    if axis == 1u {
        let by_sum = vec4(0.5, 0.5, -0.25, -0.25);
        let by_change = vec4(0.25, 0.25, -0.75, -0.75);
        return Jet(
            by_sum * sum.plain + by_change * change.plain.zwxy, by_sum * sum.by_x + by_change * change.by_x.zwxy
        );
    }
    let by_sum = vec4(0.5, -0.25, 0.5, -0.25);
    let by_change = vec4(0.25, -0.75, 0.25, -0.75);
    return Jet(by_sum * sum.plain + by_change * change.plain.yxwz, by_sum * sum.by_x + by_change * change.by_x.yxwz);
}

// Octrees of polynomials (SPEC.md §12).

// A leaf that holds a finest cell.
struct Leaf {
    // Byte in the section of leaves.
    place: u32,
    // Least corner, in finest cells, and edge as a power of two.
    cell: vec3<u32>,
    shift: u32,
}

// What comes before the coefficients of a leaf.
struct LeafHead {
    // The two words of its shape.
    kind_and_degrees: u32,
    widths: u32,
    // Codes of SPEC.md §12.6.
    support: u32,
    reach: u32,
}

fn find_leaf(field: Field, cell: vec3<u32>) -> Leaf {
    var node = word(field.nodes + root_of(field, cell));
    var shift = field.depth;
    while (node & ROOT_LEAF) == 0u && shift > 0u {
        shift -= 1u;
        node = child_node(field, node, octant_of(cell, shift));
    }
    return Leaf(node & ~ROOT_LEAF, (cell >> vec3(shift)) << vec3(shift), shift);
}

// Nodes are as root words have them: the byte of a leaf and a bit, or the number of a record.

fn child_node(field: Field, record: u32, octant: u32) -> u32 {
    // Records start at even bytes: four words hold one, in their lower or upper fourteen bytes.
    let start = field.records + (RECORD_LENGTH * record) / 4u;
    let shift = 8u * ((RECORD_LENGTH * record) & 3u);
    var words: array<u32, 4>;
    for (var index = 0u; index < 4u; index++) {
        words[index] = word(start + index);
    }
    let inner_and_starts =
        vec2(joined(words[0], words[1], shift), joined(words[1], words[2], shift));
    let first = vec2(joined(words[2], words[3], shift), words[3] >> shift);

    let own = (inner_and_starts[octant >> 2u] >> (8u * (octant & 3u))) & 0xFFu;
    let before = select(own, 0u, octant == 0u);
    if ((inner_and_starts.x >> octant) & 1u) == 1u {
        return (first.x & RECORD_CHILD_MASK) + before;
    }
    let leaf = joined(first.x, first.y, RECORD_CHILD_BITS) & RECORD_LEAF_MASK;
    return ROOT_LEAF | (leaf + before);
}

// 32 bits from a bit of the lower of two words on.
fn joined(lower: u32, upper: u32, bit: u32) -> u32 {
    return (lower >> bit) | ((upper << 1u) << (31u - bit));
}

// 32 bits from a bit on, counted from a word of a section.
fn bits_at(section: u32, bit: u32, index: u32) -> u32 {
    let at = section + index + bit / 32u;
    return joined(word(at), word(at + 1u), bit & 31u);
}

// Local coordinates, -1 to 1 within the leaf.
fn local_of(leaf: Leaf, position: vec3<f32>) -> vec3<f32> {
    return (position - vec3<f32>(leaf.cell)) * (2.0 * power_of_half(leaf.shift)) - 1.0;
}

// Edge of a leaf, mesh units.
fn edge_of(field: Field, leaf: Leaf) -> f32 {
    return field.spacing.x * power_of_half(field.depth - leaf.shift);
}

fn read_head(field: Field, place: u32) -> LeafHead {
    let bits = bits_at(field.samples, 8u * (place & 3u), place / 4u);
    let shape = field.shapes + 2u * (bits & ((1u << field.shape_bits) - 1u));
    let codes = bits >> field.shape_bits;
    return LeafHead(word(shape), word(shape + 1u), codes & 3u, (codes >> SUPPORT_BITS) & 3u);
}

// Value and gradient of a leaf alone.
fn evaluate_leaf(field: Field, leaf: Leaf, head: LeafHead, local: vec3<f32>) -> Answer {
    let kind = byte_of(head.kind_and_degrees, 0u);
    let exponent = byte_of(head.kind_and_degrees, 3u) & MAX_EXPONENT;
    let step = field.quantum * bitcast<f32>((127u + exponent) << 23u);

    var bit = 8u * (leaf.place & 3u) + field.shape_bits + select(OVERLAP_BITS, 0u, field.overlap == 0.0);
    var answer = Answer(0.0, vec3(0.0));
    for (var index = 0u; index < select(2u, 1u, kind == KIND_SINGLE); index++) {
        let degree = byte_of(head.kind_and_degrees, 1u + index);
        let terms = read_terms(field, leaf.place / 4u, bit, degree, head.widths);
        bit = terms.end;
        let other = evaluate_terms(terms, degree, local);
        let is_less = other.distance < answer.distance;
        let is_greater = other.distance > answer.distance;
        if index == 0u || (kind == KIND_MIN && is_less) || (kind != KIND_MIN && is_greater) {
            answer = other;
        }
    }
    let per_half = 2.0 / edge_of(field, leaf);
    return Answer(answer.distance * step, answer.gradient * step * per_half);
}

// The coefficients of a polynomial, in steps, by axes: those that belong to none are in the fourth lane.
struct Terms {
    // x y z 1.
    linear: vec4<f32>,
    // P2(x) P2(y) P2(z).
    square: vec4<f32>,
    // xy yz zx.
    cross: vec4<f32>,
    // P3(x) P3(y) P3(z) xyz.
    cube: vec4<f32>,
    // P2(x) y and so on, P2(x) z and so on.
    next: vec4<f32>,
    previous: vec4<f32>,
    // The bit after the last one.
    end: u32,
}

fn read_terms(field: Field, index: u32, start: u32, degree: u32, widths: u32) -> Terms {
    // In the order of the file.
    var codes: array<f32, 20>;
    var bit = start;
    var number = 0u;
    for (var of_degree = 0u; of_degree <= min(degree, 3u); of_degree++) {
        let width = byte_of(widths, of_degree) & 31u;
        let size = 1u << width;
        // 1, 4, 10, 20.
        let end = (of_degree + 1u) * (of_degree + 2u) * (of_degree + 3u) / 6u;
        for (; number < end; number++) {
            let code = bits_at(field.samples, bit, index) & (size - 1u);
            codes[number] = f32(i32(code) - i32(size >> 1u));
            bit += width;
        }
    }

    var terms: Terms;
    terms.linear = vec4(codes[1], codes[2], codes[3], codes[0]);
    terms.square = vec4(codes[4], codes[5], codes[6], 0.0);
    terms.cross = vec4(codes[7], codes[8], codes[9], 0.0);
    terms.cube = vec4(codes[10], codes[11], codes[12], codes[19]);
    terms.next = vec4(codes[13], codes[14], codes[15], 0.0);
    terms.previous = vec4(codes[16], codes[17], codes[18], 0.0);
    terms.end = bit;
    return terms;
}

// Value and derivatives of a sum of products of Legendre polynomials, in steps.
fn evaluate_terms(terms: Terms, degree: u32, local: vec3<f32>) -> Answer {
    let first = vec4(local, 1.0);
    let next = vec4(local.yzx, 0.0);
    let previous = vec4(local.zxy, 0.0);
    let second = vec4((1.5 * (first * first) - 0.5).xyz, 0.0);
    let third = vec4((first * (2.5 * (first * first) - 1.5)).xyz, local.x * local.y * local.z);

    var value = terms.linear * first;
    var slope = terms.linear;
    if degree >= 2u {
        let line = terms.linear + terms.cross * next;
        var square = terms.square;
        if degree >= 3u {
            square += terms.next * next + terms.previous * previous;
        }
        value = line * first + square * second;
        slope = (line + terms.cross.zxyw * previous) + square * (3.0 * first);
        if degree >= 3u {
            value += terms.cube * third;
            let others = (terms.next * second).zxyw + (terms.previous * second).yzxw;
            slope = slope + (terms.cube * (7.5 * (first * first) - 1.5) + others) + terms.cube.w * (next * previous);
        }
    }
    return Answer((value.x + value.y) + (value.z + value.w), slope.xyz);
}

// Leaves that overlap: their mean by weights that fall smoothly to zero at the edges of their supports (SPEC.md §12.6).

// The weight of a leaf and its derivatives by local coordinates. `steepness` is half the leaf's edge over twice the
// distance by which it reaches beyond its cell.
fn weight_at(local: vec3<f32>, steepness: f32) -> vec4<f32> {
    let s = clamp(0.5 + (1.0 - abs(local)) * steepness, vec3(0.0), vec3(1.0));
    let w = (s * s) * (3.0 - 2.0 * s);
    let signs = vec3(
        copy_sign(steepness, -local.x), copy_sign(steepness, -local.y), copy_sign(steepness, -local.z)
    );
    let slope = (6.0 * s * (1.0 - s)) * signs;
    return vec4(slope.x * (w.y * w.z), slope.y * (w.x * w.z), slope.z * (w.x * w.y), w.x * w.y * w.z);
}

fn evaluate_polynomial_octree(field: Field, position: vec3<f32>) -> Answer {
    let own = find_leaf(field, min(vec3<u32>(position), field.cells - 1u));
    // For a support code of 0.
    let steepness = 0.25 / field.overlap;
    // Of the leaf that holds the position.
    var alone: Answer;
    // Sums over leaves, the values being differences to that leaf's, which loses less to rounding.
    var weight = 0.0;
    var weight_slope = vec3(0.0);
    var change = 0.0;
    var slope = vec3(0.0);
    var is_alone = true;
    var region: Region;

    // First that leaf, then those around it, so that a leaf is evaluated at one place of the code: compilers of shaders
    // write all of the reading out at each.
    var leaf = own;
    loop {
        let head = read_head(field, leaf.place);
        let local = local_of(leaf, position);
        let is_own = leaf.place == own.place;
        let its_weight = weight_at(local, steepness * f32(1u << head.support));
        if is_own || its_weight.w > 0.0 {
            let its = evaluate_leaf(field, leaf, head, local);
            if is_own {
                alone = its;
                if !is_shared(field, head, local) {
                    return its;
                }
                region = region_around(field, own, position, head.reach);
            } else {
                is_alone = false;
            }
            let difference = its.distance - alone.distance;
            let its_slope = its_weight.xyz * (2.0 / edge_of(field, leaf));
            weight += its_weight.w;
            change += its_weight.w * difference;
            weight_slope += its_slope;
            slope += its_weight.w * its.gradient + its_slope * difference;
        }
        leaf = next_leaf(field, &region, own.place);
        if leaf.place == own.place {
            break;
        }
    }
    if is_alone {
        return alone;
    }

    let per_weight = 1.0 / weight;
    let mean = change * per_weight;
    return Answer(alone.distance + mean, (slope - mean * weight_slope) * per_weight);
}

// Whether more leaves than the one that holds the position may have a say there.
fn is_shared(field: Field, head: LeafHead, local: vec3<f32>) -> bool {
    // In overlaps, where half an edge of the leaf is 1; with a code of 0 everywhere.
    let share = select(power_of_half(head.reach) * 4.0, 2.0 / MIN_OVERLAP, head.reach == 0u);
    let outermost = max(max(abs(local.x), abs(local.y)), abs(local.z));
    return field.overlap > 0.0 && outermost > 1.0 - field.overlap * share;
}

// The leaves that hold any of the finest cells from `low` to `high`, one after the other: the root grid x fastest, below it
// depth first.
struct Region {
    low: vec3<u32>,
    high: vec3<u32>,
    // The root cell that comes next, in root cells.
    root: vec3<u32>,
    // The last cell, and its edge as a power of two.
    cell: vec3<u32>,
    shift: u32,
    // Nodes with this edge, as a power of two, are passed over.
    finest: u32,
    // For the inner nodes on the way to it, by the power of two of their children's edge: the record, and which children
    // are yet to come.
    records: array<u32, 16>,
    pending: array<u32, 16>,
}

// The finest cells that supports can reach a position from.
fn region_around(field: Field, own: Leaf, position: vec3<f32>, reach: u32) -> Region {
    let share = select(power_of_half(reach) * 2.0, LEAST_SUPPORT_SHARE, reach == 0u);
    let margin = field.overlap * f32(1u << own.shift) * share;
    let last = field.cells - 1u;
    var region: Region;
    region.low = min(vec3<u32>(max(position - margin, vec3(0.0))), last);
    region.high = min(vec3<u32>(position + margin), last);
    region.root = region.low >> vec3(field.depth);
    region.shift = field.depth;
    // No finer leaf touches this one. Without this bound a damaged file could ask for the whole lattice.
    region.finest = max(own.shift, MAX_LEVELS_APART) - MAX_LEVELS_APART;
    return region;
}

// The next leaf of a region that is not at `own`; that one if there is none.
fn next_leaf(field: Field, region: ptr<function, Region>, own: u32) -> Leaf {
    loop {
        // Up to where a child is left, or to the next root cell.
        var shift = (*region).shift;
        while shift < field.depth && (*region).pending[shift & 15u] == 0u {
            shift += 1u;
        }
        var node: u32;
        var cell: vec3<u32>;
        if shift < field.depth {
            let children = (*region).pending[shift & 15u];
            (*region).pending[shift & 15u] = children & (children - 1u);
            let octant = count_bits((children & (~children + 1u)) - 1u);
            let parent = ((*region).cell >> vec3(shift + 1u)) << vec3(shift + 1u);
            cell = parent + (vec3(octant & 1u, (octant >> 1u) & 1u, octant >> 2u) << vec3(shift));
            node = child_node(field, (*region).records[shift & 15u], octant);
        } else {
            let root = (*region).root;
            let first = (*region).low >> vec3(field.depth);
            let last = (*region).high >> vec3(field.depth);
            if root.z > last.z {
                break;
            }
            let is_last_x = root.x == last.x;
            let is_last_y = is_last_x && root.y == last.y;
            (*region).root = vec3(
                select(root.x + 1u, first.x, is_last_x),
                select(select(root.y, root.y + 1u, is_last_x), first.y, is_last_y),
                select(root.z, root.z + 1u, is_last_y)
            );
            cell = root << vec3(field.depth);
            node = word(field.nodes + root_of(field, cell));
        }

        (*region).cell = cell;
        if (node & ROOT_LEAF) == 0u && shift > 0u {
            (*region).shift = shift;
            if shift == (*region).finest {
                continue;
            }
            shift -= 1u;
            (*region).records[shift & 15u] = node;
            (*region).pending[shift & 15u] = children_in(cell + (1u << shift), (*region).low, (*region).high);
            (*region).shift = shift;
            continue;
        }
        (*region).shift = shift;
        let place = node & ~ROOT_LEAF;
        if place != own {
            return Leaf(place, cell, shift);
        }
    }
    return Leaf(own, vec3(0u), 0u);
}

// Where a leaf is too fine for its neighbour's reach code, the share of an overlap that its support may still take.
const LEAST_SUPPORT_SHARE: f32 = f32(1u << (MAX_LEVELS_APART - MAX_SUPPORT));

// Which of the eight children around a finest cell's least corner meet a region: a bit for each.
fn children_in(middle: vec3<u32>, low: vec3<u32>, high: vec3<u32>) -> u32 {
    var children = 0xFFu;
    children &= select(0xFFu, 0x55u, high.x < middle.x) & select(0xFFu, 0xAAu, low.x >= middle.x);
    children &= select(0xFFu, 0x33u, high.y < middle.y) & select(0xFFu, 0xCCu, low.y >= middle.y);
    children &= select(0xFFu, 0x0Fu, high.z < middle.z) & select(0xFFu, 0xF0u, low.z >= middle.z);
    return children;
}

// What octrees share.

// Number of the child that holds a finest cell, of a node whose children have edges of 2 to the power of `shift`.
fn octant_of(cell: vec3<u32>, shift: u32) -> u32 {
    let half = (cell >> vec3(shift)) & vec3(1u);
    return half.x | (half.y << 1u) | (half.z << 2u);
}

// Number of the root cell that holds a finest cell.
fn root_of(field: Field, cell: vec3<u32>) -> u32 {
    let root = cell >> vec3(field.depth);
    return root.x + field.counts.x * (root.y + field.counts.y * root.z);
}

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

// Arithmetic with a fixed order of operations, words and the sample codec (SPEC.md §8).

fn float(index: u32) -> f32 {
    return bitcast<f32>(word(index));
}

// The number, or the greatest float where it is infinity. Told by its bits, whose order is that of numbers.
fn finite(number: f32) -> f32 {
    return bitcast<f32>(min(bitcast<i32>(number), 0x7F7FFFFF));
}

fn byte_of(bits: u32, number: u32) -> u32 {
    return (bits >> (8u * number)) & 0xFFu;
}

// 2 to the power of minus `exponent`, for exponents up to 126.
fn power_of_half(exponent: u32) -> f32 {
    return bitcast<f32>((127u - min(exponent, 126u)) << 23u);
}

fn copy_sign(magnitude: f32, sign: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(abs(magnitude)) | (bitcast<u32>(sign) & 0x80000000u));
}

// Bits that are set. GLSL ES 3.00 cannot count them by itself.
fn count_bits(bits: u32) -> u32 {
    let pairs = bits - ((bits >> 1u) & 0x55555555u);
    let nibbles = (pairs & 0x33333333u) + ((pairs >> 2u) & 0x33333333u);
    return (((nibbles + (nibbles >> 4u)) & 0x0F0F0F0Fu) * 0x01010101u) >> 24u;
}

// 1/√x for x from 1/3 to 1.
fn reciprocal_sqrt(x: f32) -> f32 {
    let seed = 2.8898656 - x * (4.8495786 - x * (4.646499 - x * 1.6896812));
    let half = 0.5 * x;
    let coarse = seed * (1.5 - half * (seed * seed));
    return coarse + coarse * (0.5 - half * (coarse * coarse));
}

// Length, at most the greatest float, and unit direction of a finite vector that is not zero.
fn length_and_direction(vector: vec3<f32>) -> Answer {
    let largest = max(max(abs(vector.x), abs(vector.y)), abs(vector.z));
    let scaled = vector / largest;
    // On the octahedron |x| + |y| + |z| = 1 the squared length lies in 1/3 to 1.
    let taxicab = abs(scaled.x) + abs(scaled.y) + abs(scaled.z);
    let place = scaled / taxicab;
    let squared = place.x * place.x + place.y * place.y + place.z * place.z;
    let reciprocal = reciprocal_sqrt(squared);
    let length = finite(taxicab * (squared * reciprocal) * largest);
    return Answer(length, place * reciprocal);
}

// Unit gradient of an octahedral code, which is in the low 20 bits (Meyer et al. 2010).
fn decode_gradient(code: u32) -> vec3<f32> {
    let codes = vec2<i32>(vec2(code & GRADIENT_MASK, (code >> GRADIENT_BITS) & GRADIENT_MASK)) - GRADIENT_CENTRE;
    let flat = vec2<f32>(codes) * GRADIENT_STEP;
    // The lower half of the octahedron is folded over the edges of the square.
    let z = 1.0 - abs(flat.x) - abs(flat.y);
    let fold = max(-z, 0.0);
    let x = flat.x - copy_sign(fold, flat.x);
    let y = flat.y - copy_sign(fold, flat.y);
    return vec3(x, y, z) * reciprocal_sqrt(x * x + y * y + z * z);
}

// Value of the half float in the low 16 bits; 0 for an infinity or a NaN.
fn decode_half(bits: u32) -> f32 {
    let sign = (bits & 0x8000u) << 16u;
    let exponent = (bits >> 10u) & 31u;
    let fraction = bits & 0x3FFu;
    if exponent == 0u {
        return bitcast<f32>(sign | bitcast<u32>(f32(fraction) * SUBNORMAL_STEP));
    }
    return bitcast<f32>(sign | select(((exponent + 112u) << 23u) | (fraction << 13u), 0u, exponent == 31u));
}

const SUBNORMAL_STEP: f32 = 1.0 / 16777216.0;

// The low and the high half of a word.
fn decode_halves(bits: u32) -> vec2<f32> {
    return vec2(decode_half(bits), decode_half(bits >> 16u));
}

// Distance of a code, mesh units.
fn decode_distance(base: i32, code: u32, quantum: f32) -> f32 {
    return f32(base + i32(code)) * quantum;
}

// The float of a sample; 0 for what a valid file does not hold.
fn decode_float(bits: u32) -> f32 {
    return select(0.0, bitcast<f32>(bits), (bits & 0x7FFFFFFFu) <= MAX_MAGNITUDE_BITS);
}

// The constants of the format.

const FAMILY_WORD: u32 = 4u;
const FAMILY_BYTE: u32 = 0u;
const SECTION_COUNT_WORD: u32 = 4u;
const SECTION_COUNT_BYTE: u32 = 2u;
const BOX_MIN_WORD: u32 = 6u;
const BOX_MAX_WORD: u32 = 9u;
const LIPSCHITZ_WORD: u32 = 14u;
const UNIFORM_MAX_WORD: u32 = 17u;
const BAND_MAX_WORD: u32 = 20u;
const SAMPLE_COUNT_WORD: u32 = 22u;
const TABLE_WORD: u32 = 32u;
const SECTION_WORDS: u32 = 4u;
const MAX_SECTIONS: u32 = 16u;
const SECTION_OCTREE: u32 = 1381253967u;
const SECTION_NODES: u32 = 1162104654u;
const SECTION_SAMPLES: u32 = 1347240275u;
const SECTION_GRID: u32 = 1145655879u;
const SECTION_BASES: u32 = 1163084098u;
const SECTION_POLYNOMIAL: u32 = 1163023440u;
const SECTION_ROOTS: u32 = 1414483794u;
const SECTION_SHAPES: u32 = 1162889299u;
const SECTION_RECORDS: u32 = 1162170964u;
const SECTION_LEAVES: u32 = 1178682700u;
const FAMILY_GRID: u32 = 1u;
const FAMILY_OCTREE: u32 = 2u;
const FAMILY_POLYNOMIAL: u32 = 3u;
const MAX_DEPTH: u32 = 16u;
const INTERPOLANT_TRICUBIC: u32 = 1u;
const NODE_OFFSET_BITS: u32 = 28u;
const NODE_OFFSET_MASK: u32 = 268435455u;
const NODE_INNER: u32 = 0u;
const LATTICE_MASK: u32 = 134217727u;
const PRECISION_SHIFT: u32 = 27u;
const PRECISION_PACKED32: u32 = 0u;
const PRECISION_F16: u32 = 1u;
const PRECISION_F32: u32 = 2u;
const GRADIENT_BITS: u32 = 10u;
const GRADIENT_MASK: u32 = 1023u;
const DISTANCE_SHIFT: u32 = 20u;
const RECONSTRUCTION_NEAREST: u32 = 0u;
const RECONSTRUCTION_HALF: u32 = 2u;
const RECONSTRUCTION_BLEND: u32 = 3u;
const RECONSTRUCTION_HERMITE: u32 = 4u;
const RANGE_BRICK: u32 = 1u;
const BRICK_EDGE: u32 = 4u;
const ROOT_LEAF: u32 = 2147483648u;
const RECORD_LENGTH: u32 = 14u;
const RECORD_FIRST: u32 = 8u;
const RECORD_CHILD_BITS: u32 = 21u;
const RECORD_CHILD_MASK: u32 = 2097151u;
const RECORD_LEAF_MASK: u32 = 134217727u;
const KIND_SINGLE: u32 = 0u;
const KIND_MIN: u32 = 1u;
const MAX_EXPONENT: u32 = 15u;
const SUPPORT_BITS: u32 = 2u;
const OVERLAP_BITS: u32 = 4u;
const MAX_SUPPORT: u32 = 3u;
const MAX_LEVELS_APART: u32 = 5u;
const MAX_MAGNITUDE_BITS: u32 = 1568669696u;
const GRADIENT_CENTRE: i32 = 511;
const GRADIENT_STEP: f32 = 0.0019569471f;
const MIN_OVERLAP: f32 = 0.015625f;
