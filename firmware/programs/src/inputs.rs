//! Inputs of the measured operations. Except for `collapse_within` and floats in software, their
//! values do not change the counts, because no operation branches on its numbers.

use eigenshade::{Disc, NormalMap, NormalPixels};

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
    use eigenshade::{Light, Material, Normal, Source};

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

    /// Two round and two elongated sources in front of the object.
    #[must_use]
    pub fn sources(along: f32) -> [Source; 4] {
        let new = |[x, y]: [f32; 2], minor: f32| {
            let Ok(normal) = Normal::new(x, y, 1.0) else { board::exit(false) };
            let (direction, energy, major) =
                (normal.components(), [1.0, 0.9, 0.8], [0.0, 0.05, 0.0]);
            match minor {
                0.05 => Source::round(direction, energy, minor),
                _ => Source::new(direction, energy, major, minor),
            }
        };
        [([along, 0.2], 0.05), ([-along, 0.2], 0.05), ([along, -0.2], 0.02), ([-along, -0.2], 0.02)]
            .map(|(place, minor)| new(place, minor).unwrap_or_else(|_| board::exit(false)))
    }
}

/// Inputs in Q15.
pub mod integers {
    use core::hint::black_box;
    use eigenshade::q15::{Light, Material, Normal, Q15};

    /// A fraction of 2^31.
    #[must_use]
    pub fn of(fraction: i32) -> Q15 {
        Q15((fraction >> 16) as i16)
    }

    /// Four visible normals.
    #[must_use]
    pub fn normals() -> [Normal; 4] {
        // 3, 4 and 5 are the sides of a right triangle.
        const FIFTH: i32 = i32::MAX / 5;
        [[0, 0, 5], [3, 0, 4], [0, -4, 3], [-3, 4, 0]].map(|fifths| {
            let [x, y, z] = fifths.map(|count| of(count * black_box(FIFTH)));
            Normal::from_unit(x, y, z).unwrap_or_else(|_| board::exit(false))
        })
    }

    /// Mantissas of both signs, always the same.
    #[must_use]
    pub fn mantissas<const N: usize>() -> [Q15; N] {
        let mut state = black_box(1_u32);
        core::array::from_fn(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            // Half of the largest, so that its bits are those of a light's.
            of(state.cast_signed() >> 1)
        })
    }

    /// A light of these mantissas.
    #[must_use]
    pub fn light(mantissas: &[Q15]) -> Light<'_> {
        Light::new(-15, mantissas).unwrap_or_else(|_| board::exit(false))
    }

    /// A material of these mantissas.
    #[must_use]
    pub fn material(mantissas: &[Q15], order: usize) -> Material<'_> {
        let exponents = EXPONENTS.get(..=order).unwrap_or_default();
        Material::new(exponents, mantissas).unwrap_or_else(|_| board::exit(false))
    }

    /// Exponents of a material of order 7.
    static EXPONENTS: [i8; 8] = [-15; 8];
}
