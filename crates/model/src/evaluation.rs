//! A table evaluated in f64, from its fields alone: the reference for the runtime.
//!
//! The eigenimages U_i are u(α) Φ_m(β).
//!
//! ```
//! use eigenshade_model::evaluation::Evaluator;
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables");
//! let table = eigenshade_table::decode(&std::fs::read(format!("{folder}/sphere.bin"))?)?;
//! let evaluator = Evaluator::new(&table);
//! let d = evaluator.project(&[3.5, 0.0, 1.0, 0.0], &[2.0])?;
//! let images = evaluator.eigenimages(&[[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]);
//! let irradiance = images.reconstruct(&d);
//! assert!(irradiance[0] > irradiance[1] && irradiance[1] > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::error::{Error, Result};
use crate::orthogonal_series::OrthogonalSeries;
use crate::task::checkpoint;
use eigenshade_table::effect::{Effect, Effects};
use eigenshade_table::reduce::fingerprint;
use eigenshade_table::{Component, MeanImage, Profile, Table, light, material, mode};
use std::borrow::Borrow;
use std::f64::consts::SQRT_2;

/// Projects lights on materials onto a table, borrowed or owned, and reconstructs images.
#[derive(Clone, Debug)]
pub struct Evaluator<T> {
    table: T,
    components: usize,
    effects: Effects,
    /// UᵀM, a row for each profile.
    rows: Vec<Vec<Entry>>,
    /// The profiles of a table beyond [`CHEBYSHEV`]; otherwise empty.
    series: Vec<OrthogonalSeries>,
}

/// The largest degree at which the Chebyshev series of all profiles are exact to 1e-12 of an image's
/// peak.
const CHEBYSHEV: usize = 12;

/// A number of UᵀM that is not 0.
#[derive(Clone, Copy, Debug)]
struct Entry {
    l: usize,
    /// The position of (o, p, q) in a material.
    place: usize,
    value: f64,
}

/// The transfer T of a material: T_l = Σ_opq (UᵀM)_lopq b_op^q for each profile and each l from its
/// |m| on.
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer(Vec<Vec<f64>>);

/// The eigenimages and the mean image of a table at some normals.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigenimages {
    mean: Vec<f64>,
    /// A row for each normal, a column for each eigenimage.
    values: Vec<f64>,
    components: usize,
}

impl<T: Borrow<Table>> Evaluator<T> {
    /// Evaluates all components and all effects of the table.
    #[must_use]
    pub fn new(table: T) -> Self {
        let (components, effects) = (table.borrow().count(), Effects::ALL);
        let rows = rows(table.borrow(), effects);
        let profiles = &table.borrow().profiles;
        let is_high = table.borrow().gram.degree > CHEBYSHEV;
        let high = profiles.iter().filter(|_| is_high);
        let series = high.map(|profile| OrthogonalSeries::new(table.borrow(), profile)).collect();
        Self { table, components, effects, rows, series }
    }

    fn table(&self) -> &Table {
        self.table.borrow()
    }

    /// Restricts the images to the first `count` components.
    #[must_use]
    pub fn with_components(self, count: usize) -> Self {
        let components = count.min(self.table().count());
        Self { components, ..self }
    }

    /// Restricts the images to some effects. The mean image is ambient.
    ///
    /// # Errors
    ///
    /// If the table has transfers, which contain all its effects, and some are left out.
    pub fn with_effects(self, effects: Effects) -> Result<Self> {
        let all = self.table().effects();
        if effects.and(all) != all && !self.table().has_projection() {
            let what = "the table has transfers, which contain all its effects";
            let remedy = "leave --effects out, or make a table with store = \"projection\"";
            return Err(Error::new(what, remedy));
        }
        let rows = rows(self.table(), effects);
        Ok(Self { effects, rows, ..self })
    }

    /// The transfer of one channel of a material. Missing coefficients count as zero, and those
    /// beyond the table's order are ignored.
    ///
    /// # Errors
    ///
    /// If the table has only transfers, and none of this material.
    pub fn transfer(&self, material: &[f64]) -> Result<Transfer> {
        let degree = self.table().gram.degree;
        if !self.table().has_projection() {
            return self.stored(material);
        }
        let profiles = self.table().profiles.iter().zip(&self.rows);
        let of_profile = |(profile, row): (&Profile, &Vec<Entry>)| {
            let mut sums = vec![0.0; degree + 1 - profile.azimuth];
            for &Entry { l, place, value } in row {
                let b = material.get(place).copied().unwrap_or(0.0);
                sums[l - profile.azimuth] += value * b;
            }
            sums
        };
        Ok(Transfer(profiles.map(of_profile).collect()))
    }

    fn stored(&self, material: &[f64]) -> Result<Transfer> {
        let fingerprint = fingerprint(material);
        let found = self.table().transfers.iter().find(|one| one.fingerprint == fingerprint);
        let found = found.ok_or_else(|| {
            let what = "the table has transfers only for its scene's materials, and a material is \
                        not one of them";
            let remedy =
                "use the scene's material file, or make a table with store = \"projection\"";
            Error::new(what, remedy)
        })?;
        let mut rest = found.numbers.iter().copied();
        let lengths = self.table().profiles.iter();
        let lengths = lengths.map(|profile| self.table().gram.degree + 1 - profile.azimuth);
        Ok(Transfer(lengths.map(|length| rest.by_ref().take(length).collect()).collect()))
    }

