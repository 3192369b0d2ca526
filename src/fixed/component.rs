//! A component of a new light as one product of rows, for machines that take numbers one
//! by one: nothing is multiplied that is zero.

use crate::index::light::position;
use crate::scalar::Scalar;

/// Whether the target takes numbers in groups, as [`pass`](super::pass) does.
pub const GROUPS: bool = cfg!(any(
    target_arch = "x86",
    target_arch = "x86_64",
    target_arch = "aarch64",
    target_arch = "wasm32",
    target_feature = "neon",
    target_feature = "v"
));

/// L_l^m of the order `M` for the `L` degrees from |m| on.
#[inline(always)]
pub fn light_of_order<S: Scalar, const M: isize, const L: usize, const N: usize>(
    light: &[S; N],
) -> [S; L] {
    let mut degree = M.unsigned_abs();
    [(); L].map(|()| {
        let value = light.get(position(degree, M)).copied().unwrap_or(S::ZERO);
        degree += 1;
        value
    })
}

/// d_i = Σ_l T_i,l L_l^m, of the row from `START` on whose numbers are `STEP` apart.
#[inline(always)]
pub fn component<
    S: Scalar,
    const START: usize,
    const STEP: usize,
    const L: usize,
    const T: usize,
>(
    transfer: &[S; T],
    light: &[S; L],
) -> S {
    let row = transfer.get(START..).unwrap_or_default().iter().step_by(STEP.max(1));
    row.zip(light).fold(S::ZERO, |sum, (&number, &light)| sum.add_product(number, light))
}
