//! Roots and angles by the crate `micromath`.

use super::functions::Mathematics;
use micromath::F32Ext;

/// Roots and angles by the crate `micromath`: a handful of instructions each, and as
/// exact as that.
///
/// Roots are off by up to 6.1 %, their reciprocals by 3.5 %: a normal that it scales is so
/// much too long or too short. Sines and cosines are off by up to 1.1e-3 within 10 rad.
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
