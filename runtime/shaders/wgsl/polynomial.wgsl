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

fn evaluate_polynomial_octree(field: Field, position: vec3<f32>) -> Answer {
    let own = find_leaf(field, min(vec3<u32>(position), field.cells - 1u));
    let local = local_of(own, position);
    let answer = evaluate_leaf(field, own, local);
    if field.overlap == 0.0 {
        return answer;
    }
    let reach = read_head(field, own.place).reach;
    // In overlaps, where half an edge of the leaf is 1; with a code of 0 everywhere.
    let share = select(power_of_half(reach) * 4.0, 2.0 / MIN_OVERLAP, reach == 0u);
    if max(max(abs(local.x), abs(local.y)), abs(local.z)) > 1.0 - field.overlap * share {
        return blend(field, own, position, answer);
    }
    return answer;
}

fn find_leaf(field: Field, cell: vec3<u32>) -> Leaf {
    let root = cell >> vec3(field.depth);
    var node = root_node(field, root);
    var shift = field.depth;
    while (node & ROOT_LEAF) == 0u && shift > 0u {
        shift -= 1u;
        node = child_node(field, node, octant_of(cell, shift));
    }
    return Leaf(node & ~ROOT_LEAF, (cell >> vec3(shift)) << vec3(shift), shift);
}

// Nodes are as root words have them: the byte of a leaf and a bit, or the number of a record.

fn root_node(field: Field, root: vec3<u32>) -> u32 {
    return word(field.nodes + root.x + field.counts.x * (root.y + field.counts.y * root.z));
}

fn child_node(field: Field, record: u32, octant: u32) -> u32 {
    // Records start at even bytes.
    let byte = RECORD_LENGTH * record;
    let start_bits = bits_at(field.records, 8u * (byte & 3u) + 8u * octant, byte / 4u);
    let start = select(start_bits & 0xFFu, 0u, octant == 0u);
    let inner = bits_at(field.records, 8u * (byte & 3u), byte / 4u);
    let first_bit = 8u * ((byte & 3u) + RECORD_FIRST);
    if ((inner >> octant) & 1u) == 1u {
        return (bits_at(field.records, first_bit, byte / 4u) & RECORD_CHILD_MASK) + start;
    }
    let leaf = bits_at(field.records, first_bit + RECORD_CHILD_BITS, byte / 4u) & RECORD_LEAF_MASK;
    return ROOT_LEAF | (leaf + start);
}

// 32 bits from a bit on, counted from a word of a section.
fn bits_at(section: u32, bit: u32, index: u32) -> u32 {
    let at = section + index + bit / 32u;
    let shift = bit & 31u;
    return (word(at) >> shift) | ((word(at + 1u) << 1u) << (31u - shift));
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
fn evaluate_leaf(field: Field, leaf: Leaf, local: vec3<f32>) -> Answer {
    let head = read_head(field, leaf.place);
    let widths = head.widths;
    let kind = byte_of(head.kind_and_degrees, 0u);
    let exponent = byte_of(head.kind_and_degrees, 3u) & MAX_EXPONENT;
    let step = field.quantum * bitcast<f32>((127u + exponent) << 23u);

    var bit = 8u * (leaf.place & 3u) + field.shape_bits + select(OVERLAP_BITS, 0u, field.overlap == 0.0);
    var answer = Answer(0.0, vec3(0.0));
    for (var index = 0u; index < 2u; index++) {
        if index == 1u && kind == KIND_SINGLE {
            break;
        }
        let degree = byte_of(head.kind_and_degrees, 1u + index);
        let terms = read_terms(field, leaf.place / 4u, bit, degree, widths);
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
    var terms: Terms;
    var bit = start;
    terms.linear.w = read_code(field, index, bit, byte_of(widths, 0u));
    bit += byte_of(widths, 0u);
    if degree >= 1u {
        let width = byte_of(widths, 1u);
        terms.linear = vec4(read_codes(field, index, bit, width), terms.linear.w);
        bit += 3u * width;
    }
    if degree >= 2u {
        let width = byte_of(widths, 2u);
        terms.square = vec4(read_codes(field, index, bit, width), 0.0);
        terms.cross = vec4(read_codes(field, index, bit + 3u * width, width), 0.0);
        bit += 6u * width;
    }
    if degree >= 3u {
        let width = byte_of(widths, 3u);
        terms.cube = vec4(
            read_codes(field, index, bit, width), read_code(field, index, bit + 9u * width, width)
        );
        terms.next = vec4(read_codes(field, index, bit + 3u * width, width), 0.0);
        terms.previous = vec4(read_codes(field, index, bit + 6u * width, width), 0.0);
        bit += 10u * width;
    }
    terms.end = bit;
    return terms;
}

// The number of a code of `width` bits.
fn read_code(field: Field, index: u32, bit: u32, width: u32) -> f32 {
    let size = 1u << (width & 31u);
    let code = bits_at(field.samples, bit, index) & (size - 1u);
    return f32(i32(code) - i32(size >> 1u));
}

fn read_codes(field: Field, index: u32, bit: u32, width: u32) -> vec3<f32> {
    return vec3(
        read_code(field, index, bit, width),
        read_code(field, index, bit + width, width),
        read_code(field, index, bit + 2u * width, width)
    );
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
