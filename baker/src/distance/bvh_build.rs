//! Builds the tree over the triangles: a binary tree by binned surface-area heuristic (Wald 2007,
//! "On fast construction of SAH-based bounding volume hierarchies"), folded into nodes of eight.

use super::bvh::{Bvh, LANES, MAX_DEPTH, Node, Packet};
use super::bvh_fold::{Layout, Tree};
use super::bvh_nearest::Finder;
use super::local_mesh::{Bounds, LocalMesh};
use super::oriented_box::OrientedBox;
use rayon::prelude::*;

/// Bins along each axis.
const BINS: usize = 16;
/// From this many triangles on, the two halves of a split are built in parallel. It bears on speed
/// alone: the tree is the same.
const PARALLEL: usize = 8192;

/// A triangle as the builder sees it.
#[derive(Clone, Copy)]
struct Primitive {
    bounds: Bounds,
    triangle: u32,
}

impl Primitive {
    /// Twice the middle of the box.
    fn centre(&self, axis: usize) -> f32 {
        self.bounds.min[axis] + self.bounds.max[axis]
    }
}

fn bounds_of(primitives: &[Primitive]) -> Bounds {
    primitives.iter().fold(Bounds::EMPTY, |all, primitive| all.joined(primitive.bounds))
}

/// Builds the tree, and puts the mesh into its order. It depends on the mesh alone, not on threads.
pub(super) fn build(mesh: &LocalMesh) -> Finder {
    let mut primitives: Vec<Primitive> = (0..mesh.triangles.len() as u32)
        .into_par_iter()
        .map(|triangle| Primitive { bounds: mesh.bounds(triangle), triangle })
        .collect();
    let tree = split(&mut primitives, 0, 0);
    let order: Vec<u32> = primitives.iter().map(|primitive| primitive.triangle).collect();
    let mesh = mesh.reordered(&order);

    let layout = Layout::of(&tree);
    let packets = layout.packets.par_iter().map(|range| Packet::new(&mesh, range.clone()));
    let nodes = layout.nodes.par_iter().map(|children| {
        let mut node = Node::EMPTY;
        for (lane, (tree, child)) in children.iter().enumerate() {
            node.set_child(lane, &OrientedBox::around(&mesh, tree), *child);
        }
        node
    });
    let bvh = Bvh { nodes: nodes.collect(), packets: packets.collect() };
    Finder { mesh, bvh }
}

/// Splits until a leaf fills at most one packet. `start` is the place of `primitives` in the whole.
fn split(primitives: &mut [Primitive], start: usize, depth: usize) -> Tree {
    let count = primitives.len();
    let bounds = bounds_of(primitives);
    if count <= LANES {
        return Tree::leaf(bounds, start..start + count);
    }

    // Levels that median splits of the rest would take.
    let levels = (count.div_ceil(LANES)).next_power_of_two().trailing_zeros() as usize;
    let middle = match best_split(primitives) {
        Some(plane) if depth + levels + 1 < MAX_DEPTH => plane.partition(primitives),
        _ => halve(primitives),
    };
    let (left, right) = primitives.split_at_mut(middle);
    let mut build_left = || split(left, start, depth + 1);
    let mut build_right = || split(right, start + middle, depth + 1);
    let (left, right) =
        if count >= PARALLEL { rayon::join(build_left, build_right) } else { (build_left(), build_right()) };
    Tree::inner(bounds, left, right)
}

/// A split: primitives whose bin along `axis` is below `bin` go left.
struct Plane {
    axis: usize,
    bin: usize,
    low: f32,
    scale: f32,
}

impl Plane {
    fn partition(&self, primitives: &mut [Primitive]) -> usize {
        let mut left = 0;
        for k in 0..primitives.len() {
            if bin_of(primitives[k].centre(self.axis), self.low, self.scale) < self.bin {
                primitives.swap(left, k);
                left += 1;
            }
        }
        left
    }
}

fn bin_of(centre: f32, low: f32, scale: f32) -> usize {
    (((centre - low) * scale) as usize).min(BINS - 1)
}

/// The cheapest split by the surface-area heuristic, counting packets rather than triangles, so
/// that packets are filled.
fn best_split(primitives: &[Primitive]) -> Option<Plane> {
    // Extent of the centres.
    let mut centres = Bounds::EMPTY;
    for primitive in primitives {
        let centre = [0, 1, 2].map(|axis| primitive.centre(axis));
        centres = centres.joined(Bounds { min: centre, max: centre });
    }

    // Bins, all axes in one pass.
    let scale = [0, 1, 2].map(|axis| BINS as f32 / (centres.max[axis] - centres.min[axis]));
    let mut bins = [[(Bounds::EMPTY, 0usize); BINS]; 3];
    for primitive in primitives {
        for axis in 0..3 {
            let bin = &mut bins[axis][bin_of(primitive.centre(axis), centres.min[axis], scale[axis])];
            *bin = (bin.0.joined(primitive.bounds), bin.1 + 1);
        }
    }

    // Sweep each axis from the right, then from the left.
    let cost = |(bounds, count): (Bounds, usize)| bounds.half_area() * count.div_ceil(LANES) as f32;
    let join = |a: (Bounds, usize), b: (Bounds, usize)| (a.0.joined(b.0), a.1 + b.1);
    let mut best: Option<(f32, Plane)> = None;
    for axis in 0..3 {
        if !scale[axis].is_finite() {
            continue;
        }
        let mut cost_right = [0.0; BINS];
        let mut right = (Bounds::EMPTY, 0);
        for bin in (1..BINS).rev() {
            right = join(right, bins[axis][bin]);
            cost_right[bin] = cost(right);
        }
        let mut left = (Bounds::EMPTY, 0);
        for bin in 1..BINS {
            left = join(left, bins[axis][bin - 1]);
            if left.1 == 0 || left.1 == primitives.len() {
                continue;
            }
            let total = cost(left) + cost_right[bin];
            if best.as_ref().is_none_or(|(least, _)| total < *least) {
                best = Some((total, Plane { axis, bin, low: centres.min[axis], scale: scale[axis] }));
            }
        }
    }
    best.map(|(_, plane)| plane)
}

/// Splits at the median of the longest axis, at a multiple of the packet size.
fn halve(primitives: &mut [Primitive]) -> usize {
    let bounds = bounds_of(primitives);
    let size = [0, 1, 2].map(|k| bounds.max[k] - bounds.min[k]);
    let axis = (0..3).fold(0, |longest, k| if size[k] > size[longest] { k } else { longest });
    let middle = (primitives.len() / 2).next_multiple_of(LANES);
    primitives.select_nth_unstable_by(middle, |a, b| {
        a.centre(axis).total_cmp(&b.centre(axis)).then(a.triangle.cmp(&b.triangle))
    });
    middle
}
