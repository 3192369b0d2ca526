//! A table read at run time, as a basis of the runtime in an integer format.

use eigenshade::quantised::{Basis, Normal, Parts, Profile};
use eigenshade::{Error, Fixed, Q15, Q31};
use eigenshade_table::Table;
use eigenshade_table::quantise::{Format, QuantiseError, QuantisedParts};

/// An integer format as the command line meets it.
pub trait Integer: Fixed {
    /// Which it is.
    const FORMAT: Format;
    /// The mantissa of this number, which has no more bits.
    fn of(mantissa: i32) -> Self;
    /// The normal of these components.
    fn normal(components: [Self; 3]) -> Normal<Self>;
    /// The basis of these parts.
    ///
    /// # Errors
    ///
    /// As that of the runtime.
    fn basis(parts: Parts<'_, Self>) -> Result<Basis<'_, Self>, Error>;
}

impl Integer for Q15 {
    const FORMAT: Format = Format::Q15;
    fn of(mantissa: i32) -> Self {
        Self(mantissa as i16)
    }
    fn normal([x, y, z]: [Self; 3]) -> Normal<Self> {
        Normal::<Self>::new(x, y, z).expect("normal")
    }
    fn basis(parts: Parts<'_, Self>) -> Result<Basis<'_, Self>, Error> {
        Basis::<Self>::new(parts)
    }
}

impl Integer for Q31 {
    const FORMAT: Format = Format::Q31;
    fn of(mantissa: i32) -> Self {
        Self(mantissa)
    }
    fn normal([x, y, z]: [Self; 3]) -> Normal<Self> {
        Normal::<Self>::new(x, y, z).expect("normal")
    }
    fn basis(parts: Parts<'_, Self>) -> Result<Basis<'_, Self>, Error> {
        Basis::<Self>::new(parts)
    }
}

/// The arrays of a basis in integers, owned.
#[derive(Clone, Debug)]
pub struct OwnedQuantised<Q> {
    parts: QuantisedParts,
    profiles: Vec<Profile>,
    polar: Vec<Q>,
    factors: Vec<Q>,
    terms: Vec<Q>,
}

impl<Q: Integer> OwnedQuantised<Q> {
    /// A table in this format, its polynomials trimmed to `tolerance`.
    ///
    /// # Errors
    ///
    /// A table that has no integer form.
    pub fn new(table: &Table, tolerance: f64) -> Result<Self, QuantiseError> {
        let parts = QuantisedParts::new(table, Q::FORMAT, tolerance)?;
        let own = |numbers: &[i32]| numbers.iter().map(|&number| Q::of(number)).collect();
        let profiles = parts.profiles.iter();
        Ok(Self {
            profiles: profiles
                .map(|place| {
                    let (components, sizes) = ([place.plus, place.minus], [place.size, place.step]);
                    Profile::new(place.azimuth, place.exponent, components, sizes)
                })
                .collect(),
            polar: own(&parts.polar),
            factors: own(&parts.factors),
            terms: own(&parts.terms),
            parts,
        })
    }

    pub fn place(&self, k: usize) -> eigenshade_table::quantise::Place {
        self.parts.profiles[k]
    }
    pub fn term(&self, k: usize) -> f64 {
        self.parts.terms[k].into()
    }
    /// The basis.
    ///
    /// # Errors
    ///
    /// None in truth: a table's parts fit together.
    pub fn view(&self) -> Result<Basis<'_, Q>, Error> {
        Q::basis(Parts {
            degree: self.parts.degree,
            order: self.parts.order,
            components: self.parts.components,
            profiles: &self.profiles,
            lengths: &self.parts.lengths,
            polar: &self.polar,
            polar_exponents: &self.parts.polar_exponents,
            factors: &self.factors,
            factor_exponents: &self.parts.factor_exponents,
            terms: &self.terms,
        })
    }
}
