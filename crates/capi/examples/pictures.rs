//! Prints the checksums of the pictures that `example/color.c` draws, as the runtime draws them:
//! `cargo run -p eigenshade-capi --example pictures`.

#[path = "../tests/support/pictures.rs"]
mod pictures;

fn main() -> Result<(), eigenshade::Error> {
    print!("{}", pictures::lines()?);
    Ok(())
}
