use crate::shapes;
use crate::support::numbers::Numbers;
use crate::vectors::{folder, read};
use glam::DVec3;
use nearfield::{Error, Family, Field};
use nearfield_bake::distance::{SignChoice, SignedDistance};
use nearfield_bake::lod::{MOST_SHARE, STEP, add_levels};
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{
    GridSettings, Layout, PolynomialSettings, RangeScope, Reconstruction, Resolution, Sampling, Settings, Target,
};
use nearfield_bake::verify;
use nearfield_bake::{Baked, bake};
use nearfield_fuzz::structure::{Choices, mutate, repair};
use nearfield_fuzz::structure_aware;

const MESH: &str = "bob_small.ply";

fn polynomial() -> Settings {
    Settings {
        layout: Layout::Polynomial(PolynomialSettings::default()),
        error: Target::Relative(1e-3),
        samples: 10_000,
        ..Settings::default()
    }
}

fn baked(settings: &Settings) -> Baked {
    bake(&shapes::read(MESH), settings, &Silent).expect("the mesh bakes")
}

fn with_levels(settings: &Settings, count: u8) -> Baked {
    add_levels(baked(settings), settings, count, |settings| Ok(baked(settings))).expect("its levels bake")
}

#[test]
fn levels_cost_a_fifth_at_most_and_keep_their_contracts() {
    let mesh = shapes::read(MESH);
    let (distance, _) = SignedDistance::choose(&mesh, SignChoice::Auto);
    let grid = GridSettings {
        resolution: Resolution::Longest(32),
        order: 1,
        reconstruction: Reconstruction::Half,
        sampling: Sampling::Taylor,
        range: RangeScope::Brick,
    };
    let tricubic = Settings { layout: Layout::Octree, error: Target::Relative(2e-3), ..polynomial() };
    for settings in [polynomial(), tricubic, Settings { layout: Layout::Grid(grid), ..polynomial() }] {
        let alone = baked(&settings).bytes;
        let bytes = with_levels(&settings, 2).bytes;
        let field = Field::open(&bytes).expect("a field");
        assert_eq!((field.validate(), field.lod_count()), (Ok(()), 3), "{settings:?}");

        // The field itself is as it would be without.
        let plain = Field::open(&alone).expect("a field");
        assert_eq!((field.header(), field.contract()), (plain.header(), plain.contract()));
        for (ours, theirs) in field.sections().skip(1).zip(plain.sections()) {
            assert!(bytes[ours.range] == alone[theirs.range], "a section differs");
        }
        let share = (bytes.len() - alone.len()) as f64 / alone.len() as f64;
        assert!(share < MOST_SHARE + 0.001, "{share} of {} bytes", alone.len());

        // So is each level: coarser by the step, and no worse than it says.
        let mut finer = field;
        for number in 1..3 {
            let level = field.lod(number).expect("a level");
            let steps = level.header().target_error / finer.header().target_error;
            assert!((f64::from(steps) - STEP).abs() < 1e-5, "{steps} times the target");
            assert!(level.contract().uniform.rmse > finer.contract().uniform.rmse);
            let contract = level.contract();
            let measured = verify::measure(&level, &distance, &mesh, contract.sample_count, verify::CONTRACT_SEED);
            assert_eq!(verify::exceeds(&contract, &measured), None, "level {number}, {settings:?}");
            let fresh = verify::measure(&level, &distance, &mesh, 20_000, verify::CONTRACT_SEED + 1);
            assert_eq!(verify::refutes(&contract, &fresh), None, "level {number}, {settings:?}");
            finer = level;
        }
    }
}

#[test]
fn levels_that_would_cost_more_are_left_out() {
    // A few hundred bytes, which no level can fall far below.
    let settings = Settings { error: Target::Relative(0.2), start_depth: 0, ..polynomial() };
    let alone = baked(&settings).bytes;
    let with = with_levels(&settings, 3);
    assert_eq!(with.report.lods_left_out, 3);
    assert!(with.bytes == alone, "a file without levels is the plain one");
}

#[test]
fn levels_are_the_same_on_any_number_of_threads() {
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| with_levels(&polynomial(), 2).bytes)
    };
    assert!(on(1) == on(4));
}

/// A level of detail that a reader opens is the field in the bytes of the level.
#[test]
fn a_level_answers_as_its_file() {
    let mut numbers = Numbers::new(5);
    for (name, levels) in
        [("polynomial", 3), ("polynomial_last_section", 3), ("polynomial_eight", 9), ("octree", 2), ("grid", 2)]
    {
        let bytes = read(&folder("valid"), &format!("lods_{name}"));
        let field = Field::open(&bytes).expect("a field");
        assert_eq!(field.lod_count(), levels, "{name}");
        assert!(field.lod(levels).is_none(), "{name}");
        let mut finer = None;
        for number in 0..levels {
            let level = field.lod(number).expect("a level");
            let copy = level.bytes().to_vec();
            let alone = Field::open(&copy).expect("a file of its own");
            assert_eq!((alone.validate(), alone.lod_count()), (Ok(()), if number == 0 { levels } else { 1 }));
            let target = level.header().target_error;
            assert!(finer.is_none_or(|finer| target > finer), "{name}: levels go from fine to coarse");
            finer = Some(target);
            for _ in 0..50 {
                let point = numbers.point(DVec3::splat(-1.0), DVec3::splat(9.0)).as_vec3().to_array();
                let (distance, gradient) = level.distance_and_gradient(point);
                assert_eq!((distance, gradient), alone.distance_and_gradient(point), "{name}, level {number}");
            }
        }
    }
}

