//! `experiments same-order`: compares the components of two tables.

use clap::Args;
use eigenshade_cli::output::message::say;
use eigenshade_cli::table::table_file;
use eigenshade_model::error::{Error, Result};
use eigenshade_table::Table;
use std::path::PathBuf;

/// The least eigenvalue that is compared, relative to the largest.
const FLOOR: f64 = 1e-24;
/// The least product of a component with itself, both of unit length; with another component or
/// with its negative it is less.
const ALIKE: f64 = 0.5;

/// Compares the order and the sign of two tables' components
///
/// Tables of one scene that two instruction sets make differ in their weakest components by far
/// more than rounding, but order and sign must agree. Compares components whose eigenvalues exceed
/// 1e-24 of the largest.
#[derive(Args, Debug)]
pub struct SameOrder {
    #[arg(value_name = "A.bin")]
    one: PathBuf,
    #[arg(value_name = "B.bin")]
    other: PathBuf,
}

impl SameOrder {
    pub fn run(self) -> Result<()> {
        let (a, b) = (table_file::read(&self.one)?, table_file::read(&self.other)?);
        let remedy = "order and sign must not depend on the instruction set";
        let fault = |what: String| Error::new(what, remedy).in_file(&self.other);
        let value =
            |table: &Table, k: usize| table.components.get(k).and_then(|one| one.eigenvalue);
        let most = (0..a.count()).filter_map(|k| value(&a, k)).fold(0.0, f64::max);
        let above = |table: &Table| {
            let is_above = |&k: &usize| value(table, k).is_none_or(|v| v > FLOOR * most);
            (0..table.count()).take_while(is_above).count()
        };
        let count = above(&a).min(above(&b));
        let mut least = f64::INFINITY;
        for (k, (one, other)) in a.components.iter().zip(&b.components).take(count).enumerate() {
            let (u, v) = (&a.profiles[one.profile], &b.profiles[other.profile]);
            let product: f64 = u.node_values.iter().zip(&v.node_values).map(|(u, v)| u * v).sum();
            least = least.min(product);
            if one.order != other.order || product < ALIKE {
                let (one, other) = (one.order, other.order);
                return Err(fault(format!(
                    "component {k}: order {one} and {other}, product {product}"
                )));
            }
        }
        if count < a.count().min(b.count()) * 9 / 10 {
            return Err(fault(format!("only {count} components can be compared")));
        }
        say(format_args!(
            "{count} components have the same order and sign, products from {least:.6} on"
        ));
        Ok(())
    }
}
