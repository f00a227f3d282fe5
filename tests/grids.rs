use crate::shapes;
use glam::{DVec3, Vec3};
use nearfield::{Error, Field, Reconstruction as Read, SignMethod};
use nearfield_bake::field_function::{Closure, FieldFunction, Sample, SampleClosure};
use nearfield_bake::geometry::Aabb;
use nearfield_bake::progress::Silent;
use nearfield_bake::random::Draws;
use nearfield_bake::settings::{
    FineGrid, GridSettings, Layout, Precision, RangeScope, Reconstruction, Resolution, Sampling, Settings,
    SettingsError,
};
use nearfield_bake::{Baked, bake, bake_function};

const BOX: Aabb = Aabb { min: DVec3::new(-1.0, -0.5, 2.0), max: DVec3::new(1.0, 1.0, 3.0) };

const ALL: [(u8, Reconstruction); 15] = [
    (0, Reconstruction::Nearest),
    (0, Reconstruction::Linear),
    (1, Reconstruction::Nearest),
    (1, Reconstruction::Linear),
    (1, Reconstruction::Half),
    (1, Reconstruction::Blend),
    (1, Reconstruction::Hermite),
    (2, Reconstruction::Nearest),
    (2, Reconstruction::Linear),
    (2, Reconstruction::Half),
    (2, Reconstruction::Blend),
    (2, Reconstruction::Hermite),
    (3, Reconstruction::Nearest),
    (3, Reconstruction::Half),
    (3, Reconstruction::Blend),
];

fn settings(order: u8, reconstruction: Reconstruction, precision: Precision) -> Settings {
    let fine = FineGrid { count: 5, extent: 0.5, falloff: 0.0, normalized: false };
    let sampling = if order < 2 { Sampling::Taylor } else { Sampling::LeastSquares(fine) };
    let grid = GridSettings {
        resolution: Resolution::Each([5, 7, 6]),
        order,
        reconstruction,
        sampling,
        range: if precision == Precision::F32 { RangeScope::File } else { RangeScope::Brick },
    };
    Settings { layout: Layout::Grid(grid), precision, margin: 0.05, samples: 2_000, ..Settings::default() }
}

/// A random polynomial of total degree `degree`, coefficients up to 1.
fn polynomial(degree: u32, seed: u64) -> impl Fn(DVec3) -> Sample + Sync {
    let mut draws = Draws::new(seed, 77, 0);
    let mut terms = Vec::new();
    for (a, b, c) in (0..4).flat_map(|a| (0..4).flat_map(move |b| (0..4).map(move |c| (a, b, c)))) {
        if a + b + c <= degree {
            terms.push((a as i32, b as i32, c as i32, 2.0 * draws.unit() - 1.0));
        }
    }
    move |p| {
        let mut sample = Sample::default();
        for &(a, b, c, k) in &terms {
            let power = |x: f64, n: i32| if n < 0 { 0.0 } else { x.powi(n) };
            let (x, y, z) = (p.x, p.y, p.z);
            sample.distance += k * power(x, a) * power(y, b) * power(z, c);
            sample.gradient += k * DVec3::new(
                f64::from(a) * power(x, a - 1) * power(y, b) * power(z, c),
                f64::from(b) * power(x, a) * power(y, b - 1) * power(z, c),
                f64::from(c) * power(x, a) * power(y, b) * power(z, c - 1),
            );
        }
        sample
    }
}

fn sphere(point: DVec3) -> Sample {
    let offset = point - DVec3::new(0.1, 0.2, 2.4);
    Sample { distance: offset.length() - 0.35, gradient: offset.normalize_or_zero() }
}

fn bake_sample(sample: impl Fn(DVec3) -> Sample + Sync, settings: &Settings) -> Baked {
    bake_function(&SampleClosure(sample), &BOX, settings, &Silent).expect("the function bakes")
}

