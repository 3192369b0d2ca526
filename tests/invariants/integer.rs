//! The integer formats with their shipped tables, and a pixel in integers with room for everything.

use super::Reader;
use eigenshade::quantized::{Basis, Normal};
use eigenshade::{Error, FixedPoint, Q15, Q31, sphere};
use eigenshade_table::quantize::Format;

/// An integer format and its shipped table.
pub trait Integer: FixedPoint {
    const FORMAT: Format;
    /// The mantissa of these bits.
    fn read(input: &mut Reader<'_>) -> Self;
    /// The nearest mantissa.
    fn nearest(number: f64) -> Self;
    fn mantissa(self) -> i128;
    fn normal(components: [Self; 3]) -> Result<Normal<Self>, Error>;
    fn basis() -> &'static Basis<'static, Self>;
    /// The image of these coefficients, by the general way and by the kernel.
    fn image(d: &[i32], exponent: i32, normals: &[Normal<Self>]) -> Result<Image, Error>;
}

/// A scene and its pixels.
pub struct Image {
    pub terms: Vec<i32>,
    pub exponent: i32,
    /// By the general way and by the kernel.
    pub pixels: Vec<[i32; 2]>,
}

macro_rules! integer {
    ($format:ident, $module:ident, $inner:ident, $bytes:literal) => {
        impl Integer for $format {
            const FORMAT: Format = Format::$format;
            fn read(input: &mut Reader<'_>) -> Self {
                Self($inner::from_le_bytes(input.bytes()))
            }
            fn nearest(number: f64) -> Self {
                Self(number.round().clamp($inner::MIN.into(), $inner::MAX.into()) as $inner)
            }
            fn mantissa(self) -> i128 {
                self.0.into()
            }
            fn normal([x, y, z]: [Self; 3]) -> Result<Normal<Self>, Error> {
                Normal::<Self>::new(x, y, z)
            }
            fn basis() -> &'static Basis<'static, Self> {
                &sphere::$module::BASIS
            }
            fn image(d: &[i32], exponent: i32, normals: &[Normal<Self>]) -> Result<Image, Error> {
                let basis = &sphere::$module::BASIS;
                let scene = basis.collapse::<{ sphere::$module::SCENE }>(d, exponent)?;
                let both = |&normal| [scene.shade(normal), sphere::$module::shade(&scene, normal)];
                Ok(Image {
                    terms: scene.terms().to_vec(),
                    exponent: scene.exponent(),
                    pixels: normals.iter().map(both).collect(),
                })
            }
        }
    };
}
integer!(Q15, q15, i16, 2);
integer!(Q31, q31, i32, 4);

/// Any accepted normals: as they come, and unit vectors of any direction, as short or as
/// long as is accepted; the corners always.
pub fn normals<Q: Integer>(input: &mut Reader<'_>) -> Vec<Normal<Q>> {
    let one = 2f64.powi(Q::FORMAT.bits());
    let mut found = Vec::new();
    let mut take = |components: [f64; 3]| {
        found.extend(Q::normal(components.map(|component| Q::nearest(one * component))));
    };
    // 1.0005² is just too long, 0.9995² too short.
    for size in [0.999_51, 1.0, 1.000_49] {
        for z in [0.0, 1.0 / one, 0.001, 0.5, 0.999, 0.999_96, 1.0] {
            for turn in 0..8 {
                let (sine, cosine) = (std::f64::consts::FRAC_PI_4 * f64::from(turn)).sin_cos();
                let slant = (1.0 - z * z).sqrt();
                take([slant * cosine, slant * sine, z].map(|component| size * component));
            }
        }
    }
    while !input.is_empty() {
        let raw = [Q::read(input), Q::read(input), Q::read(input)];
        let [x, y, z] = raw.map(|component| component.mantissa() as f64);
        let length = (x * x + y * y + z * z).sqrt();
        let size = 1.0 + 0.000_499 * f64::from(input.byte().cast_signed()) / 128.0;
        if length > 0.0 {
            found_unit(
                &mut found,
                [x, y, z.abs()].map(|component| one * size * component / length),
            );
        }
        found.extend(Q::normal(raw));
    }
    found
}

fn found_unit<Q: Integer>(found: &mut Vec<Normal<Q>>, components: [f64; 3]) {
    found.extend(Q::normal(components.map(Q::nearest)));
}

/// What `terms` give at a normal: every product and sum exact, rounded where the format
/// rounds.
///
/// # Panics
///
/// If a step or the irradiance leaves the format's bits.
pub fn exact<Q: Integer>(lengths: &[u8], terms: &[i32], normal: Normal<Q>) -> i128 {
    let bits = Q::BITS;
    let [x, y, z] = normal.components().map(Q::mantissa);
    let t = z - (1 << (bits - 1));
    let bounded = |value: i128| {
        assert!(value.abs() < 1 << Q::TERM_BITS, "a step of {value}");
        value
    };
    let mut terms = terms.iter().map(|&term| i128::from(term));
    let mut value = |length: usize| {
        let mut step = 0;
        for term in terms.by_ref().take(length) {
            step = bounded(((step * t) >> (bits - 1)) + term);
        }
        step
    };
    let mut lengths = lengths.iter().map(|&length| usize::from(length));
    let first = lengths.next().unwrap_or(0);
    let before_last = value(first.saturating_sub(1));
    let last = value(first.min(1));
    let mut sum = before_last * t + (last << (bits - 1));
    bounded(sum >> (bits - 1));
    let (mut cosine, mut sine) = ((x + 1) >> 1, (y + 1) >> 1);
    for length in lengths {
        for fraction in [cosine, sine] {
            let product = value(length) * fraction;
            assert!(product.abs() < 1 << (2 * bits + 1), "a product of {product}");
            sum += product;
        }
        let rounded = |number: i128| (number + (1 << (bits - 1))) >> bits;
        (cosine, sine) = (rounded(cosine * x - sine * y), rounded(cosine * y + sine * x));
    }
    bounded(((sum >> (bits - 2)) + 1) >> 1)
}
