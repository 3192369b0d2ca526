//! Reductions of a table: fewer components, fewer stored parts.

use crate::scene::Store;
use crate::table::{Component, MaterialTransfer, Table};
use crate::{material, mode};

/// The table restricted to the components for which `keep` returns true, and to their profiles.
///
/// `keep` receives the number of a component, counted from 0, and the component. If it keeps the
/// first K components, the result is the table of the same scene with K components.
///
/// Domain: a table that [projects](Table::has_projection). Stored transfers are dropped.
#[must_use]
pub fn with_components(whole: &Table, keep: impl Fn(usize, &Component) -> bool) -> Table {
    let chosen = whole.components.iter().enumerate().filter(|(k, one)| keep(*k, one));
    let mut components: Vec<Component> = chosen.map(|(_, one)| *one).collect();
    let mut used: Vec<usize> = components.iter().map(|one| one.profile).collect();
    used.sort_unstable();
    used.dedup();
    for component in &mut components {
        component.profile = used.partition_point(|&profile| profile < component.profile);
    }
    let profiles = used.iter().map(|&profile| whole.profiles[profile].clone()).collect();
    Table { components, profiles, transfers: Vec::new(), ..whole.clone() }
}

impl Table {
    /// Reduces a complete table to the parts that the scene's `store` requires. `materials` are the
    /// scene's materials: a name and the coefficients of each channel, of the table's order.
    pub fn keep<'a>(&mut self, materials: impl IntoIterator<Item = (&'a str, [&'a [f64]; 3])>) {
        if self.scene.basis.store == Store::Materials {
            let rows: Vec<Vec<f64>> =
                self.profiles.iter().map(|profile| self.gram_row(profile)).collect();
            for (name, channels) in materials {
                for coefficients in channels {
                    let fingerprint = fingerprint(coefficients);
                    let known = |one: &MaterialTransfer| one.fingerprint == fingerprint;
                    if !self.transfers.iter().any(known) {
                        let numbers = self.transferred(&rows, coefficients);
                        let name = name.to_owned();
                        self.transfers.push(MaterialTransfer { name, fingerprint, numbers });
                    }
                }
            }
            let gram = &mut self.gram;
            for part in
                [&mut gram.gains, &mut gram.polar_integrals, &mut gram.radials, &mut gram.rotations]
            {
                *part = Vec::new();
            }
            self.profiles.iter_mut().for_each(|profile| profile.factors = Vec::new());
        }
        if self.scene.basis.store != Store::Modes {
            self.profiles.iter_mut().for_each(|profile| profile.modes = Vec::new());
        }
    }

    /// T of one channel of a material, computed from the rows of UᵀM.
    fn transferred(&self, rows: &[Vec<f64>], coefficients: &[f64]) -> Vec<f64> {
        let (degree, order) = (self.gram.degree, self.gram.order);
        let mut numbers = Vec::with_capacity(self.transfer_length());
        for (profile, row) in self.profiles.iter().zip(rows) {
            let mut sums = vec![0.0; degree + 1 - profile.azimuth];
            let modes = mode::indices(degree, order, profile.azimuth);
            for ((l, o, p, q), entry) in modes.zip(row) {
                sums[l - profile.azimuth] += entry * coefficients[material::position(o, p, q)];
            }
            numbers.extend(sums);
        }
        numbers
    }
}

/// A number that identifies coefficients: the CRC-32 of their bits, little-endian, the same
/// checksum that the table file uses. Two random materials have the same fingerprint with a
/// probability of 1 in 4e9.
#[must_use]
pub fn fingerprint(coefficients: &[f64]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    coefficients.iter().for_each(|value| hasher.update(&value.to_bits().to_le_bytes()));
    hasher.finalize()
}
