//! Makes the table.

use eigenshade_generator::build::{self, IntegerFormat};

fn main() {
    build::statics("scene.toml", "table.rs", &[IntegerFormat::Q15]);
}
