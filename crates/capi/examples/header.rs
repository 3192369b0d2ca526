//! Writes the C header: `cargo run -p eigenshade-capi --example header`.

#[path = "../tests/support/header.rs"]
mod header;

fn main() -> std::io::Result<()> {
    std::fs::write(header::path(), header::text())
}
