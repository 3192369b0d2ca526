//! Small sources taken out of a light and shaded by the microfacet formula: against the formulas in
//! slopes, against quadrature of the blob that defines a source, and against the exact BRDF
//! integrated over that blob.

use crate::oracle::{ExplicitLight, Numbers};
use eigenshade::mathematics::{Libm, SinglePrecision, Tabled};
use eigenshade::{
    Argument, Error, Gloss, Highlights, Light, LightBuffer, Normal, Normals, Rgb, Rotation, Scalar,
    Source,
};
use std::f64::consts::PI;

pub type Vector = [f64; 3];

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn sum(a: Vector, weight: f64, b: Vector) -> Vector {
    [a[0] + weight * b[0], a[1] + weight * b[1], a[2] + weight * b[2]]
}

fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|component| component * factor)
}

pub fn unit(a: Vector) -> Vector {
    scaled(a, 1.0 / dot(a, a).sqrt())
}

pub const VIEW: Vector = [0.0, 0.0, 1.0];

/// The direction at an angle from the view, in an azimuth.
pub fn at(angle: f64, azimuth: f64) -> Vector {
    [angle.sin() * azimuth.cos(), angle.sin() * azimuth.sin(), angle.cos()]
}

/// Two tangents at a direction that is not the view's negative: away from the view, and across.
fn tangents(direction: Vector) -> [Vector; 2] {
    let across = cross(VIEW, direction);
    let across = if dot(across, across) > 1e-24 { unit(across) } else { [0.0, 1.0, 0.0] };
    [cross(across, direction), across]
}

/// A source in f64, and the tangent angle of its major axis.
#[derive(Clone, Copy, Debug)]
pub struct Blob {
    pub direction: Vector,
    pub angle: f64,
    pub major: f64,
    pub minor: f64,
}

impl Blob {
    fn axis(&self) -> Vector {
        let [along, across] = tangents(self.direction);
        sum(scaled(along, self.angle.cos()), self.angle.sin(), across)
    }

    fn source(&self, energy: [f64; 3]) -> Source<f64> {
        Source::new::<Libm>(self.direction, energy, scaled(self.axis(), self.major), self.minor)
            .expect("a small source")
    }

    pub fn single(&self, energy: [f64; 3]) -> Source<f32> {
        let of = |v: Vector| v.map(|x| x as f32);
        let major = of(scaled(self.axis(), self.major));
        let [direction, energy] = [self.direction, energy].map(of);
        Source::new::<SinglePrecision>(direction, energy, major, self.minor as f32)
            .expect("a small source")
    }

    /// Directions and weights that integrate the blob as it is defined: a heat kernel at each node
    /// along the major axis, by trapezoid sums of this spacing at most.
    fn nodes(&self, spacing: f64) -> Vec<(Vector, f64)> {
        let length = (self.major.powi(2) - self.minor.powi(2)).max(0.0).sqrt();
        let axis = self.axis();
        let arc: Vec<(Vector, f64)> = if length > 0.0 {
            let step = spacing.min(0.7 * length);
            let count = (7.0 * length / step).ceil() as i32;
            (-count..=count)
                .map(|k| {
                    let x = f64::from(k) * step;
                    let direction = sum(scaled(self.direction, x.cos()), x.sin(), axis);
                    (direction, (-0.5 * (x / length).powi(2)).exp())
                })
                .collect()
        } else {
            vec![(self.direction, 1.0)]
        };
        let kernel = heat_kernel(self.minor, spacing);
        let mut nodes: Vec<_> = arc
            .iter()
            .flat_map(|&(center, weight)| {
                let [a, b] = tangents(center);
                kernel.iter().map(move |&([u, v], of_kernel)| {
                    let angle = u.hypot(v);
                    let tangent = sum(scaled(a, u), v, b);
                    let ratio = if angle > 0.0 { angle.sin() / angle } else { 1.0 };
                    (sum(scaled(center, angle.cos()), ratio, tangent), weight * of_kernel)
                })
            })
            .collect();
        let total: f64 = nodes.iter().map(|(_, weight)| weight).sum();
        nodes.iter_mut().for_each(|(_, weight)| *weight /= total);
        nodes
    }
}

/// Points of a tangent plane, as angles, and weights of the heat kernel there: its harmonics summed
/// at each distance.
fn heat_kernel(spread: f64, spacing: f64) -> Vec<([f64; 2], f64)> {
    if spread == 0.0 {
        return vec![([0.0; 2], 1.0)];
    }
    let variance = spread * spread;
    let value = |cosine: f64| {
        let (mut before, mut now, mut sum) = (0.0, 1.0, 0.0);
        for l in 0..(9.0 / spread) as i32 + 8 {
            let degree = f64::from(l);
            sum += (2.0 * degree + 1.0) * (-0.5 * degree * (degree + 1.0) * variance).exp() * now;
            let next = ((2.0 * degree + 1.0) * cosine * now - degree * before) / (degree + 1.0);
            (before, now) = (now, next);
        }
        sum
    };
    let reach = (7.0 * spread).min(3.1);
    let step = spacing.min(0.7 * spread);
    let count = (reach / step).ceil() as i32;
    let mut points = Vec::new();
    for i in -count..=count {
        for j in -count..=count {
            let [u, v] = [i, j].map(|k| f64::from(k) * step);
            let angle = u.hypot(v);
            if angle < reach {
                let ratio = if angle > 0.0 { angle.sin() / angle } else { 1.0 };
                points.push(([u, v], value(angle.cos()) * ratio));
            }
        }
    }
    points
}

