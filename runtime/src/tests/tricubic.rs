//! Tricubic leaves against closed forms, and the faces between them.

use std::vec::Vec;

use super::file::{ALL, CORNERS, File, Random, block, divided, halves, lattice, open};
use crate::layout::{interpolant, precision};
use crate::sample::decode_gradient;

/// A polynomial of degree three in each variable.
struct Cubic([f64; 64]);

impl Cubic {
    fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        Self(core::array::from_fn(|_| f64::from(random.unit()) - 0.5))
    }

    /// Its derivative of the given orders along x, y, z.
    fn derivative(&self, orders: [usize; 3], point: [f64; 3]) -> f64 {
        // The derivative of a power of t.
        let power = |order: usize, exponent: usize, t: f64| match (order, exponent) {
            (0, _) => t.powi(exponent as i32),
            (_, 0) => 0.0,
            _ => exponent as f64 * t.powi(exponent as i32 - 1),
        };
        let term = |(index, coefficient): (usize, &f64)| {
            let exponents = [index % 4, index / 4 % 4, index / 16];
            (0..3).map(|axis| power(orders[axis], exponents[axis], point[axis])).product::<f64>() * coefficient
        };
        self.0.iter().enumerate().map(term).sum()
    }

    /// Distance, gradient and mixed derivatives as a file holds them: the polynomial's variables
    /// are local coordinates of a leaf of the given edge, from its block's least corner.
    fn sample(&self, point: [f64; 3], edge: f64) -> [f64; 8] {
        let scaled = |orders| self.derivative(orders, point) / edge;
        [
            self.derivative([0, 0, 0], point),
            scaled([1, 0, 0]),
            scaled([0, 1, 0]),
            scaled([0, 0, 1]),
            scaled([1, 1, 0]),
            scaled([1, 0, 1]),
            scaled([0, 1, 1]),
            scaled([1, 1, 1]),
        ]
    }
}

/// Samples of `f32`, full where `full` says so.
fn single_precision(cubic: &Cubic, present: u32, full: u32, edge: f64) -> Vec<u32> {
    let full_points: Vec<_> = lattice(full).collect();
    let data = lattice(present).flat_map(|point| {
        let count = if full_points.contains(&point) { 8 } else { 4 };
        cubic.sample(point, edge).into_iter().take(count).map(|value| (value as f32).to_bits())
    });
    block(present, full, precision::F32, 0, data)
}

#[test]
fn one_leaf_reproduces_a_cubic() {
    let cubic = Cubic::random(1);
    let samples = single_precision(&cubic, CORNERS, CORNERS, 2.0);
    let bytes = File::one_leaf(interpolant::TRICUBIC, samples).bytes();
    let field = open(&bytes);

    let mut random = Random::new(2);
    for _ in 0..1000 {
        let local = random.point();
        let point = [1.0 + 2.0 * local[0], 2.0 + 2.0 * local[1], 3.0 + 2.0 * local[2]];
        // What rounding left of the local coordinates.
        let exact = [0, 1, 2].map(|i| f64::from(point[i] - [1.0, 2.0, 3.0][i]) / 2.0);
        let (distance, gradient) = field.distance_and_gradient(point);
        let expected = cubic.derivative([0, 0, 0], exact);
        assert!((f64::from(distance) - expected).abs() < 4e-6, "{distance} {expected}");
        for (axis, orders) in [[1, 0, 0], [0, 1, 0], [0, 0, 1]].into_iter().enumerate() {
            let expected = cubic.derivative(orders, exact) / 2.0;
            assert!((f64::from(gradient[axis]) - expected).abs() < 2e-5, "axis {axis}");
        }
    }
}

#[test]
fn corners_are_the_derivatives_by_local_coordinates() {
    let cubic = Cubic::random(1);
    let bytes = File::one_leaf(interpolant::TRICUBIC, single_precision(&cubic, CORNERS, CORNERS, 2.0)).bytes();
    let octree = open(&bytes).octree().expect("an octree");
    let corners = octree.corners(&octree.leaf_at([0; 3]));

    let bits = |number: usize| [number >> 2 & 1, number >> 1 & 1, number & 1];
    for (corner, derivatives) in corners.iter().enumerate() {
        for (orders, derivative) in derivatives.iter().enumerate() {
            let expected = cubic.derivative(bits(orders), bits(corner).map(|bit| bit as f64));
            assert!((f64::from(*derivative) - expected).abs() < 1e-5, "corner {corner}, orders {:?}", bits(orders));
        }
    }
}

