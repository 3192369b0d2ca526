//! A table read at run time, as a runtime basis in an integer format.

use eigenshade::quantised::{Basis, Normal, Parts, Profile};
use eigenshade::{Error, Fixed, Q15, Q31};
use eigenshade_table::Table;
use eigenshade_table::quantize::{Format, QuantizeError, QuantizedParts};

/// An integer format that the command line offers.
pub trait Integer: Fixed {
    /// The format's identifier.
    const FORMAT: Format;
    /// The number with this mantissa, which must fit the format.
    fn of(mantissa: i32) -> Self;
    /// The nearest representable normal.
    ///
    /// # Errors
    ///
    /// If the vector is not a visible unit vector.
    fn normal(components: [f64; 3]) -> Result<Normal<Self>, Error>;
    /// The basis with these parts.
    ///
    /// # Errors
    ///
    /// As `Basis::new` of the runtime.
    fn basis(parts: Parts<'_, Self>) -> Result<Basis<'_, Self>, Error>;
}

impl Integer for Q15 {
    const FORMAT: Format = Format::Q15;
    fn of(mantissa: i32) -> Self {
        Self(mantissa as i16)
    }
    fn normal(components: [f64; 3]) -> Result<Normal<Self>, Error> {
        let [x, y, z] = components.map(rounded);
        Normal::<Self>::new(x, y, z)
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
    fn normal(components: [f64; 3]) -> Result<Normal<Self>, Error> {
        let [x, y, z] = components.map(rounded);
        Normal::<Self>::new(x, y, z)
    }
    fn basis(parts: Parts<'_, Self>) -> Result<Basis<'_, Self>, Error> {
        Basis::<Self>::new(parts)
    }
}

/// The nearest multiple of 2^-BITS; 1 becomes the largest mantissa.
fn rounded<Q: Integer>(component: f64) -> Q {
    let one = 2f64.powi(Q::FORMAT.bits());
    Q::of((one * component).round().clamp(1.0 - one, one - 1.0) as i32)
}

/// The owned arrays of an integer basis.
#[derive(Clone, Debug)]
pub struct OwnedQuantised<Q> {
    parts: QuantizedParts,
    profiles: Vec<Profile>,
    polar: Vec<Q>,
    factors: Vec<Q>,
    terms: Vec<Q>,
}

impl<Q: Integer> OwnedQuantised<Q> {
    /// Converts a table to this format and trims its polynomials to `tolerance`.
    ///
    /// # Errors
    ///
    /// If the table has no integer form.
    pub fn new(table: &Table, tolerance: f64) -> Result<Self, QuantizeError> {
        let parts = QuantizedParts::new(table, Q::FORMAT, tolerance)?;
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

    /// The basis.
    ///
    /// # Errors
    ///
    /// Cannot fail in practice, because the parts of a table are consistent.
    pub fn view(&self) -> Result<Basis<'_, Q>, Error> {
        Q::basis(Parts {
            degree: self.parts.degree,
            order: self.parts.order,
            effects: self.parts.effects,
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
