//! Light of other programs. Their coefficients are sums over directions with each program's own
//! published functions, their shading is its published formula, and both are compared with a
//! quadrature of radiance times the cosine, and with pixels of this crate.

use crate::oracle::ExplicitLight;
use eigenshade::lights::Convention::{self, Cmgen, CmgenIrradiance, Filament, ThreeJs};
use eigenshade::{Argument, Error, Light, Rgb, sphere};
use eigenshade_model::reference::DirectSum;
use eigenshade_table::light;
use eigenshade_testing::fixtures::{normal, spiral};
use eigenshade_testing::images;
use eigenshade_testing::vectors::{self, cross, dot, scaled, unit};
use std::f64::consts::{PI, TAU};

/// Sums over 64 x 128 directions, and constants of six digits in the programs.
const SUMS: f64 = 2e-5;

/// The same, and the shipped table's 46 components on a matte: 1.5e-4 found.
const OF_TABLE: f64 = 2e-4;

const CONVENTIONS: [Convention; 4] = [ThreeJs, Cmgen, CmgenIrradiance, Filament];

/// Radiance of degree 2 without any symmetry. In these terms nothing is lost above degree 2.
fn radiance([x, y, z]: [f64; 3]) -> f64 {
    2.0 + 0.4 * x - 0.3 * y + 0.5 * z + 0.6 * x * y - 0.2 * y * z
        + 0.25 * x * z
        + 0.35 * (x * x - y * y)
        + 0.2 * z * z
}

