//! Prints the checksums of the pictures that `example/color.c` and `example/textured.c` draw, as the
//! runtime draws them: `cargo run -p eigenshade-capi --example pictures`.

#[path = "../tests/support/pictures.rs"]
#[expect(dead_code, reason = "the tests use the rest")]
mod pictures;

fn main() -> Result<(), eigenshade::Error> {
    print!("{}", pictures::lines()?);
    Ok(())
}
