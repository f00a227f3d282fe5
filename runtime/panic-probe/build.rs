//! Tells the linker where the program starts, and to keep only what can be reached from there.

fn main() {
    println!("cargo::rustc-link-arg-bins=--gc-sections");
    println!("cargo::rustc-link-arg-bins=--entry=entry");
}
