//! A table: the eigenbasis of one scene.

use crate::chebyshev::clenshaw;
use crate::effect::Effects;
use crate::format::NumberFormat;
use crate::gram::GramFactor;
use crate::pair;
use crate::scene::{Scene, Store};
use serde::{Deserialize, Serialize};

/// All results of the generator for one scene, in f64.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// The scene that was requested.
    pub scene: Scene,
    /// Statistics of the computation.
    pub summary: Summary,
    /// M of (23), factored.
    pub gram: GramFactor,
    /// Whether a selection kept each mode, in the order of [`GramFactor::place`]; empty if all
    /// modes are kept.
    pub selection: Vec<bool>,
    /// The eigenimages in canonical order: by descending eigenvalue, then |m|, then +m before -m.
    /// The scene's number of components, or fewer if the rank is lower.
    pub components: Vec<Component>,
    /// The slant profiles of the eigenimages, by |m|, then descending eigenvalue.
    pub profiles: Vec<Profile>,
    /// The mean image that [`Criterion::Standard`](crate::scene::Criterion) subtracts.
    pub mean: Option<MeanImage>,
    /// Order m and eigenvalue of every computed component, kept or not, in canonical order.
    pub spectrum: Vec<(i32, Option<f64>)>,
    /// The transfers of the scene's materials, with [`Store::Materials`](crate::scene::Store). The
    /// factors of M and UᵀM are then empty.
    pub transfers: Vec<MaterialTransfer>,
}

/// One eigenimage: U = u(α) Φ_m(β).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Component {
    /// m, signed.
    pub order: i32,
    /// Index of the profile u.
    pub profile: usize,
    /// The variance; `None` for the constant of
    /// [`Criterion::ImageCentered`](crate::scene::Criterion).
    pub eigenvalue: Option<f64>,
}

/// One slant profile u(α), shared by +m and -m.
///
/// The mode coefficients of the component of -m are (-1)^m times these.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// |m|.
    pub azimuth: usize,
    /// √w_k u(α_k): a left singular vector W.
    pub node_values: Vec<f64>,
    /// Chebyshev coefficients in 2z - 1 of h(z) = u / sin^|m|, z = cos α in
    /// \[0, 1\]; h(1) > 0.
    pub chebyshev: Vec<f64>,
    /// Coefficients of the eigenimage over the modes of |m|, in the order of
    /// `crate::mode`: a column of U. Empty unless [`Table::has_modes`].
    pub modes: Vec<f64>,
    /// UᵀM, factored: for each l = |m|..=degree and each pair (p, q), (-1)^q √(p+1) Σ_k √w_k W_k
    /// R_p^q D_l^mq. See [`Table::gram_row`]. Empty unless [`Table::has_projection`].
    pub factors: Vec<f64>,
}

/// The mean image of the database, which has m = 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeanImage {
    /// Chebyshev coefficients in 2z - 1 of the mean irradiance at z = cos α.
    pub chebyshev: Vec<f64>,
    /// The coefficient of the mean image in each component.
    pub coefficients: Vec<f64>,
}

/// The transfer of one channel of one material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MaterialTransfer {
    /// The material's name.
    pub name: String,
    /// The checksum of the material's coefficients, by `reduce::fingerprint`.
    pub fingerprint: u32,
    /// T for each profile and each l = |m|..=degree.
    pub numbers: Vec<f64>,
}

/// Statistics of the computation of a table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Numerical rank of A for each |m| at the scene's cut-off.
    pub ranks: Vec<usize>,
    /// Largest singular value of A over all blocks.
    pub largest_singular_value: f64,
    /// Number of lights in the statistics.
    pub lights: usize,
    /// Number of materials in the statistics.
    pub materials: usize,
    /// Mean energy of the database's images about their mean. By the criterion, this is the mean of
    /// each image or of the database.
    pub energy: f64,
    /// The fraction of this energy that the components keep.
    pub energy_kept: f64,
    /// Largest |UᵀMU - I| over the first 100 components, or over all if there are fewer.
    pub orthonormality: f64,
    /// Rounding errors of the images in each number format to which the table can be converted;
    /// empty if not measured.
    pub roundings: Vec<Rounding>,
}