/// A material in f64, one channel.
#[derive(Clone, Copy, Debug)]
pub struct Glossy {
    pub roughness: f64,
    pub f0: f64,
    pub albedo: f64,
}

impl Glossy {
    pub fn alpha(&self) -> f64 {
        self.roughness * self.roughness
    }

    pub fn gloss<S: Scalar>(&self) -> Gloss<S> {
        let [roughness, f0, albedo] = [self.roughness, self.f0, self.albedo].map(S::from_f64);
        Gloss::new(roughness, [f0; 3], [albedo; 3]).expect("numbers from 0 to 1")
    }

    fn fresnel(&self, cosine: f64) -> f64 {
        self.f0 + (1.0 - self.f0) * (1.0 - cosine).powi(5)
    }

    /// Smith's term for the cosines of light and view.
    fn visibility(&self, light: f64, view: f64) -> f64 {
        let square = self.alpha().powi(2);
        let root = |cosine: f64| (square + (1.0 - square) * cosine * cosine).sqrt();
        0.5 / (light * root(view) + view * root(light))
    }

    /// BRDF times cosine for light from one direction at a normal.
    fn reflected(&self, light: Vector, normal: Vector) -> f64 {
        let [cosine, view] = [dot(light, normal), normal[2]];
        if cosine <= 0.0 {
            return 0.0;
        }
        let half = unit(sum(light, 1.0, VIEW));
        let square = self.alpha().powi(2);
        let facing = dot(half, normal);
        let divisor = facing * facing * (square - 1.0) + 1.0;
        let distribution = square / (PI * divisor * divisor);
        let fresnel = self.fresnel(dot(half, VIEW));
        let matte = (1.0 - fresnel) * self.albedo / PI;
        cosine * (matte + fresnel * distribution * self.visibility(cosine, view))
    }

    /// The lobe of a source of energy 1, with D from slopes about the half-way direction, no wider
    /// across the plane of source and view than a uniform one.
    pub fn lobe(&self, blob: &Blob, blur: Option<f64>, normal: Vector) -> f64 {
        let [cosine, view] = [dot(blob.direction, normal), normal[2]];
        if cosine <= 0.0 {
            return 0.0;
        }
        let half = unit(sum(blob.direction, 1.0, VIEW));
        let along_view = dot(half, VIEW);
        let covariance = {
            let [c, s] = [blob.angle.cos(), blob.angle.sin()];
            let [long, short] = [blob.major.powi(2), blob.minor.powi(2)];
            [
                [long * c * c + short * s * s, (long - short) * c * s],
                [(long - short) * c * s, long * s * s + short * c * c],
            ]
        };
        let jacobian = [0.5, 0.5 / along_view];
        let mut wide = [[0.0; 2]; 2];
        for i in 0..2 {
            for j in 0..2 {
                wide[i][j] = jacobian[i] * covariance[i][j] * jacobian[j];
            }
        }
        let ratio = 0.5 * (wide[0][0] + wide[1][1]) / self.alpha().powi(2);
        let blur = blur.unwrap_or(2.0 + 1.0 / (1.0 + ratio));
        for (i, row) in wide.iter_mut().enumerate() {
            row.iter_mut().for_each(|element| *element *= blur);
            row[i] += self.alpha().powi(2);
        }
        let behind = covariance[1][1] / along_view.powi(2);
        let faded = 1.0 / (1.0 + 0.5 * behind * behind);
        if wide[1][1] > 1.0 {
            wide[0][1] /= wide[1][1];
            wide[1][0] = wide[0][1];
            wide[1][1] = 1.0;
        }
        let determinant = wide[0][0] * wide[1][1] - wide[0][1] * wide[1][0];
        // The tangents of the source's plane at the half-way direction.
        let across = tangents(blob.direction)[1];
        let along = cross(across, half);
        let facing = dot(half, normal);
        let [p, q] = [dot(along, normal) / facing, dot(across, normal) / facing];
        let quadratic =
            (wide[1][1] * p * p - 2.0 * wide[0][1] * p * q + wide[0][0] * q * q) / determinant;
        let distribution =
            1.0 / (PI * determinant.sqrt() * facing.powi(4) * (1.0 + quadratic).powi(2));
        let fresnel = self.fresnel(along_view);
        let matte = (1.0 - fresnel) * self.albedo / PI;
        cosine * (matte + faded * fresnel * distribution * self.visibility(cosine, view))
    }
}

