//! The transfers of a scene's materials, which a table stores if it does not store UᵀM for all
//! materials.
//!
//! T_i,l = Σ_opq (UᵀM)_i,(l,opq) b_op^q, so that d_i = Σ_l T_i,l L_l^m. The transfer of -m is
//! (-1)^m times that of m.

use crate::scene::Store;
use crate::table::Table;
use eigenshade_index::{material, mode};
use serde::{Deserialize, Serialize};

/// The transfer of one channel of one material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MaterialTransfer {
    /// The material's name.
    pub name: String,
    /// The [`fingerprint`] of the material's coefficients.
    pub fingerprint: u32,
    /// T for each profile and each l = |m|..=degree.
    pub numbers: Vec<f64>,
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

impl Table {
    /// Whether the table stores U over modes.
    #[must_use]
    pub fn has_modes(&self) -> bool {
        self.scene.basis.store == Store::Modes
    }

    /// Whether the table stores the factors of UᵀM and M and can therefore project any material.
    #[must_use]
    pub fn has_projection(&self) -> bool {
        self.scene.basis.store != Store::Materials
    }

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
                        let numbers = self.folded(&rows, coefficients);
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
            if let Some(general) = &mut self.general {
                general.modes = Vec::new();
            }
        }
    }

    /// T of one channel of a material, computed from the rows of UᵀM.
    fn folded(&self, rows: &[Vec<f64>], coefficients: &[f64]) -> Vec<f64> {
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

    /// Length of one transfer.
    pub(crate) fn transfer_length(&self) -> usize {
        self.profiles.iter().map(|profile| self.gram.degree + 1 - profile.azimuth).sum()
    }
}
