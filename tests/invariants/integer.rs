//! The shipped table in f64 and as integers, decoded once, and a pixel in integers with room for everything.

use super::Reader;
use eigenshade::q15::{Light, Material, Normal, Transfer};
use eigenshade::sphere::q15;
use eigenshade::{Error, Q15};
use eigenshade_table::quantize::{TOLERANCE, integers};
use eigenshade_table::record::integers::OwnedParts;
use eigenshade_table::{Component, Table, light, material, mode, pair};
use std::f64::consts::SQRT_2;
use std::sync::OnceLock;

/// What tests read of mantissas, and what they make them of.
pub trait Mantissa {
    fn mantissa(self) -> i128;
    fn to_f64(self) -> f64;
    /// The nearest mantissa of a number in units of the last place.
    fn nearest(number: f64) -> Self;
    /// The nearest number.
    fn rounded(number: f64) -> Self;
    /// The mantissa of these bits.
    fn read(input: &mut Reader<'_>) -> Self;
}

impl Mantissa for Q15 {
    fn mantissa(self) -> i128 {
        self.0.into()
    }

    fn to_f64(self) -> f64 {
        f64::from(self.0) / 32_768.0
    }

    fn nearest(number: f64) -> Self {
        Self(number.round().clamp(-32_768.0, 32_767.0) as i16)
    }

    fn rounded(number: f64) -> Self {
        Self::nearest(number * 32_768.0)
    }

    fn read(input: &mut Reader<'_>) -> Self {
        Self(i16::from_le_bytes(input.bytes()))
    }
}

/// The normal of these components.
pub fn normal([x, y, z]: [Q15; 3]) -> Result<Normal, Error> {
    Normal::from_unit(x, y, z)
}

/// d and the pixels by the functions generated for the table, each of which must give what the
/// general one gives.
pub fn specialized(
    light: &Light<'_>,
    material: &Material<'_>,
    normals: &[Normal],
) -> Result<[(Vec<i32>, i32); 2], Error> {
    use q15::{BASIS, COMPONENTS, PROFILES, SCENE, TRANSFER, WORKSPACE};
    let transfer = q15::transfer(material)?;
    assert_eq!(transfer, BASIS.transfer::<WORKSPACE, TRANSFER, PROFILES>(material)?);
    let d = q15::relight(&transfer.view(), light)?;
    assert_eq!(d, BASIS.relight::<COMPONENTS>(&transfer.view(), light)?);
    let scene = q15::collapse(&d);
    assert_eq!(*scene, BASIS.collapse_into(d.mantissas(), d.exponent(), [0; SCENE])?);
    let pixels = normals.iter().map(|&normal| scene.shade(normal)).collect();
    assert_eq!(pixels, normals.iter().map(|&n| (*scene).shade(n)).collect::<Vec<_>>());
    Ok([(d.mantissas().to_vec(), d.exponent()), (pixels, scene.exponent())])
}

/// The transfer of a material and d under a light, with their exponents, by the general way.
pub struct Relit {
    pub numbers: Vec<Q15>,
    pub exponents: Vec<i16>,
    pub d: Vec<i32>,
    pub exponent: i32,
}

impl Relit {
    pub fn new(light: &Light<'_>, material: &Material<'_>) -> Self {
        let basis = &q15::BASIS;
        let mut workspace = vec![0; basis.workspace_len()];
        let mut numbers = vec![Q15(0); basis.transfer_len()];
        let mut exponents = vec![0; basis.profiles()];
        let made = basis.transfer_into(material, &mut workspace, &mut numbers, &mut exponents);
        made.expect("it fits");
        let mut d = vec![0; basis.components()];
        let transfer = Transfer::new(&numbers, &exponents);
        let exponent = basis.relight_into(&transfer, light, &mut d).expect("it fits");
        Self { numbers, exponents, d, exponent }
    }
}

/// Any accepted normals: as they come, and unit vectors of any direction, as short or as
/// long as is accepted; the corners always.
pub fn normals(input: &mut Reader<'_>) -> Vec<Normal> {
    let one = 2f64.powi(15);
    let mut found = Vec::new();
    let mut take = |components: [f64; 3]| found.extend(normal(components.map(Q15::rounded)));
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
        let raw = [Q15::read(input), Q15::read(input), Q15::read(input)];
        let [x, y, z] = raw.map(|component| component.mantissa() as f64);
        let length = (x * x + y * y + z * z).sqrt();
        let size = 1.0 + 0.000_499 * f64::from(input.byte().cast_signed()) / 128.0;
        if length > 0.0 {
            let unit = [x, y, z.abs()].map(|component| one * size * component / length);
            found.extend(normal(unit.map(Q15::nearest)));
        }
        found.extend(normal(raw));
    }
    found
}

