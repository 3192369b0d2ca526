//! Files that tests, CI and pages use: the golden file, materials of sharp gloss, the comparison of
//! two tables' components, tables for WebAssembly modules, and the picture of the README.

use clap::Args;
use eigenshade_cli::messages::print_message;
use eigenshade_cli::picture;
use eigenshade_cli::picture::SphereView;
use eigenshade_cli::table;
use eigenshade_generator::material::brdf::projection::project;
use eigenshade_generator::material::brdf::{Ggx, Measure};
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::write_materials;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_shading::shipped;
use eigenshade_testing::glossy;
use eigenshade_testing::golden;
use eigenshade_testing::golden::record::{Golden, Row};
use experiments::accuracy_cost::bases::Bases;
use experiments::accuracy_cost::materials::Scope;
use experiments::accuracy_cost::setting::{Format, Setting, Way};
use experiments::accuracy_cost::settings::all;
use experiments::accuracy_cost::wasm::{settings, tables};
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
                for setting in settings(recipe, &all) {
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

/// Width of a sphere and of the gap beside it, in pixels.
const SIZE: usize = 168;
const GAP: usize = 12;

/// The share of a row's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.985;

/// The light of each row.
const LIGHTS: [&str; 2] = ["esplanade", "workshop"];

/// The roughness, and for each channel the reflectance at normal incidence and the diffuse albedo.
const MATERIALS: [(f64, [f64; 3], [f64; 3]); 5] = [
    (0.5, [1.0, 0.77, 0.34], [0.0; 3]),
    (0.45, [0.04; 3], [0.55, 0.04, 0.03]),
    (0.6, [0.95, 0.64, 0.54], [0.0; 3]),
    (0.8, [0.04; 3], [0.08, 0.22, 0.45]),
    (1.0, [0.04; 3], [0.75, 0.72, 0.66]),
];

/// Spheres of GGX materials under captured lights by the runtime in f32, docs/spheres.png
#[derive(Args, Debug)]
pub struct Picture {
    /// The file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// The table of formulas
    #[arg(long, value_name = "B.bin", default_value = "tables/pbr.bin")]
    table: PathBuf,
}

impl Picture {
    pub fn run(self) -> Result<()> {
        let table = table::read(&self.table)?;
        let (degree, order) = (table.gram.degree, table.gram.order);
        let lights = shipped::lights()?.truncated(degree);
        let mut materials = Vec::new();
        for (roughness, reflectance, albedo) in MATERIALS {
            let mut rgb = [const { Vec::new() }; 3];
            for ((f0, albedo), channel) in reflectance.into_iter().zip(albedo).zip(&mut rgb) {
                let brdf = Ggx::new(roughness, f0, albedo)?;
                *channel = project(&brdf, order, Measure::Projected).coefficients;
            }
            materials.push(Named { name: format!("{roughness}"), rgb });
        }
        let basis = OwnedBasis::<f32>::new(&table);
        let mut shader = Shader::new(basis.any().map_err(fault)?, table.count());
        let view = SphereView::new(SIZE);
        let normals = OwnedNormals::new(&view.normals);
        let (width, height) = (across(MATERIALS.len()), across(LIGHTS.len()));
        let mut bytes = vec![0; 4 * width * height];
        for (row, name) in LIGHTS.into_iter().enumerate() {
            let light = lights.entries.iter().find(|light| light.name == name);
            let light = light.ok_or_else(|| Error::new("no such light", "take a shipped one"))?;
            let mut images = Vec::new();
            for material in &materials {
                images.push(shader.color((degree, light), (order, material), &normals)?);
            }
            let all = images.iter().flatten().flatten().map(|&value| f64::from(value)).collect();
            let exposure = picture::exposure(all, UNCLIPPED);
            for (column, image) in images.iter().enumerate() {
                for (k, pixel) in view.pixels.iter().enumerate() {
                    let (x, y) = (across(column) + pixel.column, across(row) + pixel.row);
                    let start = 4 * (y * width + x);
                    for (channel, byte) in image.iter().zip(&mut bytes[start..]) {
                        *byte = picture::srgb(exposure * f64::from(channel[k]));
                    }
                    bytes[start + 3] = (255.0 * pixel.coverage).round() as u8;
                }
            }
        }
        picture::write_png(&self.out, width, height, &bytes)
    }
}

/// The width in pixels of this many spheres side by side, with gaps on all sides.
const fn across(count: usize) -> usize {
    GAP + count * (SIZE + GAP)
}
