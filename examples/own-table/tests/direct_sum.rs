//! The images of the crate's own table against direct quadrature of the irradiance of its
//! scene's materials.

use eigenshade_testing::oracle;

use eigenshade::{Light, Material, Normal, Q15, q15};
use own_table::table;

/// Images of forty components in f32 against direct quadrature, of the peak: what the other
/// components have.
const OWN_TABLE_F32: f64 = 2e-6;

/// The same in 15 bits: 65 dB and more below the image, at a single normal.
const OWN_TABLE_Q15: f64 = 6e-4;

/// The coefficients of a name in the shipped databases, the first columns skipped.
fn row(file: &str, name: &str, count: usize) -> Vec<f64> {
    let path = format!("{}/../../tables/inputs/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("a shipped file");
    let rows = text.lines().filter(|line| line.starts_with(&format!("{name},")));
    let column =
        |line: &str| line.split(',').nth(if file == "lights.csv" { 3 } else { 4 })?.parse().ok();
    rows.take(count).map(|line| column(line).expect("a number")).collect()
}

#[test]
fn images_are_those_of_the_scene() {
    let light = row("lights.csv", "venice", eigenshade_table::light::count(3));
    let reference = oracle::ExplicitLight::new(&light);
    let mut numbers = oracle::Numbers(3);
    let normals: Vec<[f64; 3]> = (0..40).map(|_| numbers.normal()).collect();
    for name in ["10-plaster-a", "07-velvet", "ptfe-633nm"] {
        let material = row("materials.csv", name, eigenshade_table::material::count(4));
        let indices = eigenshade_table::material::indices(4).zip(&material);
        let brdf: Vec<_> = indices.map(|((o, p, q), &b)| (o, p, q, b)).collect();
        let expected: Vec<f64> =
            normals.iter().map(|&normal| oracle::irradiance(&reference, &brdf, normal)).collect();
        let peak = expected.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        let rounded = |values: &[f64]| values.iter().map(|&x| x as f32).collect::<Vec<_>>();
        let (light, material) = (rounded(&light), rounded(&material));
        let (floats, integers) = (floats(&light, &material), integers(&light, &material));
        for (normal, expected) in normals.iter().zip(expected) {
            let apart = (floats(*normal) - expected).abs() / peak;
            assert!(apart <= OWN_TABLE_F32, "{name}: {apart}");
            let apart = (integers(*normal) - expected).abs() / peak;
            assert!(apart <= OWN_TABLE_Q15, "{name} in integers: {apart}");
        }
    }
}

fn floats(light: &[f32], material: &[f32]) -> impl Fn([f64; 3]) -> f64 {
    let light = Light::new(light).expect("sixteen coefficients");
    let material = Material::new(material).expect("fourteen coefficients");
    let scene = table::collapse(&table::project(&light, &material).expect("it fits"));
    move |normal| {
        let [x, y, z] = normal.map(|component| component as f32);
        scene.shade(Normal::new(x, y, z).expect("a normal")).into()
    }
}

fn integers(light: &[f32], material: &[f32]) -> impl Fn([f64; 3]) -> f64 {
    use table::q15 as table;
    let (mut of_light, mut of_material) = ([Q15(0); 16], [Q15(0); 14]);
    let mut exponents = [0; 5];
    let light = q15::Light::quantize(light, &mut of_light).expect("sixteen");
    let material = q15::Material::quantize(material, &mut of_material, &mut exponents);
    let transfer = table::transfer(&material.expect("fourteen")).expect("it fits");
    let scene = table::collapse(&table::relight(&transfer.view(), &light).expect("it fits"));
    move |normal| {
        let [x, y, z] =
            normal.map(|component| Q15((32_768.0 * component).round().min(32_767.0) as i16));
        let normal = q15::Normal::from_unit(x, y, z).expect("a unit vector");
        f64::from(scene.shade(normal)) * 2f64.powi(scene.exponent())
    }
}
