//! Lights and materials: those of which a basis is made, and others that it never saw.

use crate::{parallel, shipped};
use eigenshade_generator::brdf::{
    BINS, Brdf, Geometry, Ggx, Lambertian, Measure, Merl, OrenNayar, Surface,
};
use eigenshade_generator::database::{Lights, Materials, Named};
use eigenshade_generator::error::{Error, Result};
use indicatif::ProgressBar;
use std::f64::consts::{FRAC_PI_2, PI};

/// Roughnesses of GGX.
const ROUGH: [f64; 10] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];
/// Roughnesses of the formulas of which bases beyond the measured order are made, and such
/// between them.
const EVEN: [f64; 5] = [0.2, 0.4, 0.6, 0.8, 1.0];
/// See [`EVEN`].
const BETWEEN: [f64; 3] = [0.25, 0.45, 0.85];
/// Of the lights every so-manieth shines on them.
const STEP: usize = 3;

/// What a basis of a degree and an order is made of and measured with.
pub struct Scope {
    /// Largest degree.
    pub degree: usize,
    /// Largest order.
    pub order: usize,
    /// The shipped lights, to that degree.
    pub lights: Lights,
    /// The materials of which the basis is made.
    pub seen: Materials,
    /// Materials that it never saw.
    pub unseen: Materials,
}

impl Scope {
    /// A scope without materials that its basis never saw: of the measured materials as far
    /// as they reach, above that of a few formulas.
    ///
    /// # Errors
    ///
    /// None in truth.
    pub fn seen(degree: usize, order: usize) -> Result<Self> {
        let measured = shipped::materials()?;
        let seen = if order <= measured.order {
            measured.truncated(order)
        } else {
            projected(&ggx(&EVEN, &[0.04, 0.9])?, order)
        };
        let unseen = Materials { order, entries: Vec::new() };
        Ok(Self { degree, order, lights: shipped::lights()?.truncated(degree), seen, unseen })
    }

    /// Of the measured materials as far as they reach, and GGX beside them; above that of
    /// formulas, and other formulas beside them.
    ///
    /// # Errors
    ///
    /// None in truth.
    pub fn new(degree: usize, order: usize) -> Result<Self> {
        let measured = shipped::materials()?;
        let mut lights = shipped::lights()?.truncated(degree);
        let (seen, mut others) = if order <= measured.order {
            (measured.truncated(order), ggx(&ROUGH, &[0.04, 0.9])?)
        } else {
            let mut formulas = ggx(&EVEN, &[0.04, 0.9])?;
            formulas.extend(matte()?);
            lights.entries = lights.entries.into_iter().step_by(STEP).collect();
            (projected(&formulas, order), ggx(&BETWEEN, &[0.04, 0.5])?)
        };
        others.extend(merl_like()?);
        let unseen = projected(&others, order);
        Ok(Self { degree, order, lights, seen, unseen })
    }
}

/// GGX of these roughnesses and reflectances; those of a dielectric have a matte base.
fn ggx(roughness: &[f64], f0: &[f64]) -> Result<Vec<Surface>> {
    let mut surfaces = Vec::new();
    for &f0 in f0 {
        let albedo = if f0 < 0.1 { 0.5 } else { 0.0 };
        for &roughness in roughness {
            let brdf = Ggx::new(roughness, f0, albedo)?;
            surfaces.push(Surface::grey(format!("ggx-{f0}-{roughness}"), Box::new(brdf)));
        }
    }
    Ok(surfaces)
}

/// Matte surfaces.
fn matte() -> Result<Vec<Surface>> {
    Ok(vec![
        Surface::grey("lambertian".into(), Box::new(Lambertian::new(0.8)?)),
        Surface::grey("oren-nayar-0.35".into(), Box::new(OrenNayar::new(0.8, 0.35)?)),
    ])
}

/// The surfaces whose model's error is measured, from matte to glossy.
///
/// # Errors
///
/// None in truth.
pub fn modelled() -> Result<Vec<Surface>> {
    let mut surfaces = matte()?;
    surfaces.extend(ggx(&[0.5, 0.3], &[0.04])?);
    surfaces.extend(ggx(&[0.7, 0.4], &[0.9])?);
    Ok(surfaces)
}

/// Two tables in the layout of the MERL database, of lobes that are not GGX's: a matte base
/// under a Gaussian lobe of slopes.
fn merl_like() -> Result<Vec<Surface>> {
    let tables = [("merl-like-paint", 0.6, 0.05, 0.35), ("merl-like-metal", 0.05, 0.8, 0.2)];
    let surface = |&(name, albedo, strength, width): &(&str, f64, f64, f64)| {
        let table = Merl::new(gaussian(albedo, strength, width));
        let table = table.ok_or_else(|| Error::new("a table of another size", "report it"))?;
        Ok(Surface::grey(name.into(), Box::new(Coarse(table))))
    };
    tables.iter().map(surface).collect()
}

/// Values at the centres of the bins; -1 where a direction is below the surface.
fn gaussian(albedo: f64, strength: f64, width: f64) -> Vec<f64> {
    let mut values = Vec::with_capacity(BINS.iter().product());
    for h in 0..BINS[0] {
        let theta_h = FRAC_PI_2 * ((h as f64 + 0.5) / BINS[0] as f64).powi(2);
        let slope = theta_h.tan() / width;
        let lobe = strength * (-slope * slope).exp() / (4.0 * PI * width * width);
        for d in 0..BINS[1] {
            let theta_d = FRAC_PI_2 * (d as f64 + 0.5) / BINS[1] as f64;
            for p in 0..BINS[2] {
                let phi_d = PI * (p as f64 + 0.5) / BINS[2] as f64;
                let (upright, aslant) =
                    (theta_h.cos() * theta_d.cos(), theta_h.sin() * theta_d.sin() * phi_d.cos());
                let visible = upright - aslant > 0.0 && upright + aslant > 0.0;
                values.push(if visible { albedo / PI + lobe } else { -1.0 });
            }
        }
    }
    values
}

/// A table of a lobe that is known to be wide: its quadrature need not be as fine as any
/// table may want.
struct Coarse(Merl);

impl Brdf for Coarse {
    fn value(&self, at: Geometry) -> f64 {
        self.0.value(at)
    }

    fn width(&self) -> f64 {
        0.1
    }
}

fn projected(surfaces: &[Surface], order: usize) -> Materials {
    let hidden = ProgressBar::hidden();
    // One at a time, so that every core has some.
    let entries: Vec<Named> = parallel::map(surfaces.len(), &hidden, |k| {
        surfaces[k].project(order, Measure::Projected).material
    });
    Materials { order, entries }
}
