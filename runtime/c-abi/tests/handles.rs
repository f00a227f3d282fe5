//! Handles that are not open, pointers that are NULL, and numbers that nobody knows.

#![expect(unsafe_code, reason = "the tests call as C does")]

use nearfield_c::*;
use std::collections::HashSet;
use std::ffi::CStr;
use std::mem::MaybeUninit;
use std::ptr;

const ORIGIN: NearfieldVector = NearfieldVector { x: 0.0, y: 0.0, z: 0.0 };
const BYTES: &[u8] = include_bytes!("../../../format-spec/vectors/valid/continuity_c1.nfd");

fn closed() -> NearfieldField {
    // SAFETY: any bits are a handle; zero is one that is not open.
    unsafe { MaybeUninit::zeroed().assume_init() }
}

fn open(bytes: &[u8]) -> (NearfieldField, NearfieldResult) {
    let mut field = closed();
    // SAFETY: the callers' bytes are static or outlive the handle.
    let result = unsafe { nearfield_open(&mut field, bytes.as_ptr().cast(), bytes.len()) };
    (field, result)
}

fn text(result: i32) -> &'static str {
    // SAFETY: texts are static and end in a zero.
    unsafe { CStr::from_ptr(nearfield_result_text(result)) }.to_str().expect("a text")
}

#[test]
fn sizes_are_those_of_the_manual() {
    assert_eq!((size_of::<NearfieldField>(), align_of::<NearfieldField>()), (256, align_of::<u64>()));
    assert_eq!((size_of::<NearfieldCursor>(), align_of::<NearfieldCursor>()), (1024, align_of::<u64>()));
    assert_eq!((size_of::<NearfieldInstance>(), align_of::<NearfieldInstance>()), (384, align_of::<u64>()));
}

/// An instance in memory of which nothing is known.
fn placed(field: Option<&NearfieldField>, placement: NearfieldPlacement) -> (NearfieldInstance, NearfieldResult) {
    let mut instance = MaybeUninit::uninit();
    let result = nearfield_instance(field, placement, Some(&mut instance));
    // SAFETY: `nearfield_instance` writes a handle, open or not.
    (unsafe { instance.assume_init() }, result)
}

/// Turned by a right angle about z, mirrored along it and scaled by `scale` along x and y, by `height` along z.
fn placement(scale: f32, height: f32) -> NearfieldPlacement {
    NearfieldPlacement {
        x_axis: NearfieldVector { y: scale, ..ORIGIN },
        y_axis: NearfieldVector { x: -scale, ..ORIGIN },
        z_axis: NearfieldVector { z: -height, ..ORIGIN },
        origin: NearfieldVector { x: 5.0, y: -0.25, z: 1.0 },
    }
}

#[test]
fn an_instance_has_the_bits_of_rust() {
    let reader = nearfield::Field::open(BYTES).expect("a field");
    let ours =
        nearfield::Instance::new(reader, [[0.0, 2.5, 0.0], [-2.5, 0.0, 0.0], [0.0, 0.0, -2.5]], [5.0, -0.25, 1.0])
            .expect("a similarity");
    let (field, _) = open(BYTES);
    let (instance, result) = placed(Some(&field), placement(2.5, 2.5));
    assert_eq!(result, NearfieldResult::Ok);
    for step in 0..200 {
        let part = |prime: i32| (step * prime % 199) as f32 / 199.0;
        let point = [2.0 + 6.0 * part(7), -2.0 + 6.0 * part(31), -3.0 + 6.0 * part(101)];
        let (distance, gradient) = ours.distance_and_gradient(point);
        let theirs = nearfield_instance_distance_and_gradient(Some(&instance), point.into());
        assert_eq!(theirs.distance.to_bits(), distance.to_bits());
        assert_eq!(<[f32; 3]>::from(theirs.gradient).map(f32::to_bits), gradient.map(f32::to_bits));
        assert_eq!(nearfield_instance_distance(Some(&instance), point.into()).to_bits(), distance.to_bits());
    }
}

#[test]
fn instances_that_are_none_answer_nan() {
    let (field, _) = open(BYTES);
    let whole = placement(1.0, 1.0);
    for (field, placement, expected) in [
        (None, whole, NearfieldResult::NotOpen),
        (Some(&closed()), whole, NearfieldResult::NotOpen),
        (Some(&field), placement(1.0, 2.0), NearfieldResult::NotASimilarity),
        (Some(&field), placement(f32::NAN, 1.0), NearfieldResult::NotASimilarity),
    ] {
        let (instance, result) = placed(field, placement);
        assert_eq!(result, expected);
        assert!(nearfield_instance_distance(Some(&instance), ORIGIN).is_nan());
        assert!(nearfield_instance_distance_and_gradient(Some(&instance), ORIGIN).gradient.z.is_nan());
    }
    assert_eq!(nearfield_instance(Some(&field), whole, None), NearfieldResult::Null);
    assert!(nearfield_instance_distance(None, ORIGIN).is_nan());
}

