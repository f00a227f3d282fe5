use crate::shapes;
use glam::DVec3;
use nearfield::Field;
use nearfield_bake::distance::{SignChoice, SignMethod, SignedDistance};
use nearfield_bake::encode::{Provenance, encode_polynomial};
use nearfield_bake::field_function::{FieldFunction, Sample, SampleClosure};
use nearfield_bake::geometry::Aabb;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::polynomial::PolynomialOctree;
use nearfield_bake::polynomial::overlap::Blend;
use nearfield_bake::progress::Silent;
use nearfield_bake::random::Draws;
use nearfield_bake::settings::{Continuity, Layout, PolynomialSettings, Profile, Settings, Target};
use nearfield_bake::verify::measure;
use nearfield_bake::{BakeError, Baked, bake, bake_function, bake_smallest};

fn with_error(error: f64, polynomial: PolynomialSettings) -> Settings {
    Settings {
        error: Target::Relative(error),
        layout: Layout::Polynomial(polynomial),
        samples: 20_000,
        ..Settings::default()
    }
}

fn spot() -> CheckedMesh {
    shapes::read("spot.ply")
}

fn baked(settings: &Settings) -> Baked {
    bake(&spot(), settings, &Silent).expect("the mesh bakes")
}

#[test]
fn errors_keep_their_share_of_the_target_and_faces_do_not_show() {
    let diagonal = spot().bounds.diagonal();
    for error in [2e-3, 1e-3] {
        let measured = baked(&with_error(error, PolynomialSettings::default())).report.measurement;
        let (uniform, band) = (&measured.uniform, &measured.band);
        // What octrees of interpolants reach at the same target (Pujol and Chica 2023).
        assert!(uniform.rmse <= 0.52 * error * diagonal, "{error}: uniform {:.2e}", uniform.rmse / diagonal);
        assert!(band.rmse <= 0.62 * error * diagonal, "{error}: band {:.2e}", band.rmse / diagonal);
        let max = uniform.max().max(band.max());
        assert!(max <= 8.0 * error * diagonal, "{error}: max {:.2e}", max / diagonal);
        assert!(measured.seams.max <= 1e-6 * diagonal, "{error}: seam {:.2e}", measured.seams.max / diagonal);
    }
}

/// A crease between the outermost sample of a cell and its corner, where none of the samples sees it.
#[test]
fn the_corners_of_large_cells_are_seen() {
    let settings = with_error(3e-4, PolynomialSettings::default());
    let cube = Aabb::around([DVec3::ZERO, DVec3::ONE]);
    let bake = |function: &dyn FieldFunction| bake_function(function, &cube, &settings, &Silent).expect("it bakes");
    let corner_of = |bytes: &[u8]| Field::open(bytes).expect("a field").header().bounds.max;

    let flat = bake(&SampleClosure(|_| Sample::default())).bytes;
    let corner = DVec3::from(corner_of(&flat).map(f64::from));
    let falling = DVec3::ONE.normalize();
    let creased = bake(&SampleClosure(move |point: DVec3| {
        let beyond = (point - corner).dot(falling) + 0.0105;
        Sample { distance: -beyond.max(0.0), gradient: if beyond > 0.0 { -falling } else { DVec3::ZERO } }
    }));
    let field = Field::open(&creased.bytes).expect("a field");
    assert_eq!(field.header().bounds.max, corner_of(&flat));

    // Twice the greatest error of a leaf at its samples.
    let greatest = 2.0 * 6.0 * 0.75 * 3e-4 * cube.diagonal();
    let error = (f64::from(field.distance(corner_of(&flat))) + 0.0105).abs();
    assert!(error <= greatest, "{error:.2e}");
}

/// Exact distances jump where winding numbers close a hole. No polynomial follows, and ever smaller cells gain little.
#[test]
fn jumps_are_cut_no_finer_than_the_mean_error_asks() {
    let (error, half) = (2e-3, DVec3::splat(0.5));
    let settings = with_error(error, PolynomialSettings::default());
    let cube = Aabb::around([DVec3::ZERO, DVec3::ONE]);
    let lid = |point: DVec3| {
        let is_behind = point.x < 0.37 && (point - half).abs().max_element() < 0.25;
        Sample { distance: if is_behind { -0.02 } else { 0.02 }, gradient: DVec3::ZERO }
    };
    let baked = bake_function(&SampleClosure(lid), &cube, &settings, &Silent).expect("it bakes");
    let uniform = baked.report.measurement.uniform.rmse / cube.diagonal();
    assert!(uniform <= error, "{uniform:.2e}");
    assert!(baked.bytes.len() < 100_000, "{} bytes", baked.bytes.len());
}

