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
