//! Fits the runtime's gloss, one GGX lobe over a matte base, to any BRDF.
//!
//! The picture of a sphere under a small round source is fitted, for sources from near the camera
//! to behind the object, each relative to its peak. For one roughness, the picture is linear in
//! each of the reflectances and the albedo; the roughness is searched.

use eigenshade_generator::material::brdf::{Brdf, Geometry, Ggx, Surface};
use eigenshade_generator::material::measurements::{Measured, Measurement};
use eigenshade_model::error::Result;
use eigenshade_model::parallel;
use eigenshade_model::source::{Gloss, NamedGloss};
use eigenshade_table::highlights::SMOOTHEST;
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::Range;

/// Angles of the lights from the camera in degrees.
const LIGHTS: [f64; 6] = [10.0, 35.0, 60.0, 85.0, 110.0, 140.0];
/// The standard deviation of a source in radians, about as in captured lamps.
const SPREAD: f64 = 0.04;
/// The points that stand for a source are a grid of this step to this radius, both in standard
/// deviations. Half-way directions are half as far apart: 0.003, less than α of the smoothest lobe.
/// With a coarser grid, that lobe would show each point, and no fit could be right.
const STEP: f64 = 0.15;
const RADIUS: f64 = 3.0;
/// Normals around the half-way direction: rings from this angle to a right angle, and normals of
/// one on one side of the plane of source and camera. The other side is its mirror image.
const NEAREST: f64 = 0.004;
const RINGS: usize = 40;
const AROUND: usize = 8;
/// The roughnesses that are tried at first, their step, and how often it is halved after them.
const TRIED: usize = 48;
const FIRST_STEP: f64 = (1.0 - SMOOTHEST) / (TRIED - 1) as f64;
const HALVINGS: usize = 6;
/// A lobe counts as no highlight if the residual of a matte surface is at most this times as large,
/// or this large.
const FLAT: f64 = 1.05;
const EXACT: f64 = 1e-7;
/// Steps of the least squares solution.
const STEPS: usize = 100;

/// A normal of a picture, or a measured pair of directions.
struct Place {
    /// The geometry of each point of the source that the normal faces, and its share.
    lit: Vec<(Geometry, f64)>,
    weight: f64,
}

impl Place {
    /// The irradiance of a source of energy 1: Σ share f cos.
    fn irradiance(&self, brdf: &dyn Brdf) -> f64 {
        self.lit.iter().map(|(at, share)| share * at.incident * brdf.value(*at)).sum()
    }
}

/// The irradiance to fit at a place, by channel, and its weight.
struct Point {
    weight: f64,
    values: [f64; 3],
}

/// The four terms of [`terms`] at each place.
type Terms = Vec<[f64; 4]>;

/// Fits surfaces one after the other. All are first compared with the same lobes, which are computed
/// for the first surface that needs them.
#[derive(Default)]
pub struct Fitter(Option<Lobes>);

/// The pictures of the lobes that are tried at first.
struct Lobes {
    places: Vec<Place>,
    /// The places under each of [`LIGHTS`].
    pictures: [Range<usize>; LIGHTS.len()],
    tried: Vec<Terms>,
}

impl Fitter {
    /// The gloss of a surface: exact, or fitted.
    ///
    /// # Errors
    ///
    /// Cannot fail in practice: every roughness is in range.
    pub fn named(&mut self, surface: &Surface) -> Result<NamedGloss> {
        let (gloss, error) = match surface.gloss() {
            Some(gloss) => (gloss, 0.0),
            None => self.fit(surface)?,
        };
        Ok(NamedGloss { name: surface.name.clone(), gloss, error })
    }

    /// The gloss nearest to a surface, and its rms residual relative to the rms of the surface.
    fn fit(&mut self, surface: &Surface) -> Result<(Gloss, f64)> {
        let Lobes { places, pictures, tried } = match &mut self.0 {
            Some(lobes) => lobes,
            none => none.insert(Lobes::new()?),
        };
        let mut points = parallel::map(places.len(), &(), |k| {
            let values = [0, 1, 2].map(|c| places[k].irradiance(surface.channel(c)));
            Point { weight: places[k].weight, values }
        });
        // Each picture counts relative to its peak.
        for picture in &*pictures {
            let points = &mut points[picture.clone()];
            let values = points.iter().flat_map(|point| point.values);
            let peak = values.fold(f64::MIN_POSITIVE, f64::max);
            points.iter_mut().for_each(|point| point.weight /= peak * peak);
        }
        nearest(places, &points, |k| Ok(at_roughness(&points, &tried[k], roughness(k))))
    }
}

