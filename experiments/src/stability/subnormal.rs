//! The share of f32 numbers that are subnormal when the light is at 1e-30, and the time that they
//! take.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade::{Light, Material, Normal, sphere};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_testing::fixtures;
use eigenshade_testing::oracle::Numbers;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Share of the nonzero products of a pixel at 2^-100 in f32 that are subnormal: the highest terms
/// are 1e-7 of the strongest, and t and n_x are small somewhere: 0.7 %.
const SUBNORMAL_PRODUCTS: f64 = 0.02;

/// Share of the coefficients at 2^-100 in f32 that are subnormal, among all components: those with
/// amplitudes weaker than 1e-8 of the strongest.
const SUBNORMAL_COMPONENTS: f64 = 0.5;

pub const TINY: Case = Case {
    name: "light at 1e-30 in f32: what becomes subnormal, and what it takes in time",
    naively: "products below 1e-38 are subnormal: some processors take a hundred times as long for each",
    here: "with the shipped table no coefficient, term or pixel is, nor any product on the way but less than one in a \
           hundred of a pixel's; of all components the weakest are. Images are linear: light scaled by a power of two \
           to about 1, and the pixels back, gives the same bits",
    measure,
};

/// 2^-100 = 8e-31.
const FAR: i32 = -100;

/// Width of the sphere in pixels.
const SIZE: i32 = 48;

/// The operations that every image of a material goes through.
struct Work {
    material: Vec<f32>,
    transfer: sphere::Transfer,
    normals: Vec<[f32; 3]>,
}

impl Work {
    fn new() -> Self {
        let material = fixtures::materials(7, 1, &mut Numbers(42)).entries[0].luminance();
        let material: Vec<f32> = material.iter().map(|value| *value as f32).collect();
        let on = Material::new(7, &material).expect("coefficients");
        let transfer = sphere::transfer(&on).expect("it fits");
        let at = |k: i32| (2.0 * k as f32 + 1.0) / SIZE as f32 - 1.0;
        let pixels = (0..SIZE).flat_map(|row| (0..SIZE).map(move |column| (at(column), at(row))));
        let normals = pixels.filter(|(x, y)| x * x + y * y < 1.0);
        let normal = |(x, y): (f32, f32)| [x, y, (1.0 - x * x - y * y).sqrt()];
        Self { material, transfer, normals: normals.map(normal).collect() }
    }

    fn relight(&self, light: &[f32]) -> sphere::Coefficients {
        let light = Light::new(9, light).expect("coefficients");
        sphere::relight(&self.transfer, &light).expect("it fits")
    }

    fn project(&self, light: &[f32]) -> sphere::Coefficients {
        let light = Light::new(9, light).expect("coefficients");
        let on = Material::new(7, &self.material).expect("coefficients");
        sphere::project(&light, &on).expect("it fits")
    }

    fn shade(&self, scene: &sphere::Scene) -> Vec<f32> {
        let normal = |[x, y, z]: [f32; 3]| Normal::new(x, y, z).expect("visible");
        self.normals.iter().map(|xyz| sphere::shade(scene, normal(*xyz))).collect()
    }

    /// The shares of the nonzero products of relighting and of collapsing that are subnormal.
    fn products(&self, light: &[f32], d: &[f32]) -> [f64; 2] {
        let mut of_light = Share::default();
        for (k, value) in light.iter().enumerate() {
            let transfer = self.relight(&unit(light.len(), k));
            transfer.iter().for_each(|number| of_light.add(number * value));
        }
        let mut of_terms = Share::default();
        for (i, value) in d.iter().enumerate() {
            let terms = terms(&unit(d.len(), i));
            terms.iter().for_each(|term| of_terms.add(term * value));
        }
        [of_light.value(), of_terms.value()]
    }
}

fn unit(count: usize, one: usize) -> Vec<f32> {
    (0..count).map(|k| f32::from(u8::from(k == one))).collect()
}

/// The terms of all polynomials of an image.
fn terms(d: &[f32]) -> Vec<f32> {
    let mut terms = vec![0.0; sphere::SCENE];
    sphere::BASIS.collapse_into(d, &mut terms[..]).expect("sizes");
    terms
}

/// Counts how many of the nonzero products are subnormal.
#[derive(Default)]
struct Share([usize; 2]);

impl Share {
    fn add(&mut self, product: f32) {
        self.0[0] += usize::from(product.is_subnormal());
        self.0[1] += usize::from(product != 0.0);
    }

    fn value(&self) -> f64 {
        self.0[0] as f64 / self.0[1].max(1) as f64
    }
}

/// Products of a pixel: azimuths by Horner's rule, as the shipped table uses them, or by the powers
/// of n_x + i n_y, as any table does.
fn shade(terms: &[f32], [x, y, z]: [f32; 3], by_powers: bool, share: &mut Share) -> f32 {
    let lengths = sphere::BASIS.parts().lengths;
    let t = 2.0 * z - 1.0;
    let mut product = |a: f32, b: f32| {
        share.add(a * b);
        a * b
    };
    let mut values = Vec::new();
    let mut start = 0;
    for (m, length) in lengths.iter().map(|length| usize::from(*length)).enumerate() {
        let count = if m == 0 { 1 } else { 2 };
        let polynomials = terms[start..start + count * length].chunks(length.max(1));
        // The highest term comes first.
        let value = |terms: &[f32]| {
            terms.iter().copied().reduce(|sum, term| product(sum, t) + term).unwrap_or(0.0)
        };
        let mut of_azimuth: Vec<f32> = polynomials.map(value).collect();
        of_azimuth.resize(2, 0.0);
        values.push([of_azimuth[0], of_azimuth[1]]);
        start += count * length;
    }
    if by_powers {
        let (mut cosine, mut sine, mut sum) = (1.0, 0.0, 0.0);
        for [plus, minus] in values {
            sum += product(plus, cosine);
            sum += product(minus, sine);
            (cosine, sine) =
                (product(cosine, x) - product(sine, y), product(cosine, y) + product(sine, x));
        }
        return sum;
    }
    let [mut real, mut imaginary] = [0.0, 0.0];
    for [plus, minus] in values.into_iter().rev() {
        (real, imaginary) = (
            plus + product(real, x) + product(imaginary, y),
            minus + product(imaginary, x) - product(real, y),
        );
    }
    real
}

