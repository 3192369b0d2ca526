//! The tables that `crates/wasm/ladder` puts into WebAssembly modules: those of the settings
//! whose times `eigenshade accuracy-cost` sets beside their errors.
//!
//! ```sh
//! cargo run --release --example wasm_ladder -- target/modules/ladder
//! ```
//!
//! writes a table each, and `ladder.csv`: which module of which table is which setting.

use eigenshade_cli::accuracy_cost::bases::Bases;
use eigenshade_cli::accuracy_cost::knobs;
use eigenshade_cli::accuracy_cost::materials::Scope;
use eigenshade_cli::accuracy_cost::setting::{Format, Setting, Way};
use eigenshade_cli::accuracy_cost::wasm::{settings, tables};
use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(env::args().nth(1).ok_or("usage: wasm_ladder FOLDER")?);
    fs::create_dir_all(&folder)?;
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
            let table = bases.table(recipe).ok_or("a basis is missing")?;
            fs::write(folder.join(format!("{name}.bin")), eigenshade_table::encode(&table))?;
            for setting in settings(recipe, &all) {
                let is_float = setting.format == Format::F32;
                let module = if is_float { "floats.simd" } else { "all.simd" };
                let way = if setting.way == Way::Polynomial { "shade" } else { "look_up" };
                lines += &format!("{name},{module},{setting},{way},{}\n", setting.format);
            }
        }
    }
    fs::write(folder.join("ladder.csv"), lines)?;
    Ok(())
}