/// What `terms` give at a normal: every product and sum exact, rounded where the format
/// rounds.
///
/// # Panics
///
/// If a step or the irradiance leaves the format's bits.
pub fn exact(lengths: &[u8], terms: &[i32], normal: Normal) -> i128 {
    let bits = 15;
    let [x, y, z] = normal.components().map(Q15::mantissa);
    let t = z - (1 << (bits - 1));
    let bounded = |value: i128| {
        assert!(value.abs() < 1 << 17, "a step of {value}");
        value
    };
    let mut terms = terms.iter().map(|&term| i128::from(term));
    let mut value = |length: usize| {
        let step = |step: i128, term| bounded(((step * t) >> (bits - 1)) + term);
        terms.by_ref().take(length).fold(0, step)
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

/// A component's image at a normal: its Chebyshev series by cosines.
pub fn eigenimage(table: &Table, component: &Component, [x, y, z]: [f64; 3]) -> f64 {
    let (angle, turn) = ((2.0 * z - 1.0).clamp(-1.0, 1.0).acos(), y.atan2(x));
    let terms = table.profiles[component.profile].chebyshev.iter().enumerate();
    let profile: f64 = terms.map(|(k, term)| term * (k as f64 * angle).cos()).sum();
    let order = f64::from(component.order);
    let around = match component.order {
        0 => 1.0,
        1.. => SQRT_2 * (order * turn).cos(),
        // Φ_-m = √2 sin(-mβ).
        _ => SQRT_2 * (order * turn).sin(),
    };
    profile * x.hypot(y).powi(component.order.abs()) * around
}

/// The table, its rows of UᵀM, and its integer forms.
pub struct Shipped {
    pub table: Table,
    rows: Vec<Vec<f64>>,
    pub parts: OwnedParts<Q15>,
}

pub fn shipped() -> &'static Shipped {
    static SHIPPED: OnceLock<Shipped> = OnceLock::new();
    SHIPPED.get_or_init(|| {
        let bytes = include_bytes!("../../tables/sphere.bin");
        let table = eigenshade_table::decode(bytes).expect("a table");
        let parts = integers(&table, TOLERANCE).expect("a sphere's table");
        let rows = table.profiles.iter().map(|profile| table.gram_row(profile)).collect();
        Shipped { rows, parts, table }
    })
}

impl Shipped {
    /// d = UᵀMc, mode by mode; coefficients beyond the slices are zero.
    pub fn project(&self, light: &[f64], material: &[f64]) -> Vec<f64> {
        let gram = &self.table.gram;
        let of = |component: &Component| {
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

    /// Σ d_i U_i at a normal.
    pub fn reconstruct(&self, d: &[f64], normal: [f64; 3]) -> f64 {
        let components = d.iter().zip(&self.table.components);
        components.map(|(d, component)| d * eigenimage(&self.table, component, normal)).sum()
    }

    /// Upper bound of the difference between the image of `d` by the integer polynomials and by the
    /// table's: the omitted terms, and half a unit for each mantissa. Normals may be 5e-4 too long.
    pub fn lost(&self, d: &[f64]) -> f64 {
        let parts = &self.parts;
        let lost = d.iter().zip(&self.table.components).map(|(d, component)| {
            let profile = &self.table.profiles[component.profile];
            let length = usize::from(parts.lengths[profile.azimuth]);
            let rest: f64 = profile.chebyshev.iter().skip(length).map(|term| term.abs()).sum();
            let around = if profile.azimuth == 0 { 1.0 } else { SQRT_2 };
            let unit = 2f64.powi(parts.profiles[component.profile].exponent.into());
            let slant = 1.0005f64.powi(profile.azimuth as i32);
            d.abs() * slant * (around * rest + 0.5 * unit * length as f64)
        });
        lost.sum()
    }

    /// Σ d_i U_i at the components of a normal as they are, from the mantissas of the
    /// integer form.
    pub fn reconstruct_quantized(&self, d: &[f64], [x, y, z]: [f64; 3]) -> f64 {
        let parts = &self.parts;
        let t = 2.0 * z - 1.0;
        let (mut terms, mut sum) = (parts.terms.as_slice(), 0.0);
        for place in &parts.profiles {
            let azimuth = usize::from(place.azimuth);
            let (of_profile, rest) = terms.split_at(parts.lengths[azimuth].into());
            terms = rest;
            let value = of_profile.iter().fold(0.0, |sum, &term| sum * t + f64::from(term.0));
            let (slant, angle) = (x.hypot(y).powi(azimuth as i32), azimuth as f64 * y.atan2(x));
            let weight = |index: u16| d.get(usize::from(index)).copied().unwrap_or(0.0);
            let around = weight(place.plus) * angle.cos() - weight(place.minus) * angle.sin();
            sum += 2f64.powi(place.exponent.into()) * value * slant * around;
        }
        sum
    }
}
