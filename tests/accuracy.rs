use crate::shapes;
use glam::{DVec3, Vec3};
use nearfield::Field;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::progress::Silent;
use nearfield_bake::random::Draws;
use nearfield_bake::settings::{Continuity, Interpolant, Layout, Precision, Settings, Target};
use nearfield_bake::{Baked, bake};

const TARGET: f64 = 2e-3;
const POINTS: u64 = 50_000;

fn settings(interpolant: Interpolant, precision: Precision) -> Settings {
    Settings {
        error: Target::Relative(TARGET),
        interpolant,
        continuity: Continuity::C0,
        precision,
        max_depth: 8,
        samples: 20_000,
        layout: Layout::Octree,
        ..Settings::default()
    }
}

/// Root mean square and largest error over points of the mesh's box, by an oracle that shares nothing with the baker.
fn errors(field: &Field<'_>, mesh: &CheckedMesh, truth: impl Fn(DVec3) -> f64) -> (f64, f64) {
    let errors: Vec<f64> = (0..POINTS)
        .map(|index| {
            let mut draws = Draws::new(99, 0, index);
            let unit = DVec3::new(draws.unit(), draws.unit(), draws.unit());
            let point: Vec3 = (mesh.bounds.min + unit * mesh.bounds.size()).as_vec3();
            (f64::from(field.distance(point.to_array())) - truth(point.as_dvec3())).abs()
        })
        .collect();
    let mean_square = errors.iter().map(|error| error * error).sum::<f64>() / POINTS as f64;
    (mean_square.sqrt(), errors.iter().copied().fold(0.0, f64::max))
}

fn baked(mesh: &CheckedMesh, settings: &Settings) -> Baked {
    bake(mesh, settings, &Silent).expect("the mesh bakes")
}

fn every_kind() -> impl Iterator<Item = Settings> {
    [Interpolant::Trilinear, Interpolant::Tricubic].into_iter().flat_map(|interpolant| {
        [Precision::Packed32, Precision::F16, Precision::F32].map(|precision| settings(interpolant, precision))
    })
}

#[test]
fn a_box_meets_its_target_by_formula() {
    let mesh = shapes::cuboid();
    let diagonal = mesh.bounds.diagonal();

    for settings in every_kind() {
        let baked = baked(&mesh, &settings);
        let field = Field::open(&baked.bytes).expect("a field");
        let (rmse, _) = errors(&field, &mesh, shapes::distance_to_cuboid);
        assert!(rmse <= TARGET * diagonal, "{settings:?}: {:e} of the diagonal", rmse / diagonal);
    }
}

#[test]
fn a_sphere_meets_its_target_by_formula() {
    let (mesh, depth) = shapes::sphere(5);
    let diagonal = mesh.bounds.diagonal();

    for settings in every_kind() {
        let baked = baked(&mesh, &settings);
        let field = Field::open(&baked.bytes).expect("a field");
        let (rmse, _) = errors(&field, &mesh, |point| point.length() - 1.0);
        // The mesh itself is up to `depth` inside the sphere.
        assert!(rmse <= TARGET * diagonal + depth, "{settings:?}: {:e} of the diagonal", rmse / diagonal);
    }
}

#[test]
fn the_contract_says_what_the_formula_says() {
    let mesh = shapes::cuboid();
    for settings in every_kind() {
        let baked = baked(&mesh, &settings);
        let field = Field::open(&baked.bytes).expect("a field");
        let contract = field.contract();
        let (rmse, max) = errors(&field, &mesh, shapes::distance_to_cuboid);

        // Two random samples of the same errors: their RMSE agree to 10 %, their maxima to a factor of two.
        let ratio = rmse / f64::from(contract.uniform.rmse);
        assert!((0.9..1.1).contains(&ratio), "{settings:?}: RMSE {ratio} times the stored one");
        let ratio = max / f64::from(contract.uniform.max);
        assert!((0.5..2.0).contains(&ratio), "{settings:?}: maximum {ratio} times the stored one");
    }
}

#[test]
fn a_smaller_target_gives_a_smaller_error() {
    let mesh = shapes::cuboid();
    let rmse = |target: f64| {
        let settings = Settings { error: Target::Relative(target), ..settings(Interpolant::Tricubic, Precision::F32) };
        baked(&mesh, &settings).report.measurement.uniform.rmse
    };

    let errors = [8e-3, 2e-3, 5e-4].map(rmse);
    assert!(errors.is_sorted_by(|coarse, fine| coarse > fine), "{errors:?}");
}
