//! Errors against direct integration: `errors` records them beside a table, and the table's
//! manifest repeats some of them.

use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet::Sheet;
use eigenshade_table::Table;
use eigenshade_table::file::scene_checksum;
use std::fmt::Write as _;
use std::path::Path;

/// The columns of the file.
#[rustfmt::skip]
pub const COLUMNS: [&str; 10] = [
    "material", "degree", "order", "components", "median",
    "worst", "map", "normals", "scene", "energy",
];
/// The allowed relative difference between the recorded energy and the table's: it has nine digits,
/// and hosts agree to 1e-9.
const ENERGY: f64 = 1e-8;

/// Identifies a table on any host by its scene and the mean energy of its images, which depends on
/// every coefficient of its databases.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stamp {
    /// Checksum of the scene, as in the manifest.
    pub scene: String,
    /// The energy, to nine digits.
    pub energy: String,
}

impl Stamp {
    /// The stamp of this table.
    #[must_use]
    pub fn of(table: &Table) -> Self {
        Self {
            scene: format!("{:08x}", scene_checksum(&table.scene)),
            energy: format!("{:.8e}", table.summary.energy),
        }
    }
}

/// Manifest rows for the errors of this table recorded at `path`; empty if there is no such file.
/// Fails if the errors belong to another table: one of another degree, order, number of components
/// or scene, or one of other databases; or if they name materials or lights that these databases
/// lack.
pub fn manifest_rows(path: &Path, table: &Table, loaded: &Loaded) -> Result<String> {
    let mut text = String::new();
    if !path.exists() {
        return Ok(text);
    }
    let header = COLUMNS.join(",");
    let sheet = Sheet::read(path, &header)?;
    let columns = sheet.columns(COLUMNS).ok_or_else(|| sheet.wrong_header(&header))?;
    let stamp = Stamp::of(table);
    let own = [table.gram.degree, table.gram.order, table.count()].map(|n| n.to_string());
    for row in sheet.rows() {
        let [material, degree, order, components, median, worst, map, _, scene, energy] =
            columns.map(|column| row.text(column));
        let of_another = |what: String| {
            let remedy = "remove the file, make the table, record its errors with `errors`, then \
                          make the table again";
            Err(row.fault(what, remedy))
        };
        if !components.is_empty() && [degree, order, components] != own.each_ref() {
            let what =
                format!("the errors are of a table {degree}/{order} with {components} components");
            return of_another(format!("{what}, not of this one"));
        }
        if scene != stamp.scene {
            let own = stamp.scene;
            return of_another(format!("the errors are of a scene `{scene}`, this one is `{own}`"));
        }
        let recorded = row.number(columns[9])?;
        if (recorded - table.summary.energy).abs() > ENERGY * table.summary.energy {
            let own = stamp.energy;
            let what = format!("the errors are of a table of energy {energy}, this one has {own}");
            return of_another(format!("{what}: its lights or materials differ"));
        }
        if !loaded.materials.entries.iter().any(|entry| entry.name == material) {
            return of_another(format!("the scene has no material `{material}`"));
        }
        if !loaded.lights.entries.iter().any(|entry| entry.name == map) {
            return of_another(format!("the scene has no light `{map}`"));
        }
        let of = if components.is_empty() { "direct sum" } else { "table" };
        let entry = format!("error of {material} {degree}/{order} {of}");
        let _ = writeln!(text, "{entry} median,{median},,\n{entry} worst,{worst} {map},,");
    }
    Ok(text)
}
