//! The regions of an object: parts of one roughness and one share of metal.

#[cfg(feature = "presets")]
use crate::buffer::Buffer;
use crate::error::{Argument, Error};
use crate::gloss::Gloss;
use crate::highlights::Highlights;
use crate::index::object::RECORD;
#[cfg(feature = "presets")]
use crate::material::Material;
use crate::q15::Q15;
#[cfg(feature = "presets")]
use crate::q15::{self, MaterialBuffer};
use crate::source::Source;

/// The material of a part of an [`Object`](crate::object::Object), but for its base colors: glTF's
/// metallic and roughness.
///
/// By the BRDF of [`Material::metallic_roughness`], the irradiance of a pixel is
/// E = base color x T(n) + P(n). The tinted part T has the matte share of white and `metallic` of the
/// reflectance; the plain part P is what a black base color reflects.
///
/// For 0 < metallic < 1 the matte share depends on the base color in each pixel,
/// (1 - metallic)(1 - f0), and a region has the mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Region {
    metallic: Q15,
    roughness: Q15,
    /// The matte share of the tinted part.
    matte: Q15,
}

impl Region {
    /// A region of this metallic and roughness, both from 0 to 1.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if a number is not from 0 to 1.
    pub fn new(metallic: f32, roughness: f32) -> Result<Self, Error> {
        let range = [0.0, 1.0];
        Error::check_range(Argument::Metallic, [metallic], range)?;
        Error::check_range(Argument::Roughness, [roughness], range)?;
        // The reflectance of a base color of one half.
        let f0 = Gloss::DIELECTRIC * (1.0 - metallic) + 0.5 * metallic;
        let matte = (1.0 - metallic) * (1.0 - f0);
        let [metallic, roughness, matte] = [metallic, roughness, matte].map(q15);
        Ok(Self { metallic, roughness, matte })
    }

    /// The region with this matte share of the tinted part, from 0 to 1, which is
    /// (1 - metallic)(1 - f0) of one base color. [`new`](Self::new) takes a base color of one half.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if it is not from 0 to 1.
    pub fn with_matte(self, matte: f32) -> Result<Self, Error> {
        Error::check_range(Argument::Color, [matte], [0.0, 1.0])?;
        Ok(Self { matte: q15(matte), ..self })
    }

    /// A region of a file, if its numbers are not negative.
    pub(crate) const fn of_bytes([a, b, c, d, e, f]: [u8; RECORD]) -> Option<Self> {
        let [metallic, roughness, matte] =
            [i16::from_le_bytes([a, b]), i16::from_le_bytes([c, d]), i16::from_le_bytes([e, f])];
        let is_fit = metallic >= 0 && roughness >= 0 && matte >= 0;
        let region = Self { metallic: Q15(metallic), roughness: Q15(roughness), matte: Q15(matte) };
        if is_fit { Some(region) } else { None }
    }

    /// The bytes of a region in the file of an object.
    #[must_use]
    pub const fn bytes(self) -> [u8; RECORD] {
        let [a, b] = self.metallic.0.to_le_bytes();
        let [c, d] = self.roughness.0.to_le_bytes();
        let [e, f] = self.matte.0.to_le_bytes();
        [a, b, c, d, e, f]
    }

    /// The share of metal, from 0 to 1.
    #[must_use]
    pub fn metallic(&self) -> f32 {
        float(self.metallic)
    }

    /// The perceptual roughness, from 0 to 1.
    #[must_use]
    pub fn roughness(&self) -> f32 {
        float(self.roughness)
    }

    /// The matte share of the tinted part.
    #[must_use]
    pub fn matte(&self) -> f32 {
        float(self.matte)
    }

    #[cfg(feature = "presets")]
    /// The coefficients of the tinted part and of the plain one, to order 7: materials without color,
    /// to be relit in the colors of a light. Cost: some 1,000 multiplications.
    ///
    /// # Errors
    ///
    /// Those of [`Material::metallic_roughness_parts`], none of which occurs.
    pub fn materials(&self) -> Result<[Buffer<f32, 40>; 2], Error> {
        let metallic = self.metallic();
        let [mut tinted, mut plain, metal] = Material::metallic_roughness_parts(self.roughness())?;
        let of_plain = Gloss::DIELECTRIC * (1.0 - metallic);
        for ((tinted, plain), metal) in tinted.iter_mut().zip(plain.iter_mut()).zip(&*metal) {
            *tinted = self.matte() * *tinted + metallic * metal;
            *plain += of_plain * metal;
        }
        Ok([tinted, plain])
    }

    #[cfg(feature = "presets")]
    /// [`materials`](Self::materials) in integers.
    ///
    /// # Errors
    ///
    /// Those of [`q15::Material::metallic_roughness`], none of which occurs.
    pub fn materials_q15(&self) -> Result<[MaterialBuffer<40, 8>; 2], Error> {
        const OF_DIELECTRIC: i32 = (Gloss::DIELECTRIC * 32_768.0 + 0.5) as i32;
        let plain = (OF_DIELECTRIC * (32_767 - i32::from(self.metallic.0))) >> 15;
        let shares =
            [[self.matte, Q15(0), self.metallic], [Q15(0), Q15(i16::MAX), Q15(plain as i16)]];
        q15::Material::metallic_roughness_sums(self.roughness, shares)
    }

    /// The highlights of sources in the tinted part and in the plain one.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if there are more than `N` sources.
    pub fn highlights<const N: usize>(
        &self,
        sources: &[Source],
    ) -> Result<[Highlights<N>; 2], Error> {
        let (metallic, roughness) = (self.metallic(), self.roughness());
        let f0 = Gloss::DIELECTRIC * (1.0 - metallic);
        let plain = Gloss::new(roughness, [f0; 3], [0.0; 3])?;
        // Of a white base color.
        let f0 = f0 + metallic;
        let albedo = if f0 < 1.0 { (self.matte() / (1.0 - f0)).min(1.0) } else { 0.0 };
        let white = Gloss::new(roughness, [f0.min(1.0); 3], [albedo; 3])?;
        let [white, plain] = [Highlights::new(&white, sources)?, Highlights::new(&plain, sources)?];
        Ok([white.less(&plain), plain])
    }
}

fn q15(number: f32) -> Q15 {
    Q15((number * f32::from(i16::MAX) + 0.5) as i16)
}

/// The largest number is 1.
fn float(number: Q15) -> f32 {
    f32::from(number.0) / f32::from(i16::MAX)
}
