//! Makes the table.

use eigenshade_generator::build;

fn main() {
    build::statics("scene.toml", "table.rs");
}
