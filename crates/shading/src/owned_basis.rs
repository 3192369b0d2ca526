//! A table read at run time, as a runtime basis in a chosen number format.

use eigenshade::{
    Basis, Coupling, GeneralBasis, GeneralParts, Parts, Pass, ProfilePlace, Row, Scalar,
};
use eigenshade_index::effect::Effects;
use eigenshade_index::layout::Recurrence;
use eigenshade_table::Table;
use eigenshade_table::parts::{self, NONE};

/// The owned arrays of a basis.
#[derive(Clone, Debug)]
pub struct OwnedBasis<S> {
    degree: usize,
    order: usize,
    effects: Effects,
    ambient: Vec<S>,
    components: usize,
    profiles: Vec<ProfilePlace>,
    passes: Vec<Pass>,
    slots: Vec<u16>,
    couplings: Vec<Coupling>,
    lengths: Vec<u16>,
    polar: Vec<S>,
    factors: Vec<S>,
    terms: Vec<S>,
    recurrences: Vec<Recurrence>,
    mean: Vec<S>,
    mean_coefficients: Vec<S>,
    selection: Vec<bool>,
    general: Option<OwnedGeneral<S>>,
    transfers: Vec<OwnedTransfer<S>>,
}

/// The owned arrays of a general basis.
#[derive(Clone, Debug)]
struct OwnedGeneral<S> {
    components: usize,
    projection: Vec<S>,
    synthesis: Vec<S>,
    mean: Vec<S>,
    mean_coefficients: Vec<S>,
}

/// A material whose transfer the table stores.
#[derive(Clone, Debug)]
pub struct OwnedTransfer<S> {
    /// The fingerprint of its coefficients: [`eigenshade_table::reduce::fingerprint`].
    pub fingerprint: u32,
    /// Its transfer, for [`Basis::relight_into`].
    pub transfer: Vec<S>,
}

impl<S: Scalar> OwnedBasis<S> {
    /// Rounds a table's numbers to the format.
    #[must_use]
    pub fn new(table: &Table) -> Self {
        let parts = eigenshade_table::Parts::new(table);
        fn rounded<S: Scalar>(values: &[f64]) -> Vec<S> {
            values.iter().map(|&value| S::from_f64(value)).collect()
        }
        let transfers = table.transfers.iter().map(|one| OwnedTransfer {
            fingerprint: one.fingerprint,
            transfer: rounded(&parts.transfer(&one.numbers)),
        });
        Self {
            transfers: transfers.collect(),
            degree: parts.degree,
            order: parts.order,
            effects: parts.effects,
            ambient: rounded(&parts.ambient),
            components: parts.components,
            profiles: parts.profiles.iter().map(place).collect(),
            passes: parts.passes.iter().map(|p| Pass::new(p.first, p.profiles)).collect(),
            slots: parts.slots,
            couplings: parts.couplings.iter().map(coupling).collect(),
            polar: rounded(&parts.polar),
            factors: rounded(&parts.factors),
            terms: rounded(&parts.terms),
            recurrences: parts.recurrences,
            mean: rounded(&parts.mean),
            mean_coefficients: rounded(&parts.mean_coefficients),
            lengths: parts.lengths,
            selection: parts.selection,
            general: table.general.as_ref().map(|general| OwnedGeneral {
                components: general.eigenvalues.len(),
                projection: rounded(&general.projection),
                synthesis: rounded(&general.synthesis),
                mean: rounded(&general.mean),
                mean_coefficients: rounded(&general.mean_coefficients),
            }),
        }
    }

    /// The materials whose transfers the table stores; empty for a table that projects.
    #[must_use]
    pub fn transfers(&self) -> &[OwnedTransfer<S>] {
        &self.transfers
    }

    /// The basis of the table, of either kind.
    ///
    /// # Errors
    ///
    /// See [`basis`](Self::basis).
    pub fn any(&self) -> Result<AnyBasis<'_, S>, eigenshade::Error> {
        let Some(general) = &self.general else { return self.basis().map(AnyBasis::Sphere) };
        let parts = GeneralParts {
            components: general.components,
            projection: &general.projection,
            synthesis: &general.synthesis,
            mean: &general.mean,
            mean_coefficients: &general.mean_coefficients,
        };
        GeneralBasis::new(self.basis()?, parts).map(AnyBasis::General)
    }

    /// The basis itself, or the span of a general basis.
    ///
    /// # Errors
    ///
    /// As [`Basis::new`], for a table whose parts contradict each other.
    pub fn basis(&self) -> Result<Basis<'_, S>, eigenshade::Error> {
        Basis::new(Parts {
            degree: self.degree,
            order: self.order,
            effects: self.effects,
            ambient: &self.ambient,
            components: self.components,
            profiles: &self.profiles,
            passes: &self.passes,
            slots: &self.slots,
            couplings: &self.couplings,
            lengths: &self.lengths,
            polar: &self.polar,
            factors: &self.factors,
            terms: &self.terms,
            recurrences: &self.recurrences,
            mean: &self.mean,
            mean_coefficients: &self.mean_coefficients,
            selection: &self.selection,
        })
    }
}

/// A basis of either kind.
#[derive(Clone, Copy, Debug)]
pub enum AnyBasis<'a, S> {
    /// Each eigenimage has a single azimuth.
    Sphere(Basis<'a, S>),
    /// Eigenimages are sums over several azimuths.
    General(GeneralBasis<'a, S>),
}

impl<'a, S> From<Basis<'a, S>> for AnyBasis<'a, S> {
    fn from(basis: Basis<'a, S>) -> Self {
        Self::Sphere(basis)
    }
}

fn coupling(&[o, p]: &[u16; 2]) -> Coupling {
    Coupling::new(o, p)
}

fn place(place: &parts::ProfilePlace) -> ProfilePlace {
    let index = |index: u16| (index != NONE).then_some(index);
    let row = |row: parts::Row| Row::new(row.start, row.step);
    ProfilePlace::new(
        place.azimuth,
        index(place.plus),
        index(place.minus),
        row(place.plus_row),
        row(place.minus_row),
    )
}