/// Normals uniform over the sphere's disc.
fn disc(width: i32) -> Vec<Vector> {
    let place = |k: i32| f64::from(2 * k + 1) / f64::from(width) - 1.0;
    let all = (0..width * width).map(|k| [place(k % width), place(k / width)]);
    all.filter(|[x, y]| x.hypot(*y) < 1.0)
        .map(|[x, y]| [x, y, (1.0 - x * x - y * y).sqrt()])
        .collect()
}

/// Normals around the half-way direction of a source, in steps of a part of the lobe.
fn around(blob: &Blob, step: f64, count: i32) -> Vec<Vector> {
    let half = unit(sum(blob.direction, 1.0, VIEW));
    let [a, b] = tangents(half);
    let mut normals = Vec::new();
    for i in -count..=count {
        for j in -count..=count {
            let [u, v] = [i, j].map(|k| f64::from(k) * step);
            normals.push(unit(sum(sum(half, u, a), v, b)));
        }
    }
    normals.retain(|normal| normal[2] >= 0.0);
    normals
}

/// The κ of the runtime, by which the blob's covariance widens the lobe.
pub const BLUR: Option<f64> = None;

/// In f64 against the formula in slopes, of the lobe's peak: roots by Newton's method, and slopes of
/// up to a hundred.
const LOBE_F64: f64 = 2e-12;

/// In f32, of the lobe's peak, by roughness. A lobe of α moves by its width where a normal turns by
/// α: rounding a normal and a direction to 24 bits, and forms of numbers to 1/α, leave some ε/α. All
/// lobes have the root's 7e-7.
const LOBE_F32: [(f64, f64); 5] =
    [(0.1, 1e-5), (0.2, 5e-6), (0.3, 3e-6), (0.5, 2e-6), (1.0, 1.5e-6)];

/// Blobs by angle from the view: round and elongated, from a point to the widest.
pub fn blobs(degrees: &[f64]) -> Vec<Blob> {
    let shapes = [(0.0, 0.0), (0.02, 0.02), (0.1, 0.03), (0.2, 0.0), (0.5, 0.5)];
    let mut blobs = Vec::new();
    for (k, degrees) in degrees.iter().enumerate() {
        for (j, (major, minor)) in shapes.into_iter().enumerate() {
            let direction = at(degrees.to_radians(), 0.4 + 1.3 * k as f64);
            blobs.push(Blob { direction, angle: 0.3 + j as f64, major, minor });
        }
    }
    blobs
}

pub const ANGLES: [f64; 9] = [0.0, 0.01, 5.0, 40.0, 80.0, 90.0, 110.0, 150.0, 175.0];

/// Normals of the disc, around the highlight, and of the rim.
pub fn normals_for(blob: &Blob, width: f64) -> Vec<Vector> {
    let mut normals = disc(24);
    normals.extend(around(blob, 0.4 * width, 5));
    normals.extend(
        (0..24).map(|k| at(0.5 * PI, f64::from(k) * PI / 12.0)).map(|[x, y, _]| [x, y, 0.0]),
    );
    normals.push(VIEW);
    normals
}

fn shaded<S: Scalar, const N: usize>(highlights: &Highlights<S, N>, normal: Vector) -> Rgb<S> {
    let [x, y, z] = normal.map(S::from_f64);
    highlights.shade(Normal::new(x, y, z).expect("a visible normal"))
}

fn of_one<S: Scalar>(material: &Glossy, source: Source<S>) -> Highlights<S, 1> {
    Highlights::new::<Libm>(&material.gloss(), &[source]).expect("room for one")
}

#[test]
fn lobes_are_those_of_the_formula_in_slopes() {
    let mut most = 0.0_f64;
    for blob in blobs(&ANGLES) {
        for roughness in [0.1, 0.3, 0.6, 1.0] {
            let material = Glossy { roughness, f0: 0.3, albedo: 0.5 };
            let highlights = of_one(&material, blob.source([1.0, 0.5, 0.0]));
            let normals = normals_for(&blob, material.alpha().hypot(0.5 * blob.major));
            let expected: Vec<_> =
                normals.iter().map(|&normal| material.lobe(&blob, BLUR, normal)).collect();
            let peak = expected.iter().copied().fold(0.0, f64::max);
            for (&normal, expected) in normals.iter().zip(expected) {
                let Rgb { r, g, b } = shaded(&highlights, normal);
                most = most.max((r - expected).abs() / peak);
                assert!((g - 0.5 * r).abs() <= 1e-15 * r && b == 0.0, "{blob:?}");
            }
        }
    }
    println!("of the peak: {most:e}");
    assert!(most <= LOBE_F64, "{most:e}");
}

