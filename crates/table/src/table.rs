//! A table: the eigenbasis of one scene.

use crate::general::General;
use crate::gram::GramFactor;
use crate::scene::Scene;
use crate::transfer::MaterialTransfer;
use crate::wire::Format;
use eigenshade_index::effect::Effects;
use eigenshade_index::pair;
use serde::{Deserialize, Serialize};

/// Everything that a generator found out about one scene, in f64.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// What was asked for.
    pub scene: Scene,
    /// How it went.
    pub summary: Summary,
    /// M of (23), factored.
    pub gram: GramFactor,
    /// The modes that a selection kept, in the order of [`GramFactor::place`], or
    /// empty for all.
    pub selection: Vec<bool>,
    /// The eigenimages in canonical order: eigenvalue falling, then |m|, then +m
    /// before -m. The scene's number of them, or fewer where the rank ends.
    pub components: Vec<Component>,
    /// The slant profiles of those eigenimages, by |m|, then eigenvalue falling.
    pub profiles: Vec<Profile>,
    /// The mean image, which [`Criterion::Standard`](crate::scene::Criterion)
    /// subtracts.
    pub mean: Option<MeanImage>,
    /// Order m and eigenvalue of every component found, kept or not, in
    /// canonical order; no m where components are sums of several.
    pub spectrum: Vec<(Option<i32>, Option<f64>)>,
    /// Eigenimages that are sums of the components, which are then but a span.
    pub general: Option<General>,
    /// The scene's materials folded in, with [`Store::Materials`](crate::scene::Store);
    /// the factors of M and of UᵀM are then empty.
    pub transfers: Vec<MaterialTransfer>,
}

/// One eigenimage: U = u(α) Φ_m(β).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Component {
    /// m, signed.
    pub order: i32,
    /// Which profile is u.
    pub profile: usize,
    /// The variance that it carries; none for the constant of
    /// [`Criterion::ImageCentered`](crate::scene::Criterion).
    pub eigenvalue: Option<f64>,
}

/// One slant profile u(α), shared by +m and -m.
///
/// The mode coefficients of the component of -m are (-1)^m times those here.
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
    /// `eigenshade_index::mode`: a column of U. Empty unless
    /// [`Table::has_modes`].
    pub modes: Vec<f64>,
    /// UᵀM, factored: for each l = |m|..=degree, for each pair (p, q) up to the order that the
    /// scene's effects factor, (-1)^q √(p+1) Σ_k √w_k W_k R_p^q D_l^mq; 0 for l = 0 without
    /// ambient. Behind them, where m = 0, UᵀM of the coefficients of l = 0 that
    /// [stand apart](eigenshade_index::effect::Effects). See [`Table::gram_row`]. Empty unless
    /// [`Table::has_projection`].
    pub factors: Vec<f64>,
}

/// The mean image of the database, an image of m = 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeanImage {
    /// Chebyshev coefficients in 2z - 1 of the mean irradiance at z = cos α.
    pub chebyshev: Vec<f64>,
    /// Its coefficient in each component.
    pub coefficients: Vec<f64>,
}

/// How the making of a table went.
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
    /// Mean energy of the database's images about their mean (each its own, or
    /// the database's, by the criterion).
    pub energy: f64,
    /// The share of it that the components keep.
    pub energy_kept: f64,
    /// Largest |UᵀMU - I| over the first 100 components, or all if fewer.
    pub orthonormality: f64,
    /// What each number format that serves the table costs its images; empty where nobody
    /// measured it.
    pub roundings: Vec<Rounding>,
}

/// What a number format costs the images of the table's database with all components, against
/// f64, as shares of each image's peak.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rounding {
    /// The format.
    pub format: Format,
    /// The largest error of a pixel in any image.
    pub largest: f64,
    /// The largest root mean square error of an image, over the sphere's normals.
    pub rms: f64,
}

impl Table {
    /// The row of UᵀM of a profile, over the modes of its |m|, rebuilt from its
    /// factors: for o != p
    /// (Ĉ_lo^q g_pq + Ĉ_lp^q g_oq) / √2, for o = p Ĉ_lo^q g_oq, with
    /// Ĉ_lo^q = √(o+1) N_l^q C_lo^q and g the factors of l.
    ///
    /// Modes that a selection dropped, or that belong to no effect of the scene's, are 0.
    /// Domain: [`Table::has_projection`].
    #[must_use]
    pub fn gram_row(&self, profile: &Profile) -> Vec<f64> {
        let gram = &self.gram;
        let effects = self.effects();
        let pairs = pair::count(effects.factored_order(gram.order));
        let apart = &profile.factors[pairs * (gram.degree + 1 - profile.azimuth)..];
        let of_apart = |o, p| {
            let place = effects.apart(gram.order).position(|one| one == (o, p));
            apart[place.expect("a coefficient that stands apart")]
        };
        let polar = |l: usize, o: usize, q: usize| {
            gram.polar_integrals[pair::position(o, q) * (gram.degree + 1) + l]
                * ((o + 1) as f64).sqrt()
        };
        eigenshade_index::mode::indices(gram.degree, gram.order, profile.azimuth)
            .map(|(l, o, p, q)| {
                if !self.keeps(profile.azimuth, l, o, p, q) {
                    return 0.0;
                }
                if !effects.factored(o) {
                    return of_apart(o, p);
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

    /// The effects that it is made for.
    #[must_use]
    pub fn effects(&self) -> Effects {
        self.scene.effects.set()
    }

    /// Whether a mode belongs to the scene's effects and the selection kept it.
    #[must_use]
    pub fn keeps(&self, azimuth: usize, l: usize, o: usize, p: usize, q: usize) -> bool {
        self.effects().keeps(l, o)
            && (self.selection.is_empty() || self.selection[self.gram.place(azimuth, l, o, p, q)])
    }

    /// What a format costs its images, if that was measured.
    #[must_use]
    pub fn rounding(&self, format: Format) -> Option<&Rounding> {
        self.summary.roundings.iter().find(|one| one.format == format)
    }

    /// Number of eigenimages K.
    #[must_use]
    pub fn count(&self) -> usize {
        self.general.as_ref().map_or(self.components.len(), |general| general.eigenvalues.len())
    }

    /// Energy that the first `count` components leave, from the eigenvalues; that of azimuths
    /// which the scene cuts is left in any case.
    #[must_use]
    pub fn energy_left(&self, count: usize) -> f64 {
        let largest = self.scene.basis.cut.and_then(|cut| cut.azimuths).unwrap_or(usize::MAX);
        let mut passed = 0;
        let left: Vec<f64> = self
            .spectrum
            .iter()
            .filter(|(order, _)| {
                let within = order.is_none_or(|order| order.unsigned_abs() as usize <= largest);
                passed += usize::from(within);
                !within || passed > count
            })
            .filter_map(|(_, value)| *value)
            .collect();
        // Summed from the small end, so that nothing small is lost.
        left.iter().rev().sum()
    }
}
