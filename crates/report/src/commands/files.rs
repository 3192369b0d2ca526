//! Files that tests, CI, pages and the runtime use: the golden file, materials of sharp gloss, the
//! comparison of two tables' components, the table from which the runtime computes materials of
//! metallic and roughness, and meshes; and the folders of figures.

use super::{command_line, write_csv};
use clap::Args;
use eigenshade_cli::messages::{print_message, progress_bar, spinner};
use eigenshade_cli::{output, table};
use eigenshade_generator::material::brdf::projection::project_orders;
use eigenshade_generator::material::brdf::{Ggx, Measure};
use eigenshade_generator::object::mesh_data::Mesh;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::write_materials;
use eigenshade_model::parallel;
use eigenshade_table::material::indices;
use eigenshade_testing::golden::record::{Golden, Row};
use eigenshade_testing::{glossy, golden};
use report::accuracy_cost::Measured;
use report::accuracy_cost::sheet::{self, SETTINGS, compare};
use report::numbers::digits;
use report::shadow_shapes::SHAPES;
use report::sheet::Purpose;
use report::stability::spectrum::{Agreement, agreement};
use report::{figures, paper};
use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes or compares the results that every machine must reproduce in every number format.
pub fn golden(purpose: &Purpose) -> Result<()> {
    const COMMAND: &str = "cargo run --release -p report -- golden --out tests/golden/sphere.csv";
    let answered = golden::golden();
    let text = answered.text(&[COMMAND, "What the rows are: docs/formats.md"]);
    purpose.write_or_compare("", &text, COMMAND, |recorded, _| {
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

pub fn glossy_materials(out: &Path) -> Result<()> {
    let file = fs::File::create(out).map_err(|error| Error::io(out, &error))?;
    write_materials(&glossy::materials(32), &mut std::io::BufWriter::new(file))
}

pub fn shadow_shape(shape: &str, out: &Path) -> Result<()> {
    let Some((_, mesh)) = SHAPES.iter().find(|(name, _)| *name == shape) else {
        let names = SHAPES.map(|(name, _)| name).join(", ");
        return Err(Error::new(format!("no shape is called `{shape}`"), format!("take {names}")));
    };
    let (Mesh { corners, triangles, .. }, mut text) = (mesh(), format!("# {}\n", command_line()));
    let corners = corners.iter().map(|[x, y, z]| format!("v {x:.6} {y:.6} {z:.6}\n"));
    let faces = triangles.iter().map(|all| all.map(|corner| corner + 1));
    text.extend(corners.chain(faces.map(|[a, b, c]| format!("f {a} {b} {c}\n"))));
    output::write_all(Some(out), text)
}

pub fn same_order(one: &Path, other: &Path) -> Result<()> {
    let (a, b) = (table::read(one)?, table::read(other)?);
    let Agreement { compared, different, least } = agreement(&a, &b);
    let remedy = "order and sign must not depend on the instruction set";
    let fault = |what: String| Err(Error::new(what, remedy).in_file(other));
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

/// Orders, with the number of Chebyshev polynomials in roughness that each takes: what these leave
/// out is below 1e-3 of a picture's peak.
const ORDERS: [(usize, usize); 2] = [(7, 12), (12, 14)];
/// The range of roughness.
const LEAST: f64 = 0.2;
const MOST: f64 = 1.0;
/// Nodes of the interpolation, from which the polynomials that are kept are taken.
const NODES: usize = 24;
/// Significant digits: those of f32.
const DIGITS: usize = 8;

pub fn metallic_roughness(out: &Path) -> Result<()> {
    let orders = ORDERS.map(|(order, _)| order);
    let angles: Vec<f64> = (0..NODES).map(|j| PI * (j as f64 + 0.5) / NODES as f64).collect();
    let project = |roughness: f64, f0: f64, albedo: f64| -> Result<Vec<Vec<f64>>> {
        let lobe = Ggx::new(roughness, f0, albedo)?;
        let projections = project_orders(&lobe, &orders, Measure::Projected);
        Ok(projections.into_iter().map(|one| one.coefficients).collect())
    };
    let progress = progress_bar("roughnesses", NODES);
    let nodes = parallel::map(NODES, &progress, |j| {
        let roughness = 0.5 * (MOST + LEAST + (MOST - LEAST) * angles[j].cos());
        Ok([project(roughness, 0.0, 0.0)?, project(roughness, 1.0, 0.0)?])
    });
    progress.finish_and_clear();
    let nodes = nodes.into_iter().collect::<Result<Vec<_>>>()?;
    // The matte part is the same at any roughness.
    let (over_matte, bare) = (project(MOST, 0.0, 1.0)?, project(MOST, 0.0, 0.0)?);
    let mut rows = Vec::new();
    for (of_order, (order, terms)) in ORDERS.into_iter().enumerate() {
        for k in 0..terms {
            // The coefficient of T_k in a function of roughness, from its values at the nodes.
            let coefficient = |value: &dyn Fn(usize) -> f64| -> f64 {
                let cosines = angles.iter().enumerate();
                let sum: f64 = cosines.map(|(j, t)| value(j) * (k as f64 * t).cos()).sum();
                sum * if k == 0 { 1.0 } else { 2.0 } / NODES as f64
            };
            for (i, (o, p, q)) in indices(order).enumerate() {
                let rim = |j: usize| nodes[j][0][of_order][i];
                let metal = |j: usize| nodes[j][1][of_order][i] - rim(j);
                let matte = over_matte[of_order][i] - bare[of_order][i];
                let matte = if k == 0 { matte } else { 0.0 };
                let numbers = [matte, coefficient(&rim), coefficient(&metal)];
                let places = [order, k, o, p, q].map(|place| place.to_string());
                rows.push([&places[..], &numbers.map(|one| digits(one, DIGITS))].concat());
            }
        }
    }
    write_csv(Some(out), "order,k,o,p,q,matte,rim,metal", rows)
}

pub fn paper(Purpose { out, check }: &Purpose) -> Result<()> {
    let progress = spinner("figures");
    let made = paper::make();
    progress.finish_and_clear();
    let files = made?;
    if let Some(folder) = out {
        figures::write(&files, folder)?;
        print_message(format_args!("{} files in {}", files.len(), folder.display()));
    }
    if let Some(folder) = check {
        let remedy = "make it again with `cargo run --release -p report -- paper --out docs/paper`";
        let count = figures::compare(&files, folder, remedy)?;
        print_message(format_args!("{count} cells are up to date"));
    }
    Ok(())
}

/// The cost of accuracy: error, bytes and time as every parameter varies
///
/// --out writes the CSV files of docs/accuracy-cost: errors against the direct sum over the shipped
/// lights and materials and over others, errors of a degree and an order against direct integration
/// under captured maps, total errors of pictures against direct integration, times on this machine,
/// and the instructions that were counted on emulated boards. --check recomputes errors, bytes and
/// counts and compares them with the files of a folder; times are not compared. --quick does either
/// for a part of the settings. A full run takes some ten minutes on two cores, a quick check one.
#[derive(Args, Debug)]
pub struct AccuracyCost {
    #[command(flatten)]
    purpose: Purpose,
    /// Only a part of the settings, surfaces and sizes
    #[arg(long)]
    quick: bool,
    /// With --out: keep the times of DIR's files and recompute the rest
    #[arg(long, conflicts_with_all = ["quick", "check"])]
    keep_times: bool,
    /// Folder of the project's environment maps
    #[arg(long, value_name = "DIR", default_value = "tables/inputs/maps")]
    maps: PathBuf,
}

impl AccuracyCost {
    pub fn run(self) -> Result<()> {
        let measure =
            |timed| Measured::new(self.quick, timed, &self.maps, &progress_bar("settings", 0));
        // Paths that cannot be read or written fail before the long computation.
        if let Some(out) = &self.purpose.out {
            fs::create_dir_all(out).map_err(|error| Error::io(out, &error))?;
            let measured = if self.keep_times {
                let earlier = Measured::read(out)?;
                let mut measured = measure(false)?;
                measured.keep_times(&earlier)?;
                measured
            } else {
                measure(true)?
            };
            let files = measured.sheets().into_iter().map(|(form, rows)| sheet::csv(form, rows));
            figures::write(&files.collect::<Result<Vec<_>>>()?, out)?;
        }
        if let Some(folder) = &self.purpose.check {
            let numbers = folder.join(SETTINGS.name);
            fs::metadata(&numbers).map_err(|error| Error::io(&numbers, &error))?;
            let measured = measure(false)?;
            let [mut rows, mut numbers] = [0, 0];
            for (form, records) in measured.sheets() {
                let [more_rows, more_numbers] = compare(form, records, folder, !self.quick)?;
                (rows, numbers) = (rows + more_rows, numbers + more_numbers);
            }
            print_message(format_args!("{rows} rows are what they should be: {numbers} numbers"));
        }
        Ok(())
    }
}
