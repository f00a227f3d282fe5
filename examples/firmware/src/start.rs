//! How a program starts and ends: on a board by its runtime, on the host as always.

#[cfg(target_os = "none")]
use semihosting::process;
#[cfg(not(target_os = "none"))]
use std::process;

#[cfg(target_os = "none")]
pub(crate) use semihosting::println;

/// Where a program starts. On a board `entry` jumps here.
#[cfg(all(target_arch = "arm", target_os = "none"))]
#[cortex_m_rt::entry]
fn start() -> ! {
    process::exit(i32::from(!crate::program()))
}

#[cfg(all(target_arch = "riscv32", target_os = "none"))]
#[riscv_rt::entry]
fn start() -> ! {
    process::exit(i32::from(!crate::program()))
}

/// The same on the host.
#[cfg(not(target_os = "none"))]
pub(crate) fn start() -> ! {
    process::exit(i32::from(!crate::program()))
}