/// Largest difference of value and of gradient between field and function inside the box.
fn largest_error(field: &Field<'_>, function: impl Fn(DVec3) -> Sample) -> (f64, f64) {
    let bounds = field.header().bounds;
    let (min, max) = (Vec3::from(bounds.min).as_dvec3(), Vec3::from(bounds.max).as_dvec3());
    let mut largest = (0.0_f64, 0.0_f64);
    for index in 0..3_000 {
        let mut draws = Draws::new(5, 5, index);
        let point = (min + (max - min) * DVec3::new(draws.unit(), draws.unit(), draws.unit())).as_vec3();
        let (distance, gradient) = field.distance_and_gradient(point.to_array());
        assert_eq!(distance.to_bits(), field.distance(point.to_array()).to_bits());
        let exact = function(point.as_dvec3());
        largest.0 = largest.0.max((f64::from(distance) - exact.distance).abs());
        largest.1 = largest.1.max((Vec3::from(gradient).as_dvec3() - exact.gradient).length());
    }
    largest
}

/// A reduced blend is exact one degree above its order: `half` of order 1 on every quadratic, of order 2 on every cubic.
#[test]
fn half_is_exact_on_polynomials_one_degree_higher() {
    for (order, seed) in [1, 2, 3].into_iter().flat_map(|order| (0..8).map(move |seed| (order, seed))) {
        let function = polynomial(u32::from(order) + 1, seed);
        let error = |reconstruction| {
            let mut settings = settings(order, reconstruction, Precision::F32);
            let Layout::Grid(grid) = &mut settings.layout else { panic!("a grid") };
            // A narrow fit is the Taylor polynomial: it differs by the square of its reach.
            if let Sampling::LeastSquares(fine) = &mut grid.sampling {
                fine.extent = 0.005;
            }
            let baked = bake_sample(&function, &settings);
            largest_error(&Field::open(&baked.bytes).expect("a field"), &function)
        };
        let (value, gradient) = error(Reconstruction::Half);
        assert!(value < 2e-4 && gradient < 2e-3, "order {order}: {value} {gradient}");

        // The whole polynomials are not.
        let (whole, _) = error(Reconstruction::Linear);
        assert!(whole > 4.0 * value && whole > 2e-4, "order {order}: {whole} against {value}");
    }
}

/// Every reconstruction reproduces the polynomials that its samples hold.
#[test]
fn every_order_reproduces_its_own_polynomials() {
    for (order, reconstruction) in ALL {
        // Hermite of order 2 lacks the mixed derivatives of degree 3, not those of a quadratic.
        let function = polynomial(u32::from(order), 3);
        let baked = bake_sample(&function, &settings(order, reconstruction, Precision::F32));
        let field = Field::open(&baked.bytes).expect("a field");
        assert_eq!(field.validate(), Ok(()));
        let (value, gradient) = largest_error(&field, &function);
        let twist = order == 1 && reconstruction == Reconstruction::Hermite;
        assert!(value < 3e-4, "{order} {reconstruction:?}: {value}");
        assert!(gradient < 4e-3 || twist, "{order} {reconstruction:?}: {gradient}");
    }
}

/// The distance to two spheres, with a kink between them.
fn spheres(point: DVec3) -> Sample {
    let ball = |centre: DVec3| {
        let offset = point - centre;
        Sample { distance: offset.length() - 0.3, gradient: offset.normalize_or(DVec3::X) }
    };
    let (a, b) = (ball(DVec3::new(-0.4, 0.1, 2.4)), ball(DVec3::new(0.5, 0.3, 2.6)));
    if a.distance <= b.distance { a } else { b }
}

