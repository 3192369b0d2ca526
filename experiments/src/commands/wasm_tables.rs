//! `experiments wasm-tables`: tables for WebAssembly modules.

use clap::Args;
use eigenshade_model::error::{Error, Result};
use experiments::accuracy_cost::bases::Bases;
use experiments::accuracy_cost::knobs;
use experiments::accuracy_cost::materials::Scope;
use experiments::accuracy_cost::setting::{Format, Setting, Way};
use experiments::accuracy_cost::wasm::{settings, tables};
use std::fs;
use std::path::{Path, PathBuf};

/// The tables that crates/wasm/ladder puts into modules, and ladder.csv, which assigns a setting of
/// accuracy-cost to each module and table
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
        let all: Vec<Setting> = knobs::settings(false).iter().map(|knob| knob.setting).collect();
        let mut lines = String::from("# crates/wasm/ladder\ntable,module,setting,way,format\n");
        let tables = tables();
        let mut sizes: Vec<(usize, usize)> =
            tables.iter().map(|recipe| (recipe.degree, recipe.order)).collect();
        sizes.sort_unstable();
        sizes.dedup();
        for (degree, order) in sizes {
            let scope = Scope::new(degree, order)?;
            let of_size =
                tables.iter().filter(|recipe| (recipe.degree, recipe.order) == (degree, order));
            let bases = Bases::new(&scope, of_size.clone().copied())?;
            for recipe in of_size {
                let name = recipe.to_string().replace('/', "-").replace(' ', "_");
                let table = bases
                    .table(recipe)
                    .ok_or_else(|| Error::new("a basis is missing", "this is a defect"))?;
                write(&folder.join(format!("{name}.bin")), &eigenshade_table::encode(&table))?;
                for setting in settings(recipe, &all) {
                    let is_float = setting.format == Format::F32;
                    let module = if is_float { "floats.simd" } else { "all.simd" };
                    let way = if setting.way == Way::Polynomial { "shade" } else { "look_up" };
                    lines += &format!("{name},{module},{setting},{way},{}\n", setting.format);
                }
            }
        }
        write(&folder.join("ladder.csv"), lines.as_bytes())
    }
}

fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    fs::write(path, bytes).map_err(|error| Error::io(path, &error))
}
