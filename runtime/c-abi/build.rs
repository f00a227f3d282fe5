//! Gives the shared library its name for the dynamic linker: it changes with `NEARFIELD_ABI_VERSION`.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-soname,libnearfield_c.so.1");
    }
}