fn subnormal(values: &[f32]) -> usize {
    values.iter().filter(|value| value.is_subnormal()).count()
}

/// The share of d that is subnormal, for all components of the shipped scene.
fn of_all(work: &Work, light: &[f32]) -> f64 {
    let table = fixtures::table(&fixtures::shipped());
    let owned = OwnedBasis::<f32>::new(&table);
    let basis = owned.basis().expect("a basis");
    let mut d = vec![0.0; basis.components()];
    let mut workspace = vec![0.0; basis.workspace_len()];
    let light = Light::new(9, light).expect("coefficients");
    let on = Material::new(7, &work.material).expect("coefficients");
    basis.project_into(&light, &on, &mut workspace, &mut d).expect("sizes");
    subnormal(&d) as f64 / d.len() as f64
}

fn measure() -> Vec<Figure> {
    let light = fixtures::lights(9, 1, &mut Numbers(43)).entries[0].luminance();
    let plain: Vec<f32> = light.iter().map(|value| *value as f32).collect();
    let tiny: Vec<f32> = plain.iter().map(|value| value * 2f32.powi(FAR)).collect();
    let work = Work::new();
    let d = work.relight(&tiny);
    let scene = sphere::collapse(&d).expect("it fits");
    let (pixels, of_image) = (work.shade(&scene), terms(&d));
    let [of_light, of_terms] = work.products(&tiny, &d);
    let [mut horner, mut powers] = [Share::default(), Share::default()];
    for (normal, expected) in work.normals.iter().zip(&pixels) {
        let found = shade(&of_image, *normal, false, &mut horner);
        let largest = of_image.iter().fold(0.0f32, |most, term| most.max(term.abs()));
        // Confirms that the counted operations are those of the pixel.
        assert!((found - expected).abs() <= tolerances::SAME_SUM_F32 * largest);
        shade(&of_image, *normal, true, &mut powers);
    }
    // Scaled to 1 and back.
    let large = work.relight(&plain);
    let scaled = work.shade(&sphere::collapse(&large).expect("it fits"));
    let mut of_scaled = Share::default();
    for normal in &work.normals {
        shade(&terms(&large), *normal, false, &mut of_scaled);
    }
    let other = pixels.iter().zip(&scaled).filter(|(a, b)| **a != **b * 2f32.powi(FAR)).count();

    let [relight, project, collapse, shade] = ratios(&work, [&plain, &tiny]);
    vec![
        Figure::exactly("subnormal coefficients", subnormal(&d), 0),
        Figure::exactly("terms", subnormal(&of_image), 0),
        Figure::exactly("pixels", subnormal(&pixels), 0),
        Figure::most("products in relighting, of all", of_light, 0.0),
        Figure::most("in collapsing", of_terms, 0.0),
        Figure::most("in shading", horner.value(), SUBNORMAL_PRODUCTS),
        Figure::most("in shading by powers", powers.value(), SUBNORMAL_PRODUCTS),
        Figure::most(
            "coefficients of all components, of all",
            of_all(&work, &tiny),
            SUBNORMAL_COMPONENTS,
        ),
        Figure::most("in shading, scaled to 1", of_scaled.value(), 0.0),
        Figure::exactly("pixels of another bit, scaled back", other, 0),
        Figure::told("time of relighting, of that at 1", relight),
        Figure::told("projecting", project),
        Figure::told("collapsing", collapse),
        Figure::told("shading", shade),
    ]
}

/// Times with the second light relative to those with the first: each is the shortest of many runs,
/// and the two alternate.
fn ratios(work: &Work, lights: [&[f32]; 2]) -> [f64; 4] {
    let ds = lights.map(|light| work.relight(light));
    let scenes = ds.each_ref().map(|d| sphere::collapse(d).expect("it fits"));
    let mut shortest = [[Duration::MAX; 2]; 4];
    let time = |shortest: &mut Duration, task: &dyn Fn()| {
        let start = Instant::now();
        (0..16).for_each(|_| task());
        *shortest = start.elapsed().min(*shortest);
    };
    for _ in 0..200 {
        for k in 0..2 {
            time(&mut shortest[0][k], &|| drop(black_box(work.relight(black_box(lights[k])))));
            time(&mut shortest[1][k], &|| drop(black_box(work.project(black_box(lights[k])))));
            time(&mut shortest[2][k], &|| drop(black_box(sphere::collapse(black_box(&ds[k])))));
        }
    }
    for _ in 0..20 {
        for k in 0..2 {
            time(&mut shortest[3][k], &|| drop(black_box(work.shade(black_box(&scenes[k])))));
        }
    }
    shortest.map(|[plain, tiny]| tiny.as_secs_f64() / plain.as_secs_f64())
}
