//! Makes the C header again: `cargo run -p eigenshade-capi --example header`.

#[path = "../tests/header/mod.rs"]
mod header;

fn main() -> std::io::Result<()> {
    std::fs::write(header::path(), header::text())
}
