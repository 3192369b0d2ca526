//! Compares the order and the sign of two tables' components, whose eigenvalues exceed 1e-24
//! of the largest: `cargo run --release --example same_order -- A.bin B.bin`.
//!
//! Tables that two instruction sets make of one scene differ in their weakest components by
//! far more than rounding; what they may not differ in is which is which, and its sign.

use eigenshade_table::{Table, decode};
use std::process::ExitCode;

/// Of the largest eigenvalue.
const FLOOR: f64 = 1e-24;
/// Of a component and itself, of unit length both; of another or its negative it is less.
const ALIKE: f64 = 0.5;

fn main() -> ExitCode {
    let paths: Vec<String> = std::env::args().skip(1).collect();
    let [a, b] = &paths[..] else {
        eprintln!("usage: same_order A.bin B.bin");
        return ExitCode::from(2);
    };
    let read = |path: &String| -> Table {
        decode(&std::fs::read(path).expect("a file")).expect("a table")
    };
    let (a, b) = (read(a), read(b));
    let value = |table: &Table, k: usize| table.components.get(k).and_then(|one| one.eigenvalue);
    let most = (0..a.count()).filter_map(|k| value(&a, k)).fold(0.0, f64::max);
    let above = |table: &Table| {
        (0..table.count()).take_while(|&k| value(table, k).is_none_or(|v| v > FLOOR * most)).count()
    };
    let count = above(&a).min(above(&b));
    let mut least = f64::INFINITY;
    for (k, (one, other)) in a.components.iter().zip(&b.components).take(count).enumerate() {
        let (u, v) = (&a.profiles[one.profile], &b.profiles[other.profile]);
        let product: f64 = u.node_values.iter().zip(&v.node_values).map(|(u, v)| u * v).sum();
        least = least.min(product);
        if one.order != other.order || product < ALIKE {
            eprintln!(
                "error: component {k}: order {} and {}, product {product}",
                one.order, other.order
            );
            return ExitCode::from(1);
        }
    }
    if count < a.count().min(b.count()) * 9 / 10 {
        eprintln!("error: only {count} components could be compared");
        return ExitCode::from(1);
    }
    println!("{count} components have the same order and sign, products from {least:.6} on");
    ExitCode::SUCCESS
}
