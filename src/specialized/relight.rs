//! Relights order by order, for machines that process numbers one at a time. It skips products with
//! zero and reads each coefficient of the light once.

use crate::index::light::position;
use crate::scalar::Scalar;

/// Whether the target processes numbers in groups, as [`pass`](super::pass) does.
pub const GROUPS: bool = cfg!(any(
    target_arch = "x86",
    target_arch = "x86_64",
    target_arch = "aarch64",
    target_arch = "wasm32",
    target_feature = "neon",
    target_feature = "v"
));

/// d_i = Σ_l T_i,l L_l^m for the components of `P` profiles of order `M`, over `D` degrees from
/// |m| on.
///
/// The transfer has `T` numbers. Those of this order start at `START`, `STEP` apart from one degree
/// to the next and four apart from one profile to the next. The sums are written to the indices in
/// `components`.
///
/// Not inlined: a compiler that sees several orders at once runs out of registers.
#[inline(never)]
pub fn order<
    S: Scalar,
    const M: isize,
    const START: usize,
    const STEP: usize,
    const P: usize,
    const D: usize,
    const T: usize,
    const N: usize,
    const K: usize,
>(
    transfer: &[S; T],
    light: &[S; N],
    components: &'static [u16; P],
    coefficients: &mut [S; K],
) {
    let mut sums = [S::ZERO; P];
    for l in 0..D {
        let degree = M.unsigned_abs() + l;
        let light = light.get(position(degree, M)).copied().unwrap_or(S::ZERO);
        for (profile, sum) in sums.iter_mut().enumerate() {
            if let Some(&number) = transfer.get(START + l * STEP + 4 * profile) {
                *sum = if l == 0 { number * light } else { sum.add_product(number, light) };
            }
        }
    }
    for (&component, sum) in components.iter().zip(sums) {
        if let Some(coefficient) = coefficients.get_mut(usize::from(component)) {
            *coefficient = sum;
        }
    }
}

/// Coefficients of an image, all zero.
#[inline(always)]
#[must_use]
pub fn blank_coefficients<S: Scalar, const K: usize>() -> crate::Coefficients<S, K> {
    crate::Buffer::from([S::ZERO; K])
}

/// The coefficients of an image, to be written, if there are exactly `K`.
#[inline(always)]
pub fn coefficients_mut<S: Scalar, const K: usize>(
    coefficients: &mut crate::Coefficients<S, K>,
) -> Option<&mut [S; K]> {
    coefficients.as_mut_slice().try_into().ok()
}

/// The numbers of a transfer, if there are exactly `T`.
#[inline(always)]
pub fn transfer<S: Scalar, const T: usize>(transfer: &crate::Transfer<S, T>) -> Option<&[S; T]> {
    transfer.as_slice().try_into().ok()
}
