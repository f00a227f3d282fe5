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