/// What is fitted errs less than what is sampled, in mean square everywhere, and keeps what samples hold exactly.
#[test]
fn fitted_samples_err_less_than_exact_ones() {
    for (order, reconstruction) in [
        (0, Reconstruction::Linear),
        (1, Reconstruction::Half),
        (1, Reconstruction::Blend),
        (1, Reconstruction::Hermite),
    ] {
        for precision in [Precision::F32, Precision::Packed32] {
            let baked = |sampling| {
                let mut settings = settings(order, reconstruction, precision);
                let Layout::Grid(grid) = &mut settings.layout else { panic!("a grid") };
                (grid.sampling, grid.resolution) = (sampling, Resolution::Longest(17));
                bake_sample(spheres, &settings)
            };
            let [exact, fitted] = [baked(Sampling::Taylor), baked(Sampling::Fitted)];
            let rmse = |baked: &Baked| baked.report.measurement.uniform.rmse;
            let ratio = rmse(&fitted) / rmse(&exact);
            assert!(ratio < 0.9, "{order} {reconstruction:?} {precision:?}: {ratio} of the error");
            assert_eq!(exact.bytes.len(), fitted.bytes.len());
        }

        let mut settings = settings(order, reconstruction, Precision::F32);
        let Layout::Grid(grid) = &mut settings.layout else { panic!("a grid") };
        grid.sampling = Sampling::Fitted;
        let function = polynomial(u32::from(order), 3);
        let baked = bake_sample(&function, &settings);
        let (value, _) = largest_error(&Field::open(&baked.bytes).expect("a field"), &function);
        assert!(value < 3e-4, "{order} {reconstruction:?}: {value}");
    }
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    for (order, reconstruction) in [(1, Reconstruction::Nearest), (2, Reconstruction::Half)] {
        let mut settings = settings(order, reconstruction, Precision::F32);
        let Layout::Grid(grid) = &mut settings.layout else { panic!("a grid") };
        grid.sampling = Sampling::Fitted;
        assert_eq!(settings.check(), Err(SettingsError::Fitted), "{order} {reconstruction:?}");
    }
}

/// Bán and Valasek 2020, section 3: blending values is blending coefficients in the global power basis.
#[test]
fn linear_is_the_interpolation_of_global_coefficients() {
    let baked = bake_sample(sphere, &settings(1, Reconstruction::Linear, Precision::F32));
    let field = Field::open(&baked.bytes).expect("a field");
    let grid = field.grid().expect("a grid");
    let (min, spacing) = (Vec3::from(grid.bounds().min).as_dvec3(), Vec3::from(grid.spacing()).as_dvec3());

    for index in 0..2_000 {
        let mut draws = Draws::new(1, 1, index);
        let place = DVec3::new(4.0 * draws.unit(), 6.0 * draws.unit(), 5.0 * draws.unit());
        let cell = place.floor();
        let t = place - cell;
        let point = (min + place * spacing).as_vec3();

        // a x + b y + c z + d, each interpolated.
        let (mut slope, mut constant) = (DVec3::ZERO, 0.0);
        for corner in 0..8_u32 {
            let end = DVec3::new(f64::from(corner >> 2), f64::from(corner >> 1 & 1), f64::from(corner & 1));
            let at = (cell + end).as_uvec3();
            let (value, gradient) = grid.sample(at.to_array());
            let gradient = Vec3::from(gradient).as_dvec3();
            let weight = (1.0 - t + end * (2.0 * t - 1.0)).element_product();
            slope += weight * gradient;
            constant += weight * (f64::from(value) - gradient.dot(min + at.as_dvec3() * spacing));
        }
        let expected = slope.dot(point.as_dvec3()) + constant;
        let found = f64::from(field.distance(point.to_array()));
        assert!((found - expected).abs() < 3e-6, "{found} {expected}");
    }
}

/// Values never jump between cells, gradients not where the reconstruction is smooth.
#[test]
fn cells_meet_as_smoothly_as_they_should() {
    for (order, reconstruction) in ALL {
        for precision in [Precision::F32, Precision::F16, Precision::Packed32] {
            let baked = bake_sample(sphere, &settings(order, reconstruction, precision));
            let seams = &baked.report.measurement.seams;
            assert!(seams.points > 1_000);
            if reconstruction == Reconstruction::Nearest {
                assert!(seams.max > 1e-4, "{order}: nearest jumps");
                continue;
            }
            assert_eq!(seams.max, 0.0, "{order} {reconstruction:?} {precision:?}");
            let smooth = matches!(reconstruction, Reconstruction::Blend | Reconstruction::Hermite);
            let bound = if smooth { 2e-5 } else { f64::INFINITY };
            assert!(seams.gradient_max <= bound, "{order} {reconstruction:?} {precision:?}: {}", seams.gradient_max);
            if !smooth {
                assert!(seams.gradient_max > 1e-3, "{order} {reconstruction:?}: a kink at every face");
            }
        }
    }
}