/// An octree of Spot as the baker has it, and its bytes.
fn octree_and_bytes(error: f64, continuity: Continuity) -> (PolynomialOctree, Vec<u8>) {
    let mesh = spot();
    let distance = SignedDistance::new(&mesh, SignMethod::Pseudonormal);
    let diagonal = mesh.bounds.diagonal();
    let polynomial = PolynomialSettings::default();
    let settings = Settings { continuity, ..with_error(error, polynomial) };
    let octree = PolynomialOctree::build(&distance, &mesh.bounds, &settings, &polynomial, diagonal, &Silent);
    let octree = octree.expect("no greatest error is asked for");
    let provenance = Provenance {
        mesh_hash: [0; 16],
        settings_hash: [0; 8],
        sign_method: 1,
        diagonal,
        target_error: error * diagonal,
    };
    let bytes = encode_polynomial(&octree, &provenance).expect("it fits the format");
    (octree, bytes)
}

#[test]
fn the_reader_answers_the_blend_of_the_leaves() {
    let diagonal = spot().bounds.diagonal();
    for continuity in [Continuity::None, Continuity::C1] {
        let (octree, bytes) = octree_and_bytes(2e-3, continuity);
        let field = Field::open(&bytes).expect("a field");
        assert_eq!(field.validate(), Ok(()), "{continuity:?}");

        let blend = Blend::new(&octree.cells, &octree.reaches, octree.overlap, &octree.steps);
        let bounds = field.polynomial_octree().expect("an octree of polynomials").bounds();
        let (min, max) = (DVec3::from(bounds.min.map(f64::from)), DVec3::from(bounds.max.map(f64::from)));
        let mut off = 0;
        for index in 0..4000 {
            let mut draws = Draws::new(8, 15, index);
            let point = min + (max - min) * DVec3::new(draws.unit(), draws.unit(), draws.unit());
            let point = point.as_vec3();
            let (found, _) = field.distance_and_gradient(point.to_array());
            let (wanted, _) = blend.evaluate(point.as_dvec3());
            off += usize::from((f64::from(found) - wanted).abs() > 1e-6 * diagonal);
        }
        // Without overlap a point within rounding of a face may belong to the leaf on either side.
        assert!(off <= if continuity == Continuity::None { 2 } else { 0 }, "{continuity:?}: {off} answers differ");
    }
}

/// The reader looks beyond the faces of a leaf; what it is compared with adds up all leaves that touch it.
#[test]
fn beyond_the_faces_of_a_deep_field_no_leaf_is_missed() {
    let diagonal = spot().bounds.diagonal();
    let (octree, bytes) = octree_and_bytes(3e-4, Continuity::C1);
    let field = Field::open(&bytes).expect("a field");
    let polynomials = field.polynomial_octree().expect("an octree of polynomials");
    let blend = Blend::new(&octree.cells, &octree.reaches, octree.overlap, &octree.steps);
    let bounds = polynomials.bounds();
    let (min, max) = (DVec3::from(bounds.min.map(f64::from)), DVec3::from(bounds.max.map(f64::from)));
    let lattice = DVec3::from(polynomials.lattice().map(f64::from));

    let (mut points, mut turned, mut least_edge, mut greatest_edge) = (0, 0, u32::MAX, 0);
    for (index, leaf) in polynomials.leaves().enumerate() {
        let mut draws = Draws::new(9, 15, index as u64);
        (least_edge, greatest_edge) = (least_edge.min(leaf.edge), greatest_edge.max(leaf.edge));
        // Near its faces, edges and corners, on either side: as far as any support reaches.
        let mut local = DVec3::new(draws.unit(), draws.unit(), draws.unit());
        for axis in 0..3 {
            if draws.unit() < 0.6 {
                local[axis] = (2.0 * draws.unit()).floor() + 0.5 * (draws.unit() - 0.5);
            }
        }
        let cells = DVec3::from(leaf.cell.map(f64::from)) + f64::from(leaf.edge) * local;
        let point = (min + (max - min) * cells.clamp(DVec3::ZERO, lattice) / lattice).as_vec3();
        let point = point.clamp(bounds.min.into(), bounds.max.into());

        let (found, slope) = field.distance_and_gradient(point.to_array());
        let (wanted, wanted_slope) = blend.evaluate(point.as_dvec3());
        assert!((f64::from(found) - wanted).abs() <= 1e-6 * diagonal, "{found} is not {wanted} at {point}");
        // At a crease within a leaf rounding decides on which side a point is.
        turned += usize::from((DVec3::from(slope.map(f64::from)) - wanted_slope).length() > 1e-3);
        points += 1;
    }
    assert!(greatest_edge >= 16 * least_edge, "leaves of edges {least_edge} to {greatest_edge}");
    assert!(turned * 1000 <= points, "{turned} of {points} gradients differ");
}

