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

// The answer where more leaves than the one that holds the position may have a say. `alone` is that leaf's.
fn blend(field: Field, own: Leaf, position: vec3<f32>, alone: Answer) -> Answer {
    let head = read_head(field, own.place);
    // For a support code of 0.
    let steepness = 0.25 / field.overlap;
    let own_weight = weight_at(local_of(own, position), steepness * f32(1u << head.support));
    var weight = own_weight.w;
    var weight_slope = own_weight.xyz * (2.0 / edge_of(field, own));
    // Of differences to the leaf's own value, which loses less to rounding.
    var change = 0.0;
    var slope = own_weight.w * alone.gradient;
    var is_alone = true;

    // The finest cells that supports can reach the position from.
    let share = select(power_of_half(head.reach) * 2.0, LEAST_SUPPORT_SHARE, head.reach == 0u);
    let margin = field.overlap * f32(1u << own.shift) * share;
    let last = field.cells - 1u;
    let low = min(vec3<u32>(max(position - margin, vec3(0.0))), last);
    let high = min(vec3<u32>(position + margin), last);

    // All leaves of that region: the root grid x fastest, below it depth first. For each level on the way down, by the
    // power of two of the children's edge: the record, and which children are yet to come.
    var records: array<u32, 16>;
    var pending: array<u32, 16>;
    let first_root = low >> vec3(field.depth);
    let last_root = high >> vec3(field.depth);
    var root = first_root;
    var cell = vec3(0u);
    var shift = field.depth;
    loop {
        // Up to where a child is left, or to the next root cell.
        while shift < field.depth && pending[shift & 15u] == 0u {
            shift += 1u;
        }
        var node: u32;
        if shift < field.depth {
            let children = pending[shift & 15u];
            pending[shift & 15u] = children & (children - 1u);
            let octant = count_bits((children & (~children + 1u)) - 1u);
            let parent = (cell >> vec3(shift + 1u)) << vec3(shift + 1u);
            cell = parent + (vec3(octant & 1u, (octant >> 1u) & 1u, octant >> 2u) << vec3(shift));
            node = child_node(field, records[shift & 15u], octant);
        } else {
            if root.z > last_root.z {
                break;
            }
            cell = root << vec3(field.depth);
            node = root_node(field, root);
            root.x += 1u;
            if root.x > last_root.x {
                root.x = first_root.x;
                root.y += 1u;
            }
            if root.y > last_root.y {
                root.y = first_root.y;
                root.z += 1u;
            }
        }

        if (node & ROOT_LEAF) == 0u && shift > 0u {
            shift -= 1u;
            records[shift & 15u] = node;
            pending[shift & 15u] = children_in(cell + (1u << shift), low, high);
            continue;
        }
        let leaf = Leaf(node & ~ROOT_LEAF, cell, shift);
        if leaf.place == own.place {
            continue;
        }
        let local = local_of(leaf, position);
        let its_weight = weight_at(local, steepness * f32(1u << read_head(field, leaf.place).support));
        if its_weight.w > 0.0 {
            is_alone = false;
            let its = evaluate_leaf(field, leaf, local);
            let difference = its.distance - alone.distance;
            let its_slope = its_weight.xyz * (2.0 / edge_of(field, leaf));
            weight += its_weight.w;
            change += its_weight.w * difference;
            weight_slope += its_slope;
            slope += its_weight.w * its.gradient + its_slope * difference;
        }
    }
    if is_alone {
        return alone;
    }

    let per_weight = 1.0 / weight;
    let mean = change * per_weight;
    return Answer(alone.distance + mean, (slope - mean * weight_slope) * per_weight);
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
