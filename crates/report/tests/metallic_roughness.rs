//! The runtime's materials of metallic and roughness, against projections of the formula itself.

use crate::assert_recorded;
use crate::support::{Folder, numbers, rows};
use eigenshade::presets::light::PARK;
use eigenshade::{Argument, Error, Material, Normal, Q15, Transfer, q15, sphere};
use eigenshade_generator::material::brdf::projection::project_orders;
use eigenshade_generator::material::brdf::{Ggx, Measure};
use eigenshade_model::reference::DirectSum;
use eigenshade_model::shipped;
use eigenshade_table::material::{count, indices};
use eigenshade_testing::fixtures::spiral;

/// The largest difference of a pixel in f32, relative to the largest irradiance of the channel.
const OF_A_PICTURE: f64 = 6e-4;
/// The same of coefficients in Q15, drawn in f64.
const IN_Q15: f64 = 8e-4;
/// The same of the formula's own coefficients, rounded to Q15: what no material in Q15 avoids.
const OF_ROUNDING: f64 = 5e-4;
/// The difference of coefficients in f32, of their norm: of the series, worst at roughness 1.
const OF_COEFFICIENTS: f64 = 2e-4;
/// A sum of three transfers against the transfer of the sum, of the largest pixel.
const OF_TRANSFERS: f32 = 2e-6;
/// The orders of the series, with the degree of the light.
const SIZES: [(usize, usize); 2] = [(9, 7), (12, 12)];
/// From black to white, and the reflectance of dielectrics.
const BASE: [f32; 6] = [0.0, 0.02, 0.04, 0.2, 0.5, 1.0];
const METALLIC: [f32; 4] = [0.0, 0.3, 0.7, 1.0];
/// Ranges of roughness, with roughnesses between the nodes of the series and at its ends.
const ROUGHNESS: [&[f32]; 5] = [
    &[0.2, 0.202, 0.208, 0.219, 0.23, 0.245],
    &[0.26, 0.28, 0.3, 0.32, 0.345],
    &[0.37, 0.4, 0.43, 0.47],
    &[0.52, 0.57, 0.63, 0.7],
    &[0.75, 0.8, 0.86, 0.93, 0.98, 1.0],
];

/// Normals of equal shares of the disc, from the axis to the rim.
fn normals(count: usize) -> Vec<[f64; 3]> {
    spiral((0..count).map(|k| (1.0 - (k as f64 + 0.5) / count as f64).sqrt()))
}

