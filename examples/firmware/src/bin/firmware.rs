//! A robot's firmware: it opens the field in its flash, checks it, and asks how far it may move. It prints what it found, and
//! a hash of many answers, which is the same on every machine. Built for the host it is the same program.
#![cfg_attr(target_os = "none", no_std, no_main)]

use nearfield::{Error, Field, Representation};
use nearfield_firmware::{GRID, OCTREE, POLYNOMIAL, checksum};

#[path = "../start.rs"]
mod start;
#[cfg(target_os = "none")]
use start::println;

#[cfg(not(target_os = "none"))]
fn main() {
    start::start()
}

/// Whether all is well.
fn program() -> bool {
    let octree = Field::open_octree(OCTREE).and_then(checked);
    let grid = Field::open_grid(GRID).and_then(checked);
    let polynomial = Field::open_polynomial_octree(POLYNOMIAL).and_then(checked);
    let (Ok(octree), Ok(polynomial), Ok(grid)) = (octree, polynomial, grid) else {
        println!("a field in flash is damaged");
        return false;
    };
    let hand = [0.4, 0.1, -0.2];
    println!("the hand may move by {} micrometres", (octree.clearance(hand) * 1e6) as i32);
    println!("octree {:08x}", checksum(&octree));
    println!("polynomial {:08x}", checksum(&polynomial));
    println!("grid {:08x}", checksum(&grid));
    true
}

fn checked<'a, R: Representation<'a>>(field: Field<'a, R>) -> Result<Field<'a, R>, Error> {
    field.validate().map(|()| field)
}
