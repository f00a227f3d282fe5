//! Trilinear leaves.

use std::vec::Vec;

use super::file::{ALL, CORNERS, File, Random, block, divided, lattice, open, trilinear};
use crate::layout::{interpolant, precision};

#[test]
fn one_leaf_reproduces_a_trilinear_function() {
    let function = |[x, y, z]: [f64; 3]| 0.5 - x + 2.0 * y + 3.0 * z - 4.0 * x * y * z + y * z;
    let bytes = trilinear(function).bytes();
    let field = open(&bytes);
    let mut random = Random::new(1);
    for _ in 0..1000 {
        let [u, v, w] = random.point();
        let point = [1.0 + 2.0 * u, 2.0 + 2.0 * v, 3.0 + 2.0 * w];
        let [x, y, z] = [0, 1, 2].map(|i| f64::from(point[i] - [1.0, 2.0, 3.0][i]) / 2.0);
        let (distance, gradient) = field.distance_and_gradient(point);
        assert!((f64::from(distance) - function([x, y, z])).abs() < 1e-6);
        assert_eq!(distance.to_bits(), field.distance(point).to_bits());

        let expected = [-1.0 - 4.0 * y * z, 2.0 - 4.0 * x * z + z, 3.0 - 4.0 * x * y + y].map(|d| d / 2.0);
        for (got, expected) in gradient.into_iter().zip(expected) {
            assert!((f64::from(got) - expected).abs() < 2e-6, "{got} {expected}");
        }
    }
}

#[test]
fn codes_of_sixteen_bits_share_words() {
    // An odd number of samples, so that the last word is half empty.
    let codes: Vec<u32> = (0..27).map(|rank| 2417 * rank).collect();
    let words = codes.chunks(2).map(|pair| pair[0] | pair.get(1).unwrap_or(&0) << 16);
    let mut file = divided(block(ALL, 0, precision::PACKED32, -70, words));
    file.interpolant = interpolant::TRILINEAR;
    let bytes = file.bytes();
    let field = open(&bytes);
    for (point, code) in lattice(ALL).zip(codes) {
        let at = [1.0 + point[0] as f32, 2.0 + point[1] as f32, 3.0 + point[2] as f32];
        let expected = (-70.0 * 16.0 + code as f32) / 2048.0;
        assert_eq!(field.distance(at), expected, "{point:?}");
    }
}

#[test]
fn precisions_agree() {
    let codes = [5, 65535, 1024, 77, 30000, 4, 4096, 123];
    let words = codes.chunks(2).map(|pair: &[u32]| pair[0] | pair[1] << 16);
    let singles = codes.map(|code| ((code as f32 - 320.0) / 1024.0).to_bits());
    let write = |samples| File::one_leaf(interpolant::TRILINEAR, samples).bytes();
    let packed = write(block(CORNERS, 0, precision::PACKED32, -20, words.clone()));
    let half = write(block(CORNERS, 0, precision::F16, -20, words));
    let single = write(block(CORNERS, 0, precision::F32, 0, singles));
    let point = [1.3, 3.9, 4.1];
    let expected = open(&single).distance_and_gradient(point);
    assert_eq!(open(&packed).distance_and_gradient(point), expected);
    assert_eq!(open(&half).distance_and_gradient(point), expected);
}
