//! Materials of metallic and roughness, from the runtime's series, against projections of the formula
//! itself.

use eigenshade::index::material::indices;
use eigenshade::presets::light;
use eigenshade::quantized;
use eigenshade::sphere;
use eigenshade::{Argument, Buffer, Error, Material, Q15, Rgb};
use eigenshade_generator::material::brdf::projection::project;
use eigenshade_generator::material::brdf::{Ggx, Measure};

/// The largest difference of a pixel, relative to the picture's largest irradiance.
const OF_A_PICTURE: f64 = 1e-3;

/// The same of coefficients in Q15, drawn in f32, as pixels in Q15 have errors of their own. Where the
/// polynomials cancel, the rounding of the first ones shows.
const IN_Q15: f64 = 1.5e-3;

/// The length of the difference of coefficients of order 12, relative to the length of all of them, in
/// f32 and in Q15.
const OF_ORDER_12: [f64; 2] = [1e-3, 2e-3];

const COLORS: [[f32; 3]; 2] = [[1.0, 0.766, 0.336], [0.0, 0.02, 0.5]];
const METALLIC: [f32; 3] = [0.0, 0.5, 1.0];
/// Between the series' nodes, and at its ends.
const ROUGHNESS: [f32; 8] = [0.2, 0.213, 0.247, 0.3, 0.41, 0.55, 0.77, 1.0];

/// The formula's coefficients in each channel, as glTF 2.0, appendix B, defines its parameters.
fn formula(color: [f32; 3], metallic: f32, roughness: f32, order: usize) -> [Vec<f64>; 3] {
    color.map(|base| {
        let (base, metallic) = (f64::from(base), f64::from(metallic));
        let f0 = 0.04 * (1.0 - metallic) + base * metallic;
        let ggx = Ggx::new(f64::from(roughness), f0, base * (1.0 - metallic)).unwrap();
        project(&ggx, order, Measure::Projected).coefficients
    })
}

fn fixed(number: f32) -> Q15 {
    Q15((number * 32_768.0).round().min(32_767.0) as i16)
}

/// The coefficients of a material in integers.
fn values(material: quantized::Material<'_, Q15>) -> impl Iterator<Item = f64> {
    let of_order = move |(index, mantissa): ((usize, usize, usize), &Q15)| {
        let exponent = material.exponents()[index.0];
        f64::from(mantissa.0) * f64::from(exponent).exp2()
    };
    indices(material.exponents().len() - 1).zip(material.mantissas()).map(of_order)
}

/// The length of the difference, relative to that of the second.
fn from(found: &[f64], expected: &[f64]) -> f64 {
    let length = |squares: f64| squares.sqrt();
    let apart = found.iter().zip(expected).map(|(a, b)| (a - b) * (a - b)).sum();
    length(apart) / length(expected.iter().map(|b| b * b).sum())
}

fn normals() -> Vec<[f64; 3]> {
    crate::spread(200).into_iter().filter(|[.., z]| *z > 0.0).collect()
}

/// The largest difference of two pictures in color, relative to the largest value of the second.
fn apart(found: &[[f64; 3]], expected: &[[f64; 3]]) -> f64 {
    let pairs = found.as_flattened().iter().zip(expected.as_flattened());
    let largest = expected.as_flattened().iter().fold(0.0f64, |most, value| most.max(value.abs()));
    pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / largest
}

fn picture(
    light: Rgb<eigenshade::Light<'_, f32>>,
    material: Rgb<Material<'_, f32>>,
) -> Vec<[f64; 3]> {
    let scene = sphere::color::scene(light, material).unwrap();
    let shade = |normal: [f64; 3]| {
        let [x, y, z] = normal.map(|component| component as f32);
        let color = scene.shade(eigenshade::Normal::new(x, y, z).unwrap());
        <[f32; 3]>::from(color).map(f64::from)
    };
    normals().into_iter().map(shade).collect()
}

#[test]
fn pictures_are_those_of_the_formula() {
    let mut worst = [0.0f64; 2];
    for roughness in ROUGHNESS {
        for (color, metallic) in COLORS.iter().flat_map(|color| METALLIC.map(|m| (*color, m))) {
            let expected = formula(color, metallic, roughness, 7)
                .map(|channel| channel.iter().map(|&b| b as f32).collect::<Vec<f32>>());
            let [r, g, b] = &expected;
            let expected = Rgb::new(r, g, b).map(|channel| Material::new(channel).unwrap());
            let found = Material::metallic_roughness(color, metallic, roughness).unwrap();

            let in_integers = quantized::Material::metallic_roughness(
                color.map(fixed),
                fixed(metallic),
                fixed(roughness),
            )
            .unwrap();
            let rounded = in_integers.map(|channel| {
                let values = values(channel.material().unwrap());
                Buffer::<f32, 40>::from_slice(&values.map(|b| b as f32).collect::<Vec<f32>>())
                    .unwrap()
            });
            for (_, light) in light::ALL.iter().step_by(5) {
                let exact = picture(*light, expected);
                let error = apart(&picture(*light, found.materials().unwrap()), &exact);
                let of_q15 = apart(&picture(*light, rounded.materials().unwrap()), &exact);
                worst = [worst[0].max(error), worst[1].max(of_q15)];
                assert!(error <= OF_A_PICTURE, "{color:?} {metallic} {roughness}: {error}");
                assert!(of_q15 <= IN_Q15, "Q15: {color:?} {metallic} {roughness}: {of_q15}");
            }
        }
    }
    println!("metallic and roughness: {:.1e}, in Q15 {:.1e}", worst[0], worst[1]);
}

#[test]
fn coefficients_of_order_12_are_those_of_the_formula() {
    let mut worst = [0.0f64; 2];
    for roughness in ROUGHNESS {
        for metallic in METALLIC {
            let expected = formula(COLORS[0], metallic, roughness, 12);
            let found =
                Material::metallic_roughness_of_order_12(COLORS[0], metallic, roughness).unwrap();
            let integers = quantized::Material::metallic_roughness_of_order_12(
                COLORS[0].map(fixed),
                fixed(metallic),
                fixed(roughness),
            )
            .unwrap();
            let channels = <[_; 3]>::from(found).into_iter().zip(<[_; 3]>::from(integers));
            for ((found, integers), expected) in channels.zip(expected) {
                let found = found.iter().map(|&b| f64::from(b)).collect::<Vec<f64>>();
                let of_q15 = values(integers.material().unwrap()).collect::<Vec<f64>>();
                let errors = [found, of_q15].map(|found| from(&found, &expected));
                worst = [0, 1].map(|k| worst[k].max(errors[k]));
                assert!(errors[0] <= OF_ORDER_12[0], "{metallic} {roughness}: {errors:?}");
                assert!(errors[1] <= OF_ORDER_12[1], "{metallic} {roughness}: {errors:?}");
            }
        }
    }
    println!("order 12: {:.1e} of the coefficients, in Q15 {:.1e}", worst[0], worst[1]);
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
    }
    let found = quantized::Material::metallic_roughness([Q15(1); 3], Q15(1), Q15(-1));
    assert_eq!(found.unwrap_err(), Error::Outside { argument: Argument::Roughness });
    // Smoother than the series: as its smoothest.
    assert_eq!(
        Material::metallic_roughness([0.5; 3], 1.0, 0.0),
        Material::metallic_roughness([0.5; 3], 1.0, 0.2)
    );
}
