//! How the module is linked: a small stack, and the rest of the memory for its user.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|architecture| architecture == "wasm32") {
        // No query recurses; the deepest needs less than 4 KiB.
        println!("cargo::rustc-link-arg-cdylib=-zstack-size=16384");
        println!("cargo::rustc-link-arg-cdylib=--export=__heap_base");
    }
}