#[test]
fn single_precision() {
    for (roughness, tolerance) in LOBE_F32 {
        let material = Glossy { roughness, f0: 0.3, albedo: 0.5 };
        let mut most = 0.0_f64;
        for blob in blobs(&ANGLES) {
            let double = of_one(&material, blob.source([1.0; 3]));
            let single: Highlights<f32, 1> =
                Highlights::new::<SinglePrecision>(&material.gloss(), &[blob.single([1.0; 3])])
                    .expect("room for one");
            let normals = normals_for(&blob, material.alpha().hypot(0.5 * blob.major));
            let pairs: Vec<_> = normals
                .iter()
                .map(|&normal| (shaded(&double, normal).r, f64::from(shaded(&single, normal).r)))
                .collect();
            let peak = pairs.iter().map(|(exact, _)| *exact).fold(0.0, f64::max);
            for (exact, found) in pairs {
                most = most.max((found - exact).abs() / peak);
            }
        }
        println!("roughness {roughness}, of the peak: {most:e}");
        assert!(most <= tolerance, "{roughness}: {most:e}");
    }
}

/// Errors of the lobe against the exact BRDF over the blob, by spread in radians: of the peak and
/// rms over the disc, as fractions of the exact peak. Sources to 110 degrees from the view, roughness
/// 0.2 to 0.6; and to 140 degrees.
const LOBE_ERRORS: [(f64, [f64; 2], [f64; 2]); 5] = [
    (0.01, [0.025, 0.0005], [0.04, 0.0006]),
    (0.02, [0.05, 0.0014], [0.06, 0.002]),
    (0.05, [0.065, 0.005], [0.065, 0.006]),
    (0.1, [0.075, 0.011], [0.075, 0.012]),
    (0.2, [0.065, 0.025], [0.065, 0.03]),
];

/// The error of the peak and the rms error for some κ, of the exact peak.
fn lobe_errors(material: &Glossy, blob: &Blob, blurs: &[Option<f64>]) -> Vec<[f64; 2]> {
    let alpha = material.alpha();
    let narrower = if blob.minor > 0.0 { blob.minor } else { blob.major };
    let nodes = blob.nodes((0.8 * alpha).min(0.8 * narrower));
    let exact = |normal: Vector| -> f64 {
        nodes.iter().map(|&(light, weight)| weight * material.reflected(light, normal)).sum()
    };
    // Enough for the narrowest lobe.
    let all = disc(if narrower < 0.02 { 80 } else { 48 });
    let near = around(blob, 0.25 * alpha.hypot(0.5 * narrower), 6);
    let images: Vec<f64> = all.iter().map(|&normal| exact(normal)).collect();
    let peak = near.iter().map(|&normal| exact(normal)).chain(images.iter().copied());
    let peak = peak.fold(0.0, f64::max);
    let errors = blurs.iter().map(|&blur| {
        let lobe = |&normal: &Vector| material.lobe(blob, blur, normal);
        let found: Vec<f64> = all.iter().map(lobe).collect();
        let of_lobe = near.iter().map(lobe).chain(found.iter().copied()).fold(0.0, f64::max);
        let squares: f64 = found.iter().zip(&images).map(|(f, e)| (f - e).powi(2)).sum();
        [of_lobe / peak - 1.0, (squares / all.len() as f64).sqrt() / peak]
    });
    errors.collect()
}

#[test]
fn lobes_are_near_the_exact_brdf_over_the_blob() {
    let blurs = [BLUR, Some(2.0), Some(2.5), Some(3.0), Some(4.0)];
    println!("spread,angle,error,κ {blurs:?}: the largest of roughness 0.2 to 0.6");
    for (spread, near, far) in LOBE_ERRORS {
        for (degrees, bounds) in [(5.0_f64, near), (60.0, near), (110.0, near), (140.0, far)] {
            let mut worst = vec![[0.0_f64; 2]; blurs.len()];
            for roughness in [0.2, 0.3, 0.4, 0.6] {
                let material = Glossy { roughness, f0: 0.9, albedo: 0.0 };
                let direction = at(degrees.to_radians(), 0.4);
                let blob = Blob { direction, angle: 0.0, major: spread, minor: spread };
                let errors = lobe_errors(&material, &blob, &blurs);
                for (worst, errors) in worst.iter_mut().zip(&errors) {
                    *worst = [0, 1].map(|k| worst[k].max(errors[k].abs()));
                }
            }
            for (kind, name) in ["peak", "rms"].iter().enumerate() {
                let row = worst.iter().map(|worst| format!(",{:.4}", worst[kind]));
                println!("{spread},{degrees},{name}{}", row.collect::<String>());
            }
            let [peak, rms] = worst[0];
            assert!(peak <= bounds[0] && rms <= bounds[1], "{spread} {degrees}: {:?}", worst[0]);
        }
    }
}

/// The same for elongated blobs in any orientation, on a metal and on a dielectric: of the peak, and
/// rms.
const ELONGATED: [f64; 2] = [0.06, 0.0095];