/// The gradient is the derivative of the value, and no steeper than the header says.
#[test]
fn gradients_are_derivatives_and_within_the_bound() {
    for (order, reconstruction) in ALL {
        let baked = bake_sample(sphere, &settings(order, reconstruction, Precision::F32));
        let field = Field::open(&baked.bytes).expect("a field");
        let bound = f64::from(field.header().lipschitz);
        let mut steepest: f64 = 0.0;
        for index in 0..2_000 {
            let mut draws = Draws::new(8, 8, index);
            let point = BOX.min + BOX.size() * DVec3::new(draws.unit(), draws.unit(), draws.unit());
            let at = |offset: DVec3| f64::from(field.distance((point + offset).as_vec3().to_array()));
            let gradient = Vec3::from(field.distance_and_gradient(point.as_vec3().to_array()).1).as_dvec3();
            steepest = steepest.max(gradient.length());

            // Unless the difference straddles two cells.
            const STEP: f64 = 1.0 / 512.0;
            let grid = field.grid().expect("a grid");
            let place = (point - Vec3::from(grid.bounds().min).as_dvec3()) / Vec3::from(grid.spacing()).as_dvec3();
            let near_face = |t: f64| (2.0 * t - (2.0 * t).round()).abs() < 0.05;
            if near_face(place.x) || near_face(place.y) || near_face(place.z) {
                continue;
            }
            let slope = |axis: DVec3| (at(STEP * axis) - at(-STEP * axis)) / (2.0 * STEP);
            let difference = DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z));
            assert!((difference - gradient).length() < 6e-3, "{order} {reconstruction:?}: {difference} {gradient}");
        }
        assert!(steepest <= bound, "{order} {reconstruction:?}: {steepest} {bound}");
        assert!(bound < 1.55 * steepest + 1e-30, "{order} {reconstruction:?}: {bound} is far from {steepest}");
    }
}

/// A sample is wrong by half a quantum, and a gradient by half a step of its code.
#[test]
fn stored_samples_are_as_close_as_their_bits_allow() {
    for precision in [Precision::F32, Precision::F16, Precision::Packed32] {
        for (order, range) in [(0, RangeScope::Brick), (1, RangeScope::Brick), (1, RangeScope::File)] {
            let mut settings = settings(order, Reconstruction::Linear, precision);
            let Layout::Grid(grid) = &mut settings.layout else { panic!("a grid") };
            grid.range = range;
            grid.resolution = Resolution::Longest(21);
            let baked = bake_sample(sphere, &settings);
            let field = Field::open(&baked.bytes).expect("a field");
            assert_eq!(field.validate(), Ok(()), "{precision:?} {order} {range:?}");
            let grid = field.grid().expect("a grid");
            let quantum = if precision == Precision::F32 { 1e-6 } else { f64::from(grid.quantum()) };
            let [nx, ny, nz] = grid.resolution();
            for at in (0..nx).flat_map(|x| (0..ny).flat_map(move |y| (0..nz).map(move |z| [x, y, z]))) {
                let place = Vec3::from(at.map(|at| at as f32)).as_dvec3();
                let point = Vec3::from(grid.bounds().min).as_dvec3() + place * Vec3::from(grid.spacing()).as_dvec3();
                let (value, gradient) = grid.sample(at);
                let exact = sphere(point);
                let error = (f64::from(value) - exact.distance).abs();
                assert!(error <= 0.501 * quantum + 3e-7, "{precision:?} {range:?}: {error} {quantum}");
                if order == 1 {
                    let off = (Vec3::from(gradient).as_dvec3() - exact.gradient).length();
                    assert!(off < 0.003, "{precision:?}: {off}");
                }
            }
        }
    }
}

/// A brick's own range is worth its few bytes.
#[test]
fn brick_ranges_are_finer_than_the_file() {
    let quantum = |range| {
        let mut settings = settings(1, Reconstruction::Half, Precision::Packed32);
        let Layout::Grid(grid) = &mut settings.layout else { panic!("a grid") };
        (grid.range, grid.resolution) = (range, Resolution::Longest(41));
        let baked = bake_sample(sphere, &settings);
        (Field::open(&baked.bytes).expect("a field").grid().expect("a grid").quantum(), baked.bytes.len())
    };
    let (brick, brick_bytes) = quantum(RangeScope::Brick);
    let (file, file_bytes) = quantum(RangeScope::File);
    assert!(brick * 5.0 < file, "{brick} {file}");
    assert!((brick_bytes as f64) < 1.04 * file_bytes as f64, "{brick_bytes} {file_bytes}");
}

