//! The times of an earlier run, from its files.

use super::growth::Growth;
use super::machine::{Machine, Price};
use super::points::Point;
use super::sheet::{GROWTH, POINTS};
use super::times::Cost;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::sheet::{Row, Sheet};
use std::collections::BTreeMap;
use std::path::Path;

/// A time of a growth curve: quantity, measure, size and nanoseconds.
type Grown = (String, String, f64, f64);

/// Times by setting, and times of growth curves.
pub struct Kept {
    settings: BTreeMap<String, (Cost, Price)>,
    growths: Vec<Grown>,
}

impl Kept {
    /// Reads the times from the files of a folder.
    ///
    /// # Errors
    ///
    /// If a file is missing, has other columns, or lacks a number where one belongs.
    pub fn read(folder: &Path) -> Result<Self> {
        let columns = ["setting", "host_pixel_ns", "host_light_ns", "host_pixel", "host_light"];
        let of_setting = |row: Row<'_>, [name, rest @ ..]: [usize; 5]| {
            if row.text(rest[0]).is_empty() {
                return Ok(None);
            }
            let [pixel, light, of_nine, light_of_nine] = rest.map(|column| row.number(column));
            let cost = Cost { pixel: pixel?, light: light? };
            let (pixel, light) = (Some(of_nine?), Some(light_of_nine?));
            let price = Price { pixel, light, ..Price::default() };
            Ok(Some((row.text(name).to_owned(), (cost, price))))
        };
        let of_growth = |row: Row<'_>, [quantity, measure, size, time]: [usize; 4]| {
            if row.text(time).is_empty() {
                return Ok(None);
            }
            let names = [quantity, measure].map(|column| row.text(column).to_owned());
            let [quantity, measure] = names;
            Ok(Some((quantity, measure, row.number(size)?, row.number(time)?)))
        };
        let settings = rows(&folder.join(POINTS), columns, of_setting)?.into_iter().collect();
        let columns = ["quantity", "measure", "size", "host_ns"];
        let growths = rows(&folder.join(GROWTH), columns, of_growth)?;
        Ok(Self { settings, growths })
    }

    /// The time of the setting with this name, and its price on this machine.
    #[must_use]
    pub fn of_setting(&self, name: &str) -> Option<(Cost, Price)> {
        self.settings.get(name).copied()
    }

    /// Fills in the time of each setting.
    ///
    /// # Errors
    ///
    /// If a setting has no time.
    pub fn give(&self, points: &mut [Point]) -> Result<()> {
        for point in points {
            let name = point.setting.to_string();
            let Some((cost, price)) = self.of_setting(&name) else {
                let what = format!("`{name}` has no time to be kept");
                return Err(Error::new(what, "measure all times again, without --keep-times"));
            };
            point.cost = Some(cost);
            point.prices.insert(Machine::Host, price);
        }
        Ok(())
    }

    /// The times of a growth curve, by size.
    #[must_use]
    pub fn of(&self, growth: &Growth) -> Vec<(f64, f64)> {
        let names = (growth.quantity, growth.measure);
        let of = self.growths.iter().filter(|one| (&*one.0, &*one.1) == names);
        of.map(|&(_, _, size, time)| (size, time)).collect()
    }
}

/// The parsed rows of a file, without the empty ones.
fn rows<T, const N: usize>(
    path: &Path,
    columns: [&str; N],
    read: impl Fn(Row<'_>, [usize; N]) -> Result<Option<T>>,
) -> Result<Vec<T>> {
    let header = columns.join(",");
    let sheet = Sheet::read(path, &header)?;
    let places = sheet.columns(columns).ok_or_else(|| sheet.wrong_header(&header))?;
    sheet.rows().filter_map(|row| read(row, places).transpose()).collect()
}
