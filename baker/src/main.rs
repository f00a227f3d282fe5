//! The command line of Nearfield.

fn main() {}
