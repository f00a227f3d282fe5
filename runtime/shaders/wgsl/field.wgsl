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
