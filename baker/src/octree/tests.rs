use super::*;
use crate::corner::Corner;
use crate::field_function::Sample;
use crate::progress::Silent;
use crate::settings::{Layout, NEAR, Precision, Target, Termination};
use glam::{DVec3, UVec3};
use std::collections::HashSet;
use std::sync::Mutex;

/// The distance to the union of two spheres, remembering where it was asked.
#[derive(Default)]
struct Spheres {
    asked: Mutex<Vec<DVec3>>,
}

impl FieldFunction for Spheres {
    fn sample(&self, point: DVec3) -> Sample {
        self.asked.lock().expect("no test thread panics while it holds the lock").push(point);
        let sphere = |centre: DVec3, radius: f64| Sample {
            distance: (point - centre).length() - radius,
            gradient: (point - centre).normalize_or(DVec3::X),
        };
        let (a, b) = (sphere(DVec3::new(-0.4, 0.1, 0.0), 0.5), sphere(DVec3::new(0.5, 0.0, 0.2), 0.4));
        if a.distance <= b.distance { a } else { b }
    }
}

const TARGET: f64 = 1e-3;

const BOUNDS: Aabb = Aabb { min: DVec3::new(-0.9, -0.4, -0.5), max: DVec3::new(0.9, 0.6, 0.6) };

fn settings(interpolant: Interpolant, continuity: Continuity) -> Settings {
    Settings {
        error: Target::Absolute(TARGET),
        interpolant,
        continuity,
        precision: Precision::F32,
        start_depth: 2,
        max_depth: 6,
        layout: Layout::Octree,
        ..Settings::default()
    }
}

fn build(settings: &Settings) -> Octree {
    Octree::build(&Spheres::default(), &BOUNDS, settings, settings.error.absolute(1.0), &Silent)
}

/// The derivatives at a lattice vertex as every leaf around it sees them.
fn seen_from_leaves(octree: &Octree, vertex: UVec3) -> Vec<Corner> {
    let tree = &octree.tree;
    tree.leaves_at(vertex)
        .map(|id| {
            let leaf = tree.node(id);
            let local = (vertex - leaf.origin).as_dvec3() / f64::from(tree.lattice_edge(leaf));
            octree.corners.patch(tree, leaf).derivatives(local)
        })
        .collect()
}

/// The largest disagreement between leaves, in value and in gradient, over the vertices of a lattice
/// finer than any face between leaves of the tree.
fn seams(octree: &Octree) -> (f64, f64) {
    let size = octree.tree.domain.lattice_size();
    let vertices =
        (0..size.z).flat_map(|z| (0..size.y).flat_map(move |y| (0..size.x).map(move |x| UVec3::new(x, y, z))));
    vertices.fold((0.0, 0.0), |(value, gradient): (f64, f64), vertex| {
        let seen = seen_from_leaves(octree, vertex);
        seen.iter().fold((value, gradient), |(value, gradient), corner| {
            (
                value.max((corner.distance() - seen[0].distance()).abs()),
                gradient.max((corner.gradient() - seen[0].gradient()).length()),
            )
        })
    })
}

#[test]
fn each_lattice_point_is_evaluated_once() {
    let function = Spheres::default();
    let settings = settings(Interpolant::Tricubic, Continuity::C1);
    let octree = Octree::build(&function, &BOUNDS, &settings, TARGET, &Silent);

    let asked = function.asked.into_inner().expect("no test thread panics while it holds the lock");
    let distinct: HashSet<[u64; 3]> = asked.iter().map(|point| point.to_array().map(f64::to_bits)).collect();
    assert_eq!(asked.len(), distinct.len(), "some points were asked for twice");
    assert_eq!(asked.len(), octree.samples);
}

#[test]
fn leaves_of_different_levels_meet() {
    for interpolant in [Interpolant::Trilinear, Interpolant::Tricubic] {
        let octree = build(&settings(interpolant, Continuity::C0));
        let levels: HashSet<u8> =
            octree.tree.nodes().iter().filter(|node| node.is_leaf()).map(|leaf| leaf.level).collect();
        assert!(levels.len() > 1, "{interpolant:?}: the test needs leaves of several levels, found {levels:?}");
    }
}

#[test]
fn a_tree_without_continuity_has_seams() {
    let (value, gradient) = seams(&build(&settings(Interpolant::Tricubic, Continuity::None)));
    assert!(value > 1e-4, "value seams of {value}: the other tests would prove nothing");
    assert!(gradient > 1e-2, "gradient seams of {gradient}: the other tests would prove nothing");
}

#[test]
fn c0_makes_the_value_continuous() {
    let octree = build(&settings(Interpolant::Trilinear, Continuity::C0));
    let (value, _) = seams(&octree);
    assert_eq!(octree.continuity, Continuity::C0);
    assert!(value < 1e-6, "value seams of {value}");
}