/// Pixels as sums over a material's coefficients: by light, by normal and by coefficient.
fn pixels((degree, order): (usize, usize)) -> Vec<Vec<Vec<f64>>> {
    // The worst pixels lie at the rim: the outermost have z = 0.028.
    let normals = normals(640);
    let lights = shipped::lights().unwrap().truncated(degree).entries;
    let lights: Vec<&Vec<f64>> = lights.iter().step_by(5).map(|light| &light.rgb[1]).collect();
    let sum = DirectSum::new(degree, order);
    let mut pixels = vec![vec![vec![0.0; count(order)]; normals.len()]; lights.len()];
    for (n, &normal) in normals.iter().enumerate() {
        let modes = sum.at(normal);
        for i in 0..count(order) {
            let mut unit = vec![0.0; count(order)];
            unit[i] = 1.0;
            let scattered = modes.scatter(&unit);
            for (pixels, light) in pixels.iter_mut().zip(&lights) {
                pixels[n][i] = modes.irradiance(light, &scattered);
            }
        }
    }
    pixels
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The largest difference of a pixel under any light, relative to the picture's largest.
fn apart(pixels: &[Vec<Vec<f64>>], found: &[f64], expected: &[f64]) -> f64 {
    let difference: Vec<f64> = found.iter().zip(expected).map(|(a, b)| a - b).collect();
    let largest = |picture: &[Vec<f64>], b: &[f64]| {
        picture.iter().fold(0.0, |most: f64, pixel| most.max(product(pixel, b).abs()))
    };
    let of_light =
        |picture: &Vec<Vec<f64>>| largest(picture, &difference) / largest(picture, expected);
    pixels.iter().map(of_light).fold(0.0, f64::max)
}

/// The formula's coefficients of both orders, as glTF 2.0, appendix B, defines its parameters.
fn formula(roughness: f32, f0: f64, albedo: f64) -> [Vec<f64>; 2] {
    let ggx = Ggx::new(f64::from(roughness), f0, albedo).unwrap();
    let orders = SIZES.map(|(_, order)| order);
    let found = project_orders(&ggx, &orders, Measure::Projected);
    [0, 1].map(|k: usize| found[k].coefficients.clone())
}

/// The coefficients of a material in integers.
fn values(material: q15::Material<'_>) -> Vec<f64> {
    let of_order = |(index, mantissa): ((usize, usize, usize), &Q15)| {
        let exponent = material.exponents()[index.0];
        f64::from(mantissa.0) * f64::from(exponent).exp2()
    };
    indices(material.exponents().len() - 1).zip(material.mantissas()).map(of_order).collect()
}

/// Coefficients rounded to Q15.
fn rounded(exact: &[f64], order: usize) -> Vec<f64> {
    let from: Vec<f32> = exact.iter().map(|&b| b as f32).collect();
    let (mut mantissas, mut exponents) = (vec![Q15(0); from.len()], vec![0; order + 1]);
    values(q15::Material::quantize(&from, &mut mantissas, &mut exponents).unwrap())
}

fn wide(numbers: &[f32]) -> Vec<f64> {
    numbers.iter().map(|&b| f64::from(b)).collect()
}

fn fixed(number: f32) -> Q15 {
    Q15((number * 32_768.0).round().min(32_767.0) as i16)
}

/// The coefficients of a gray material in f32 and in Q15, at the order of each size.
fn of_runtime(size: usize, base: f32, metallic: f32, roughness: f32) -> [Vec<f64>; 2] {
    type Fixed = q15::Material<'static>;
    let color = [base; 3];
    let [q_color, q_metallic, q_roughness] = [base, metallic, roughness].map(fixed);
    let q_color = [q_color; 3];
    if size == 0 {
        let float = Material::metallic_roughness(color, metallic, roughness).unwrap();
        let integer = Fixed::metallic_roughness(q_color, q_metallic, q_roughness).unwrap();
        [wide(&float.g), values(integer.g.material().unwrap())]
    } else {
        let float = Material::metallic_roughness_of_order_12(color, metallic, roughness).unwrap();
        let integer =
            Fixed::metallic_roughness_of_order_12(q_color, q_metallic, q_roughness).unwrap();
        [wide(&float.g), values(integer.g.material().unwrap())]
    }
}

/// Every picture of one channel: the exact coefficients are sums of three projections, which the
/// test below compares with projections of whole materials.
#[test]
fn pictures_are_those_of_the_formula_over_all_parameters() {
    let pixels = SIZES.map(pixels);
    let [bare, over_matte] = [0.0, 1.0].map(|albedo| formula(1.0, 0.0, albedo));
    let mut rows = Vec::new();
    let mut failures = Vec::new();
    for range in ROUGHNESS {
        let mut worst = [[0.0f64; 3]; 2];
        for &roughness in range {
            let [rim, whole] = [0.0, 1.0].map(|f0| formula(roughness, f0, 0.0));
            for (base, metallic) in BASE.into_iter().flat_map(|base| METALLIC.map(|m| (base, m))) {
                let [a, m] = [base, metallic].map(f64::from);
                let f0 = 0.04 * (1.0 - m) + a * m;
                for size in 0..2 {
                    let of = |i: usize| {
                        let (matte, rim) = (over_matte[size][i] - bare[size][i], rim[size][i]);
                        a * (1.0 - m) * (1.0 - f0) * matte + rim + f0 * (whole[size][i] - rim)
                    };
                    let expected: Vec<f64> = (0..rim[size].len()).map(of).collect();
                    let [float, integer] = of_runtime(size, base, metallic, roughness);
                    let found = [float, integer, rounded(&expected, SIZES[size].1)];
                    for (format, found) in found.iter().enumerate() {
                        let error = apart(&pixels[size], found, &expected);
                        worst[size][format] = worst[size][format].max(error);
                        if error > [OF_A_PICTURE, IN_Q15, OF_ROUNDING][format] {
                            failures.push(format!(
                                "order {}, format {format}: {base} {metallic} {roughness}: {error:.1e}",
                                SIZES[size].1
                            ));
                        }
                    }
                }
            }
        }
        let [first, last] = [range[0], range[range.len() - 1]];
        let numbers = worst.as_flattened().iter().map(|error| format!("{error:.1e}"));
        rows.push(std::iter::once(format!("{first} to {last}")).chain(numbers).collect());
    }
    assert!(failures.is_empty(), "{}: {:#?}", failures.len(), &failures[..failures.len().min(20)]);
    let columns = "roughness,order 7: f32,order 7: Q15,order 7: only rounded,order 12: f32,\
                   order 12: Q15,order 12: only rounded";
    assert_recorded("metallic-roughness.csv", columns, &rows);
}

/// The program's `material ggx` projects whole materials.
#[test]
fn the_program_has_the_same_numbers() {
    let folder = Folder::new();
    for (base, metallic, roughness) in [(0.5, 0.0, 0.37), (0.9, 1.0, 0.62), (0.3, 0.5, 0.25)] {
        let f0 = 0.04 * (1.0 - metallic) + base * metallic;
        let albedo = base * (1.0 - metallic);
        let text = folder.ok(&format!(
            "material ggx --roughness {roughness} --f0 {f0} --albedo {albedo} --order 7"
        ));
        let expected = numbers(&rows(&text, "name,o,p,q,value"), 1);
        let [found, _] = of_runtime(0, base as f32, metallic as f32, roughness as f32);
        let length = product(&expected, &expected).sqrt();
        let square: f64 = found.iter().zip(&expected).map(|(a, b)| (a - b) * (a - b)).sum();
        println!("{base} {metallic} {roughness}: {:.1e} of |b|", square.sqrt() / length);
        assert!(square.sqrt() <= OF_COEFFICIENTS * length);
    }
}

/// A transfer is linear in the material.
#[test]
fn transfers_of_the_parts_add_up() {
    let [matte, rim, metal] = Material::metallic_roughness_parts(0.35).unwrap();
    let parts = [matte, rim, metal].map(|b| sphere::transfer(&Material::new(&b).unwrap()).unwrap());
    for (color, metallic) in [([0.93, 0.52, 0.38], 1.0), ([0.1, 0.6, 0.9], 0.25)] {
        let shares = Material::metallic_roughness_shares(color, metallic).unwrap();
        let transfer = shares.try_map(|shares| Transfer::sum(parts.each_ref(), shares)).unwrap();
        let found = sphere::color::relight(&transfer, PARK).unwrap();
        let material = Material::metallic_roughness(color, metallic, 0.35).unwrap();
        let expected = sphere::color::scene(PARK, material.materials().unwrap()).unwrap();
        let (mut peak, mut worst) = (0.0f32, 0.0f32);
        for [x, y, z] in normals(200) {
            let normal = Normal::new(x as f32, y as f32, z as f32).unwrap();
            let (found, expected) = (found.shade(normal), expected.shade(normal));
            peak = peak.max(expected.g.abs());
            worst = worst.max((found.g - expected.g).abs());
        }
        println!("transfers: {:.1e}", worst / peak);
        assert!(worst <= OF_TRANSFERS * peak, "{worst}");
    }
    let twelve = Material::metallic_roughness_parts_of_order_12(0.35).unwrap();
    let whole = Material::metallic_roughness_of_order_12([1.0; 3], 1.0, 0.35).unwrap();
    let sum = twelve[1].iter().zip(twelve[2].iter()).map(|(a, b)| a + b);
    assert!(sum.zip(whole.r.iter()).all(|(a, b)| (a - b).abs() < 1e-6));
}

#[test]
fn parameters_outside_their_range_are_refused() {
    let refused = [
        ([1.0, 1.5, 0.0], 0.0, 0.5, Argument::Color),
        ([1.0, f32::NAN, 0.0], 0.0, 0.5, Argument::Color),
        ([1.0; 3], -0.1, 0.5, Argument::Metallic),
        ([1.0; 3], 0.0, f32::INFINITY, Argument::Roughness),
    ];
    for (color, metallic, roughness, argument) in refused {
        let found = Material::metallic_roughness(color, metallic, roughness);
        assert_eq!(found.unwrap_err(), Error::Outside { argument });
        let [shares, parts] = [
            Material::metallic_roughness_shares(color, metallic).err(),
            Material::metallic_roughness_parts(roughness).err(),
        ];
        assert_eq!(shares.or(parts), Some(Error::Outside { argument }));
    }
    let found = q15::Material::metallic_roughness([Q15(1); 3], Q15(1), Q15(-1));
    assert_eq!(found.unwrap_err(), Error::Outside { argument: Argument::Roughness });
    // Smoother than the series: as its smoothest.
    assert_eq!(
        Material::metallic_roughness([0.5; 3], 1.0, 0.0),
        Material::metallic_roughness([0.5; 3], 1.0, 0.2)
    );
}
