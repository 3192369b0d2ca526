//! Turns light: by any rotation, and about the view axis alone.

mod about_view;
pub(crate) mod exchange;
mod floats;
pub(crate) mod swing_twist;
pub(crate) mod twist;

use crate::buffer::{Buffer, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::light::Light;
use crate::rotation::Rotation;
use floats::Floats;
use swing_twist::Scales;

impl Light<'_> {
    /// The coefficients of this light after rotation: L'(Rω) = L(ω).
    ///
    /// `N` must be at least (degree + 1)², and the degree at most 16.
    /// [`truncated`](Self::truncated) omits higher degrees, which no rotation mixes with the
    /// others.
    ///
    /// The energy of each degree is preserved. A light of degree 9 that is rotated and rotated back
    /// matches the original within 1e-6 of its largest coefficient. Cost: for degree 9 some 1,500
    /// products, and one root; see `docs/costs.md`. Turning is set-up work, not work for each
    /// pixel.
    ///
    /// ```
    /// use eigenshade::{Light, Rotation};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?; // brightest at the camera
    /// let quarter = core::f32::consts::FRAC_PI_2;
    /// let rotation = Rotation::from_euler(0.0, quarter, 0.0)?;
    /// let turned = light.turned::<4>(&rotation)?; // now from the right
    /// assert!(turned[2].abs() < 1e-6 && (turned[3].abs() - 1.0).abs() < 1e-6);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small, [`Error::Beyond`] if the degree is above 16.
    pub fn turned<const N: usize>(&self, rotation: &Rotation) -> Result<Buffer<f32, N>, Error> {
        turned([*self], rotation).map(|[turned]| turned)
    }
}

impl Rgb<Light<'_>> {
    /// [`Light::turned`] in each channel, at less than three times its cost.
    ///
    /// # Errors
    ///
    /// As [`Light::turned`].
    pub fn turned<const N: usize>(
        &self,
        rotation: &Rotation,
    ) -> Result<Rgb<Buffer<f32, N>>, Error> {
        turned((*self).into(), rotation).map(Rgb::from)
    }
}

fn turned<const C: usize, const N: usize>(
    lights: [Light<'_>; C],
    rotation: &Rotation,
) -> Result<[Buffer<f32, N>; C], Error> {
    let mut turned = [(); C].map(|()| Buffer::default());
    for (to, light) in turned.iter_mut().zip(&lights) {
        Error::check_turned(light.degree())?;
        *to = zeros(Argument::Light, light.coefficients().len())?;
    }
    let degree = lights.iter().map(Light::degree).max().unwrap_or_default();
    rotation.swing_twist(degree).turn::<Floats, C>(
        degree,
        lights.map(|light| light.coefficients()),
        turned.each_mut().map(Buffer::as_mut_slice),
        &mut [Scales::default(); C],
    );
    Ok(turned)
}