/// Directions and solid angles: Simpson's weights in z, equal ones in the azimuth.
fn directions() -> impl Iterator<Item = ([f64; 3], f64)> {
    let (heights, azimuths) = (64, 128);
    (0..=heights).flat_map(move |k| {
        let z = 2.0 * f64::from(k) / f64::from(heights) - 1.0;
        let weight = match k {
            0 | 64 => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let solid_angle = 2.0 / f64::from(heights) / 3.0 * weight * TAU / f64::from(azimuths);
        (0..azimuths).map(move |j| {
            let (sine, cosine) = (TAU * (f64::from(j) + 0.5) / f64::from(azimuths)).sin_cos();
            let across = (1.0 - z * z).max(0.0).sqrt();
            ([across * cosine, across * sine, z], solid_angle)
        })
    })
}

/// `SphericalHarmonics3.getBasisAt` of three.js r187, src/math/SphericalHarmonics3.js.
fn three_js([x, y, z]: [f64; 3]) -> [f64; 9] {
    [
        0.282095,
        0.488603 * y,
        0.488603 * z,
        0.488603 * x,
        1.092548 * x * y,
        1.092548 * y * z,
        0.315392 * (3.0 * z * z - 1.0),
        1.092548 * x * z,
        0.546274 * (x * x - y * y),
    ]
}

/// `CubemapSH::TSH` of Filament, libs/ibl/src/CubemapSH.cpp.
fn filament([x, y, z]: [f64; 3]) -> [f64; 9] {
    let root = PI.sqrt();
    [
        1.0 / (2.0 * root),
        -(3f64.sqrt() * y) / (2.0 * root),
        (3f64.sqrt() * z) / (2.0 * root),
        -(3f64.sqrt() * x) / (2.0 * root),
        (15f64.sqrt() * y * x) / (2.0 * root),
        -(15f64.sqrt() * y * z) / (2.0 * root),
        (5f64.sqrt() * (3.0 * z * z - 1.0)) / (4.0 * root),
        -(15f64.sqrt() * z * x) / (2.0 * root),
        (15f64.sqrt() * (x * x - y * y)) / (4.0 * root),
    ]
}

/// `CubemapSH::computeTruncatedCosSh`, of each coefficient.
const COSINE: [f64; 9] = {
    let [a, b, c] = [PI, 2.0 * PI / 3.0, PI / 4.0];
    [a, b, b, b, c, c, c, c, c]
};

/// What each program computes for a light.
fn coefficients(convention: Convention, light: impl Fn([f64; 3]) -> f64) -> [f64; 9] {
    let mut sums = [0.0; 9];
    for (direction, solid_angle) in directions() {
        let basis = match convention {
            ThreeJs => three_js(direction),
            _ => filament(direction),
        };
        for (sum, value) in sums.iter_mut().zip(basis) {
            *sum += light(direction) * value * solid_angle;
        }
    }
    // `CubemapSH::computeSH` for irradiance, and `preprocessSHForShader`, whose A are the norms of
    // `TSH` with their signs.
    let norm = filament([1.0, 1.0, 1.0]);
    let plane = filament([1.0, 0.0, 0.0])[8];
    for (i, sum) in sums.iter_mut().enumerate() {
        let norm = match i {
            6 => 0.5 * norm[6],
            8 => plane,
            _ => norm[i],
        };
        match convention {
            CmgenIrradiance => *sum *= COSINE[i],
            Filament => *sum *= COSINE[i] * norm / PI,
            _ => {}
        }
    }
    sums
}

fn wide(light: &[f32]) -> Vec<f64> {
    light.iter().map(|&number| number.into()).collect()
}

/// What each program's shader makes of its coefficients: irradiance over π.
fn shaded(convention: Convention, c: &[f64; 9], normal: [f64; 3]) -> f64 {
    let [x, y, z] = normal;
    let sum = |values: [f64; 9]| -> f64 { c.iter().zip(values).map(|(c, value)| c * value).sum() };
    match convention {
        // `getIrradianceAt`, divided by π as in `BRDF_Lambert`.
        ThreeJs => {
            let [c1, c2] = [2.0 * 0.429043, 2.0 * 0.511664];
            let first = [0.886227, c2 * y, c2 * z, c2 * x, c1 * x * y, c1 * y * z];
            let [a, b, d, e, f, g] = first;
            let upright = 0.743125 * z * z - 0.247708;
            sum([a, b, d, e, f, g, upright, c1 * x * z, 0.429043 * (x * x - y * y)]) / PI
        }
        // `Irradiance_SphericalHarmonics` of shaders/src/light_indirect.fs.
        Filament => sum([1.0, y, z, x, y * x, y * z, 3.0 * z * z - 1.0, z * x, x * x - y * y]),
        // `renderSH`, which divides by π.
        CmgenIrradiance => sum(filament(normal)) / PI,
        _ => {
            let basis = filament(normal);
            sum([0, 1, 2, 3, 4, 5, 6, 7, 8].map(|i| basis[i] * COSINE[i])) / PI
        }
    }
}

/// The irradiance over π by quadrature.
fn irradiance(light: impl Fn([f64; 3]) -> f64, normal: [f64; 3]) -> f64 {
    // The cosine has a kink, so the quadrature is taken in a frame along the normal.
    let side = if normal[0].abs() < 0.5 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let first = unit(cross(normal, side));
    let second = cross(normal, first);
    let (rings, turns) = (200, 32);
    let mut sum = 0.0;
    for ring in 0..rings {
        // Equal shares of cos θ dω.
        let sine = ((f64::from(ring) + 0.5) / f64::from(rings)).sqrt();
        let cosine = (1.0 - sine * sine).sqrt();
        for turn in 0..turns {
            let (v, u) = (TAU * f64::from(turn) / f64::from(turns)).sin_cos();
            let across = [0, 1, 2].map(|i| u * first[i] + v * second[i]);
            sum += light(vectors::sum(scaled(normal, cosine), sine, across));
        }
    }
    sum / f64::from(rings * turns)
}

/// Of equal areas on the disc, from its center.
fn normals() -> Vec<[f64; 3]> {
    spiral((0..40).map(|k| (1.0 - (f64::from(k) + 0.5) / 40.0).sqrt()))
}

#[test]
fn a_matte_sphere_is_as_bright_as_there() {
    for convention in CONVENTIONS {
        let numbers = coefficients(convention, radiance);
        let light = Light::from_graphics::<9>(convention, &numbers.map(|x| x as f32)).unwrap();
        let sum = DirectSum::new(2, 0);
        let scene = sphere::collapse(&images::coefficients(&light, &[2.0]));
        let light = wide(&light);
        for at in normals() {
            let expected = irradiance(radiance, at);
            let modes = sum.at(at);
            let here = modes.irradiance(&light, &modes.scatter(&[2.0]));
            // The formula is the program's.
            for found in [shaded(convention, &numbers, at), here] {
                let off = (found - expected).abs();
                assert!(off <= SUMS * expected, "{convention:?}: {found} {expected}");
            }
            let pixel = f64::from(scene.shade(normal(at)));
            let off = (pixel - expected).abs();
            assert!(off <= OF_TABLE * expected, "{convention:?}: {pixel} {expected}");
        }
    }
}

/// A lamp in each of several directions comes out there, and nowhere else.
#[test]
fn a_patch_of_light_stays_where_it_is() {
    for lamp in [[0.6, 0.64, 0.48], [-0.8, 0.36, -0.48], [0.0, -1.0, 0.0], [0.36, -0.48, 0.8]] {
        // A lobe of about 20 degrees, wide enough for the sums.
        let patch = |direction| (20.0 * (dot(direction, lamp) - 1.0)).exp();
        for convention in CONVENTIONS {
            let numbers = coefficients(convention, patch);
            let light = Light::from_graphics::<9>(convention, &numbers.map(|x| x as f32)).unwrap();
            let light = ExplicitLight::new(&wide(&light));
            let lit = directions().map(|(direction, _)| (light.radiance(direction), direction));
            let (_, brightest) = lit.max_by(|(a, _), (b, _)| a.total_cmp(b)).unwrap();
            // The grid has 2.8 degrees.
            assert!(dot(brightest, lamp) > 0.998, "{convention:?}: {brightest:?} {lamp:?}");
        }
    }
}

#[test]
fn conversions_are_inverse() {
    let numbers: [f32; 9] = [3.0, -0.5, 0.25, 1.5, 0.3, -0.7, 0.1, 0.9, -0.2];
    for convention in CONVENTIONS {
        let light = Light::from_graphics::<9>(convention, &numbers).unwrap();
        let back = Light::new(&light).unwrap().to_graphics::<9>(convention).unwrap();
        for (back, number) in back.iter().zip(numbers) {
            assert!((back - number).abs() <= 5e-7, "{convention:?}");
        }
        let rows = numbers.map(|number| [number, 2.0 * number, -number]);
        let color = Rgb::<Light<'_>>::from_graphics::<9>(convention, &rows).unwrap();
        assert_eq!(color.r, light);
        assert!(color.g.iter().zip(light.iter()).all(|(a, b)| *a == 2.0 * b));
        assert!(color.b.iter().zip(light.iter()).all(|(a, b)| *a == -b));
    }
}

/// Beyond degree 2: Filament's recurrence for P_l^m with the factor (1 - 2m), its cos mφ and
/// sin |m|φ, against the harmonics of this crate.
#[test]
fn higher_degrees_of_cmgen_have_its_harmonics() {
    let direction @ [x, y, z] = [0.48, -0.6, 0.64_f64];
    for (l, m) in light::indices(5) {
        let order = m.unsigned_abs();
        // `CubemapSH::computeShBasis` and `Kml`.
        let (mut before, mut now) = (0.0, (1..=order).fold(1.0, |p, k| p * (1.0 - 2.0 * k as f64)));
        for k in order + 1..=l {
            let next = (2 * k - 1) as f64 * now * z - (k + order - 1) as f64 * before;
            (before, now) = (now, next / (k - order) as f64);
        }
        let (mut cosine, mut sine) = (1.0, 0.0);
        for _ in 0..order {
            (cosine, sine) = (cosine * x - sine * y, sine * x + cosine * y);
        }
        let factorials: f64 = (l - order + 1..=l + order).map(|k| k as f64).product();
        let norm = ((2 * l + 1) as f64 / (4.0 * PI) / factorials).sqrt();
        let value = match m {
            0 => norm * now,
            m if m > 0 => 2f64.sqrt() * norm * now * cosine,
            _ => 2f64.sqrt() * norm * now * sine,
        };
        let mut numbers = [0.0; 36];
        numbers[light::position(l, m)] = 1.0;
        let light = Light::from_graphics::<36>(Cmgen, &numbers).unwrap();
        let here = ExplicitLight::new(&wide(&light)).radiance(direction);
        assert!((here - value).abs() < 1e-12, "{l} {m}: {here} {value}");
    }
}

/// A light that is published in this convention: Grace Cathedral, from R. Rost, "OpenGL Shading
/// Language", second edition, 2006, with the book's formula.
#[test]
fn published_nine_terms_are_read() {
    const GRACE: [[f32; 3]; 9] = [
        [0.78908, 0.43710, 0.54161],
        [0.39499, 0.34989, 0.60488],
        [-0.33974, -0.18236, -0.26940],
        [-0.29213, -0.05562, 0.00944],
        [-0.11141, -0.05090, -0.12231],
        [-0.26240, -0.22401, -0.47479],
        [-0.15570, -0.09471, -0.14733],
        [0.56014, 0.21444, 0.13915],
        [0.21205, -0.05432, -0.30374],
    ];
    let light = Rgb::<Light<'_>>::from_graphics::<9>(ThreeJs, &GRACE).unwrap();
    let sum = DirectSum::new(2, 0);
    for normal in normals() {
        let [x, y, z] = normal;
        let modes = sum.at(normal);
        for (channel, light) in <[_; 3]>::from(light.clone()).iter().enumerate() {
            let [l00, l1m1, l10, l11, l2m2, l2m1, l20, l21, l22] =
                GRACE.map(|row| f64::from(row[channel]));
            let [c1, c2, c3, c4, c5] = [0.429043, 0.511664, 0.743125, 0.886227, 0.247708];
            let expected = c1 * l22 * (x * x - y * y) + c3 * l20 * z * z + c4 * l00 - c5 * l20
                + 2.0 * c1 * (l2m2 * x * y + l21 * x * z + l2m1 * y * z)
                + 2.0 * c2 * (l11 * x + l1m1 * y + l10 * z);
            let found = PI * modes.irradiance(&wide(light), &modes.scatter(&[2.0]));
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
    }
}

#[test]
fn coefficients_that_mean_nothing_are_refused() {
    let (sixteen, error) =
        ([1.0; 16], Error::Beyond { argument: Argument::Irradiance, most: 2, found: 3 });
    for convention in [CmgenIrradiance, Filament] {
        assert_eq!(Light::from_graphics::<16>(convention, &sixteen), Err(error));
        let light = Light::new(&sixteen).unwrap();
        assert_eq!(light.to_graphics::<16>(convention), Err(error));
        assert!(light.truncated(2).to_graphics::<9>(convention).is_ok());
    }
    assert!(Light::from_graphics::<16>(Cmgen, &sixteen).is_ok());
    let eight = Light::from_graphics::<9>(ThreeJs, &[1.0; 8]);
    assert!(matches!(eight, Err(Error::Count { found: 8, .. })), "{eight:?}");
    let capacity = Light::from_graphics::<4>(ThreeJs, &[1.0; 9]);
    assert!(matches!(capacity, Err(Error::Capacity { needed: 9, .. })), "{capacity:?}");
    let infinite = Light::from_graphics::<4>(Filament, &[1.0, 0.0, f32::INFINITY, 0.0]);
    assert!(matches!(infinite, Err(Error::NotFinite { index: 2, .. })), "{infinite:?}");
    let text = error.to_string();
    assert!(text.contains("degree 3") && text.contains("first 9"), "{text}");
}