#[test]
fn a_reader_of_one_family_has_its_levels() {
    let bytes = read(&folder("valid"), "lods_polynomial");
    let (any, one) = (Field::open(&bytes), Field::open_polynomial_octree(&bytes));
    let (any, one) = (any.expect("a field"), one.expect("a polynomial octree"));
    let point = [1.3, 2.4, 3.5];
    for level in 0..3 {
        let (any, one) = (any.lod(level).expect("a level"), one.lod(level).expect("a level"));
        assert_eq!(any.distance(point).to_bits(), one.distance(point).to_bits());
    }
    // Unchecked, a level of another family is none.
    let wrong = read(&folder("invalid"), "lods_other_family");
    let field = Field::open(&wrong).expect("the field itself is sound");
    assert_eq!((field.header().family, field.lod_count()), (Family::Polynomial, 3));
    assert!(field.lod(1).is_none() && field.lod(2).is_some());
}

#[test]
fn the_coarsest_level_that_is_good_enough() {
    let bytes = with_levels(&polynomial(), 2).bytes;
    let field = Field::open(&bytes).expect("a field");
    let errors = [0, 1, 2].map(|level| field.lod(level).expect("a level").contract().max_error());
    assert!(errors[0] < errors[1] && errors[1] < errors[2], "{errors:?}");
    let target = |level: &Field<'_>| level.header().target_error;
    let expect = |max_error: f32, level: usize| {
        let expected = field.lod(level).expect("a level");
        assert_eq!(target(&field.lod_within(max_error)), target(&expected), "{max_error}");
    };
    expect(f32::INFINITY, 2);
    expect(errors[2], 2);
    expect(errors[2].next_down(), 1);
    expect(errors[1].next_down(), 0);
    expect(0.0, 0);
    expect(f32::NAN, 0);
}

/// As the bytes of a file arrive, what can be asked grows finer.
#[test]
fn a_prefix_is_its_finest_whole_level() {
    for name in ["polynomial", "octree", "grid"] {
        let bytes = read(&folder("valid"), &format!("lods_{name}"));
        let field = Field::open(&bytes).expect("a field");
        let levels: Vec<Field<'_>> = (0..field.lod_count()).filter_map(|level| field.lod(level)).collect();
        let place = |level: &Field<'_>| level.bytes().as_ptr().addr() - bytes.as_ptr().addr() + level.bytes().len();
        for length in 0..=bytes.len() {
            let expected = levels.iter().find(|level| place(level) <= length);
            match (Field::open_prefix(&bytes[..length]), expected) {
                (Ok(found), Some(level)) => assert!(found.bytes() == level.bytes(), "{length} bytes of {name}"),
                (Err(error), None) => assert_eq!(error, Error::Truncated, "{length} bytes of {name}"),
                (found, _) => panic!("{length} bytes of {name}: {found:?}"),
            }
        }
    }

    let bytes = read(&folder("valid"), "lods_polynomial");
    let mut damaged = bytes[..bytes.len() - 4].to_vec();
    damaged[130] ^= 1;
    assert_eq!(Field::open_prefix(&damaged).err(), Some(Error::HeaderChecksum), "of the file's own table");
    assert_eq!(Field::open_prefix(b"solid cube").err(), Some(Error::Magic));
    let longer = [&bytes[..], b"more"].concat();
    assert_eq!(Field::open_prefix(&longer).err(), Some(Error::FileLength));
}

/// Words of levels change, and every checksum with them: a level may be refused, but nothing fails.
#[test]
fn damaged_levels_are_refused_or_answer_with_numbers() {
    let (mut refused, mut choices) = (0, Choices::new(9));
    for name in ["polynomial", "polynomial_eight", "octree", "grid"] {
        let bytes = read(&folder("valid"), &format!("lods_{name}"));
        for _ in 0..200 {
            let mut damaged = bytes.clone();
            damaged.extend([0; 64]);
            let length = mutate(&mut damaged, bytes.len(), &mut choices);
            damaged.truncate(length);
            repair(&mut damaged);
            structure_aware(&damaged);
            let field = Field::open(&damaged);
            refused +=
                u32::from(field.is_ok_and(|field| (1..field.lod_count()).any(|level| field.lod(level).is_none())));
        }
    }
    assert!(refused > 10, "{refused} files with a level that does not open");
}
