//! What the firmware and the host do alike.
#![no_std]

use nearfield::{Field, Representation};

/// An octree that lies in flash, without any alignment.
pub static OCTREE: &[u8] = include_bytes!("../fields/octree.nfd");
/// An octree of polynomials.
pub static POLYNOMIAL: &[u8] = include_bytes!("../fields/polynomial.nfd");
/// A grid.
pub static GRID: &[u8] = include_bytes!("../fields/grid.nfd");

/// Points that wander through the box of a field and a little beyond, the same on every machine.
pub fn points<'a, R: Representation<'a>>(field: &Field<'a, R>) -> impl Iterator<Item = [f32; 3]> + use<'a, R> {
    let bounds = field.header().bounds;
    let mut state = 1_u32;
    let mut share = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 * (1.1 / (1 << 24) as f32)
    };
    core::iter::repeat_with(move || {
        let shares = [share(), share(), share()];
        [0, 1, 2].map(|axis: usize| bounds.min[axis] + shares[axis] * (bounds.max[axis] - bounds.min[axis]))
    })
}

/// A hash of the bits of many answers: equal on two machines only if all of them are.
pub fn checksum<'a, R: Representation<'a>>(field: &Field<'a, R>) -> u32 {
    let mut hash = 0x811c_9dc5_u32;
    let mut add = |number: f32| hash = (hash ^ number.to_bits()).wrapping_mul(0x0100_0193);
    for point in points(field).take(100) {
        let (distance, gradient) = field.distance_and_gradient(point);
        add(distance);
        gradient.into_iter().for_each(&mut add);
        add(field.distance(point));
        field.closest_point(point).point.into_iter().for_each(&mut add);
        add(field.clearance(point));
    }
    hash
}
