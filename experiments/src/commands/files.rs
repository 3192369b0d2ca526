//! Files that tests, CI and pages use: the golden file, materials of sharp gloss, the comparison of
//! two tables' components, and tables for WebAssembly modules.

use clap::Args;
use eigenshade_cli::messages::print_message;
use eigenshade_cli::table;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::write_materials;
use eigenshade_testing::glossy;
use eigenshade_testing::golden;
use eigenshade_testing::golden::record::{Golden, Row};
use experiments::accuracy_cost::machines::{tables, timed};
use experiments::accuracy_cost::scope::Bases;
use experiments::accuracy_cost::scope::Scope;
use experiments::accuracy_cost::settings::all;
use experiments::accuracy_cost::settings::{Format, Setting, Way};
use experiments::pages::Purpose;
use experiments::stability::spectrum::{Agreement, agreement};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes or compares the results that every machine must reproduce in every number format.
pub fn golden(purpose: &Purpose) -> Result<()> {
    const COMMAND: &str =
        "cargo run --release -p experiments -- golden --out tests/golden/sphere.csv";
    let answered = golden::golden();
    let text = answered.text(&[COMMAND, "What the rows are: docs/formats.md"]);
    purpose.write_or_compare(&text, COMMAND, |recorded, _| {
        let recorded = Golden::parse(recorded)?;
        if recorded.rows.len() != answered.rows.len() {
            return Err("the number of rows differs".into());
        }
        for (old, new) in recorded.rows.iter().zip(&answered.rows) {
            if old != new && !near(old, new)? {
                let (pair, array) = (new.pair.join(" "), &new.array);
                return Err(format!("{} {pair} {array} differs", new.format));
            }
        }
        Ok(())
    })
}

/// Whether both are the same array of floats, up to the tolerance times the largest value.
fn near(old: &Row, new: &Row) -> std::result::Result<bool, String> {
    if old.format != "f32" || (&old.pair, &old.array) != (&new.pair, &new.array) {
        return Ok(false);
    }
    let (old, new) = (old.floats()?, new.floats()?);
    let largest = new.iter().fold(0.0f32, |most, number| most.max(number.abs()));
    let within = |(a, b): (&f32, &f32)| (a - b).abs() <= golden::GOLDEN_F32 * largest;
    Ok(old.len() == new.len() && old.iter().zip(&new).all(within))
}

/// GGX lobes at order 32, as a material CSV
#[derive(Args, Debug)]
pub struct GlossyMaterials {
    /// The file to write
    #[arg(value_name = "FILE")]
    out: PathBuf,
}

impl GlossyMaterials {
    pub fn run(self) -> Result<()> {
        let file =
            std::fs::File::create(&self.out).map_err(|error| Error::io(&self.out, &error))?;
        write_materials(&glossy::materials(32), &mut std::io::BufWriter::new(file))
    }
}

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
        let (a, b) = (table::read(&self.one)?, table::read(&self.other)?);
        let Agreement { compared, different, least } = agreement(&a, &b);
        let remedy = "order and sign must not depend on the instruction set";
        let fault = |what: String| Err(Error::new(what, remedy).in_file(&self.other));
        if let Some(&k) = different.first() {
            let orders = [&a, &b].map(|table| table.components[k].order);
            return fault(format!("component {k}: orders {orders:?}, least product {least}"));
        }
        if compared < a.count().min(b.count()) * 9 / 10 {
            return fault(format!("only {compared} components can be compared"));
        }
        print_message(format_args!(
            "{compared} components have the same order and sign, products from {least:.6} on"
        ));
        Ok(())
    }
}

/// The tables that crates/wasm/benchmark-tables puts into modules
///
/// benchmark_tables.csv assigns a setting of accuracy-cost to each module and table.
#[derive(Args, Debug)]
pub struct WasmTables {
    /// The folder to write to
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

impl WasmTables {
    pub fn run(self) -> Result<()> {
        let folder = self.folder;
        fs::create_dir_all(&folder).map_err(|error| Error::io(&folder, &error))?;
        let all: Vec<Setting> = all(false).iter().map(|one| one.setting).collect();
        let mut lines =
            String::from("# crates/wasm/benchmark-tables\ntable,module,setting,way,format\n");
        let tables = tables();
        let sizes = tables.iter().map(|recipe| (recipe.degree, recipe.order));
        for (degree, order) in sizes.collect::<BTreeSet<(usize, usize)>>() {
            let scope = Scope::new(degree, order)?;
            let of_size =
                tables.iter().filter(|recipe| (recipe.degree, recipe.order) == (degree, order));
            let bases = Bases::new(&scope, of_size.clone().copied())?;
            for recipe in of_size {
                let name = recipe.to_string().replace('/', "-").replace(' ', "_");
                let table = bases.table(recipe)?;
                write(&folder.join(format!("{name}.bin")), &eigenshade_table::encode(&table))?;
                for setting in timed(recipe, &all) {
                    let is_float = setting.format == Format::F32;
                    let module = if is_float { "floats.simd" } else { "all.simd" };
                    let way = if setting.way == Way::Polynomial { "shade" } else { "look_up" };
                    lines += &format!("{name},{module},{setting},{way},{}\n", setting.format);
                }
            }
        }
        write(&folder.join("benchmark_tables.csv"), lines.as_bytes())
    }
}

fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    fs::write(path, bytes).map_err(|error| Error::io(path, &error))
}