#[test]
fn eight_leaves_reproduce_a_cubic_from_one_block() {
    let cubic = Cubic::random(3);
    let samples = lattice(ALL).flat_map(|point| cubic.sample(point, 1.0));
    let largest = samples.fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let bytes = divided(single_precision(&cubic, ALL, ALL, 1.0)).bytes();
    let field = open(&bytes);

    let mut random = Random::new(4);
    for _ in 0..1000 {
        let point = random.point().map(|unit| 2.0 * unit);
        let expected = cubic.derivative([0, 0, 0], point.map(f64::from));
        let distance = field.distance([1.0 + point[0], 2.0 + point[1], 3.0 + point[2]]);
        let tolerance = 2.0 * f64::from(f32::EPSILON) * largest;
        assert!((f64::from(distance) - expected).abs() < tolerance, "{distance} {expected}");
    }
}

#[test]
fn full_samples_shift_what_follows_them() {
    // The leaves that touch a full sample know its mixed derivatives, the others see zero.
    let cubic = Cubic::random(5);
    let full = 1 << 3 | 1 << 13 | 1 << 26;
    let bytes = divided(single_precision(&cubic, ALL, full, 1.0)).bytes();
    let field = open(&bytes);
    for point in lattice(ALL) {
        let expected = cubic.sample(point, 1.0);
        let at = [1.0 + point[0] as f32, 2.0 + point[1] as f32, 3.0 + point[2] as f32];
        let (distance, gradient) = field.distance_and_gradient(at);
        assert_eq!(distance, expected[0] as f32, "{point:?}");
        for axis in 0..3 {
            let error = f64::from(gradient[axis]) - expected[1 + axis];
            assert!(error.abs() < 1e-5 * (1.0 + expected[0].abs()), "{point:?} axis {axis}");
        }
    }

    // Along the diagonal of the leaf between samples 13 and 26 the twist shows.
    let without = divided(single_precision(&cubic, ALL, 0, 1.0)).bytes();
    let middle = [2.5, 3.5, 4.5];
    let difference = field.distance(middle) - open(&without).distance(middle);
    let twist = |bit: usize| {
        let [.., xy, xz, yz, xyz] = cubic.sample(lattice(ALL).nth(bit).expect("a sample"), 1.0);
        // At the middle every slope weighs 1/8, and with the opposite sign at the far end.
        if bit == 13 { (xy + xz + yz) / 128.0 + xyz / 512.0 } else { (xy + xz + yz) / 128.0 - xyz / 512.0 }
    };
    assert!((f64::from(difference) - twist(13) - twist(26)).abs() < 1e-5, "{difference}");
}

#[test]
fn packed_corners_are_exact() {
    let mut random = Random::new(6);
    let words: Vec<u32> = lattice(ALL).map(|_| random.packed_sample()).collect();
    let bytes = divided(block(ALL, 0, precision::PACKED32, -1000, words.clone())).bytes();
    let field = open(&bytes);
    for (point, word) in lattice(ALL).zip(words) {
        let at = [1.0 + point[0] as f32, 2.0 + point[1] as f32, 3.0 + point[2] as f32];
        let (distance, gradient) = field.distance_and_gradient(at);
        let quantum = 1.0 / 128.0;
        assert_eq!(distance, ((word >> 20) as i32 - 1000) as f32 * quantum, "{point:?}");
        assert_eq!(distance, field.distance(at), "{point:?}");
        // The derivative's distances cancel: they are up to 3096 quanta.
        for (got, expected) in gradient.into_iter().zip(decode_gradient(word)) {
            assert!((got - expected).abs() < 1e-5, "{point:?}: {got} {expected}");
        }
    }
}