    /// d of one channel of a light on a material, less the mean image's d. Missing coefficients of
    /// the light count as zero, and those beyond the table's degree are ignored.
    #[must_use]
    pub fn relight(&self, transfer: &Transfer, light: &[f64]) -> Vec<f64> {
        let coordinate = |component: &Component| {
            let m = component.order as isize;
            let numbers = &transfer.0[component.profile];
            let products = (m.unsigned_abs()..).zip(numbers).map(|(l, number)| {
                number * light.get(light::position(l, m)).copied().unwrap_or(0.0)
            });
            let sum: f64 = products.sum();
            // Modes of -m are (-1)^m times those of m.
            if m < 0 && m % 2 != 0 { -sum } else { sum }
        };
        let components = self.table().components.iter().take(self.components);
        let mut d: Vec<f64> = components.map(coordinate).collect();
        if let Some(mean) = self.mean() {
            d.iter_mut().zip(&mean.coefficients).for_each(|(d, mean)| *d -= mean);
        }
        d
    }

    /// d = UᵀMc of one channel of a light on one channel of a material: [`transfer`](Self::transfer)
    /// and [`relight`](Self::relight).
    ///
    /// # Errors
    ///
    /// As [`transfer`](Self::transfer).
    pub fn project(&self, light: &[f64], material: &[f64]) -> Result<Vec<f64>> {
        Ok(self.relight(&self.transfer(material)?, light))
    }

    /// The eigenimages at unit normals with z >= 0.
    #[must_use]
    pub fn eigenimages(&self, normals: &[[f64; 3]]) -> Eigenimages {
        let mut images = Eigenimages {
            mean: Vec::with_capacity(normals.len()),
            values: Vec::with_capacity(normals.len() * self.components),
            components: self.components,
        };
        for &normal in normals {
            checkpoint();
            images.values.extend(self.values(normal));
            images.mean.push(self.mean().map_or(0.0, |mean| mean.value(normal[2])));
        }
        images
    }

    /// u(α) Φ_m(β) of each component at a normal.
    fn values(&self, [x, y, z]: [f64; 3]) -> Vec<f64> {
        // sin^m α (cos mβ, sin mβ), the powers of x + iy.
        let power = |&[re, im]: &[f64; 2]| Some([re * x - im * y, re * y + im * x]);
        let waves = std::iter::successors(Some([1.0, 0.0]), power);
        let waves: Vec<[f64; 2]> = waves.take(self.table().gram.degree + 1).collect();
        let heights: Vec<f64> = match &self.series[..] {
            [] => self.table().profiles.iter().map(|profile| profile.height(z)).collect(),
            series => series.iter().map(|one| one.height(z)).collect(),
        };
        let value = |component: &Component| {
            let [cosine, sine] = waves[component.order.unsigned_abs() as usize];
            let wave = match component.order {
                0 => 1.0,
                1.. => SQRT_2 * cosine,
                _ => -SQRT_2 * sine,
            };
            heights[component.profile] * wave
        };
        self.table().components.iter().take(self.components).map(value).collect()
    }

    /// The mean image, if the table has one and the effects include it.
    fn mean(&self) -> Option<&MeanImage> {
        self.table().mean.as_ref().filter(|_| self.effects.has(Effect::Ambient))
    }
}

impl Eigenimages {
    /// The image of coefficients d, at most as many as there are eigenimages: the mean image plus
    /// Σ d_i U_i.
    #[must_use]
    pub fn reconstruct(&self, d: &[f64]) -> Vec<f64> {
        let rows = (0..self.mean.len()).map(|k| &self.values[k * self.components..]);
        rows.zip(&self.mean).map(|(row, mean)| mean + product(&row[..self.components], d)).collect()
    }

    /// The eigenimage of this number, U_i.
    #[must_use]
    pub fn eigenimage(&self, number: usize) -> Vec<f64> {
        (0..self.mean.len()).map(|k| self.values[k * self.components + number]).collect()
    }

    /// The mean image, the image of d = 0; black for a table without one.
    #[must_use]
    pub fn mean(&self) -> &[f64] {
        &self.mean
    }
}

/// The rows of UᵀM for some effects; none for a table without projection.
fn rows(table: &Table, effects: Effects) -> Vec<Vec<Entry>> {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let profiles = table.profiles.iter().filter(|_| table.has_projection());
    let row = |profile: &Profile| {
        let modes = mode::indices(degree, order, profile.azimuth).zip(table.gram_row(profile));
        let kept = modes.filter(|&((l, o, ..), value)| value != 0.0 && effects.keeps(l, o));
        let entry = |((l, o, p, q), value)| Entry { l, place: material::position(o, p, q), value };
        kept.map(entry).collect()
    };
    profiles.map(row).collect()
}

/// Σ a_k b_k over the shorter of two lists.
fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
