//! The cost of accuracy: the error and the price of varying every parameter.
//!
//! Measurements become [`Record`]s, of which the CSV files, checks, charts and tables are made.

pub mod errors;
pub mod images;
pub mod machines;
pub mod numbers;
pub mod report;
pub mod scope;
pub mod settings;
pub mod sheet;
mod source_times;
pub mod times;
pub mod total;

use crate::sheet::{Form, Record, read};
use eigenshade_cli::table;
use eigenshade_model::error::{Error, Result};
use errors::{Found, compare};
use images::Images;
use indicatif::ProgressBar;
use machines::Boards;
use numbers::table_bytes;
use scope::{Bases, Scope};
use settings::{Format, Setting, Varied, WindowChoice};
use sheet::{MODEL, SETTINGS, TOTAL};
use source_times::Lit;
use std::collections::BTreeSet;
use std::path::Path;
use times::Case;
use total::references::SPACING;
use total::{ERROR_COLUMNS, Study, subjects};

const ROUNDS: usize = 25;
/// The columns of a setting's times on this machine.
const TIMES: [&str; 4] = ["host_pixel_ns", "host_light_ns", "host_pixel", "host_light"];

#[derive(Clone, Debug, Default)]
pub struct Measured {
    pub settings: Vec<Record>,
    pub model: Vec<Record>,
    pub total: Vec<Record>,
}

impl Measured {
    /// Runs the measurements with the environment maps in `maps`; with `quick`, only for a part of
    /// the settings, surfaces and sizes. Times are left out unless `timed`.
    pub fn new(quick: bool, timed: bool, maps: &Path, progress: &ProgressBar) -> Result<Self> {
        let model = errors::rows(maps, quick, progress)?;
        let subjects = if quick { subjects::few()? } else { subjects::all()? };
        let orders: Vec<usize> = settings::sizes().map(|(_, order)| order).collect();
        let study = Study::new(maps, subjects, &orders, SPACING, progress)?;
        // A quick run has too few surfaces for the error of the model.
        let models_of_all = (!quick).then_some(&model[..]);
        let (settings, mut total) =
            measure(&settings::all(quick), models_of_all, &study, timed, progress)?;
        if !quick {
            total.extend(study.shipped()?);
            total.extend(study.components()?);
            total.extend(study.rivals()?);
        }
        Ok(Self { settings, model, total })
    }

    pub fn read(folder: &Path) -> Result<Self> {
        let [settings, model, total] = [&SETTINGS, &MODEL, &TOTAL].map(|form| read(form, folder));
        Ok(Self { settings: settings?, model: model?, total: total? })
    }

