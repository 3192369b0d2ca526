//! The shipped lights, materials, sources, gloss and tone curves as constants of C. A program links
//! those that it names.
#![expect(unsafe_code, reason = "exported symbols")]

use crate::boundary::Input;
use crate::color::{Channels, Gloss, Source};
use crate::{float, integers};
use eigenshade::presets::{gloss, light, material, sources};
use eigenshade::{Display, Rgb, Tone, q15, sphere};

/// A constant that C reads.
#[repr(transparent)]
struct Constant<T>(T);

// SAFETY: neither it nor what it points to is ever written.
unsafe impl<T> Sync for Constant<T> {}

macro_rules! channels {
    ($from:expr, $of:path) => {
        Constant(Channels([$of(&$from.r), $of(&$from.g), $of(&$from.b)]))
    };
}

const fn light_f32(light: &eigenshade::Light<'static>) -> float::Light {
    let coefficients = light.coefficients();
    let (degree, length) = (light.degree(), coefficients.len());
    float::Light { degree, length, coefficients: Input::to(coefficients) }
}

const fn material_f32(material: &eigenshade::Material<'static>) -> float::Material {
    let coefficients = material.coefficients();
    let (order, length) = (material.order(), coefficients.len());
    float::Material { order, length, coefficients: Input::to(coefficients) }
}

const fn light_q15(light: &q15::Light<'static>) -> integers::Light {
    let (mantissas, exponent) = (light.mantissas(), light.exponent());
    assert!(mantissas.len() == sphere::LIGHT, "presets have the degree of the shipped table");
    let mantissas = Input::to(mantissas);
    integers::Light { degree: sphere::DEGREE, length: sphere::LIGHT, mantissas, exponent }
}

const fn material_q15(material: &q15::Material<'static>) -> integers::Material {
    let (mantissas, exponents) = (material.mantissas(), material.exponents());
    assert!(exponents.len() == sphere::ORDER + 1, "presets have the order of the shipped table");
    integers::Material {
        order: sphere::ORDER,
        length: mantissas.len(),
        mantissas: Input::to(mantissas),
        exponents_length: exponents.len(),
        exponents: Input::to(exponents),
    }
}

macro_rules! lights {
    ($($constant:ident $name:literal)*) => {
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_light_", $name, "_f32"))]
            static $constant: Constant<Channels<float::Light>> =
                channels!(light::$constant, light_f32);
        )*};
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_light_", $name, "_q15"))]
            static $constant: Constant<Channels<integers::Light>> =
                channels!(light::q15::$constant, light_q15);
        )*};
    };
}
eigenshade::each_preset_light!(lights);

macro_rules! materials {
    ($($constant:ident $name:literal)*) => {
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_material_", $name, "_f32"))]
            static $constant: Constant<Channels<float::Material>> =
                channels!(material::$constant, material_f32);
        )*};
        const _: () = {$(
            #[unsafe(export_name = concat!("eigenshade_material_", $name, "_q15"))]
            static $constant: Constant<Channels<integers::Material>> =
                channels!(material::q15::$constant, material_q15);
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

macro_rules! displays {
    ($($constant:ident $tone:ident $name:literal)*) => {
        $(
            #[unsafe(export_name = concat!("eigenshade_display_", $name))]
            static $constant: Display = Display::new(Tone::$tone);
        )*
        /// The names of the tone curves.
        #[cfg(test)]
        pub(crate) const DISPLAYS: &[&str] = &[$($name),*];
    };
}
displays! {
    LINEAR Linear "linear"
    REINHARD Reinhard "reinhard"
    FILMIC Filmic "filmic"
}