/// The error of the images of the table's database with all components in a number format, against
/// f64, relative to each image's peak.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rounding {
    /// The format.
    pub format: NumberFormat,
    /// The largest error of any pixel in any image.
    pub largest: f64,
    /// The largest root mean square error of any image, over the sphere's normals.
    pub rms: f64,
}

impl Profile {
    /// h(z) = u / sin^|m|.
    #[must_use]
    pub fn height(&self, z: f64) -> f64 {
        clenshaw(&self.chebyshev, 2.0 * z - 1.0)
    }
}

impl MeanImage {
    /// The mean irradiance at z = cos α.
    #[must_use]
    pub fn value(&self, z: f64) -> f64 {
        clenshaw(&self.chebyshev, 2.0 * z - 1.0)
    }
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

    /// The row of UᵀM of a profile over the modes of its |m|, computed from its factors.
    ///
    /// For o != p it is (Ĉ_lo^q g_pq + Ĉ_lp^q g_oq) / √2, for o = p Ĉ_lo^q g_oq, with Ĉ_lo^q =
    /// √(o+1) N_l^q C_lo^q and the factors g of l.
    ///
    /// Modes that a selection dropped are 0.
    /// Domain: [`Table::has_projection`].
    #[must_use]
    pub fn gram_row(&self, profile: &Profile) -> Vec<f64> {
        let gram = &self.gram;
        let pairs = pair::count(gram.order);
        let polar = |l: usize, o: usize, q: usize| {
            gram.polar_integrals[pair::position(o, q) * (gram.degree + 1) + l]
                * ((o + 1) as f64).sqrt()
        };
        crate::mode::indices(gram.degree, gram.order, profile.azimuth)
            .map(|(l, o, p, q)| {
                if !self.keeps(profile.azimuth, l, o, p, q) {
                    return 0.0;
                }
                let factor = |p: usize| {
                    profile.factors[(l - profile.azimuth) * pairs + pair::position(p, q)]
                };
                if o == p {
                    polar(l, o, q) * factor(o)
                } else {
                    (polar(l, o, q) * factor(p) + polar(l, p, q) * factor(o))
                        * std::f64::consts::FRAC_1_SQRT_2
                }
            })
            .collect()
    }

    /// The effects of the scene.
    #[must_use]
    pub fn effects(&self) -> Effects {
        self.scene.effects.set()
    }

    /// Whether the selection kept a mode.
    #[must_use]
    pub fn keeps(&self, azimuth: usize, l: usize, o: usize, p: usize, q: usize) -> bool {
        self.selection.is_empty() || self.selection[self.gram.place(azimuth, l, o, p, q)]
    }

    /// The rounding errors of a format, if they were measured.
    #[must_use]
    pub fn rounding(&self, format: NumberFormat) -> Option<&Rounding> {
        self.summary.roundings.iter().find(|one| one.format == format)
    }

    /// Number of polynomial terms of a collapsed scene, with both signs of m: the multiply-adds of
    /// a pixel and channel, without the azimuths' own.
    #[must_use]
    pub fn terms(&self) -> usize {
        let azimuths = self.profiles.iter().map(|one| (one.azimuth, one.chebyshev.len()));
        let mean = self.mean.iter().map(|mean| (0, mean.chebyshev.len()));
        let mut longest = vec![0; self.gram.degree + 1];
        for (azimuth, length) in azimuths.chain(mean) {
            longest[azimuth] = length.max(longest[azimuth]);
        }
        longest.iter().enumerate().map(|(m, length)| length * if m == 0 { 1 } else { 2 }).sum()
    }

    /// Number of eigenimages K.
    #[must_use]
    pub fn count(&self) -> usize {
        self.components.len()
    }

    /// Energy beyond the first `count` components, from the eigenvalues.
    #[must_use]
    pub fn energy_left(&self, count: usize) -> f64 {
        // Summed from the small end to preserve small values.
        self.spectrum.iter().skip(count).rev().filter_map(|(_, value)| *value).sum()
    }

    /// Length of one transfer.
    pub(crate) fn transfer_length(&self) -> usize {
        self.profiles.iter().map(|profile| self.gram.degree + 1 - profile.azimuth).sum()
    }
}
