//! The shipped lights, materials, sources, gloss and tone curves as constants of C. A program links
//! those that it names.
#![expect(unsafe_code, reason = "exported symbols")]

use crate::draw::Display;
use crate::records_f32::{ColorLightF32, ColorMaterialF32, LightF32, MaterialF32};
use crate::records_q15::{ColorLightQ15, ColorMaterialQ15, LightQ15, MaterialQ15};
use crate::sources::{Gloss, Source};
use eigenshade::presets::{gloss, light, material, sources};
use eigenshade::screen::Tone;
use eigenshade::{Rgb, q15, sphere};

/// A constant that C reads.
#[repr(transparent)]
struct Constant<T>(T);

// SAFETY: neither it nor what it points to is ever written.
unsafe impl<T> Sync for Constant<T> {}

macro_rules! channels {
    ($color:ident, $from:expr, $of:path) => {
        Constant($color { r: $of(&$from.r), g: $of(&$from.g), b: $of(&$from.b) })
    };
}

const fn light_f32(light: &eigenshade::Light<'static>) -> LightF32 {
    let coefficients = light.coefficients();
    let (degree, length) = (light.degree(), coefficients.len());
    LightF32 { degree, length, coefficients: coefficients.as_ptr() }
}

const fn material_f32(material: &eigenshade::Material<'static>) -> MaterialF32 {
    let coefficients = material.coefficients();
    let (order, length) = (material.order(), coefficients.len());
    MaterialF32 { order, length, coefficients: coefficients.as_ptr() }
}

const fn light_q15(light: &q15::Light<'static>) -> LightQ15 {
    let (mantissas, exponent) = (light.mantissas(), light.exponent());
    assert!(mantissas.len() == sphere::LIGHT, "presets have the degree of the shipped table");
    let mantissas = mantissas.as_ptr();
    LightQ15 { degree: sphere::DEGREE, length: sphere::LIGHT, mantissas, exponent }
}

const fn material_q15(material: &q15::Material<'static>) -> MaterialQ15 {
    let (mantissas, exponents) = (material.mantissas(), material.exponents());
    assert!(exponents.len() == sphere::ORDER + 1, "presets have the order of the shipped table");
    MaterialQ15 {
        order: sphere::ORDER,
        length: mantissas.len(),
        mantissas: mantissas.as_ptr(),
        exponents_length: exponents.len(),
        exponents: exponents.as_ptr(),
    }
}

macro_rules! lights {
    ($($constant:ident $name:literal)*) => {
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_light_", $name, "_f32"))]
            static $constant: Constant<ColorLightF32> =
                channels!(ColorLightF32, light::$constant, light_f32);
        )*};
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_light_", $name, "_q15"))]
            static $constant: Constant<ColorLightQ15> =
                channels!(ColorLightQ15, light::q15::$constant, light_q15);
        )*};
    };
}
eigenshade::each_preset_light!(lights);

macro_rules! materials {
    ($($constant:ident $name:literal)*) => {
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_material_", $name, "_f32"))]
            static $constant: Constant<ColorMaterialF32> =
                channels!(ColorMaterialF32, material::$constant, material_f32);
        )*};
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_material_", $name, "_q15"))]
            static $constant: Constant<ColorMaterialQ15> =
                channels!(ColorMaterialQ15, material::q15::$constant, material_q15);
        )*};
    };
}
eigenshade::each_preset_material!(materials);

const fn sources_f32<const N: usize>(from: [eigenshade::Source; N]) -> [Source; N] {
    const NONE: Source = Source { direction: [0.0; 3], energy: [0.0; 3], spread: 0.0 };
    let (mut to, mut k) = ([NONE; N], 0);
    while k < N {
        let Rgb { r, g, b } = from[k].energy();
        let (direction, spread) = (from[k].direction(), from[k].spread());
        to[k] = Source { direction, energy: [r, g, b], spread };
        k += 1;
    }
    to
}

const fn gloss_f32(gloss: &eigenshade::Gloss) -> Gloss {
    const fn numbers(Rgb { r, g, b }: Rgb<f32>) -> [f32; 3] {
        [r, g, b]
    }
    // The root of alpha, by Newton's method.
    let alpha = gloss.alpha() as f64;
    let mut root = 1.0;
    let mut k = 0;
    while k < 16 {
        root = 0.5 * (root + alpha / root);
        k += 1;
    }
    let [reflectance, grazing] = [numbers(gloss.reflectance()), numbers(gloss.grazing())];
    Gloss { roughness: root as f32, reflectance, grazing, albedo: numbers(gloss.albedo()) }
}

macro_rules! sources {
    ($($constant:ident $name:literal)*) => {
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_sources_", $name, "_f32"))]
            static $constant: Constant<[Source; sources::$constant.len()]> =
                Constant(sources_f32(sources::$constant));
        )*};
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_source_errors_", $name, "_f32"))]
            static $constant: Constant<[[f32; 6]; sources::errors::$constant.len()]> =
                Constant(sources::errors::$constant);
        )*};
    };
}
eigenshade::each_preset_sources!(sources);

macro_rules! glosses {
    ($($constant:ident $name:literal)*) => {
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_gloss_", $name, "_f32"))]
            static $constant: Constant<Gloss> = Constant(gloss_f32(&gloss::$constant));
        )*};
    };
}
eigenshade::each_preset_gloss!(glosses);

macro_rules! display {
    ($tone:ident) => {
        Display(eigenshade::screen::Display::new(Tone::$tone))
    };
}

/// Clips at white.
#[unsafe(no_mangle)]
pub static eigenshade_display_linear: Display = display!(Linear);

/// Reinhard's curve: reaches white at 16.
#[unsafe(no_mangle)]
pub static eigenshade_display_reinhard: Display = display!(Reinhard);

/// A fit to the curve of ACES.
#[unsafe(no_mangle)]
pub static eigenshade_display_filmic: Display = display!(Filmic);