#[test]
fn lobes_of_elongated_blobs() {
    let mut worst = [0.0_f64; 2];
    for (f0, albedo) in [(0.9, 0.0), (0.04, 0.5)] {
        for (major, minor) in [(0.1, 0.02), (0.15, 0.05)] {
            for (degrees, angle) in [(30.0_f64, 0.0), (30.0, 0.8), (80.0, 1.57), (80.0, 2.4)] {
                let material = Glossy { roughness: 0.3, f0, albedo };
                let direction = at(degrees.to_radians(), 2.0);
                let blob = Blob { direction, angle, major, minor };
                let errors = lobe_errors(&material, &blob, &[BLUR]);
                println!("{f0} {blob:?}: {:?}", errors[0]);
                worst = [0, 1].map(|k| worst[k].max(errors[0][k].abs()));
            }
        }
    }
    assert!(worst[0] <= ELONGATED[0] && worst[1] <= ELONGATED[1], "{worst:?}");
}

/// Coefficients of a blob by the trapezoid rule of the runtime, for energy 1: its ends and its
/// aliases leave 4e-6 each, of a harmonic of at most 1.41 times √((2l + 1) / 4π) = 1.41.
const BLOB: f64 = 1e-5;

/// The coefficients that a source takes from no light, negated.
fn taken<S: Scalar, const N: usize>(source: Source<S>) -> Vec<S>
where
    Libm: eigenshade::mathematics::Mathematics<S>,
{
    let dark = [S::ZERO; N];
    let light = Rgb::gray(Light::new(&dark).expect("all degrees"));
    let residual = light.residual::<Libm, N>(&[source]).expect("room");
    residual.r.iter().map(|&coefficient| -coefficient).collect()
}

#[test]
fn blobs_have_the_harmonics_of_their_definition() {
    let explicit: Vec<_> = (0..169)
        .map(|k| {
            let mut alone = [0.0; 169];
            alone[k] = 1.0;
            ExplicitLight::new(&alone)
        })
        .collect();
    let shapes =
        [(0.0, 0.0), (0.05, 0.05), (0.3, 0.0), (0.3, 0.1), (0.5, 0.45), (0.5, 0.0), (0.4, 0.4)];
    let directions =
        [VIEW, [0.0, 0.0, -1.0], at(1e-6, 2.0), at(0.7, 0.4), at(PI / 2.0, 2.5), at(2.5, -1.0)];
    let mut most = 0.0_f64;
    for (k, direction) in directions.into_iter().enumerate() {
        for (major, minor) in shapes {
            let blob = Blob { direction, angle: 0.5 + k as f64, major, minor };
            let found = taken::<f64, 169>(blob.source([1.0, 0.0, 0.0]));
            let nodes = blob.nodes(0.2);
            for (found, explicit) in found.iter().zip(&explicit) {
                let expected: f64 =
                    nodes.iter().map(|&(at, weight)| weight * explicit.radiance(at)).sum();
                most = most.max((found - expected).abs());
            }
        }
    }
    println!("of energy 1: {most:e}");
    assert!(most <= BLOB, "{most:e}");
}

/// Degree 9 in f32: the direction rounded by 6e-8, times a slope of up to 13, and nine steps of a
/// recurrence with factors of up to 2.
const BLOB_F32: f64 = 4e-6;

#[test]
fn blobs_in_single_precision() {
    let mut most = 0.0_f64;
    for blob in blobs(&ANGLES) {
        let exact = taken::<f64, 100>(blob.source([1.0; 3]));
        let dark = [0.0; 100];
        let light = Rgb::gray(Light::new(&dark).expect("degree 9"));
        for residual in [
            light.residual::<SinglePrecision, 100>(&[blob.single([1.0; 3])]),
            light.residual::<Tabled, 100>(&[blob.single([1.0; 3])]),
        ] {
            for (found, exact) in residual.expect("room").g.iter().zip(&exact) {
                most = most.max((f64::from(-found) - exact).abs());
            }
        }
    }
    println!("of energy 1: {most:e}");
    assert!(most <= BLOB_F32, "{most:e}");
}

fn noise<const N: usize>(numbers: &mut Numbers) -> Rgb<[f64; N]> {
    Rgb::gray(()).map(|()| [(); N].map(|()| numbers.next()))
}

fn sources() -> [Source<f64>; 4] {
    let blobs = blobs(&[20.0, 100.0]);
    [0, 1, 7, 8].map(|k| blobs[k].source([1.0 + k as f64, 0.5, 30.0]))
}

fn lights<const N: usize>(residual: &Rgb<LightBuffer<f64, N>>) -> Rgb<Light<'_, f64>> {
    residual.lights().expect("all degrees")
}