#[test]
fn a_mesh_in_a_grid_keeps_its_contract_and_its_settings() {
    let mesh = shapes::cuboid();
    let baked = bake(&mesh, &settings(1, Reconstruction::Hermite, Precision::Packed32), &Silent).expect("bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    let grid = field.grid().expect("a grid");
    assert!(field.octree().is_none());
    assert_eq!((grid.order(), grid.reconstruction(), grid.resolution()), (1, Read::Hermite, [5, 7, 6]));
    assert_eq!(field.contract(), baked.report.measurement.contract());
    assert!(field.contract().uniform.rmse < 0.02, "{:?}", field.contract());

    // The box holds the mesh and its margin.
    let (min, max) = (Vec3::from(grid.bounds().min).as_dvec3(), Vec3::from(grid.bounds().max).as_dvec3());
    assert!((shapes::CUBOID.min - 0.05).cmpge(min).all() && (shapes::CUBOID.max + 0.05).cmple(max).all());
}

#[test]
fn a_closure_bakes_with_and_without_its_gradient() {
    let settings = settings(1, Reconstruction::Half, Precision::F32);
    let exact = bake_sample(sphere, &settings);
    let closure = Closure { distance: |point| sphere(point).distance, step: 1e-5 };
    let differences = bake_function(&closure, &BOX, &settings, &Silent).expect("the function bakes");

    for baked in [&exact, &differences] {
        let field = Field::open(&baked.bytes).expect("a field");
        let header = field.header();
        assert_eq!((header.sign_method, header.mesh_hash), (SignMethod::None, [0; 16]));
        assert_eq!(baked.report.sign, None);
        assert_eq!(field.contract().sample_count, settings.samples);
        assert!(baked.report.measurement.band.count() > 500, "{:?}", baked.report.measurement.band.count());
        let point = [0.5, 0.25, 2.5];
        let exact = sphere(Vec3::from(point).as_dvec3()).distance;
        assert!((f64::from(field.distance(point)) - exact).abs() < 0.02);
    }
    let (a, b) = (Field::open(&exact.bytes), Field::open(&differences.bytes));
    let difference = a.expect("a field").distance([0.4; 3]) - b.expect("a field").distance([0.4; 3]);
    assert!(difference.abs() < 1e-5, "{difference}");
    assert!((closure.sample(DVec3::ONE).gradient - sphere(DVec3::ONE).gradient).length() < 1e-8);
}

/// The same function in an octree.
#[test]
fn a_closure_bakes_into_an_octree() {
    let settings = Settings { layout: Layout::Octree, max_depth: 6, samples: 2_000, ..Settings::default() };
    let baked = bake_function(&SampleClosure(sphere), &BOX, &settings, &Silent).expect("the function bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    assert!(field.octree().is_some());
    assert!(f64::from(field.contract().uniform.rmse) < 5e-4 * BOX.diagonal());
}

#[test]
fn damage_is_found() {
    let baked = bake_sample(sphere, &settings(2, Reconstruction::Blend, Precision::Packed32));
    for byte in (0..baked.bytes.len()).step_by(7) {
        let mut bytes = baked.bytes.clone();
        bytes[byte] ^= 0x10;
        let outcome = Field::open(&bytes).and_then(|field| field.validate());
        // The 124th to 127th byte are unused, and still under the checksum.
        assert!(outcome.is_err(), "byte {byte}");
    }
    for length in (0..baked.bytes.len()).step_by(11) {
        assert!(Field::open(&baked.bytes[..length]).is_err());
    }
    assert_eq!(Field::open(&baked.bytes[..100]).err(), Some(Error::Truncated));
}

#[test]
fn the_bytes_do_not_depend_on_threads() {
    let mut fitted = settings(1, Reconstruction::Hermite, Precision::Packed32);
    let Layout::Grid(grid) = &mut fitted.layout else { panic!("a grid") };
    grid.sampling = Sampling::Fitted;
    for settings in [settings(3, Reconstruction::Half, Precision::F16), fitted] {
        let bytes = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| bake_sample(sphere, &settings).bytes)
        };
        assert_eq!(bytes(1), bytes(3));
    }
}
