use crate::shapes;
use glam::{DVec3, Vec3};
use nearfield::layout::section;
use nearfield::{Field, Interpolant as ReadInterpolant, SignMethod};
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Continuity, Interpolant, Layout, Precision, Settings, Target};

fn quick() -> Settings {
    Settings {
        error: Target::Relative(2e-3),
        max_depth: 7,
        samples: 10_000,
        layout: Layout::Octree,
        ..Settings::default()
    }
}

#[test]
fn the_header_says_what_was_asked_and_measured() {
    let mesh = shapes::read("bob_small.ply");
    let settings = Settings { margin: 0.1, ..quick() };
    let baked = bake(&mesh, &settings, &Silent).expect("the mesh bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    assert_eq!(field.validate(), Ok(()));
    let header = field.header();

    // The mesh.
    assert_eq!(header.diagonal, mesh.bounds.diagonal() as f32);
    assert_eq!(header.mesh_hash, mesh.hash());
    assert_eq!(header.sign_method, SignMethod::Pseudonormal);

    // The settings.
    assert_eq!(header.target_error, (2e-3 * mesh.bounds.diagonal()) as f32);
    assert_eq!(header.settings_hash, settings.hash());
    assert_eq!(field.octree().expect("an octree").interpolant(), ReadInterpolant::Tricubic);

    // The box holds the mesh and its margin.
    let margin = 0.1 * mesh.bounds.size().max_element();
    let rounding = 1e-6 * mesh.bounds.diagonal();
    let (min, max) = (Vec3::from(header.bounds.min).as_dvec3(), Vec3::from(header.bounds.max).as_dvec3());
    assert!((mesh.bounds.min - margin + rounding).cmpge(min).all(), "{min} is not low enough");
    assert!((mesh.bounds.max + margin - rounding).cmple(max).all(), "{max} is not high enough");

    // The contract.
    assert_eq!(field.contract(), baked.report.measurement.contract());
    assert_eq!(field.contract().sample_count, settings.samples);

    // The tree.
    assert_eq!(
        field.octree().expect("an octree").leaves().count(),
        field.octree().expect("an octree").leaf_count() as usize
    );
    assert_eq!(
        field.octree().expect("an octree").leaf_count() as usize,
        baked.report.leaves_by_level.iter().sum::<usize>()
    );
}

#[test]
fn the_sections_tile_the_file() {
    let baked = bake(&shapes::cuboid(), &quick(), &Silent).expect("the mesh bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    let sections: Vec<_> = field.sections().collect();

    let kinds: Vec<u32> = sections.iter().map(|section| section.kind).collect();
    assert_eq!(kinds, [section::OCTREE, section::NODES, section::SAMPLES]);
    assert!(sections.windows(2).all(|pair| pair[0].range.end == pair[1].range.start), "{sections:?}");
    assert_eq!(sections.last().map(|section| section.range.end), Some(baked.bytes.len()));
}

/// Every vertex of a mesh is on its surface.
#[test]
fn every_kind_of_field_vanishes_at_the_vertices() {
    let mesh = shapes::read("bob_small.ply");
    for interpolant in [Interpolant::Trilinear, Interpolant::Tricubic] {
        for continuity in [Continuity::None, Continuity::C0, Continuity::C1] {
            for precision in [Precision::Packed32, Precision::F16, Precision::F32] {
                let settings = Settings { interpolant, continuity, precision, ..quick() };
                if settings.check().is_err() {
                    continue;
                }
                let baked = bake(&mesh, &settings, &Silent).expect("the mesh bakes");
                let field = Field::open(&baked.bytes).expect("a field");
                assert_eq!(field.validate(), Ok(()), "{settings:?}");

                // A leaf's error is bounded on average only: allow for its worst point.
                let squares = mesh.positions.iter().map(|&vertex| f64::from(distance(&field, vertex)).powi(2));
                let rmse = (squares.sum::<f64>() / mesh.positions.len() as f64).sqrt();
                let target = settings.error.absolute(mesh.bounds.diagonal());
                assert!(rmse <= 2.0 * target, "{settings:?}: {:.2} times the target", rmse / target);
            }
        }
    }
}

#[test]
fn outside_the_box_the_distance_grows_with_the_distance_to_the_box() {
    let mesh = shapes::cuboid();
    let baked = bake(&mesh, &quick(), &Silent).expect("the mesh bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    let corner = DVec3::from(field.header().bounds.max.map(f64::from));

    let at_corner = distance(&field, corner);
    let (beyond, gradient) = field.distance_and_gradient((corner + DVec3::new(3.0, 4.0, 12.0)).as_vec3().to_array());

    assert!((beyond - (at_corner + 13.0)).abs() <= 1e-5 * beyond, "{beyond} against {at_corner} + 13");
    assert!((Vec3::from(gradient) - Vec3::new(3.0, 4.0, 12.0) / 13.0).length() < 1e-6, "{gradient:?}");
}

fn distance(field: &Field<'_>, point: DVec3) -> f32 {
    field.distance(point.as_vec3().to_array())
}