    pub fn sheets(&self) -> [(&'static Form, &[Record]); 3] {
        let Self { settings, model, total } = self;
        [(&SETTINGS, settings), (&MODEL, model), (&TOTAL, total)]
    }

    /// Takes over the times of an earlier run, which must have all settings; a window takes no time.
    pub fn keep_times(&mut self, earlier: &Self) -> Result<()> {
        for row in &mut self.settings {
            let name = row.text("setting").trim_end_matches(" no-window").to_owned();
            let is_it = |other: &&Record| other.text("setting") == name;
            // A setting that was not timed stays so.
            let Some(found) = earlier.settings.iter().find(is_it) else {
                let what = format!("`{}` is not among the files' settings", row.text("setting"));
                return Err(Error::new(what, "measure all times again, without --keep-times"));
            };
            TIMES.iter().for_each(|column| row.put(*column, found.text(column)));
        }
        Ok(())
    }
}

/// The rows of the settings, and those of their total errors.
fn measure(
    varied: &[Varied],
    models: Option<&[Record]>,
    study: &Study,
    timed: bool,
    progress: &ProgressBar,
) -> Result<(Vec<Record>, Vec<Record>)> {
    let size = |one: &Varied| one.setting.recipe.size();
    let boards = Boards::new()?;
    let mut rows = vec![Record::default(); varied.len()];
    let mut totals = vec![Vec::new(); varied.len()];
    let mut cases = Vec::new();
    progress.set_length(varied.len() as u64);
    let sizes: BTreeSet<(usize, usize)> = varied.iter().map(size).collect();
    // To project other materials to a higher order takes as long as the rest of a quick run.
    let unseen = if models.is_some() { usize::MAX } else { total::HIGHEST };
    for scope in Scope::all(&Vec::from_iter(sizes), unseen)? {
        let of_scope = (scope.degree, scope.order);
        let images = Images::new(&scope);
        let of_size = || varied.iter().zip(0..).filter(|(one, _)| size(one) == of_scope);
        let bases = Bases::new(&scope, of_size().map(|(one, _)| one.setting.recipe))?;
        let mut methods: Vec<(Setting, Found)> = Vec::new();
        for (one, k) in of_size() {
            let setting = &one.setting;
            let of = |error: Error| error.of(format_args!("`{setting}`"));
            let table = bases.table(&setting.recipe)?;
            // Sources change nothing in how near a table is to its degree and order.
            let base = Setting { sources: 0, window: WindowChoice::Auto, ..*setting };
            let found = match methods.iter().find(|(other, _)| *other == base) {
                Some((_, found)) => found.clone(),
                None => compare(&base, &table, &images).map_err(of)?,
            };
            methods.push((base, found.clone()));
            if timed && *setting == base {
                let pair = &images.images[found.typical].pair;
                cases.push((k, Case::new(setting, &table, pair).map_err(of)?));
            }
            let row = &mut rows[k];
            describe(row, one);
            fill(row, &found);
            if let Some(errors) = study.of_setting(setting, &table).map_err(of)? {
                totals[k] = study.rows(&setting.to_string(), setting.sources, &errors);
                let whole = totals[k].iter().find(|row| row.text("kind") == subjects::ALL);
                whole.into_iter().for_each(|total| copy_total(row, total));
            }
            if let Some(models) = models {
                let spread = errors::spread(models, of_scope);
                row.measure("model_median", spread.median);
                row.measure("model_worst", spread.worst);
            }
            // f64 is the host's.
            if setting.format != Format::F64 {
                row.put("table_bytes", table_bytes(setting, &table).map_err(of)?);
            }
            row.put("state_bytes", found.bytes + setting.sources * numbers::source_bytes(setting));
            boards.fill(row, setting);
            progress.inc(1);
        }
    }
    if timed {
        cases.sort_by_key(|(k, _)| *k);
        fill_times(varied, &mut rows, &mut cases)?;
    }
    Ok((rows, totals.concat()))
}

/// Fills in the times of the settings: those of `cases`, which have the numbers of their settings,
/// and for settings with sources those of the highlights alone, added to the times without sources.
/// The first setting is the nine-term formula.
fn fill_times(varied: &[Varied], rows: &mut [Record], cases: &mut [(usize, Case)]) -> Result<()> {
    let of_sources = |&Setting { format, sources, .. }: &Setting| (format, sources);
    let lit = varied.iter().map(|one| of_sources(&one.setting));
    let lit: BTreeSet<_> = lit.filter(|(_, sources)| *sources > 0).collect();
    let lamps = Lit::new()?;
    let numbers: Vec<usize> = cases.iter().map(|(k, _)| *k).collect();
    let mut works = Vec::new();
    for (_, case) in cases {
        works.push(case.works()?);
    }
    for &(format, sources) in &lit {
        works.push(lamps.works(format, sources)?);
    }
    let costs = times::costs(works, ROUNDS);
    let (of_cases, of_lit) = costs.split_at(numbers.len());
    let without = |setting: &Setting| {
        let base = Setting { sources: 0, window: WindowChoice::Auto, ..*setting };
        let place = numbers.iter().position(|&k| varied[k].setting == base)?;
        Some(of_cases[place])
    };
    let nine = of_cases.first().map_or(f64::NAN, |costs| costs[0]);
    for (row, Varied { setting, .. }) in rows.iter_mut().zip(varied) {
        let highlights = lit.iter().position(|one| *one == of_sources(setting));
        let highlights = highlights.map_or([0.0; 2], |place| of_lit[place]);
        // A quick run lacks some settings without their sources.
        let Some([pixel, light]) = without(setting) else { continue };
        let [pixel, light] = [pixel + highlights[0], light + highlights[1]];
        let times = [pixel, light, pixel / nine, light / nine];
        TIMES.into_iter().zip(times).for_each(|(column, time)| row.measure(column, time));
    }
    Ok(())
}

fn copy_total(row: &mut Record, total: &Record) {
    for (column, _) in ERROR_COLUMNS {
        for kind in ["median", "most"] {
            let column = format!("{column}_{kind}");
            row.put(format!("total_{column}"), total.text(&column));
        }
    }
}

fn describe(row: &mut Record, Varied { parameter, setting }: &Varied) {
    let recipe = &setting.recipe;
    row.put("parameter", *parameter);
    row.put("setting", setting);
    row.put("degree", recipe.degree);
    row.put("order", recipe.order);
    row.put("effects", table::effect_names(recipe.effects));
    recipe.components.into_iter().for_each(|count| row.put("components", count));
    row.put("way", setting.way);
    row.put("format", setting.format);
    row.put("sources", setting.sources);
}

fn fill(row: &mut Record, Found { seen, unseen, terms, .. }: &Found) {
    row.put("terms", *terms);
    let decibels = |error: f64| format!("{:.1}", -20.0 * error.log10());
    for (name, spread) in [("rms", seen.rms), ("largest", seen.largest)] {
        for (kind, error) in [("median", spread.median), ("worst", spread.worst)] {
            row.measure(format!("{name}_{kind}"), error);
            row.put(format!("{name}_{kind}_db"), decibels(error));
        }
    }
    if unseen.rms.median.is_nan() {
        return;
    }
    for (name, spread) in [("unseen_rms", unseen.rms), ("unseen_largest", unseen.largest)] {
        row.measure(format!("{name}_median"), spread.median);
        row.measure(format!("{name}_most"), spread.most);
        row.measure(format!("{name}_worst"), spread.worst);
    }
}
