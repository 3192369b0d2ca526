//! The golden file on the host: bit for bit in integers, by every way that the runtime
//! has; floats to the tolerance that the file states.

use crate::invariants::integer::{normal, specialized};
use eigenshade::q15::{Light, Material, Normal};
use eigenshade::{Normals, Q15, sphere};
use eigenshade_testing::golden::record::{Golden, Row};
use eigenshade_testing::golden::{GOLDEN_F32, answer, checksum};
use eigenshade_testing::relative_error;

/// Signal-to-error ratio of 15-bit mantissas, in dB: 63.4 for slate in the studio, of whose narrow
/// highlight the few normals of the golden file meet little.
const GOLDEN_Q15: f64 = 63.0;

fn recorded() -> Golden {
    Golden::parse(include_str!("golden/sphere.csv")).expect("tests/golden/sphere.csv")
}

fn integers(row: &Row) -> Vec<i32> {
    row.integers().expect("integers")
}

fn mantissas(row: &Row) -> Vec<Q15> {
    integers(row).into_iter().map(|number| Q15(number as i16)).collect()
}

/// From the file's own mantissas to its answers and their checksum, by the generated functions and
/// by the general ones; the mantissas from the file's floats.
#[test]
fn integers_are_the_same_bits() {
    let golden = recorded();
    let numbers: Vec<Q15> = mantissas(golden.find("q15", [""; 3], "normals").expect("a row"));
    let normals = numbers.as_chunks::<3>().0.iter();
    let normals: Vec<Normal> =
        normals.map(|&components| normal(components).expect("a visible normal")).collect();
    let mut answers = Vec::new();
    for name in golden.pairs() {
        let row = |array| golden.find("q15", name, array).expect("a row");
        let of_material = row("material").exponents.iter().map(|&one| one as i8);
        let (of_light, of_material) = (row("light").exponents[0], of_material.collect::<Vec<_>>());
        let [light, material] = ["light", "material"].map(|array| mantissas(row(array)));
        let light = Light::new(of_light, &light).expect("a light");
        let material = Material::new(&of_material, &material).expect("a material");

        let floats =
            |array| golden.find("f32", name, array).and_then(Row::floats).expect("a row of floats");
        let [mut of_floats, mut of_more] =
            [light.mantissas(), material.mantissas()].map(|given| vec![Q15(0); given.len()]);
        let mut exponents = vec![0; of_material.len()];
        let quantized = Light::quantize(&floats("light"), &mut of_floats);
        assert_eq!(quantized, Ok(light), "{name:?}");
        let quantized = Material::quantize(&floats("material"), &mut of_more, &mut exponents);
        assert_eq!(quantized, Ok(material), "{name:?}");

        let given =
            ["d", "irradiance"].map(|array| (integers(row(array)), row(array).exponents[0]));
        let specialized = specialized(&light, &material, &normals).expect("they fit");
        assert_eq!(specialized, given, "{name:?}");
        let found = answer(&sphere::q15::BASIS, &light, &material, &normals).expect("they fit");
        assert_eq!(found, given, "{name:?}");
        answers.push(found);
    }
    let recorded = golden.find("q15", [""; 3], "crc32").expect("a row");
    assert_eq!(recorded.numbers, [checksum(&answers).to_string()]);
}

fn assert_near(what: &str, found: &[f32], recorded: &[f32]) {
    let [found, recorded] = [found, recorded].map(|numbers| numbers.iter().map(|&x| f64::from(x)));
    let error = relative_error(&found.collect::<Vec<_>>(), &recorded.collect::<Vec<_>>());
    assert!(error <= f64::from(GOLDEN_F32), "{what}: {error:e}");
}

#[test]
fn floats_are_within_the_tolerance() {
    let golden = recorded();
    let all = |array| golden.find("f32", [""; 3], array).and_then(Row::floats).expect("floats");
    assert_eq!(all("tolerance"), [GOLDEN_F32]);
    let normals = all("normals");
    let of_axis = |axis| normals.iter().skip(axis).step_by(3).copied().collect::<Vec<f32>>();
    let [x, y, z] = [0, 1, 2].map(of_axis);
    let normals = Normals::new(&x, &y, &z).expect("one length");
    for name in golden.pairs() {
        let row = |array| golden.find("f32", name, array).and_then(Row::floats).expect("floats");
        let (light, material) = (row("light"), row("material"));
        let light = eigenshade::Light::new(&light).expect("a light");
        let material = eigenshade::Material::new(&material).expect("a material");
        let d = sphere::project(&light, &material).expect("it fits");
        assert_near(&format!("{name:?} d"), &d, &row("d"));
        let scene = sphere::collapse(&d);
        let mut irradiances = vec![0.0; normals.len()];
        scene.shade_slice(normals, &mut irradiances).expect("one length");
        assert_near(&format!("{name:?} irradiance"), &irradiances, &row("irradiance"));
    }
}

/// The integers stand for the same images as the floats.
#[test]
fn formats_agree() {
    let golden = recorded();
    for (format, decibels) in [("q15", GOLDEN_Q15)] {
        for name in golden.pairs() {
            for array in ["light", "d", "irradiance"] {
                let row = golden.find(format, name, array).expect("a row");
                let of_floats = golden.find("f32", name, array).and_then(Row::floats);
                let scale = 2f64.powi(row.exponents[0]);
                let (mut signal, mut noise) = (0.0, 0.0);
                for (number, float) in integers(row).into_iter().zip(of_floats.expect("floats")) {
                    let float = f64::from(float);
                    signal += float * float;
                    noise += (scale * f64::from(number) - float).powi(2);
                }
                let found = 10.0 * (signal / noise).log10();
                assert!(found >= decibels, "{format} {name:?} {array}: {found} dB");
            }
        }
    }
}
