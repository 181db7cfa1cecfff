//! Hands the compiler flags of the build to the program, so that it can print what it was built with.

fn main() {
    let flags = std::env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    println!("cargo:rustc-env=BUILD_FLAGS={}", flags.replace('\x1f', " "));
    println!("cargo:rerun-if-env-changed=CARGO_ENCODED_RUSTFLAGS");
}
