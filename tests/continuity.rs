use crate::shapes;
use nearfield::{Field, Leaf, Octree};
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Continuity, Interpolant, Precision, Settings, Target};

/// Points along an edge of the smaller leaf: powers of two, so that the place in both leaves is exact.
const STEPS: u32 = 8;

/// The largest differences between the two sides of a kind of face.
#[derive(Clone, Copy, Debug, Default)]
struct Jump {
    faces: usize,
    value: f32,
    gradient: f32,
}

#[derive(Clone, Copy, Debug, Default)]
struct Jumps {
    /// Between leaves of one level.
    equal: Jump,
    /// Between leaves of different levels.
    different: Jump,
}

/// Both sides of every face, at a lattice of points that holds its corners and edges.
fn jumps(octree: &Octree<'_>) -> Jumps {
    let mut jumps = Jumps::default();
    for leaf in octree.leaves() {
        for axis in 0..3 {
            for high in [false, true] {
                let Some(other) = neighbour(octree, &leaf, axis, high) else { continue };
                if other.level > leaf.level {
                    continue; // Met from the other side.
                }
                let jump = if other.level == leaf.level { &mut jumps.equal } else { &mut jumps.different };
                jump.faces += 1;
                for point in face_points(axis, high) {
                    compare(octree, &leaf, &other, point, jump);
                }
            }
        }
    }
    jumps
}

fn neighbour(octree: &Octree<'_>, leaf: &Leaf, axis: usize, high: bool) -> Option<Leaf> {
    let mut cell = leaf.cell;
    cell[axis] = if high { cell[axis] + leaf.edge } else { cell[axis].checked_sub(1)? };
    (cell[axis] < octree.lattice()[axis]).then(|| octree.leaf_at(cell))
}

fn face_points(axis: usize, high: bool) -> impl Iterator<Item = [f32; 3]> {
    (0..=STEPS).flat_map(move |v| (0..=STEPS).map(move |u| [u, v])).map(move |[u, v]| {
        let mut steps = [u; 3];
        steps[(axis + 2) % 3] = v;
        steps[axis] = if high { STEPS } else { 0 };
        steps.map(|steps| steps as f32 / STEPS as f32)
    })
}

fn compare(octree: &Octree<'_>, leaf: &Leaf, other: &Leaf, local: [f32; 3], jump: &mut Jump) {
    let place_in_other = [0, 1, 2].map(|axis: usize| {
        let place = leaf.cell[axis] as f32 + local[axis] * leaf.edge as f32;
        (place - other.cell[axis] as f32) / other.edge as f32
    });
    let (value, gradient) = octree.evaluate(leaf, local);
    let (other_value, other_gradient) = octree.evaluate(other, place_in_other);

    jump.value = jump.value.max((value - other_value).abs());
    for axis in 0..3 {
        jump.gradient = jump.gradient.max((gradient[axis] - other_gradient[axis]).abs());
    }
}

fn measured(interpolant: Interpolant, continuity: Continuity, precision: Precision) -> (Jumps, f32, f32) {
    let settings = Settings {
        error: Target::Relative(1e-3),
        interpolant,
        continuity,
        precision,
        max_depth: 7,
        samples: 5_000,
        ..Settings::default()
    };
    let baked = bake(&shapes::read("bob_small.ply"), &settings, &Silent).expect("the mesh bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    let jumps = jumps(&field.octree());
    println!(
        "{interpolant:?} {continuity:?} {precision:?} {jumps:?} stored {} q0 {} depth {}",
        field.contract().seam_max,
        field.octree().quantum(0),
        field.octree().depth()
    );
    (jumps, field.contract().seam_max, field.octree().quantum(0))
}

#[test]
fn explore() {
    for i in [Interpolant::Trilinear, Interpolant::Tricubic] {
        for c in [Continuity::None, Continuity::C0, Continuity::C1] {
            for p in [Precision::Packed32, Precision::F16, Precision::F32] {
                if i == Interpolant::Trilinear && c == Continuity::C1 {
                    continue;
                }
                let r = std::panic::catch_unwind(|| measured(i, c, p));
                if r.is_err() {
                    println!("{i:?} {c:?} {p:?} failed");
                }
            }
        }
    }
}