impl Lobes {
    fn new() -> Result<Self> {
        let mut places = Vec::new();
        let pictures = LIGHTS.map(|angle| {
            let first = places.len();
            places.extend(picture(angle));
            first..places.len()
        });
        let tried = (0..TRIED).map(|k| terms(&places, roughness(k))).collect::<Result<_>>()?;
        Ok(Self { places, pictures, tried })
    }
}

/// The gloss nearest to measurements. The error is relative to the measurements: between them the
/// lobe is not known.
///
/// # Errors
///
/// Cannot fail in practice: every roughness is in range.
pub fn of_measured(measured: &Measured) -> Result<NamedGloss> {
    let of = |sample: &Measurement| {
        let Measurement { theta_i, theta_r, delta_phi, rgb } = *sample;
        let at = Geometry::from_angles(theta_i, theta_r, delta_phi);
        let values = rgb.map(|value| value * at.incident);
        let weight = at.reflected;
        (Place { lit: vec![(at, 1.0)], weight }, Point { weight, values })
    };
    let (places, points): (Vec<_>, Vec<_>) = measured.samples.iter().map(of).unzip();
    let fit = |k| Ok(at_roughness(&points, &terms(&places, roughness(k))?, roughness(k)));
    let (gloss, error) = nearest(&places, &points, fit)?;
    Ok(NamedGloss { name: measured.name.clone(), gloss, error })
}

/// The k-th roughness that is tried at first.
fn roughness(k: usize) -> f64 {
    SMOOTHEST + FIRST_STEP * k as f64
}

/// The gloss nearest to pictures, and its rms residual, from the fit of the k-th roughness that is
/// tried at first.
fn nearest(
    places: &[Place],
    points: &[Point],
    fit: impl Fn(usize) -> Result<(Gloss, f64)> + Sync,
) -> Result<(Gloss, f64)> {
    let fits = parallel::map(TRIED, &(), fit).into_iter().collect::<Result<Vec<_>>>()?;
    let mut best = fits[0];
    for one in &fits[1..] {
        if one.1 < best.1 {
            best = *one;
        }
    }
    // The roughness of a lobe that shows nothing means nothing, and must not ask for sources.
    let matte = matte(points, &terms(places, 1.0)?);
    if matte.1 <= FLAT * best.1 + EXACT {
        return Ok(matte);
    }
    let mut step = FIRST_STEP;
    for _ in 0..HALVINGS {
        step *= 0.5;
        for roughness in [best.0.roughness - step, best.0.roughness + step] {
            let roughness = roughness.clamp(SMOOTHEST, 1.0);
            let one = at_roughness(points, &terms(places, roughness)?, roughness);
            if one.1 < best.1 {
                best = one;
            }
        }
    }
    Ok(best)
}

/// The points of a source at this angle from the camera, with their shares of its energy: a grid of
/// this step in standard deviations.
fn source_points(angle: f64, step: f64) -> Vec<([f64; 3], f64)> {
    let (sine, cosine) = angle.to_radians().sin_cos();
    let most = (RADIUS / step) as i32;
    let places = (-most..=most).flat_map(|i| (-most..=most).map(move |j| [i, j]));
    let places = places.map(|place| place.map(|k| step * f64::from(k)));
    let places = places.filter(|[u, v]| u.hypot(*v) <= RADIUS);
    let points = places.map(|[u, v]| {
        let ((su, cu), (sv, cv)) = ((SPREAD * u).sin_cos(), (SPREAD * v).sin_cos());
        let at = [(sine * cu + cosine * su) * cv, sv, (cosine * cu - sine * su) * cv];
        (at, (-0.5 * (u * u + v * v)).exp())
    });
    let mut points: Vec<_> = points.collect();
    let total: f64 = points.iter().map(|point| point.1).sum();
    points.iter_mut().for_each(|point| point.1 /= total);
    points
}

