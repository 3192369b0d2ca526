//! Projection, then reconstruction, in every format, against f64.

use super::Reader;
use super::integer::{Integer, normals};
use super::shipped::shipped;
use eigenshade::quantized::{Light, Material, Transfer};
use eigenshade::{Effect, Effects, Normal, Q15, Q31, sphere};
use eigenshade_index::{light, material};
use eigenshade_table::quantize::Format;

/// d of any light and material, of what its addends could be, all of the largest size and of one
/// sign: some roundings of 24 bits, of addends far smaller.
const ANY_D_F32: f64 = 2e-8;

/// A pixel of d in f32, of the sizes of all its terms: roundings of 24 bits.
const ANY_PIXEL_F32: f64 = 1e-6;

/// A pixel of d, of the sizes of all its terms: 15 bits, and what is trimmed of the polynomials.
const ANY_IMAGE_Q15: f64 = 1e-3;

/// See [`ANY_IMAGE_Q15`]: less is trimmed.
const ANY_IMAGE_Q31: f64 = 1e-6;

/// Any light and material of moderate size, rounded to each format by the runtime.
pub fn reconstruct(input: &mut Reader<'_>) {
    let degree = input.up_to(sphere::BASIS.degree());
    let light: Vec<f32> = (0..light::count(degree)).map(|_| input.moderate()).collect();
    let order = input.up_to(sphere::BASIS.order());
    let material: Vec<f32> = (0..material::count(order)).map(|_| input.moderate()).collect();
    let wide = |numbers: &[f32]| numbers.iter().map(|&one| one.into()).collect::<Vec<f64>>();
    let case = Case {
        reference: shipped().project(&wide(&light), &wide(&material)),
        scales: shipped().scales(largest(&light), &of_orders(order, &material)),
        degree,
        light,
        order,
        material,
    };
    let seen = normals::<Q31>(input);
    case.in_floats(&seen);
    case.in_integers::<Q15>(&normals(&mut Reader::new(&[])));
    case.in_integers::<Q31>(&seen);
}

fn largest(numbers: &[f32]) -> f64 {
    numbers.iter().fold(0.0f32, |most, number| most.max(number.abs())).into()
}

/// The largest coefficient of each o.
fn of_orders(order: usize, material: &[f32]) -> Vec<f64> {
    let of = |o: usize| &material[material::position(o, o % 2, o % 2)..material::count(o)];
    (0..=order).map(|o| largest(of(o))).collect()
}

struct Case {
    degree: usize,
    light: Vec<f32>,
    order: usize,
    material: Vec<f32>,
    reference: Vec<f64>,
    scales: Vec<f64>,
}

impl Case {
    /// d, of what its addends could be.
    fn projected(&self, found: &[f64], part: f64, common: f64) {
        let largest = self.scales.iter().copied().fold(0.0, f64::max);
        for (k, ((found, reference), scale)) in
            found.iter().zip(&self.reference).zip(&self.scales).enumerate()
        {
            let allowed = part * scale + common * largest + f64::from(f32::MIN_POSITIVE);
            assert!(
                (found - reference).abs() <= allowed,
                "component {k}: {found}, not {reference}"
            );
        }
    }

    /// The image of `d`, of what its terms could be.
    fn image(d: &[f64], normal: [f64; 3], found: f64, part: f64) {
        let [expected, scale] = shipped().reconstruct(d, normal);
        let off = (found - expected).abs();
        let allowed = part * scale + f64::from(f32::MIN_POSITIVE);
        assert!(off <= allowed, "{found}, not {expected}: {} of its terms", off / scale);
    }

    fn in_floats(&self, normals: &[eigenshade::quantized::Normal<Q31>]) {
        let light = eigenshade::Light::new(&self.light).expect("a light");
        let material = eigenshade::Material::new(&self.material).expect("a material");
        let d = sphere::project(&light, &material).expect("it fits");
        let wide: Vec<f64> = d.iter().map(|&d| d.into()).collect();
        self.projected(&wide, ANY_D_F32, 0.0);
        self.projected(&self.of_effects(&light, &material), ANY_D_F32, 0.0);
        let scene = sphere::collapse(&d).expect("it fits");
        for normal in normals {
            let [x, y, z] = normal.components().map(|one| one.mantissa() as f32);
            let normal = Normal::new(x, y, z).expect("a normal");
            let at = normal.components().map(f64::from);
            Self::image(&wide, at, scene.shade(normal).into(), ANY_PIXEL_F32);
        }
    }

    /// d, the sum of that of each effect.
    fn of_effects(
        &self,
        light: &eigenshade::Light<'_, f32>,
        material: &eigenshade::Material<'_, f32>,
    ) -> Vec<f64> {
        let (basis, mut sum) = (&sphere::BASIS, vec![0.0; sphere::COMPONENTS]);
        let mut workspace = vec![0.0; basis.workspace_len()];
        let mut d = vec![0.0; basis.components()];
        for effect in Effect::ALL {
            let effects = Effects::NONE.with(effect);
            basis
                .project_effects_into(light, material, effects, &mut workspace, &mut d)
                .expect("it fits");
            sum.iter_mut().zip(&d).for_each(|(sum, &d)| *sum += f64::from(d));
        }
        sum
    }

    fn in_integers<Q: Integer>(&self, normals: &[eigenshade::quantized::Normal<Q>]) {
        let basis = Q::basis();
        let mut mantissas = vec![Q::default(); self.light.len()];
        let light = Light::quantize(&self.light, &mut mantissas).expect("a light");
        let mut of_material = vec![Q::default(); self.material.len()];
        let mut exponents = vec![0; self.order + 1];
        let material = Material::quantize(&self.material, &mut of_material, &mut exponents);
        let material = material.expect("a material");
        let mut workspace = vec![Q::Wide::default(); basis.workspace_len()];
        let mut numbers = vec![Q::default(); basis.transfer_len()];
        let mut exponents = vec![0; basis.profiles()];
        basis
            .transfer_into(&material, &mut workspace, &mut numbers, &mut exponents)
            .expect("it fits");
        let transfer = Transfer::new(&numbers, &exponents);
        let mut d = vec![0; basis.components()];
        let exponent = basis.relight_into(&transfer, &light, &mut d).expect("it fits");
        let scale = 2f64.powi(exponent);
        let wide: Vec<f64> = d.iter().map(|&d| scale * f64::from(d)).collect();
        let (of_d, of_pixel) = match Q::FORMAT {
            Format::Q15 => (super::ANY_D_Q15, ANY_IMAGE_Q15),
            Format::Q31 => (super::ANY_D_Q31, ANY_IMAGE_Q31),
        };
        self.projected(&wide, of_d, super::ANY_D_COMMON);
        let image = Q::image(&d, exponent, normals).expect("a moderate exponent");
        let one = 2f64.powi(Q::FORMAT.bits());
        for (normal, [pixel, _]) in normals.iter().zip(&image.pixels) {
            let at = normal.components().map(|one_of| one_of.mantissa() as f64 / one);
            // As long as it is: U is a polynomial of its components.
            let found = f64::from(*pixel) * 2f64.powi(image.exponent);
            Self::image(&wide, at, found, of_pixel);
        }
    }
}