#[test]
fn precisions_agree_on_numbers_that_all_can_hold() {
    // Axis gradients and quantized distances are exact in every precision.
    let axes = [
        (1022 | 511 << 10, [1.0, 0.0, 0.0]),
        (511, [0.0, -1.0, 0.0]),
        (511 | 511 << 10, [0.0, 0.0, 1.0]),
        (0, [0.0, 0.0, -1.0]),
    ];
    let mixed = [0.5, -0.25, 2.0, -1.5];
    let full = 1 << 1 | 1 << 12;
    let (mut packed, mut half, mut single) = (Vec::new(), Vec::new(), Vec::new());
    for (rank, bit) in (0..27).filter(|bit| CORNERS >> bit & 1 == 1).enumerate() {
        let (code, gradient) = axes[rank % 4];
        let distance = 100 + 37 * rank as u32;
        let code16 = 16 * distance;
        let is_full = full >> bit & 1 == 1;

        let mut words = halves(&[&[0.0][..], &gradient, &mixed].concat());
        words[0] |= code16;
        words.truncate(if is_full { 4 } else { 2 });
        half.extend(&words);
        packed.extend(if is_full { words } else { [code | distance << 20].into() });

        let value = (distance as f32 - 300.0) / 64.0;
        let values = [&[value][..], &gradient, &mixed[..if is_full { 4 } else { 0 }]].concat();
        single.extend(values.into_iter().map(f32::to_bits));
    }

    let write = |precision, base, data| {
        let samples = block(CORNERS, full, precision, base, data);
        File::one_leaf(interpolant::TRICUBIC, samples).bytes()
    };
    let packed = write(precision::PACKED32, -300, packed);
    let half = write(precision::F16, -300, half);
    let single = write(precision::F32, 0, single);
    let mut random = Random::new(7);
    for _ in 0..100 {
        let [x, y, z] = random.point();
        let point = [1.0 + 2.0 * x, 2.0 + 2.0 * y, 3.0 + 2.0 * z];
        let expected = open(&single).distance_and_gradient(point);
        assert_eq!(open(&packed).distance_and_gradient(point), expected);
        assert_eq!(open(&half).distance_and_gradient(point), expected);
    }
}

#[test]
fn both_sides_of_a_face_agree_to_the_bit() {
    let mut random = Random::new(8);
    let full = random.word() & ALL;
    let packed = block(ALL, 0, precision::PACKED32, 5, (0..27).map(|_| random.packed_sample()));
    let cubic = Cubic::random(9);
    let mixed = single_precision(&cubic, ALL, full, 1.0);

    for samples in [packed, mixed] {
        let bytes = divided(samples).bytes();
        let octree = open(&bytes).octree().expect("an octree");
        for axis in 0..3 {
            for _ in 0..200 {
                let (mut near, mut far) = (random.point(), [0; 3]);
                let mut lattice = [0, 1, 2].map(|_| random.word() & 1);
                lattice[axis] = 0;
                far.copy_from_slice(&lattice);
                far[axis] = 1;
                near[axis] = 1.0;
                let (value, gradient) = octree.evaluate(&octree.leaf_at(lattice), near);
                near[axis] = 0.0;
                let (other, other_gradient) = octree.evaluate(&octree.leaf_at(far), near);
                assert_eq!(value.to_bits(), other.to_bits());
                for along in (0..3).filter(|&along| along != axis) {
                    assert_eq!(gradient[along].to_bits(), other_gradient[along].to_bits());
                }
                let jump = (gradient[axis] - other_gradient[axis]).abs();
                assert!(jump < 1e-4 * (1.0 + value.abs()), "across the face: {jump}");
            }
        }
    }
}

#[test]
fn the_value_does_not_depend_on_asking_for_the_gradient() {
    let bytes = super::file::three_levels().bytes();
    let field = open(&bytes);
    let mut random = Random::new(10);
    for _ in 0..2000 {
        let [x, y, z] = random.point();
        let point = [8.0 * x, 4.0 * y, 6.0 * z];
        let (distance, _) = field.distance_and_gradient(point);
        assert_eq!(distance.to_bits(), field.distance(point).to_bits(), "{point:?}");
    }
}