#[test]
fn closed_handles_answer_nan() {
    let (unopened, result) = open(b"solid cube");
    assert_eq!(result, NearfieldResult::Magic);
    for field in [None, Some(&closed()), Some(&unopened)] {
        assert_eq!(nearfield_validate(field), NearfieldResult::NotOpen);
        assert!(nearfield_distance(field, ORIGIN).is_nan());
        let sample = nearfield_distance_and_gradient(field, ORIGIN);
        assert!(sample.distance.is_nan() && sample.gradient.x.is_nan());
        assert!(nearfield_normal(field, ORIGIN).x.is_nan());
        assert_eq!(nearfield_clearance(field, ORIGIN), f32::NEG_INFINITY);
        assert!(!nearfield_is_clear(field, ORIGIN, -1e30));
        assert_eq!(
            nearfield_range(field, ORIGIN, ORIGIN),
            NearfieldRange { min: f32::NEG_INFINITY, max: f32::INFINITY }
        );
        assert_eq!(nearfield_closest_point(field, ORIGIN).steps, 0);
        assert_eq!(nearfield_info(field).lipschitz, 0.0);
        let ray =
            NearfieldRay { origin: ORIGIN, direction: NearfieldVector { x: 1.0, ..ORIGIN }, length: 1.0, within: 0.0 };
        assert_eq!(nearfield_raycast(field, ray).end, NearfieldRayEnd::Miss);

        let mut distance = [7.0_f32];
        // SAFETY: one point and room for one answer.
        let count = unsafe { nearfield_distances(field, [0.0_f32; 3].as_ptr(), 12, distance.as_mut_ptr(), 4, 1) };
        assert_eq!((count, distance), (0, [7.0]));

        let mut cursor = MaybeUninit::uninit();
        nearfield_cursor(field, Some(&mut cursor));
        // SAFETY: it was written.
        let cursor = unsafe { cursor.assume_init_mut() };
        assert!(nearfield_cursor_distance(Some(cursor), ORIGIN).is_nan());
        assert!(nearfield_cursor_distance_and_gradient(None, ORIGIN).distance.is_nan());
    }
    nearfield_cursor(None, None);
}

#[test]
fn null_is_refused() {
    let mut field = closed();
    // SAFETY: NULL is what is tested; nothing is read from it.
    unsafe {
        assert_eq!(nearfield_open(ptr::null_mut(), BYTES.as_ptr().cast(), BYTES.len()), NearfieldResult::Null);
        assert_eq!(nearfield_open(&mut field, ptr::null(), 1), NearfieldResult::Null);
        assert_eq!(nearfield_open(&mut field, ptr::null(), 0), NearfieldResult::Truncated);
        assert_eq!(nearfield_open(&mut field, BYTES.as_ptr().cast(), usize::MAX), NearfieldResult::FileLength);
    }
    let (field, result) = open(BYTES);
    assert_eq!(result, NearfieldResult::Ok);
    // SAFETY: as above.
    unsafe {
        assert_eq!(nearfield_distances(Some(&field), ptr::null(), 12, [0.0_f32].as_mut_ptr(), 4, 1), 0);
        assert_eq!(nearfield_distances(Some(&field), [0.0_f32; 3].as_ptr(), 12, ptr::null_mut(), 4, 1), 0);
    }
}

#[test]
fn a_handle_may_be_copied_and_opened_again() {
    let (field, _) = open(BYTES);
    let copy = field;
    assert_eq!(nearfield_validate(Some(&copy)), NearfieldResult::Ok);
    assert_eq!(nearfield_distance(Some(&copy), ORIGIN).to_bits(), nearfield_distance(Some(&field), ORIGIN).to_bits());
    let mut again = copy;
    // SAFETY: static bytes.
    assert_eq!(unsafe { nearfield_open(&mut again, b"".as_ptr().cast(), 0) }, NearfieldResult::Truncated);
    assert!(nearfield_distance(Some(&again), ORIGIN).is_nan(), "a failed open closes the handle");
}

