//! What holds for any bytes and any point, and what octahedral codes lose.

use glam::DVec3;
use nearfield::layout::packed_sample::{GRADIENT_BITS, GRADIENT_MAX};
use nearfield::{Field, sample};
use nearfield_bake::quantize::sample::encode_gradient;
use proptest::prelude::*;
use proptest::sample::Index;
use std::path::Path;
use std::sync::LazyLock;

/// The files that every reader must accept.
static VECTORS: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../format-spec/vectors/valid");
    let mut paths: Vec<_> = folder.read_dir().expect("vectors").map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "nfd"));
    paths.sort_unstable();
    assert!(paths.len() > 50, "vectors are missing");
    paths.iter().map(|path| std::fs::read(path).expect("a vector")).collect()
});

fn finite_point() -> impl Strategy<Value = [f32; 3]> {
    let component = prop_oneof![4 => -2.0_f32..2.0, 1 => prop::num::f32::NORMAL | prop::num::f32::ZERO];
    [component.clone(), component.clone(), component]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// One, many, and with memory: the same bits.
    #[test]
    fn every_door_gives_the_same_bits(vector: Index, points in prop::collection::vec(finite_point(), 1..20)) {
        let field = Field::open(&VECTORS[vector.index(VECTORS.len())]).expect("a field");
        let (mut distances, mut again) = (vec![0.0; points.len()], vec![0.0; points.len()]);
        let mut gradients = vec![[0.0; 3]; points.len()];
        prop_assert_eq!(field.distances(&points, &mut distances), points.len());
        prop_assert_eq!(field.distances_and_gradients(&points, &mut again, &mut gradients), points.len());

        let mut cursor = field.cursor();
        for (index, &point) in points.iter().enumerate() {
            let (distance, gradient) = field.distance_and_gradient(point);
            let (remembered, remembered_gradient) = cursor.distance_and_gradient(point);
            for other in [field.distance(point), distances[index], again[index], cursor.distance(point), remembered] {
                prop_assert_eq!(other.to_bits(), distance.to_bits());
            }
            for other in [gradients[index], remembered_gradient] {
                prop_assert_eq!(other.map(f32::to_bits), gradient.map(f32::to_bits));
            }
        }
    }

    /// Damage behind the door, found by validation alone, costs the right answer but never its being a number.
    #[test]
    fn damaged_files_answer_with_numbers(
        vector: Index,
        damage in prop::collection::vec((any::<Index>(), any::<u8>()), 1..8),
        points in prop::collection::vec(finite_point(), 1..8),
    ) {
        let mut bytes = VECTORS[vector.index(VECTORS.len())].clone();
        // Mostly behind the header and the parameters, which are checked by their sums at the door.
        let first = Field::open(&bytes).expect("a field").sections().nth(1).expect("a section").range.start;
        for (place, value) in damage {
            let place = first + place.index(bytes.len() - first);
            bytes[place] = value;
        }
        let Ok(field) = Field::open(&bytes) else { return Ok(()) };
        for point in points {
            let (distance, gradient) = field.distance_and_gradient(point);
            prop_assert!(distance.is_finite(), "{} at {:?}", distance, point);
            prop_assert!(gradient.iter().all(|slope| slope.is_finite()), "{:?} at {:?}", gradient, point);
        }
    }

    /// Ten bits a coordinate: the greatest angle between a direction and its code is 0.18 degrees.
    #[test]
    fn octahedral_codes_are_close(x in -1.0..1.0, y in -1.0..1.0, z in -1.0..1.0) {
        let direction = DVec3::new(x, y, z);
        prop_assume!(direction.length() > 1e-3);
        let decoded = DVec3::from(sample::decode_gradient(encode_gradient(direction)).map(f64::from));
        prop_assert!(decoded.angle_between(direction).to_degrees() < 0.18);
    }
}

/// Every code that a writer may write stands for one direction, and is the code of that direction.
#[test]
fn octahedral_codes_survive_the_round_trip() {
    for (x, y) in (0..=GRADIENT_MAX).flat_map(|x| (0..=GRADIENT_MAX).map(move |y| (x, y))) {
        let code = x | y << GRADIENT_BITS;
        let direction = sample::decode_gradient(code);
        let again = encode_gradient(DVec3::from(direction.map(f64::from)));
        // On the edge of the square two codes share a direction, up to rounding.
        let [a, b] = [direction, sample::decode_gradient(again)].map(|direction| DVec3::from(direction.map(f64::from)));
        assert!(again == code || a.distance(b) < 1e-6, "{code:#x} became {again:#x}");
    }
}