#[test]
fn the_surface_profile_spares_bytes_far_away_alone() {
    let uniform = baked(&with_error(1e-3, PolynomialSettings::default()));
    let surface = PolynomialSettings { profile: Profile::Surface, ..PolynomialSettings::default() };
    let surface = baked(&with_error(1e-3, surface));
    assert!(4 * surface.bytes.len() < 3 * uniform.bytes.len(), "{} bytes", surface.bytes.len());
    let (band, before) = (surface.report.measurement.band.rmse, uniform.report.measurement.band.rmse);
    assert!(band <= 1.05 * before, "{band} near the surface instead of {before}");
}

#[test]
fn a_greatest_error_is_kept() {
    let mesh = spot();
    let (diagonal, distance) = (mesh.bounds.diagonal(), SignedDistance::choose(&mesh, SignChoice::Auto).0);
    for (asked, profile) in [(4e-3, Profile::Uniform), (5e-3, Profile::Surface)] {
        let settings = PolynomialSettings { max_error: Some(Target::Relative(asked)), profile, ..Default::default() };
        let baked = baked(&with_error(2e-3, settings));
        let max = baked.report.measurement.greatest(profile);
        assert!(max <= asked * diagonal, "{asked}: {:.2e}", max / diagonal);

        // Where nobody looked before.
        let field = Field::open(&baked.bytes).expect("a field");
        let fresh = measure(&field, &distance, &mesh, 100_000, 77).greatest(profile);
        assert!(fresh <= asked * diagonal, "{asked}: {:.2e} at fresh points", fresh / diagonal);
    }
}

#[test]
fn a_greatest_error_that_no_leaf_keeps_is_refused() {
    let asked = PolynomialSettings { max_error: Some(Target::Relative(6e-3)), ..PolynomialSettings::default() };
    let settings = Settings { max_depth: 4, ..with_error(2e-3, asked) };
    let Err(BakeError::Unkept(unkept)) = bake(&spot(), &settings, &Silent) else {
        panic!("a greatest error of 6e-3 in leaves of level 4");
    };
    assert!(unkept.error > 5e-3 * spot().bounds.diagonal(), "{unkept}");
}

#[test]
fn the_smallest_layout_is_no_larger_and_no_worse_than_the_octree() {
    // So coarse that a grid wins, and as fine as not to let one.
    let cases = [("bob_small.ply", 5e-2, Continuity::None, true), ("spot.ply", 4e-3, Continuity::C1, false)];
    for (file, error, continuity, is_grid) in cases {
        let mesh = shapes::read(file);
        let settings = Settings { continuity, ..with_error(error, PolynomialSettings::default()) };
        let octree = bake(&mesh, &settings, &Silent).expect("the mesh bakes");
        let (smallest, chosen) = bake_smallest(&mesh, &settings, &Silent).expect("the mesh bakes");

        assert_eq!(matches!(chosen.layout, Layout::Grid(_)), is_grid, "{file}");
        assert_eq!(smallest.bytes.len() < octree.bytes.len(), is_grid, "{file}");
        let (found, asked) = (&smallest.report.measurement, &octree.report.measurement);
        for (found, asked) in [(&found.uniform, &asked.uniform), (&found.band, &asked.band)] {
            assert!(found.rmse <= asked.rmse && found.max() <= asked.max(), "{file}");
        }
        assert!(bake(&mesh, &chosen, &Silent).expect("the mesh bakes").bytes == smallest.bytes, "{file}");
    }
}

#[test]
fn a_budget_is_filled_or_refused() {
    let settings = Settings { max_bytes: Some(24_000), ..with_error(5e-4, PolynomialSettings::default()) };
    let bytes = baked(&settings).bytes.len();
    assert!((23_000..=24_000).contains(&bytes), "{bytes} bytes");

    let tiny = Settings { max_bytes: Some(1_000), ..settings };
    let Err(BakeError::Budget { max_bytes: 1_000, smallest }) = bake(&spot(), &tiny, &Silent) else {
        panic!("a field in a thousand bytes");
    };
    let fits = Settings { max_bytes: Some(smallest as u64), ..settings };
    assert_eq!(baked(&fits).bytes.len(), smallest);
}

#[test]
fn one_two_and_eight_threads_give_the_same_bytes() {
    let bytes_with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| baked(&with_error(2e-3, PolynomialSettings::default())).bytes)
    };
    let bytes = bytes_with(1);
    for threads in [2, 8] {
        assert!(bytes_with(threads) == bytes, "{threads} threads");
    }
}
