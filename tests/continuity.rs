use crate::shapes;
use nearfield::{Field, Leaf, Octree};
use nearfield_bake::bake;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Continuity, Interpolant, Layout, Precision, Settings, Target};

/// Points along an edge of the smaller leaf: a power of two, so that the place in both leaves is exact.
const STEPS: u32 = 4;

/// What differs between the two sides of the faces of one kind.
#[derive(Clone, Copy, Debug, Default)]
struct Jump {
    faces: usize,
    /// Largest difference of the value, mesh units.
    value: f32,
    /// The same, in distance quanta of the smaller leaf.
    value_in_quanta: f32,
    /// Largest difference of a component of the gradient.
    gradient: f32,
}

struct Seams {
    settings: Settings,
    /// Between leaves of one level.
    equal: Jump,
    /// Between leaves of different levels.
    different: Jump,
    /// What the header says.
    stored_max: f32,
    /// Smallest edge of a leaf, and largest |distance| in the field, mesh units.
    smallest_edge: f32,
    farthest: f32,
}

/// An octree of interpolants with this error, a fraction of the diagonal.
fn octree(error: f64, interpolant: Interpolant, continuity: Continuity, precision: Precision) -> Settings {
    Settings {
        layout: Layout::Octree,
        error: Target::Relative(error),
        interpolant,
        continuity,
        precision,
        max_depth: 6,
        samples: 5_000,
        ..Settings::default()
    }
}

