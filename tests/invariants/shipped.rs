//! The shipped table in f64 and as integers, decoded once.

use super::integer::Integer;
use eigenshade_index::{light, material, mode, pair};
use eigenshade_table::Table;
use eigenshade_table::quantize::{Format, QuantizedParts};
use std::f64::consts::SQRT_2;
use std::sync::OnceLock;

/// The table, its rows of UᵀM, and its integer forms.
pub struct Shipped {
    pub table: Table,
    rows: Vec<Vec<f64>>,
    q15: QuantizedParts,
    q31: QuantizedParts,
}

pub fn shipped() -> &'static Shipped {
    static SHIPPED: OnceLock<Shipped> = OnceLock::new();
    SHIPPED.get_or_init(|| {
        let bytes = include_bytes!("../../tables/sphere.bin");
        let table = eigenshade_table::decode(bytes).expect("a table");
        let parts = |format: Format| {
            QuantizedParts::new(&table, format, format.tolerance()).expect("a sphere's table")
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
    pub fn parts<Q: Integer>(&self) -> &QuantizedParts {
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