/// The points of a source that a normal faces, and their shares.
fn lit_points(source: &[([f64; 3], f64)], [x, y, z]: [f64; 3]) -> Vec<(Geometry, f64)> {
    let lit = source.iter().map(|&([a, b, c], share)| {
        (Geometry { incident: a * x + b * y + c * z, reflected: z, between: c }, share)
    });
    lit.filter(|(at, _)| at.incident > 0.0).collect()
}

/// The places of a picture under the source at this angle.
fn picture(angle: f64) -> Vec<Place> {
    let source = source_points(angle, STEP);
    let (sin_h, cos_h) = (0.5 * angle.to_radians()).sin_cos();
    let ratio = (FRAC_PI_2 / NEAREST).powf(1.0 / RINGS as f64);
    let mut places = Vec::new();
    for ring in 0..RINGS {
        let inner = NEAREST * ratio.powi(ring as i32);
        let (near, far) = (if ring == 0 { 0.0 } else { inner }, inner * ratio);
        let (s, c) = (0.5 * (near + far)).sin_cos();
        let solid_angle = PI * (near.cos() - far.cos()) / AROUND as f64;
        for k in 0..AROUND {
            let (sin_t, cos_t) = (PI * (k as f64 + 0.5) / AROUND as f64).sin_cos();
            // Along the plane of light and camera, and across it.
            let [x, y, z] =
                [c * sin_h + s * cos_t * cos_h, s * sin_t, c * cos_h - s * cos_t * sin_h];
            if z <= 0.0 {
                continue;
            }
            let lit = lit_points(&source, [x, y, z]);
            places.push(Place { lit, weight: solid_angle * z });
        }
    }
    places
}

/// A lobe of this roughness and a matte base at each place.
///
/// With p = (1 - cos θ_d)^5, the picture is f0 (1 - p) S + f90 p S + albedo (1 - f0 (1 - p) - f90
/// p) / π, all times the cosine, with the lobe S.
fn terms(places: &[Place], roughness: f64) -> Result<Terms> {
    let lobe = Ggx::new(roughness, 1.0, 0.0)?;
    Ok(parallel::map(places.len(), &(), |k| {
        let mut terms = [0.0; 4];
        for (at, share) in &places[k].lit {
            let p = (1.0 - at.difference_cosine()).powi(5);
            let (lobe, matte) = (lobe.value(*at), 1.0 / PI);
            let parts = [(1.0 - p) * lobe, p * lobe, (1.0 - p) * matte, p * matte];
            let cosine = share * at.incident;
            terms.iter_mut().zip(parts).for_each(|(term, part)| *term += cosine * part);
        }
        terms
    }))
}

/// The best albedo without a lobe, and its rms residual.
fn matte(points: &[Point], terms: &Terms) -> (Gloss, f64) {
    let mut gloss =
        Gloss { roughness: 1.0, reflectance: [0.0; 3], grazing: [0.0; 3], albedo: [0.0; 3] };
    let (mut left, mut all) = (0.0, 0.0);
    for c in 0..3 {
        let sum = |of: fn(f64, f64) -> f64| -> f64 {
            let pairs = points.iter().zip(terms);
            pairs.map(|(point, term)| point.weight * of(point.values[c], term[2] + term[3])).sum()
        };
        let (square, product) = (sum(|value, _| value * value), sum(|value, term| value * term));
        let of_term = sum(|_, term| term * term);
        let albedo = if of_term > 0.0 { (product / of_term).clamp(0.0, 1.0) } else { 0.0 };
        gloss.albedo[c] = albedo;
        left += (square - albedo * (2.0 * product - albedo * of_term)).max(0.0);
        all += square;
    }
    (gloss, if all > 0.0 { (left / all).sqrt() } else { 0.0 })
}

