//! A program without an operating system that makes every query of the reader with bytes and points that the compiler
//! knows nothing about. Its panic handler calls a function that does not exist: if a panic can be reached, it does not
//! link. `.ci/run` links it, and sees that it fails to link with the feature `control`.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::panic::PanicInfo;
use nearfield::{Aabb, Field, Instance};

unsafe extern "C" {
    fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: never runs, since it never links.
    unsafe { a_panic_can_be_reached() }
}

/// Where the program starts.
#[unsafe(no_mangle)]
pub extern "C" fn entry() -> ! {
    let bytes: &[u8] = black_box(&[]);
    loop {
        if let Ok(field) = Field::open(bytes) {
            query(field, black_box([0.0; 3]));
            black_box((field.lod(black_box(1)), field.lod_count(), field.lod_within(black_box(0.0)), field.bytes()));
        }
        let _ = black_box(Field::open_prefix(bytes));
        #[cfg(feature = "control")]
        black_box(bytes[black_box(5)]);
    }
}

fn query(field: Field<'_>, point: [f32; 3]) {
    let _ = black_box(field.validate());
    black_box((field.header(), field.contract()));
    black_box(field.sections().count());
    black_box((field.distance(point), field.distance_and_gradient(point)));

    let (mut distances, mut gradients) = black_box(([0.0; 4], [[0.0; 3]; 3]));
    let points = black_box([point; 5]);
    black_box(field.distances(&points, &mut distances));
    black_box(field.distances_and_gradients(&points, &mut distances, &mut gradients));

    let mut cursor = field.cursor();
    black_box((cursor.distance(point), cursor.distance_and_gradient(point)));

    black_box(field.raycast(point, black_box(point), black_box(1.0), black_box(0.0)));
    black_box((field.closest_point(point), field.normal(point)));
    black_box(field.range(Aabb { min: point, max: black_box(point) }));
    black_box((field.clearance(point), field.is_clear(point, black_box(1.0))));

    if let Ok(instance) = Instance::new(field, black_box([point; 3]), point) {
        black_box((instance.distance(point), instance.distance_and_gradient(point)));
    }
    if let Some(octree) = field.octree() {
        for leaf in octree.leaves() {
            black_box((octree.evaluate(&leaf, point), octree.corners(&leaf)));
        }
    }
    if let Some(octree) = field.polynomial_octree() {
        black_box(octree.unblended(point));
        for leaf in octree.leaves() {
            black_box(octree.evaluate(&leaf, point));
        }
    }
    if let Some(grid) = field.grid() {
        black_box(grid.evaluate(black_box([0; 3]), point));
    }
}
