//! Inputs of the measured operations. Except for `collapse_within` and floats in software, their
//! values do not change the counts, because no operation branches on its numbers.

use eigenshade::object::{Disc, NormalMap, NormalPixels};

/// A disc of 64 x 64 pixels from its middle rows on, where hardly any pixel is outside.
#[must_use]
pub fn middle() -> Disc {
    let Ok(mut disc) = Disc::new(core::hint::black_box(64)) else { board::exit(false) };
    // The pixels above.
    let _ = disc.nth(1000);
    disc
}

/// The codes of a map of 64 x 17 normals, all inside the rim.
#[must_use]
pub fn codes() -> [[u8; 2]; 1088] {
    let step = core::hint::black_box(7);
    core::array::from_fn(|k| [(k & 63) as u8, step * (k & 7) as u8])
}

/// The pixels of that map.
#[must_use]
pub fn pixels(codes: &[[u8; 2]; 1088]) -> NormalPixels<'_> {
    match NormalMap::new(64, 17, codes.as_flattened()) {
        Ok(map) => map.pixels(),
        Err(_) => board::exit(false),
    }
}

/// Inputs in f32.
pub mod floats {
    use core::hint::black_box;
    pub use eigenshade::Material;
    pub use eigenshade::Normal;
    pub use eigenshade::Rotation;
    pub use eigenshade::object::{BakedMap, MapPoint};
    use eigenshade::object::{ObjectCoefficients, Region, ShadowedObject};
    pub use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
    use eigenshade::screen::Exposure;
    pub use eigenshade::sphere::color;
    use eigenshade::{Buffer, Error, Light, Rgb, Source, sphere};

    /// The coefficients of a material in color, of order 7.
    pub type OfOrder7 = Rgb<Buffer<f32, 40>>;
    /// The same of order 12.
    pub type OfOrder12 = Rgb<Buffer<f32, 140>>;

    /// The base color of copper.
    pub const COPPER: [f32; 3] = [0.93, 0.52, 0.38];
    /// The metallic share of a metal.
    pub const ONE: f32 = 1.0;
    /// Roughnesses between and at points of a table.
    pub const ROUGHNESSES: [f32; 2] = [0.3, 0.7];

    /// 16 visible normals.
    #[must_use]
    pub fn normals() -> [Normal; 16] {
        let step = black_box(0.4);
        let along = |k: usize| {
            let (x, y) = ((k % 4) as f32 * step - 0.6, (k / 4) as f32 * step - 0.6);
            Normal::new(x, y, 0.7).ok()
        };
        let facing = Normal::new(0.0, 0.0, 1.0).ok();
        // All have a positive length and face the camera.
        core::array::from_fn(|k| along(k).or(facing)).map(|normal| match normal {
            Some(normal) => normal,
            None => board::exit(false),
        })
    }

    /// Numbers of both signs between -1 and 1, always the same.
    #[must_use]
    pub fn numbers<const N: usize>() -> [f32; N] {
        // Keeps the compiler from computing the numbers and storing them in flash.
        let mut state = black_box(1_u32);
        core::array::from_fn(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f32::from((state >> 16) as u16 as i16) / 32768.0
        })
    }

    /// A number as an irradiance.
    #[inline]
    #[must_use]
    pub fn irradiance(number: f32) -> f32 {
        number
    }

    /// An exposure.
    #[inline]
    #[must_use]
    pub fn exposure() -> Exposure {
        Exposure::new(black_box(1.5)).unwrap_or_else(|_| board::exit(false))
    }

    /// The coefficients of an object with shadows.
    pub fn coefficients(
        object: &ShadowedObject<'_>,
        light: Rgb<Light<'_>>,
    ) -> Result<Rgb<ObjectCoefficients>, Error> {
        object.coefficients(light)
    }

    /// The transfers of both parts of a region.
    pub fn parts(region: &Region) -> Result<[sphere::Transfer; 2], Error> {
        let [tinted, plain] = region.materials()?;
        Ok([
            sphere::transfer(&Material::new(&tinted)?)?,
            sphere::transfer(&Material::new(&plain)?)?,
        ])
    }

    /// A baked map of 32 x 32 texels.
    #[inline]
    pub fn baked_map() -> Result<BakedMap<[f32; 1024]>, Error> {
        BakedMap::new(32, numbers())
    }

    /// A rotation about none of the axes.
    #[inline]
    #[must_use]
    pub fn rotation() -> Rotation {
        let rotation = Rotation::from_quaternion(black_box([0.1, 0.2, 0.3, 1.0]));
        rotation.unwrap_or_else(|_| board::exit(false))
    }

    /// A light of these coefficients.
    #[must_use]
    pub fn light(coefficients: &[f32]) -> Light<'_> {
        Light::from_finite(coefficients).unwrap_or_else(|_| board::exit(false))
    }

    /// A material of these coefficients.
    #[must_use]
    pub fn material(coefficients: &[f32]) -> Material<'_> {
        Material::from_finite(coefficients).unwrap_or_else(|_| board::exit(false))
    }

    /// Four sources in front of the object.
    #[must_use]
    pub fn sources(along: f32) -> [Source; 4] {
        [[along, 0.2], [-along, 0.2], [along, -0.2], [-along, -0.2]].map(|[x, y]| {
            let Ok(normal) = Normal::new(x, y, 1.0) else { board::exit(false) };
            let source = Source::new(normal.components(), [1.0, 0.9, 0.8], 0.05);
            source.unwrap_or_else(|_| board::exit(false))
        })
    }
}