#[test]
fn c1_makes_value_and_gradient_continuous() {
    for asked in [Continuity::C0, Continuity::C1] {
        let octree = build(&settings(Interpolant::Tricubic, asked));
        let (value, gradient) = seams(&octree);
        assert_eq!(octree.continuity, Continuity::C1);
        assert!(value < 1e-6, "value seams of {value}");
        assert!(gradient < 1e-4, "gradient seams of {gradient}");
    }
}

#[test]
fn the_measured_error_of_a_leaf_is_near_its_target() {
    for interpolant in [Interpolant::Trilinear, Interpolant::Tricubic] {
        let octree = build(&settings(interpolant, Continuity::None));
        let (tree, function) = (&octree.tree, Spheres::default());
        for leaf in tree.nodes().iter().filter(|node| node.is_leaf() && node.level < tree.domain.depth) {
            let patch = octree.corners.patch(tree, leaf);
            let square = |i: usize| {
                let local = (DVec3::new((i % 5) as f64, (i / 5 % 5) as f64, (i / 25) as f64) + 0.5) / 5.0;
                let point = tree.domain.point(leaf.origin) + local * tree.edge(leaf);
                (patch.value(local) - function.sample(point).distance).powi(2)
            };
            let rmse = ((0..125).map(square).sum::<f64>() / 125.0).sqrt();
            // The quadrature of section 5 is an estimate from 27 points; at the kink between the
            // spheres it misses up to half of the error.
            assert!(rmse < 2.0 * TARGET, "{interpolant:?}: error {rmse} in a leaf of level {}", leaf.level);
        }
    }
}

/// Leaves by rule, without continuity, and whether each of those that could still have been split is good
/// enough by the rule's own definition.
fn leaves_under(termination: Termination) -> usize {
    let settings = Settings { termination, ..settings(Interpolant::Tricubic, Continuity::None) };
    let octree = build(&settings);
    let (tree, function) = (&octree.tree, Spheres::default());
    let leaves: Vec<&Node> = tree.nodes().iter().filter(|node| node.is_leaf()).collect();
    for leaf in leaves.iter().filter(|leaf| leaf.level < tree.domain.depth) {
        let patch = octree.corners.patch(tree, leaf);
        let (mut sum, mut weights) = (0.0, 0.0);
        for i in 0..27 {
            let steps = DVec3::new((i % 3) as f64, (i / 3 % 3) as f64, (i / 9) as f64);
            let distance = function.sample(tree.domain.point(leaf.origin) + 0.5 * steps * tree.edge(leaf)).distance;
            let error = (patch.value(0.5 * steps) - distance).abs();
            // Midpoints count twice by the trapezoid rule, four times by Simpson's.
            let midpoints = steps.to_array().into_iter().filter(|&step| step == 1.0).count() as i32;
            let (weight, share) = match termination {
                Termination::Trapezoid => (2f64.powi(midpoints), error / TARGET),
                Termination::Simpson => (4f64.powi(midpoints), error / TARGET),
                Termination::ByDistance => {
                    (2f64.powi(midpoints), error / TARGET / (distance.abs() / (NEAR * BOUNDS.diagonal())).max(1.0))
                }
                Termination::MaxError => {
                    assert!(error <= TARGET * (1.0 + 1e-9), "an error of {error} in a leaf of level {}", leaf.level);
                    (0.0, 0.0)
                }
            };
            sum += weight * share * share;
            weights += weight;
        }
        let mean = if weights > 0.0 { sum / weights } else { 0.0 };
        assert!(mean <= 1.0 + 1e-9, "{termination:?}: {mean} in a leaf of level {}", leaf.level);
    }
    leaves.len()
}

#[test]
fn every_leaf_is_good_enough_by_the_rule_that_was_asked_for() {
    let [trapezoid, simpson, by_distance, max_error] =
        [Termination::Trapezoid, Termination::Simpson, Termination::ByDistance, Termination::MaxError]
            .map(leaves_under);
    // Simpson's rule weighs the midpoints more, where interpolants err; the greatest error is above any mean.
    assert!(by_distance < trapezoid, "{by_distance} {trapezoid}");
    assert!(trapezoid < simpson, "{trapezoid} {simpson}");
    assert!(simpson < max_error, "{simpson} {max_error}");
}

#[test]
fn the_lipschitz_bound_is_at_least_the_slope_of_a_distance() {
    let octree = build(&settings(Interpolant::Tricubic, Continuity::C1));
    assert!((0.99..8.0).contains(&octree.lipschitz), "{}", octree.lipschitz);
}