/// L = L' + Σ E Y, each channel with its own energy, and L' turns as the light and the sources do.
#[test]
fn residuals_lose_what_sources_take_and_turn_with_them() {
    let mut numbers = Numbers(3);
    let of_light = noise::<100>(&mut numbers);
    let light = of_light.each_ref().try_map(|channel| Light::new(channel)).expect("degree 9");
    let sources = sources();
    let residual = light.residual::<Libm, 100>(&sources).expect("room");
    let mut most = 0.0_f64;
    for (channel, k) in [(&residual.r, 0), (&residual.g, 1), (&residual.b, 2)] {
        let of_light: [&[f64]; 3] = light.map(|light| light.coefficients()).into();
        let energy = |source: &Source<f64>| <[f64; 3]>::from(source.energy())[k];
        let blobs =
            sources.map(|source| (energy(&source), taken::<f64, 100>(with_energy_1(source))));
        for (place, rest) in channel.iter().enumerate() {
            let sum: f64 = blobs.iter().map(|(energy, blob)| energy * blob[place]).sum();
            most = most.max((rest + sum - of_light[k][place]).abs());
        }
    }
    // Sums of four energies of up to 30.
    assert!(most <= 1e-13, "{most:e}");

    let rotation = Rotation::from_euler::<Libm>(0.4, 2.0, -1.1).expect("a rotation");
    let turned = light.turned::<100>(&rotation).expect("room");
    let turned_sources = sources.map(|source| source.turned(rotation));
    let before = lights(&turned).residual::<Libm, 100>(&turned_sources).expect("room");
    let after = lights(&residual).turned::<100>(&rotation).expect("room");
    for (before, after) in [(before.r, after.r), (before.g, after.g), (before.b, after.b)] {
        for (before, after) in before.iter().zip(&after) {
            assert!((before - after).abs() <= 1e-12, "{before} {after}");
        }
    }
    // The same blob, seen from elsewhere.
    let back = turned_sources.map(|source| source.turned(rotation.inverse()));
    for (back, source) in back.iter().zip(&sources) {
        for (a, b) in [(back.direction(), source.direction()), (back.major(), source.major())] {
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-15));
        }
        assert_eq!((back.minor(), back.energy()), (source.minor(), source.energy()));
    }
}

fn with_energy_1(source: Source<f64>) -> Source<f64> {
    Source::new::<Libm>(source.direction(), [1.0; 3], source.major(), source.minor())
        .expect("it was one before")
}

/// The channels of a light may have degrees of their own.
#[test]
fn residuals_of_channels_of_several_degrees() {
    let (low, high) = ([1.0; 4], [1.0; 16]);
    let light = Rgb::new(&low[..], &high[..], &low[..1]);
    let light = light.try_map(Light::new).expect("all degrees");
    let source = Source::round::<Libm>([0.0, 0.6, 0.8], [1.0; 3], 0.1).expect("a source");
    let residual = light.residual::<Libm, 16>(&[source]).expect("room");
    let blob = taken::<f64, 16>(source);
    assert_eq!([residual.r.len(), residual.g.len(), residual.b.len()], [4, 16, 1]);
    for channel in [&residual.r, &residual.g, &residual.b] {
        assert!(channel.iter().zip(&blob).all(|(rest, blob)| (rest + blob - 1.0).abs() <= 1e-15));
    }
    let refused = light.residual::<Libm, 9>(&[source]);
    let expected = Error::Capacity { argument: Argument::Light, needed: 16, capacity: 9 };
    assert_eq!(refused, Err(expected));
}

#[test]
fn sources_that_are_none_are_refused() {
    let new = |direction, energy: [f32; 3], major, minor| {
        Source::new::<SinglePrecision>(direction, energy, major, minor)
    };
    let (front, gray, wide) = ([0.0, 0.0, 1.0], [1.0; 3], [0.5, 0.0, 0.0]);
    assert!(new(front, gray, wide, 0.5).is_ok());
    assert!(new(front, [0.0; 3], [0.0; 3], 0.0).is_ok());
    for (direction, energy, major, minor) in [
        (front, gray, [0.51, 0.0, 0.0], 0.1),
        (front, gray, wide, 0.51),
        (front, gray, wide, -0.1),
        (front, gray, wide, f32::NAN),
        (front, gray, [f32::NAN, 0.0, 0.0], 0.1),
        (front, gray, [f32::INFINITY, 0.0, 0.0], 0.1),
        // Along the direction, so nothing is left.
        (front, gray, [0.0, 0.0, 0.5], 0.1),
        (front, [1.0, -1e-6, 1.0], wide, 0.1),
        (front, [1.0, f32::NAN, 1.0], wide, 0.1),
        (front, [1.0, f32::INFINITY, 1.0], wide, 0.1),
        ([0.0; 3], gray, wide, 0.1),
        ([0.0, 0.0, 1.01], gray, wide, 0.1),
        ([f32::NAN, 0.0, 1.0], gray, wide, 0.1),
    ] {
        assert_eq!(new(direction, energy, major, minor), Err(Error::Source), "{major:?} {minor}");
    }
    for spread in [-0.1, 0.51, f32::NAN] {
        assert_eq!(Source::round::<SinglePrecision>(front, gray, spread), Err(Error::Source));
    }
    assert_eq!(Source::round::<SinglePrecision>([0.0; 3], gray, 0.1), Err(Error::Source));

    // What is nearly right is made right.
    let source = new([0.6, 0.0, 0.8004], gray, [0.1, 0.1, 0.1], 0.05).expect("a source");
    let [direction, major] = [source.direction(), source.major()].map(|v| v.map(f64::from));
    assert!((dot(direction, direction) - 1.0).abs() < 6e-7 && dot(direction, major).abs() < 3e-8);
    for k in 0..50 {
        let direction = at(0.07 * f64::from(k), f64::from(k)).map(|x| x as f32);
        let source = Source::round::<SinglePrecision>(direction, gray, 0.2).expect("a source");
        let major = source.major().map(f64::from);
        assert!(
            (dot(major, major).sqrt() - 0.2).abs() < 1e-7 && (source.minor() - 0.2).abs() < 1e-7
        );
    }
}