#[test]
fn levels_of_detail_have_the_bits_of_rust() {
    let bytes = include_bytes!("../../../format-spec/vectors/valid/lods_polynomial.nfd");
    let reader = nearfield::Field::open(bytes).expect("a field");
    let (field, _) = open(bytes);
    assert_eq!(nearfield_lod_count(Some(&field)), 3);
    assert_eq!((nearfield_lod_count(None), nearfield_lod_count(Some(&closed()))), (0, 0));
    let point = [1.5, 2.75, 3.25];
    for number in 0..3 {
        let mut level = field;
        let place: *mut NearfieldField = &mut level;
        // SAFETY: one handle, which may be both.
        assert_eq!(unsafe { nearfield_lod(place, place, number) }, NearfieldResult::Ok);
        let expected = reader.lod(number).expect("a level");
        assert_eq!(nearfield_distance(Some(&level), point.into()).to_bits(), expected.distance(point).to_bits());
        assert_eq!(nearfield_info(Some(&level)).target_error, expected.header().target_error);
    }

    let mut level = field;
    // SAFETY: handles, or the NULL that is tested.
    unsafe {
        assert_eq!(nearfield_lod(&mut level, &field, 3), NearfieldResult::NoLod);
        assert!(nearfield_distance(Some(&level), ORIGIN).is_nan(), "a level that there is not");
        assert_eq!(nearfield_lod(&mut level, &closed(), 0), NearfieldResult::NotOpen);
        assert_eq!(nearfield_lod(&mut level, ptr::null(), 0), NearfieldResult::NotOpen);
        assert_eq!(nearfield_lod(ptr::null_mut(), &field, 0), NearfieldResult::Null);
    }
}

#[test]
fn a_prefix_opens_its_finest_level() {
    let bytes = include_bytes!("../../../format-spec/vectors/valid/lods_polynomial.nfd");
    let mut field = closed();
    for length in [0, 200, bytes.len() / 3, bytes.len() - 1, bytes.len()] {
        // SAFETY: so many of the bytes are there.
        let result = unsafe { nearfield_open_prefix(&mut field, bytes.as_ptr().cast(), length) };
        match nearfield::Field::open_prefix(&bytes[..length]) {
            Ok(expected) => {
                assert_eq!(result, NearfieldResult::Ok, "{length} bytes");
                assert_eq!(nearfield_info(Some(&field)).target_error, expected.header().target_error);
            }
            Err(error) => assert_eq!(result, NearfieldResult::from(error), "{length} bytes"),
        }
    }
    // SAFETY: NULL is what is tested.
    assert_eq!(unsafe { nearfield_open_prefix(ptr::null_mut(), ptr::null(), 0) }, NearfieldResult::Null);
}

#[test]
fn batches_follow_their_strides_at_any_alignment() {
    let (field, _) = open(BYTES);
    let info = nearfield_info(Some(&field));
    let points: Vec<[f32; 3]> = (0..9).map(|step| [info.box_min.x + step as f32 * 0.1; 3]).collect();

    // Records of 19 bytes from an odd address; the answer overwrites the y of its point.
    let mut records = vec![0_u8; 1 + 19 * points.len()];
    for (record, point) in records[1..].chunks_mut(19).zip(&points) {
        for (place, coordinate) in record.chunks_mut(4).zip(point) {
            place.copy_from_slice(&coordinate.to_ne_bytes());
        }
    }
    let first = records[1..].as_mut_ptr();
    // SAFETY: each record has room for a point, and for an answer 4 bytes into it.
    let count = unsafe { nearfield_distances(Some(&field), first.cast(), 19, first.add(4).cast(), 19, points.len()) };

    assert_eq!(count, points.len());
    for (record, point) in records[1..].chunks(19).zip(&points) {
        let answer = f32::from_ne_bytes(record[4..8].try_into().expect("four bytes"));
        assert_eq!(answer.to_bits(), nearfield_distance(Some(&field), (*point).into()).to_bits());
    }
}

#[test]
fn every_error_of_the_reader_has_its_number_and_its_words() {
    let mut numbers = HashSet::new();
    for &error in nearfield::Error::ALL {
        let result = NearfieldResult::from(error);
        assert_eq!(text(result as i32), error.text());
        numbers.insert(result as usize);
    }
    assert_eq!(numbers, (1..=nearfield::Error::ALL.len()).collect(), "numbers without gaps, each of its own");
    assert_eq!(text(-1), text(NearfieldResult::Other as i32));
}

#[test]
fn versions_are_those_of_the_reader() {
    assert_eq!(nearfield_abi_version(), NEARFIELD_ABI_VERSION);
    let soname = format!("libnearfield_c.so.{NEARFIELD_ABI_VERSION}");
    assert!(include_str!("../build.rs").contains(&soname), "build.rs must name {soname}");
    let format = nearfield_format();
    assert_eq!(
        (format.major, format.newest_minor),
        (nearfield::layout::VERSION_MAJOR, nearfield::layout::VERSION_MINOR)
    );
}