/// Inputs in Q15.
pub mod integers {
    use core::hint::black_box;
    use eigenshade::object::{ObjectCoefficients, Region, ShadowedObject};
    pub use eigenshade::presets::{light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT};
    pub use eigenshade::q15::Normal;
    pub use eigenshade::q15::Rotation;
    pub use eigenshade::q15::{BakedMap, MapPoint, Material};
    use eigenshade::q15::{Exposure, Light, MaterialBuffer, Q15};
    use eigenshade::sphere::q15 as sphere;
    pub use eigenshade::sphere::q15::color;
    use eigenshade::{Error, Rgb};

    /// The coefficients of a material in color, of order 7.
    pub type OfOrder7 = Rgb<MaterialBuffer<40, 8>>;
    /// The same of order 12.
    pub type OfOrder12 = Rgb<MaterialBuffer<140, 13>>;

    /// The base color of copper.
    pub const COPPER: [Q15; 3] = [Q15(30_474), Q15(17_039), Q15(12_452)];
    /// The metallic share of a metal.
    pub const ONE: Q15 = Q15(i16::MAX);
    /// Roughnesses 0.3 and 0.7.
    pub const ROUGHNESSES: [Q15; 2] = [Q15(9_830), Q15(22_938)];

    /// Four visible normals.
    #[must_use]
    pub fn normals() -> [Normal; 4] {
        // 3, 4 and 5 are the sides of a right triangle.
        const FIFTH: i32 = i32::MAX / 5;
        [[0, 0, 5], [3, 0, 4], [0, -4, 3], [-3, 4, 0]].map(|fifths| {
            let [x, y, z] = fifths.map(|count| Q15(((count * black_box(FIFTH)) >> 16) as i16));
            Normal::from_unit(x, y, z).unwrap_or_else(|_| board::exit(false))
        })
    }

    /// Mantissas of both signs, always the same.
    #[must_use]
    pub fn numbers<const N: usize>() -> [Q15; N] {
        let mut state = black_box(1_u32);
        core::array::from_fn(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            // Half of the largest, so that its bits are those of a light's.
            Q15((state.cast_signed() >> 17) as i16)
        })
    }

    /// A number as an irradiance.
    #[inline]
    #[must_use]
    pub fn irradiance(number: Q15) -> i32 {
        number.0.into()
    }

    /// An exposure.
    #[inline]
    #[must_use]
    pub fn exposure() -> Rgb<Exposure> {
        let exposure = Exposure::new(black_box(1.5), -15);
        Rgb::gray(exposure.unwrap_or_else(|_| board::exit(false)))
    }

    /// The coefficients of an object with shadows.
    pub fn coefficients(
        object: &ShadowedObject<'_>,
        light: Rgb<Light<'_>>,
    ) -> Result<Rgb<ObjectCoefficients>, Error> {
        object.coefficients_q15(light)
    }

    /// The transfers of both parts of a region.
    pub fn parts(region: &Region) -> Result<[sphere::Transfer; 2], Error> {
        let [tinted, plain] = region.materials_q15()?;
        Ok([sphere::transfer(&tinted.material()?)?, sphere::transfer(&plain.material()?)?])
    }

    /// A baked map of 32 x 32 texels.
    #[inline]
    pub fn baked_map() -> Result<BakedMap<[i16; 1024]>, Error> {
        BakedMap::new(32, 0, numbers().map(|texel| texel.0))
    }

    /// A rotation about none of the axes.
    #[inline]
    #[must_use]
    pub fn rotation() -> Rotation {
        let rotation = Rotation::from_quaternion(black_box([1, 2, 3, 10]));
        rotation.unwrap_or_else(|_| board::exit(false))
    }

    /// A light of these mantissas.
    #[must_use]
    pub fn light(mantissas: &[Q15]) -> Light<'_> {
        Light::new(-15, mantissas).unwrap_or_else(|_| board::exit(false))
    }

    /// A material of order 7 of these mantissas.
    #[must_use]
    pub fn material(mantissas: &[Q15]) -> Material<'_> {
        Material::new(&[-15; 8], mantissas).unwrap_or_else(|_| board::exit(false))
    }
}
