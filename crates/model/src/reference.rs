//! The direct sum (15) in f64, at the full orders of the given light and material: the reference
//! for all other methods.
//!
//! A sum restricted to some effects is a sum of at most two products of a light and a material:
//! ambient and the rest. [`light_products`] and [`material_products`] give their factors.

use crate::irradiance::{slant_radials, slant_rotation};
use crate::polar_integral::{PolarIntegrals, gain};
use crate::special::spherical_harmonic::azimuth;
use eigenshade_table::effect::{Effect, Effects};
use eigenshade_table::{light, material, pair};

/// The precomputed part of the sum for a degree and an order.
#[derive(Clone, Debug)]
pub struct DirectSum {
    degree: usize,
    order: usize,
    integrals: PolarIntegrals,
}

/// The modes at one normal.
#[derive(Clone, Debug)]
pub struct Modes<'a> {
    reference: &'a DirectSum,
    /// Φ_m for m = -degree..=degree.
    azimuths: Vec<f64>,
    /// D_l^mq / Φ_m: by |m|, then q, then l from max(|m|, q).
    rotations: Vec<Vec<Vec<f64>>>,
    radials: Vec<f64>,
}

/// One material at one normal: sums over (o, p) weighted with N_l^q K C, by q, then l from q.
#[derive(Clone, Debug)]
pub struct Scattered(Vec<Vec<f64>>);

impl DirectSum {
    /// Prepares sums for lights of `degree` and materials of `order`.
    #[must_use]
    pub fn new(degree: usize, order: usize) -> Self {
        Self { degree, order, integrals: PolarIntegrals::new(degree, order) }
    }

    /// The modes at a unit normal of the visible hemisphere, z >= 0.
    #[must_use]
    pub fn at(&self, [x, y, z]: [f64; 3]) -> Modes<'_> {
        let (alpha, beta) = (x.hypot(y).atan2(z), y.atan2(x));
        let top = self.degree.cast_signed();
        Modes {
            reference: self,
            azimuths: (-top..=top).map(|m| azimuth(m, beta)).collect(),
            rotations: (0..=top)
                .map(|m| {
                    let of = |q| slant_rotation(self.degree, m, q, alpha);
                    (0..=self.order.min(self.degree)).map(of).collect()
                })
                .collect(),
            radials: slant_radials(self.order, alpha),
        }
    }
}

