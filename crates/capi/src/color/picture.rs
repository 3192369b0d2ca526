//! What pixels are shaded from: a scene, one with highlights, or a baked picture.

use super::format::{Channels, Format};
use crate::boundary::Place;
use crate::status::Status;

/// The irradiance of a normal in each channel.
pub(crate) trait Shade<F: Format>:
    Fn(F::Normal) -> Result<[F::Irradiance; 3], Status>
{
}
impl<F: Format, S: Fn(F::Normal) -> Result<[F::Irradiance; 3], Status>> Shade<F> for S {}

/// A picture that was checked.
pub(crate) struct Opened<S> {
    pub(crate) shade: S,
    /// The exponents of the channels, 0 in `f32`.
    pub(crate) exponents: [i32; 3],
    pub(crate) places: [Place; 4],
}

/// A scene, one with highlights, or a baked picture.
pub(crate) trait Picture<F: Format> {
    /// Checks it.
    fn open(&self) -> Result<Opened<impl Shade<F>>, Status>;
}

impl<F: Format> Picture<F> for Channels<F::Scene> {
    fn open(&self) -> Result<Opened<impl Shade<F>>, Status> {
        let scenes = &self.0;
        scenes.iter().try_for_each(F::check)?;
        let shade = |normal| {
            let [r, g, b] = scenes;
            Ok([F::shade(r, normal)?, F::shade(g, normal)?, F::shade(b, normal)?])
        };
        let exponents = scenes.each_ref().map(F::exponent);
        Ok(Opened { shade, exponents, places: [Place::of(self); 4] })
    }
}
