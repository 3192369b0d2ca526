//! Prints the objects that `example/textured.c` draws as a C header:
//! `cargo run -p eigenshade-capi --example objects_header > objects.h`.

#[path = "../tests/support/objects.rs"]
mod objects;

fn main() -> Result<(), eigenshade::Error> {
    print!("{}", objects::text()?);
    Ok(())
}
