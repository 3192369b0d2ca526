//! Prints the sizes of the table as a C header:
//! `cargo run -p eigenshade-capi --example table_header > crates/capi/include/eigenshade_table.h`.

#[path = "../src/table.rs"]
mod table;

#[path = "../src/constants.rs"]
mod constants;

#[path = "../src/table_header.rs"]
mod table_header;

fn main() {
    print!("{}", table_header::header());
}
