//! Nothing but a reader, to be weighed: bytes come in, a distance and a gradient go out. Each feature is a way to read.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(not(target_os = "none"), expect(unused, reason = "only boards are weighed"))]

use core::hint::black_box;
use nearfield::{Aabb, Error, Field, Representation};

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(all(target_arch = "arm", target_os = "none"))]
#[cortex_m_rt::entry]
fn start() -> ! {
    program()
}

#[cfg(all(target_arch = "riscv32", target_os = "none"))]
#[riscv_rt::entry]
fn start() -> ! {
    program()
}

/// Says nothing, so as to weigh nothing.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

fn program() -> ! {
    loop {
        let bytes = black_box::<&[u8]>(&[]);
        if cfg!(feature = "grid") {
            query(Field::open_grid(bytes));
        }
        if cfg!(feature = "octree") {
            query(Field::open_octree(bytes));
        }
        if cfg!(feature = "polynomial") {
            query(Field::open_polynomial_octree(bytes));
        }
        if cfg!(feature = "any") {
            query(Field::open(bytes));
        }
        if cfg!(feature = "everything") {
            everything(Field::open(bytes));
        }
    }
}

#[inline]
fn query<'a, R: Representation<'a>>(field: Result<Field<'a, R>, Error>) {
    if let Ok(field) = field {
        black_box(field.distance_and_gradient(black_box([0.0; 3])));
    }
}

#[inline]
fn everything(field: Result<Field<'_>, Error>) {
    query(field);
    let Ok(field) = field else { return };
    let point = black_box([0.0; 3]);
    let _ = black_box(field.validate());
    black_box((field.header(), field.contract(), field.distance(point)));
    let mut cursor = field.cursor();
    black_box((cursor.distance(point), cursor.distance_and_gradient(point)));
    black_box(field.raycast(point, black_box(point), black_box(1.0), black_box(0.0)));
    black_box((field.closest_point(point), field.normal(point), field.clearance(point)));
    black_box(field.range(Aabb { min: point, max: black_box(point) }));
}
