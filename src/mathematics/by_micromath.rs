//! Roots and angles from the crate `micromath`.

use super::functions::Mathematics;
use micromath::F32Ext;

/// Roots and angles from the crate `micromath`: a handful of instructions each, with low accuracy.
///
/// Roots are off by up to 6.1 %, their reciprocals by up to 3.5 %, so a normal scaled by one is
/// too long or too short by as much. Sines and cosines are off by up to 1.1e-3 within 10 rad.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Micromath;

impl Mathematics<f32> for Micromath {
    #[inline]
    fn square_root(x: f32) -> f32 {
        F32Ext::sqrt(x)
    }
    #[inline]
    fn inverse_root(x: f32) -> f32 {
        x.invsqrt()
    }
    #[inline]
    fn sine_and_cosine(angle: f32) -> (f32, f32) {
        (F32Ext::sin(angle), F32Ext::cos(angle))
    }
}