/// Bakes a small mesh and asks both sides of every face, at points that include its corners and edges.
fn seams(interpolant: Interpolant, continuity: Continuity, precision: Precision) -> Seams {
    let settings = octree(4e-3, interpolant, continuity, precision);
    let baked = bake(&shapes::read("bob_small.ply"), &settings, &Silent).expect("the mesh bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    let octree = field.octree().expect("an octree");

    let (mut equal, mut different) = (Jump::default(), Jump::default());
    let mut farthest: f32 = 0.0;
    for leaf in octree.leaves() {
        farthest = farthest.max(octree.evaluate(&leaf, [0.0; 3]).0.abs());
        for (axis, high) in (0..3).flat_map(|axis| [(axis, false), (axis, true)]) {
            let Some(other) = neighbour(&octree, &leaf, axis, high) else { continue };
            // A face is met from its smaller side.
            if other.level <= leaf.level {
                let jump = if other.level == leaf.level { &mut equal } else { &mut different };
                jump.faces += 1;
                face_points(axis, high).for_each(|point| compare(&octree, &leaf, &other, point, jump));
            }
        }
    }
    let smallest_edge = octree.edge(octree.depth());
    Seams { settings, equal, different, stored_max: field.contract().seam_max, smallest_edge, farthest }
}

fn neighbour(octree: &Octree<'_>, leaf: &Leaf, axis: usize, high: bool) -> Option<Leaf> {
    let mut cell = leaf.cell;
    cell[axis] = if high { cell[axis] + leaf.edge } else { cell[axis].checked_sub(1)? };
    (cell[axis] < octree.lattice()[axis]).then(|| octree.leaf_at(cell))
}

fn face_points(axis: usize, high: bool) -> impl Iterator<Item = [f32; 3]> {
    let steps = (0..=STEPS).flat_map(|u| (0..=STEPS).map(move |v| [u, v]));
    steps.map(move |[u, v]| {
        let mut point = [0; 3];
        point[axis] = if high { STEPS } else { 0 };
        point[(axis + 1) % 3] = u;
        point[(axis + 2) % 3] = v;
        point.map(|steps| steps as f32 / STEPS as f32)
    })
}

fn compare(octree: &Octree<'_>, leaf: &Leaf, other: &Leaf, local: [f32; 3], jump: &mut Jump) {
    let in_other = [0, 1, 2].map(|axis: usize| {
        let place = leaf.cell[axis] as f32 + local[axis] * leaf.edge as f32;
        (place - other.cell[axis] as f32) / other.edge as f32
    });
    let (value, gradient) = octree.evaluate(leaf, local);
    let (other_value, other_gradient) = octree.evaluate(other, in_other);

    let difference = (value - other_value).abs();
    jump.value = jump.value.max(difference);
    jump.value_in_quanta = jump.value_in_quanta.max(difference / octree.quantum(leaf.level));
    for axis in 0..3 {
        jump.gradient = jump.gradient.max((gradient[axis] - other_gradient[axis]).abs());
    }
}

/// Meshes that bend, have edges, thin parts and parts that are far from each other.
fn test_set() -> [(&'static str, CheckedMesh); 4] {
    let of_file = |name| (name, shapes::read(name));
    [of_file("bob_small.ply"), of_file("spot.ply"), ("cuboid", shapes::cuboid()), ("sphere", shapes::sphere(3).0)]
}

/// Not at points but everywhere, on every face between leaves of every mesh: see [`SeamBound`].
#[test]
fn no_face_of_the_test_set_jumps_by_more_than_rounding() {
    for (name, mesh) in test_set() {
        let diagonal = mesh.bounds.diagonal();
        for (interpolant, continuity) in
            [(Interpolant::Trilinear, Continuity::C0), (Interpolant::Tricubic, Continuity::C1)]
        {
            for precision in [Precision::Packed32, Precision::F16, Precision::F32] {
                let settings = Settings { samples: 1_000, ..octree(3e-3, interpolant, continuity, precision) };
                let baked = bake(&mesh, &settings, &Silent).expect("the mesh bakes");
                let measured = baked.report.measurement.seams;
                let bound = measured.bound.expect("an octree of interpolants");
                let field = Field::open(&baked.bytes).expect("a field");

                assert!(bound.uneven_faces > 200, "{name}: {bound:?}: too few T-junctions to tell");
                assert!(bound.value <= 1e-6 * diagonal || bound.quanta <= 1.0, "{name} {precision:?}: {bound:?}");
                // Rounding the derivatives of hanging corners to half floats is all that remains.
                assert!(bound.gradient.is_none_or(|gradient| gradient <= 1e-3), "{name} {precision:?}: {bound:?}");
                assert!(f64::from(field.contract().seam_max) >= 0.999_999 * bound.value, "the header owns up to it");
            }
        }
    }
}

/// Every kind of field that promises this.
fn promising(continuity: Continuity) -> impl Iterator<Item = Seams> {
    let interpolants = match continuity {
        Continuity::C1 => vec![Interpolant::Tricubic],
        _ => vec![Interpolant::Trilinear, Interpolant::Tricubic],
    };
    interpolants.into_iter().flat_map(move |interpolant| {
        [Precision::Packed32, Precision::F16, Precision::F32].map(|precision| seams(interpolant, continuity, precision))
    })
}

impl Seams {
    /// The bits that a value loses on its way through single precision, mesh units.
    fn float_noise(&self) -> f32 {
        4.0 * f32::EPSILON * self.farthest
    }

    /// Leaves of one level that share a corner decode the same bits there, and compute the same from them.
    fn assert_equal_leaves_meet_exactly(&self) {
        assert!(self.equal.faces > 1_000, "{:?}: too few faces to tell", self.settings);
        assert_eq!(self.equal.value, 0.0, "{:?}", self.settings);
        if self.settings.interpolant == Interpolant::Tricubic {
            assert_eq!(self.equal.gradient, 0.0, "{:?}", self.settings);
        }
    }

    /// A corner that hangs on a larger leaf and determines others is stored with its distance to 1/16
    /// of a quantum and its derivatives to 11 bits. For an edge L that is 1/32 quantum, and 2^-12 of
    /// L/4 along each axis: 1.8e-4 L, a fifth of a quantum (9e-4 L). Mixed derivatives are smaller.
    fn assert_values_are_continuous(&self) {
        assert!(self.different.faces > 1_000, "{:?}: too few faces to tell", self.settings);
        match self.settings.precision {
            Precision::F32 => assert!(self.different.value <= self.float_noise(), "{:?}", self.different),
            _ => assert!(self.different.value_in_quanta <= 0.5, "{:?}: {:?}", self.settings, self.different),
        }
    }

    /// The same rounding seen by the gradient: 2^-11 for a component between 1 and 2, and 1.5 times
    /// twice 1/32 quantum over L, 8e-5.
    fn assert_gradients_are_continuous(&self) {
        let bound = match self.settings.precision {
            Precision::F32 => 2.0 * self.float_noise() / self.smallest_edge,
            _ => 2f32.powi(-10),
        };
        assert!(self.different.gradient <= bound, "{:?}: {:?}", self.settings, self.different);
    }
}

#[test]
fn without_a_promise_only_leaves_of_one_size_meet() {
    for seams in promising(Continuity::None) {
        seams.assert_equal_leaves_meet_exactly();

        // The seams that the other tests must not find are there to be found, and the header owns up to them.
        assert!(seams.different.value_in_quanta > 100.0, "{:?}: {:?}", seams.settings, seams.different);
        let ratio = seams.stored_max / seams.different.value;
        assert!((0.5..2.0).contains(&ratio), "{:?}: the header says {ratio} times as much", seams.settings);
    }
}

#[test]
fn c0_fields_have_continuous_values() {
    for seams in promising(Continuity::C0) {
        seams.assert_equal_leaves_meet_exactly();
        seams.assert_values_are_continuous();
    }
}

#[test]
fn c1_fields_have_continuous_values_and_gradients() {
    for seams in promising(Continuity::C1) {
        seams.assert_equal_leaves_meet_exactly();
        seams.assert_values_are_continuous();
        seams.assert_gradients_are_continuous();
    }
}
