//! Writes the materials of the hardest case, GGX lobes at order 32, as CSV:
//! `cargo run --release --example glossy_materials -- materials.csv`.

#[path = "../tests/stability/glossy.rs"]
mod glossy;

use eigenshade_generator::inputs::coefficient_csv::write_materials;

fn main() {
    let path = std::env::args().nth(1).expect("the file to write");
    let file = std::fs::File::create(path).expect("a file");
    write_materials(&glossy::materials(32), &mut std::io::BufWriter::new(file))
        .expect("it is written");
}
