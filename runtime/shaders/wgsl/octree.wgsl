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