#[test]
fn gloss_is_that_of_gltf() {
    let gloss = Gloss::metallic_roughness([0.5, 1.0, 0.0], 0.25, 0.6).expect("a material");
    assert!((gloss.alpha() - 0.36_f64).abs() <= 1e-15);
    for (found, expected) in
        [(gloss.reflectance(), [0.155, 0.28, 0.03]), (gloss.albedo(), [0.375, 0.75, 0.0])]
    {
        let found: [f64; 3] = found.into();
        assert!(found.iter().zip(expected).all(|(f, e)| (f - e).abs() <= 1e-15), "{found:?}");
    }
    assert_eq!(Gloss::new(0.0_f32, [0.0; 3], [0.0; 3]).map(|gloss| gloss.alpha()), Ok(0.1 * 0.1));
    let refused = |gloss: Result<Gloss<f32>, Error>, argument| {
        assert_eq!(gloss, Err(Error::Outside { argument }));
    };
    refused(Gloss::new(1.1, [0.0; 3], [0.0; 3]), Argument::Roughness);
    refused(Gloss::new(f32::NAN, [0.0; 3], [0.0; 3]), Argument::Roughness);
    refused(Gloss::new(0.5, [0.0, -0.1, 0.0], [0.0; 3]), Argument::Reflectance);
    refused(Gloss::new(0.5, [0.0; 3], [0.0, 0.0, 1.1]), Argument::Color);
    refused(Gloss::metallic_roughness([0.0, 1.1, 0.0], 0.5, 0.5), Argument::Color);
    refused(Gloss::metallic_roughness([0.0; 3], -0.5, 0.5), Argument::Metallic);
    refused(Gloss::metallic_roughness([0.0; 3], 0.5, 1.5), Argument::Roughness);
    for (color, metallic) in [(1.0_f32, 0.0), (1.0, 0.3), (1.0, 0.7), (1.0, 1.0), (0.0, 0.6)] {
        assert!(Gloss::metallic_roughness([color; 3], metallic, 0.5).is_ok(), "{color} {metallic}");
    }
}

/// Of f0 and of the matte base, what the coefficients of a glTF material are made of.
#[cfg(feature = "presets")]
#[test]
fn gloss_agrees_with_coefficients() {
    let color = [0.9, 0.4, 0.1];
    for metallic in [0.0, 0.3, 1.0] {
        let gloss = Gloss::metallic_roughness(color, metallic, 0.5).expect("a material");
        let shares = eigenshade::Material::metallic_roughness_shares(color, metallic);
        let shares = shares.expect("a material");
        let parts: [_; 3] = shares.zip(gloss.reflectance()).zip(gloss.albedo()).into();
        for (([matte, _, metal], f0), albedo) in parts {
            assert!((f0 - metal).abs() <= 1e-7 && (albedo * (1.0 - f0) - matte).abs() <= 1e-7);
        }
    }
}

