//! Makes the table.

use eigenshade_generator::build::{self, Format};

fn main() {
    build::statics("scene.toml", "table.rs", &[Format::Q15]);
}
