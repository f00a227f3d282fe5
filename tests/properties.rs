use crate::shapes;
use crate::support::numbers::Numbers;
use glam::{DVec3, Vec3};
use nearfield::{Field, Leaf};
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Continuity, Interpolant, Layout, Settings, Target};

const TRIALS: usize = 20_000;

fn baked(interpolant: Interpolant) -> Vec<u8> {
    let error = Target::Relative(4e-3);
    let continuity = Continuity::C0;
    let settings = Settings {
        error,
        interpolant,
        continuity,
        max_depth: 6,
        samples: 1000,
        layout: Layout::Octree,
        ..Settings::default()
    };
    bake(&shapes::read("bob_small.ply"), &settings, &Silent).expect("the mesh bakes").bytes
}

/// The five-point formula is exact for the cubics that a leaf is along an axis.
#[test]
fn the_gradient_is_the_derivative_of_the_value() {
    const STEP: f64 = 0.125;
    for interpolant in [Interpolant::Trilinear, Interpolant::Tricubic] {
        let bytes = baked(interpolant);
        let octree = Field::open(&bytes).expect("a field").octree().expect("an octree");
        let leaves: Vec<Leaf> = octree.leaves().collect();
        let mut numbers = Numbers::new(4);
        for _ in 0..TRIALS {
            let leaf = leaves[(numbers.unit() * leaves.len() as f64) as usize];
            let local = numbers.point(DVec3::splat(2.0 * STEP), DVec3::splat(1.0 - 2.0 * STEP));
            let value = |local: DVec3| f64::from(octree.evaluate(&leaf, local.as_vec3().to_array()).0);
            let edge = f64::from(octree.edge(leaf.level));
            let (distance, gradient) = octree.evaluate(&leaf, local.as_vec3().to_array());

            for axis in 0..3 {
                let step = DVec3::AXES[axis] * STEP;
                let near = value(local + step) - value(local - step);
                let far = value(local + 2.0 * step) - value(local - 2.0 * step);
                let derivative = (8.0 * near - far) / (12.0 * STEP * edge);
                // Rounding of the values and of the places, over the step.
                let tolerance = 2.0_f64.powi(-23) * 16.0 / STEP * (f64::from(distance.abs()) + edge) / edge;
                let error = (derivative - f64::from(gradient[axis])).abs();
                assert!(error <= tolerance, "{leaf:?} at {local}: {gradient:?} along {axis} differs by {error:.1e}");
            }
        }
    }
}

/// The contract's Lipschitz bound holds for any two points of the box, but for the jumps that it also states.
#[test]
fn no_slope_exceeds_the_bound() {
    for interpolant in [Interpolant::Trilinear, Interpolant::Tricubic] {
        let bytes = baked(interpolant);
        let field = Field::open(&bytes).expect("a field");
        let header = field.header();
        let [min, max] = [header.bounds.min, header.bounds.max].map(|corner| Vec3::from(corner).as_dvec3());
        let mut numbers = Numbers::new(5);
        for _ in 0..TRIALS {
            let (p, q) = (numbers.point(min, max).as_vec3(), numbers.point(min, max).as_vec3());
            // Close pairs as often as distant ones.
            let q = p + (q - p) * (numbers.unit() as f32).powi(8);
            let (at_p, gradient) = field.distance_and_gradient(p.to_array());
            let slope = Vec3::from(gradient).length();
            assert!(slope <= header.lipschitz * (1.0 + 1e-5), "{slope} at {p} exceeds {}", header.lipschitz);

            let rise = (field.distance(q.to_array()) - at_p).abs();
            let allowed = header.lipschitz * p.distance(q) + field.contract().seam_max + 1e-6 * header.diagonal;
            assert!(rise <= allowed, "from {p} to {q} it rises by {rise}, more than {allowed}");
        }
    }
}
