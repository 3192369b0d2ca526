//! Prints the shipped lights and materials as a C header: `cargo run -p eigenshade-capi --example
//! presets_header > crates/capi/include/eigenshade_presets.h`.

#[path = "../src/presets_header.rs"]
mod presets_header;

fn main() {
    print!("{}", presets_header::header());
}
