//! Prints the golden file as a C header of constant arrays:
//! `cargo run -p eigenshade-capi --example golden_header > golden.h`.

#[path = "../tests/support/golden_header.rs"]
mod golden_header;

fn main() -> Result<(), String> {
    print!(
        "{}",
        golden_header::text().map_err(|fault| format!("tests/golden/sphere.csv: {fault}"))?
    );
    Ok(())
}
