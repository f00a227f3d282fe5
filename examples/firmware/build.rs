//! Tells the linker how much memory the processor has.

use std::env;
use std::path::PathBuf;

fn main() {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("a folder"));
    let board = match env::var("TARGET").expect("a target").as_str() {
        "thumbv6m-none-eabi" => "microbit",
        "thumbv7em-none-eabihf" => "mps2-an386",
        "riscv32imac-unknown-none-elf" => "virt",
        _ => return,
    };
    let folder = root.join("memory").join(board);
    println!("cargo::rustc-link-search={}", folder.display());
    println!("cargo::rerun-if-changed={}", folder.display());
    if board == "virt" {
        println!("cargo::rustc-link-arg-bins=-Tmemory.x");
    }
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
}