/// Many normals at once, in whole blocks and not, give the bits of one by one, and are added.
#[test]
fn slices_are_the_sums_of_single_normals() {
    let material = Glossy { roughness: 0.3, f0: 0.5, albedo: 0.2 };
    let gloss: Gloss<f32> = material.gloss();
    let sources: Vec<_> =
        blobs(&[10.0, 120.0]).iter().map(|blob| blob.single([1.0, 2.0, 0.5])).collect();
    for count in [0, 1, 4, 10] {
        let highlights = Highlights::<f32, 10>::new::<SinglePrecision>(&gloss, &sources[..count]);
        let highlights = highlights.expect("room for ten");
        assert_eq!((highlights.len(), highlights.is_empty()), (count, count == 0));
        for length in [0, 1, 63, 64, 65, 300] {
            let normals: Vec<_> = disc(24).into_iter().take(length).collect();
            let [x, y, z] =
                [0, 1, 2].map(|k| normals.iter().map(|n| n[k] as f32).collect::<Vec<_>>());
            let list = Normals::new(&x, &y, &z).expect("one length");
            let before = Rgb::new(0.25, 0.5, 1.0);
            let mut irradiance = vec![before; length];
            highlights.add_slice(list, &mut irradiance).expect("one length");
            for (found, normal) in irradiance.iter().zip(list.iter()) {
                let Rgb { r, g, b } = highlights.shade(normal);
                assert_eq!(*found, Rgb::new(before.r + r, before.g + g, before.b + b));
            }
        }
        let mut short = [Rgb::gray(0.0)];
        let none = Normals::new(&[], &[], &[]).expect("one length");
        let refused = highlights.add_slice(none, &mut short);
        let expected = Error::Length { argument: Argument::Normals, expected: 0, found: 1 };
        assert_eq!(refused, Err(expected));
    }
    let refused = Highlights::<f32, 4>::new::<SinglePrecision>(&gloss, &sources[..5]);
    let expected = Error::Capacity { argument: Argument::Sources, needed: 5, capacity: 4 };
    assert_eq!(refused.map(|_| ()), Err(expected));
}

/// Sources at the rim, behind, at the pole and below; two that coincide; none and a million times the
/// energy: finite, not negative, and where a half-way direction exists, the formula's.
#[test]
fn hard_cases() {
    let degrees = [0.0, 1e-5, 89.99, 90.0, 90.01, 175.0, 177.0, 179.9, 180.0];
    for (roughness, tolerance) in [(0.1, 5e-5), (1.0, 4e-6)] {
        let material = Glossy { roughness, f0: 0.5, albedo: 0.5 };
        let gloss: Gloss<f32> = material.gloss();
        // D <= 1.35 / π α², as a lobe is at most √1.16 wide, V n·s <= 1 / 2 α, F <= 1.
        let alpha = material.alpha();
        let largest = 0.5 * 1.35 / (PI * alpha.powi(3)) + 1.0 / PI;
        let new = |sources: &[Source<f32>]| {
            Highlights::<f32, 2>::new::<SinglePrecision>(&gloss, sources).expect("room for two")
        };
        for blob in blobs(&degrees) {
            let source = blob.single([1.0; 3]);
            let [one, two, dark, bright] = [
                new(&[source]),
                new(&[source; 2]),
                new(&[blob.single([0.0; 3])]),
                new(&[blob.single([1e6; 3])]),
            ];
            let normals = normals_for(&blob, alpha);
            let expected: Vec<_> =
                normals.iter().map(|&normal| material.lobe(&blob, BLUR, normal)).collect();
            let peak = expected.iter().copied().fold(0.0, f64::max);
            let has_half_way = blob.direction[2] > -0.997;
            for (&normal, expected) in normals.iter().zip(expected) {
                let [single, double, none, million] =
                    [&one, &two, &dark, &bright].map(|highlights| shaded(highlights, normal).g);
                assert!(single.is_finite() && single >= 0.0, "{blob:?} {normal:?}: {single}");
                assert!((double - 2.0 * single).abs() <= 1e-6 * double, "{double}");
                assert!((million - 1e6 * single).abs() <= 2e-6 * million, "{million}");
                assert_eq!(none, 0.0);
                if has_half_way {
                    let off = (f64::from(single) - expected).abs();
                    assert!(off <= tolerance * peak, "{blob:?} {normal:?}: {single} {expected}");
                } else {
                    let found = f64::from(single);
                    assert!(found <= largest, "{blob:?} {normal:?}: {single}");
                }
            }
        }
    }
}

/// A light that turns: each source sets behind the rim and rises again, and the picture has no
/// sources that are not there.
#[test]
fn sources_set_and_rise() {
    let material = Glossy { roughness: 0.3, f0: 0.5, albedo: 0.5 };
    let source =
        Source::round::<SinglePrecision>([0.0, 0.0, 1.0], [1.0; 3], 0.02).expect("a source");
    let front: Normal<f32> = Normal::new(0.0, 0.0, 1.0).expect("a normal");
    for step in 0..=72 {
        let angle = step as f32 * 5.0_f32.to_radians();
        let rotation = Rotation::from_euler::<SinglePrecision>(0.3, angle, 0.0).expect("angles");
        let turned = source.turned(rotation);
        let highlights: Highlights<f32, 1> =
            Highlights::new::<SinglePrecision>(&material.gloss(), &[turned]).expect("room for one");
        let lit = highlights.shade(front).g;
        assert_eq!(lit > 0.0, turned.direction()[2] > 0.0, "{step}");
        for normal in disc(32) {
            let irradiance = shaded(&highlights, normal).g;
            let cosine = dot(turned.direction().map(f64::from), normal);
            assert!(irradiance.is_finite() && irradiance >= 0.0);
            assert!(cosine > -1e-6 || irradiance == 0.0, "{step} {normal:?}");
        }
    }
}