impl Modes<'_> {
    /// Σ_op b_op^q K_lop^q (C_lo^q R_p^q + C_lp^q R_o^q) of a material.
    #[must_use]
    pub fn scatter(&self, coefficients: &[f64]) -> Scattered {
        let DirectSum { degree, order, integrals } = self.reference;
        let mut sums: Vec<Vec<f64>> =
            (0..=*order.min(degree)).map(|q| vec![0.0; degree - q + 1]).collect();
        for ((o, p, q), b) in material::indices(*order).zip(coefficients) {
            let Some(sum) = sums.get_mut(q) else { continue };
            let weight = b * gain(o, p, q);
            let of_p = weight * self.radials[pair::position(p, q)];
            let of_o = weight * self.radials[pair::position(o, q)];
            let integrals = integrals.row(o, q).iter().zip(integrals.row(p, q)).skip(q);
            for (sum, (of_lo, of_lp)) in sum.iter_mut().zip(integrals) {
                *sum += of_lo * of_p + of_lp * of_o;
            }
        }
        Scattered(sums)
    }

    /// One mode E_lop^mq (14); 0 if |m| > l or q > l.
    ///
    /// Domain: indices within the degree and order of [`DirectSum::new`].
    #[must_use]
    pub fn value(&self, l: usize, m: isize, o: usize, p: usize, q: usize) -> f64 {
        let lowest = q.max(m.unsigned_abs());
        if l < lowest {
            return 0.0;
        }
        let integrals = &self.reference.integrals;
        let scattered = integrals.row(o, q)[l] * self.radials[pair::position(p, q)]
            + integrals.row(p, q)[l] * self.radials[pair::position(o, q)];
        let rotation = self.rotations[m.unsigned_abs()][q][l - lowest];
        let sign = if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 };
        let azimuth = self.azimuths[self.reference.degree.saturating_add_signed(m)];
        sign * gain(o, p, q) * rotation * scattered * azimuth
    }

    /// The irradiance (15) of this material under a light of the degree of [`DirectSum::new`].
    #[must_use]
    pub fn irradiance(&self, light: &[f64], scattered: &Scattered) -> f64 {
        self.azimuths.iter().zip(self.profile(light, scattered)).map(|(a, b)| a * b).sum()
    }

    /// The irradiance (15) of this material as a linear function of the light: its product with the
    /// light's coefficients is [`irradiance`](Self::irradiance).
    #[must_use]
    pub fn transport(&self, scattered: &Scattered) -> Vec<f64> {
        let degree = self.reference.degree;
        let one = |(l, m): (usize, isize)| {
            let of_q = |(q, (rotation, scattered)): (usize, (&Vec<f64>, &Vec<f64>))| {
                let lowest = q.max(m.unsigned_abs());
                l.checked_sub(lowest).map_or(0.0, |k| rotation[k] * scattered[l - q])
            };
            let rotations = &self.rotations[m.unsigned_abs()];
            let sum: f64 = rotations.iter().zip(&scattered.0).enumerate().map(of_q).sum();
            let sign = if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 };
            sign * sum * self.azimuths[degree.saturating_add_signed(m)]
        };
        light::indices(degree).map(one).collect()
    }

    /// The irradiance by azimuth, for m = -degree..=degree. The sum of these values times Φ_m of
    /// the tilt is the irradiance of any normal of this slant.
    #[must_use]
    pub fn profile(&self, light: &[f64], scattered: &Scattered) -> Vec<f64> {
        let top = self.reference.degree.cast_signed();
        let of_azimuth = |m: isize| {
            let mut of_order = 0.0;
            for (q, (rotation, scattered)) in
                self.rotations[m.unsigned_abs()].iter().zip(&scattered.0).enumerate()
            {
                let lowest = q.max(m.unsigned_abs());
                let scattered = scattered.iter().skip(lowest - q);
                for (l, (rotation, scattered)) in (lowest..).zip(rotation.iter().zip(scattered)) {
                    of_order += light[light::position(l, m)] * rotation * scattered;
                }
            }
            if m < 0 && m % 2 != 0 { -of_order } else { of_order }
        };
        (-top..=top).map(of_azimuth).collect()
    }
}

/// One channel of a light for each product. The k-th goes with the k-th of [`material_products`].
#[must_use]
pub fn light_products(degree: usize, light: &[f64], effects: Effects) -> Vec<Vec<f64>> {
    let of = |is_ambient: bool| {
        let kept = |l: usize| (l == 0) == is_ambient;
        let each = light::indices(degree).zip(light);
        each.map(|((l, _), &value)| if kept(l) { value } else { 0.0 }).collect()
    };
    products(effects, light, of)
}

/// One channel of a material for each product. The k-th goes with the k-th of [`light_products`].
#[must_use]
pub fn material_products(order: usize, material: &[f64], effects: Effects) -> Vec<Vec<f64>> {
    let of = |is_ambient: bool| {
        let kept = |o: usize| is_ambient || effects.keeps(1, o);
        let each = material::indices(order).zip(material);
        each.map(|((o, _, _), &b)| if kept(o) { b } else { 0.0 }).collect()
    };
    products(effects, material, of)
}

/// With all effects there is a single product of the unchanged coefficients.
fn products(effects: Effects, whole: &[f64], of: impl Fn(bool) -> Vec<f64>) -> Vec<Vec<f64>> {
    if effects.is_all() {
        return vec![whole.to_vec()];
    }
    let ambient = effects.has(Effect::Ambient).then(|| of(true));
    let rest = effects.is_directional().then(|| of(false));
    ambient.into_iter().chain(rest).collect()
}