/// The best reflectances and albedo of one roughness, and the rms of what they leave.
fn at_roughness(points: &[Point], terms: &Terms, roughness: f64) -> (Gloss, f64) {
    let mut gloss = Gloss { roughness, reflectance: [0.0; 3], grazing: [0.0; 3], albedo: [0.0; 3] };
    let (mut left, mut all) = (0.0, 0.0);
    for c in 0..3 {
        // Sums of products of the four terms and of the values.
        let mut sums = [[0.0; 4]; 4];
        let (mut right, mut square) = ([0.0; 4], 0.0);
        for (point, terms) in points.iter().zip(terms) {
            let value = point.values[c];
            square += point.weight * value * value;
            for (i, a) in terms.iter().enumerate() {
                right[i] += point.weight * a * value;
                for (j, b) in terms.iter().enumerate() {
                    sums[i][j] += point.weight * a * b;
                }
            }
        }
        let factors =
            |[f0, f90, albedo]: [f64; 3]| [f0, f90, albedo * (1.0 - f0), albedo * (1.0 - f90)];
        let of = |a: [f64; 4], b: [f64; 4]| -> f64 {
            let row = |i: usize| (0..4).map(move |j| a[i] * b[j] * sums[i][j]).sum::<f64>();
            (0..4).map(row).sum()
        };
        let with = |a: [f64; 4]| -> f64 { a.iter().zip(&right).map(|(a, b)| a * b).sum() };
        // One after the other, each within its range: the picture is linear in each.
        let mut found = [0.1, 0.1, 0.1];
        for step in 0..3 * STEPS {
            let mut at = |value: f64| {
                found[step % 3] = value;
                factors(found)
            };
            let (zero, one) = (at(0.0), at(1.0));
            let slope = [0, 1, 2, 3].map(|k: usize| one[k] - zero[k]);
            let steepness = of(slope, slope);
            if steepness > 0.0 {
                found[step % 3] = ((with(slope) - of(zero, slope)) / steepness).clamp(0.0, 1.0);
            }
        }
        let [f0, f90, albedo] = found;
        (gloss.reflectance[c], gloss.grazing[c], gloss.albedo[c]) = (f0, f90, albedo);
        let factors = factors(found);
        left += (of(factors, factors) - 2.0 * with(factors) + square).max(0.0);
        all += square;
    }
    // A black surface is any gloss without reflectance.
    (gloss, if all > 0.0 { (left / all).sqrt() } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use eigenshade_generator::material::brdf::OrenNayar;

    #[test]
    fn a_lobe_is_found_again() {
        let [r, g, b] = [(0.9, 0.0), (0.3, 0.2), (0.04, 0.7)]
            .map(|(f0, albedo)| Ggx::new(0.314, f0, albedo).unwrap());
        let surface = Surface::colored("x".into(), [Box::new(r), Box::new(g), Box::new(b)]);
        let (gloss, error) = Fitter::default().fit(&surface).unwrap();
        assert!(error < 0.01 && (gloss.roughness - 0.314).abs() < 2e-3, "{gloss:?} {error}");
        for (c, (f0, albedo)) in [(0.9, 0.0), (0.3, 0.2), (0.04, 0.7)].into_iter().enumerate() {
            assert!((gloss.reflectance[c] - f0).abs() < 0.01, "{gloss:?}");
            assert!((gloss.albedo[c] - albedo).abs() < 0.02, "{gloss:?}");
            assert!(gloss.grazing[c] > 0.95, "{gloss:?}");
        }
    }

    #[test]
    fn a_matte_surface_has_no_lobe() {
        for sigma in [0.0, 0.5, 1.0] {
            let brdf = OrenNayar::new(0.6, sigma).unwrap();
            let surface = Surface::gray("x".into(), Box::new(brdf));
            let (gloss, error) = Fitter::default().fit(&surface).unwrap();
            assert!(gloss.roughness == 1.0 && error < 0.3, "{gloss:?} {error}");
        }
    }

    /// The picture of the smoothest lobe does not show the grid that stands for a source.
    #[test]
    fn a_source_is_smooth() {
        let lobe = Ggx::new(SMOOTHEST, 0.9, 0.0).unwrap();
        let angle = 60.0;
        let profile = |step: f64| {
            let source = source_points(angle, step);
            (0..60).map(move |k| {
                // From the middle of the lobe outwards, askew to the grid.
                let from = 1e-3 * f64::from(k);
                let [slant, y] = [0.5 * angle.to_radians() + 0.8 * from, (0.6 * from).sin()];
                let rest = (1.0 - y * y).sqrt();
                let lit = lit_points(&source, [rest * slant.sin(), y, rest * slant.cos()]);
                Place { lit, weight: 1.0 }
            })
        };
        let [found, fine] = [STEP, 0.2 * STEP]
            .map(|step| profile(step).map(|place| place.irradiance(&lobe)).collect::<Vec<_>>());
        let off = found.iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 0.02 * fine[0], "{off} of {}", fine[0]);
    }
}
