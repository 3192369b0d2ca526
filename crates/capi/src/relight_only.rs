//! The shipped bases without the factors of transfers. The functions that relight, collapse and shade
//! use these, so that a program whose transfers are computed beforehand links no factors.

use eigenshade::{Basis, Parts, Q15, Q31, quantized, sphere};

/// In float.
pub(crate) static BASIS_F32: Basis<'static, f32> = {
    let all = *sphere::BASIS.parts();
    match Basis::new(Parts { polar: &[], factors: &[], ..all }) {
        Ok(basis) => basis,
        Err(_) => panic!("the table's parts do not fit together"),
    }
};

/// In mantissas of 15 bits.
pub(crate) static BASIS_Q15: quantized::Basis<'static, Q15> = {
    let all = *sphere::q15::BASIS.parts();
    let (polar, polar_exponents) = (&[], &[]);
    let (factors, factor_exponents) = (&[], &[]);
    let parts = quantized::Parts { polar, polar_exponents, factors, factor_exponents, ..all };
    match quantized::Basis::<Q15>::new(parts) {
        Ok(basis) => basis,
        Err(_) => panic!("the table's parts do not fit together"),
    }
};

/// In mantissas of 31 bits.
pub(crate) static BASIS_Q31: quantized::Basis<'static, Q31> = {
    let all = *sphere::q31::BASIS.parts();
    let (polar, polar_exponents) = (&[], &[]);
    let (factors, factor_exponents) = (&[], &[]);
    let parts = quantized::Parts { polar, polar_exponents, factors, factor_exponents, ..all };
    match quantized::Basis::<Q31>::new(parts) {
        Ok(basis) => basis,
        Err(_) => panic!("the table's parts do not fit together"),
    }
};
