//! The integer formats with their shipped tables, the shipped table in f64 and as integers, decoded
//! once, and a pixel in integers with room for everything.

use super::Reader;
use eigenshade::index::record::integers::OwnedParts;
use eigenshade::quantized::{Basis, Normal};
use eigenshade::{Error, FixedPoint, Q15, Q31, sphere};
use eigenshade_index::{light, material, mode, pair};
use eigenshade_table::Table;
use eigenshade_table::quantize::{Format, integers};
use std::f64::consts::SQRT_2;
use std::sync::OnceLock;

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

/// The table, its rows of UᵀM, and its integer forms.
pub struct Shipped {
    pub table: Table,
    rows: Vec<Vec<f64>>,
    q15: OwnedParts<i32>,
    q31: OwnedParts<i32>,
}

pub fn shipped() -> &'static Shipped {
    static SHIPPED: OnceLock<Shipped> = OnceLock::new();
    SHIPPED.get_or_init(|| {
        let bytes = include_bytes!("../../tables/sphere.bin");
        let table = eigenshade_table::decode(bytes).expect("a table");
        let parts = |format: Format| {
            integers(&table, format, format.tolerance()).expect("a sphere's table")
        };
        Shipped {
            rows: table.profiles.iter().map(|profile| table.gram_row(profile)).collect(),
            q15: parts(Format::Q15),
            q31: parts(Format::Q31),
            table,
        }
    })
}

impl Shipped {
    pub fn parts<Q: Integer>(&self) -> &OwnedParts<i32> {
        if Q::FORMAT == Format::Q15 { &self.q15 } else { &self.q31 }
    }

    /// d = UᵀMc, mode by mode; coefficients beyond the slices are zero.
    pub fn project(&self, light: &[f64], material: &[f64]) -> Vec<f64> {
        let gram = &self.table.gram;
        let of = |component: &eigenshade_table::Component| {
            let azimuth = component.order.unsigned_abs() as usize;
            let sign = if component.order < 0 && azimuth % 2 == 1 { -1.0 } else { 1.0 };
            let modes = mode::indices(gram.degree, gram.order, azimuth);
            let one = |((l, o, p, q), weight): ((usize, usize, usize, usize), &f64)| {
                let light = light.get(light::position(l, component.order as isize));
                let material = material.get(material::position(o, p, q));
                weight * light.unwrap_or(&0.0) * material.unwrap_or(&0.0)
            };
            sign * modes.zip(&self.rows[component.profile]).map(one).sum::<f64>()
        };
        self.table.components.iter().map(of).collect()
    }

    /// For each component: the most that d can be with coefficients of a light as large
    /// as `brightest`, and of each o of the material as large as `of_order`, all addends
    /// of one sign.
    pub fn scales(&self, brightest: f64, of_order: &[f64]) -> Vec<f64> {
        let gram = &self.table.gram;
        let (degrees, pairs) = (gram.degree + 1, pair::count(gram.order));
        let order = of_order.len().saturating_sub(1);
        let scattered = (0..degrees).map(|l| {
            let polar = |o: usize, q: usize| {
                let integral = gram.polar_integrals[pair::position(o, q) * degrees + l];
                (integral * ((o + 1) as f64).sqrt()).abs()
            };
            let mut sums = vec![0.0f64; pairs];
            for (o, p, q) in material::indices(order) {
                sums[pair::position(p, q)] += of_order[o] * polar(o, q);
                sums[pair::position(o, q)] += of_order[o] * polar(p, q);
            }
            sums.into_iter().fold(0.0, f64::max)
        });
        let scattered: Vec<f64> = scattered.collect();
        let of_profile = |profile: &eigenshade_table::Profile| {
            let rows = profile.factors.chunks_exact(pairs).zip(&scattered[profile.azimuth..]);
            let rows = rows.map(|(row, sum)| row.iter().map(|g| g.abs()).sum::<f64>() * sum);
            (degrees - profile.azimuth) as f64 * rows.fold(0.0, f64::max) * brightest
        };
        let profiles: Vec<f64> = self.table.profiles.iter().map(of_profile).collect();
        self.table.components.iter().map(|component| profiles[component.profile]).collect()
    }

    /// Σ d_i U_i at a normal, and Σ |d_i| Σ |terms of U_i|.
    pub fn reconstruct(&self, d: &[f64], [x, y, z]: [f64; 3]) -> [f64; 2] {
        let (slant, tilt) = (x.hypot(y), y.atan2(x));
        let angle = (2.0 * z - 1.0).clamp(-1.0, 1.0).acos();
        let (mut sum, mut scale) = (0.0, 0.0);
        for (d, component) in d.iter().zip(&self.table.components) {
            let profile = &self.table.profiles[component.profile];
            let order = f64::from(component.order);
            let around = match component.order {
                0 => 1.0,
                1.. => SQRT_2 * (order * tilt).cos(),
                // Φ_-m = √2 sin(-mβ).
                _ => SQRT_2 * (order * tilt).sin(),
            };
            let terms = profile.chebyshev.iter().enumerate();
            let value: f64 = terms.map(|(k, term)| term * (k as f64 * angle).cos()).sum();
            sum += d * value * slant.powi(profile.azimuth as i32) * around;
            let sizes: f64 = profile.chebyshev.iter().map(|term| term.abs()).sum();
            scale += d.abs() * SQRT_2 * sizes;
        }
        [sum, scale]
    }

    /// Σ d_i U_i at the components of a normal as they are, from the mantissas of the
    /// integer form.
    pub fn reconstruct_quantized<Q: Integer>(&self, d: &[f64], [x, y, z]: [f64; 3]) -> f64 {
        let parts = self.parts::<Q>();
        let t = 2.0 * z - 1.0;
        let (mut terms, mut sum) = (parts.terms.as_slice(), 0.0);
        for place in &parts.profiles {
            let azimuth = usize::from(place.azimuth);
            let (of_profile, rest) = terms.split_at(parts.lengths[azimuth].into());
            terms = rest;
            let value = of_profile.iter().fold(0.0, |sum, &term| sum * t + f64::from(term));
            let (slant, angle) = (x.hypot(y).powi(azimuth as i32), azimuth as f64 * y.atan2(x));
            let weight = |index: u16| d.get(usize::from(index)).copied().unwrap_or(0.0);
            let around = weight(place.plus) * angle.cos() - weight(place.minus) * angle.sin();
            sum += 2f64.powi(place.exponent.into()) * value * slant * around;
        }
        sum
    }
}
