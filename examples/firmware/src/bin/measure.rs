//! What queries take: the deepest stack, in bytes, and instructions, over points in and around the box. Instructions are those
//! that QEMU counts with `-icount shift=0`; on a board they would be something else.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../start.rs"]
mod start;

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod board {
    use crate::start::println;
    use core::arch::asm;
    use core::hint::black_box;
    use nearfield::{Field, Representation};
    use nearfield_firmware::{GRID, OCTREE, POLYNOMIAL, points};

    const POINTS: usize = 200;
    /// Bytes below the stack that are painted before a query.
    const PAINTED: usize = 4096;
    const PAINT: u32 = 0xdead_beef;

    pub(crate) fn measure() {
        start_counter();
        if let Ok(octree) = Field::open_octree(OCTREE) {
            report("octree", &octree);
        }
        if let Ok(polynomial) = Field::open_polynomial_octree(POLYNOMIAL) {
            report("polynomial", &polynomial);
        }
        if let Ok(grid) = Field::open_grid(GRID) {
            report("grid", &grid);
        }
    }

    fn report<'a, R: Representation<'a>>(name: &str, field: &Field<'a, R>) {
        let mut distance = |point| _ = black_box(field.distance(black_box(point)));
        let mut gradient = |point| _ = black_box(field.distance_and_gradient(black_box(point)));
        let mut closest = |point| _ = black_box(field.closest_point(black_box(point)));
        let mut ray = |point| _ = black_box(field.raycast(black_box(point), [1.0, 2.0, 3.0], 1e3, 0.0));
        let mut validate = |_| _ = black_box(field.validate());
        let queries: [(&str, usize, &mut dyn FnMut([f32; 3])); 5] = [
            ("distance", POINTS, &mut distance),
            ("gradient", POINTS, &mut gradient),
            ("closest", 20, &mut closest),
            ("ray", 20, &mut ray),
            ("validate", 1, &mut validate),
        ];
        let empty = instructions(field, POINTS, &mut |point| _ = black_box(point));
        for (what, count, query) in queries {
            let deepest = points(field).take(count).map(|point| stack(point, query)).max();
            println!("stack-{name}-{what} {}", deepest.unwrap_or(0));
            if count == POINTS {
                let spent = instructions(field, count, query) - empty;
                println!("instructions-{name}-{what} {}", spent / count as u32);
            }
        }
    }

    /// Bytes of stack that a query uses beyond the frame of its caller.
    #[inline(never)]
    fn stack(point: [f32; 3], query: &mut dyn FnMut([f32; 3])) -> usize {
        let top: usize;
        #[cfg(target_arch = "arm")]
        // SAFETY: reads a register.
        unsafe {
            asm!("mov {}, sp", out(reg) top, options(nomem, nostack));
        }
        #[cfg(target_arch = "riscv32")]
        // SAFETY: reads a register.
        unsafe {
            asm!("mv {}, sp", out(reg) top, options(nomem, nostack));
        }
        let word = |depth: usize| (top - depth) as *mut u32;
        for depth in (4..=PAINTED).step_by(4) {
            // SAFETY: below the stack there is memory that nobody uses: no interrupt is enabled, nothing is called.
            unsafe { word(depth).write_volatile(PAINT) };
        }
        query(point);
        // SAFETY: as above.
        let touched = |depth: &usize| unsafe { word(*depth).read_volatile() } != PAINT;
        (4..=PAINTED).step_by(4).filter(touched).max().unwrap_or(0)
    }

    /// Instructions of many queries and the loop around them.
    #[inline(never)]
    fn instructions<'a, R: Representation<'a>>(
        field: &Field<'a, R>,
        count: usize,
        query: &mut dyn FnMut([f32; 3]),
    ) -> u32 {
        let before = counter();
        points(field).take(count).for_each(query);
        counter().wrapping_sub(before)
    }

    #[cfg(target_arch = "arm")]
    fn start_counter() {
        // SAFETY: nobody else has the peripherals.
        let mut timer = unsafe { cortex_m::Peripherals::steal() }.SYST;
        timer.set_clock_source(cortex_m::peripheral::syst::SystClkSource::Core);
        timer.set_reload(0x00ff_ffff);
        timer.clear_current();
        timer.enable_counter();
    }

    /// Instructions since the start, to the tick of the board's clock: one takes a nanosecond.
    #[cfg(target_arch = "arm")]
    fn counter() -> u32 {
        // The MPS2 board counts at 25 MHz, the micro:bit, whose processor knows no atomic exchange, at 16 MHz.
        const PICOSECONDS_PER_TICK: u64 = if cfg!(target_has_atomic = "32") { 40_000 } else { 62_500 };
        let ticks = 0x00ff_ffff - cortex_m::peripheral::SYST::get_current();
        (u64::from(ticks) * PICOSECONDS_PER_TICK / 1000) as u32
    }

    #[cfg(target_arch = "riscv32")]
    fn start_counter() {}

    #[cfg(target_arch = "riscv32")]
    fn counter() -> u32 {
        riscv::register::minstret::read() as u32
    }
}

#[cfg(target_os = "none")]
fn program() -> bool {
    board::measure();
    true
}
