//! Pictures of a sphere by the direct sum (15): what each effect of a scene contributes, and the
//! errors of the scene's table.

use super::scenes::{self, Scene};
use eigenshade::{Light, Q15, Rotation, Tolerance};
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::light;
use eigenshade_model::database::{Named, luminance};
use eigenshade_model::reference::{DirectSum, Modes, light_products, material_products};
use eigenshade_shading::integer_shader::{Integer, IntegerShader};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_shading::sphere_rings::{Ring, rings};

/// Irradiances by channel and then by normal.
pub type Picture = Vec<Vec<f64>>;

/// The normals of a sphere, and the share of the disc that each represents.
#[derive(Clone, Debug)]
pub struct Sphere {
    /// Unit normals that face the camera.
    pub normals: Vec<[f64; 3]>,
    /// Weights; they sum to 1.
    pub weights: Vec<f64>,
}

impl Sphere {
    /// Normals `spacing` radians apart.
    pub fn new(spacing: f64) -> Self {
        let rings = rings(spacing);
        let weights = rings.iter().flat_map(|ring| vec![ring.weight; ring.tilts.len()]);
        Self { weights: weights.collect(), normals: rings.iter().flat_map(Ring::normals).collect() }
    }

    /// The root mean square over normals and channels.
    pub fn rms(&self, picture: &Picture) -> f64 {
        let square = |channel: &Vec<f64>| -> f64 {
            channel.iter().zip(&self.weights).map(|(value, weight)| weight * value * value).sum()
        };
        (picture.iter().map(square).sum::<f64>() / picture.len() as f64).sqrt()
    }

    /// The modes at every normal.
    pub fn modes<'a>(&self, reference: &'a DirectSum) -> Vec<Modes<'a>> {
        self.normals.iter().map(|&normal| reference.at(normal)).collect()
    }

    /// The direct sum over some effects, for a light by channel and a material.
    pub fn direct(
        &self,
        (degree, light): (usize, &[Vec<f64>]),
        (order, material): (usize, &[f64]),
        wanted: Effects,
    ) -> Picture {
        let reference = DirectSum::new(degree, order);
        sum(&self.modes(&reference), (degree, light), (order, material), wanted)
    }
}

/// The direct sum over some effects from the modes at each normal.
pub fn sum(
    modes: &[Modes<'_>],
    (degree, light): (usize, &[Vec<f64>]),
    (order, material): (usize, &[f64]),
    wanted: Effects,
) -> Picture {
    let materials = material_products(order, material, wanted);
    let lights: Vec<_> = light.iter().map(|light| light_products(degree, light, wanted)).collect();
    let mut picture = vec![Vec::with_capacity(modes.len()); light.len()];
    for modes in modes {
        let scattered: Vec<_> = materials.iter().map(|one| modes.scatter(one)).collect();
        for (channel, lights) in picture.iter_mut().zip(&lights) {
            let products = lights.iter().zip(&scattered);
            channel.push(products.map(|(light, one)| modes.irradiance(light, one)).sum());
        }
    }
    picture
}

/// The largest |I| of all channels.
pub fn peak(picture: &Picture) -> f64 {
    picture.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// The difference of two pictures; the second may have one channel that serves for all.
pub fn difference(a: &Picture, b: &Picture) -> Picture {
    let of = |(k, channel): (usize, &Vec<f64>)| {
        channel.iter().zip(&b[k.min(b.len() - 1)]).map(|(a, b)| a - b).collect()
    };
    a.iter().enumerate().map(of).collect()
}

/// Spacing of the 900 normals in radians.
pub const SPACING: f64 = 0.06;

/// Degree and order of the complete picture.
pub const FULL: (usize, usize) = (9, 7);

/// Errors: root mean square over the sphere, relative to the peak.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shares {
    /// The error of leaving out each effect that has modes in the scene; then of showing luminance
    /// instead of color, and of keeping the picture while the light turns by 30 degrees about the
    /// vertical.
    pub effects: Vec<(&'static str, f64)>,
    /// The error of the scene's truncation compared with degree 9 and order 7.
    pub left_out: f64,
}

/// The shares of a scene under its light.
pub fn shares(scene: &Scene) -> Shares {
    let table = &scene.whole_table();
    let sphere = Sphere::new(SPACING);
    let (degree, order) = (table.scene.degree(), table.scene.material.order);
    let light = scene.light(degree);
    let material = scenes::material(table, order);
    let reference = DirectSum::new(degree, order);
    let modes = sphere.modes(&reference);
    let of = |light: &[Vec<f64>], wanted: Effects| {
        sum(&modes, (degree, light), (order, &material), wanted)
    };
    let wanted = table.effects();
    let whole = of(&light, wanted);
    let largest = peak(&whole);
    let share = |picture: &Picture| sphere.rms(picture) / largest;
    let mut shares = Shares::default();
    for effect in Effect::ALL.into_iter().filter(|&effect| wanted.has(effect)) {
        let picture = of(&light, Effects::NONE.with(effect));
        if peak(&picture) > 0.0 {
            shares.effects.push((effect.name(), share(&picture)));
        }
    }
    if scene.channels == 3 {
        let channels = light[0].iter().zip(&light[1]).zip(&light[2]);
        let gray = channels.map(|((&r, &g), &b)| luminance([r, g, b])).collect();
        shares.effects.push(("color", share(&difference(&whole, &of(&[gray], wanted)))));
    }
    if scene.turns {
        let turned: Vec<Vec<f64>> = light.iter().map(|light| turned(light)).collect();
        shares.effects.push(("turning", share(&difference(&of(&turned, wanted), &whole))));
    }
    let (degree, order) = FULL;
    let all = sphere.direct(
        (degree, &scene.light(degree)),
        (order, &scenes::material(table, order)),
        Effects::ALL,
    );
    shares.left_out = sphere.rms(&difference(&all, &whole)) / peak(&all);
    shares
}

/// A light turned by 30 degrees about the vertical, y.
fn turned(light: &[f64]) -> Vec<f64> {
    const DEGREE: usize = FULL.0;
    let half = std::f64::consts::PI / 12.0;
    let rotation = Rotation::from_quaternion([0.0, half.sin(), 0.0, half.cos()]);
    let light = Light::new(light).expect("as many coefficients as it has");
    let turned = light.turned::<{ light::count(DEGREE) }, { Light::<f64>::turn_len(DEGREE) }>(
        &rotation.expect("a quaternion of length one"),
    );
    turned.expect("room for degree 9").to_vec()
}

/// Errors of a scene's table: root mean square over the sphere, relative to the peak.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// In f32, under the scene's own light.
    pub f32: f64,
    /// In f32, under the shipped light with the largest error.
    pub worst: f64,
    /// In Q15, under the scene's own light.
    pub q15: f64,
}

/// The errors of a scene with the boards' polynomials.
pub fn errors(scene: &Scene) -> Errors {
    let table = scene.whole_table();
    let sphere = Sphere::new(SPACING);
    let (degree, order) = (table.gram.degree, table.gram.order);
    let material = scenes::material(&table, order);
    let basis = OwnedBasis::<f32>::new(&table);
    let mut shader = Shader::new(basis.basis().expect("a basis"), table.count());
    let normals = OwnedNormals::new(&sphere.normals);
    let direct = DirectSum::new(degree, order);
    let modes = sphere.modes(&direct);
    let reference =
        |light: &[Vec<f64>]| sum(&modes, (degree, light), (order, &material), table.effects());
    let error = |found: &Picture, expected: &Picture| {
        sphere.rms(&difference(found, expected)) / peak(expected)
    };
    let mut in_f32 = |light: &[Vec<f64>]| -> Picture {
        let of_channel = |light: &Vec<f64>| -> Vec<f64> {
            let picture = shader.polynomial((degree, light), (order, &material), &normals);
            picture.expect("it fits").into_iter().map(f64::from).collect()
        };
        light.iter().map(of_channel).collect()
    };
    let mut worst = 0.0f64;
    for light in &scenes::lights(degree).entries {
        let light = scene.channels_of(light);
        worst = worst.max(error(&in_f32(&light), &reference(&light)));
    }
    let light = scene.light(degree);
    let expected = reference(&light);
    let mut shader = IntegerShader::<Q15>::new(&table, table.count()).expect("Q15 serves it");
    let normals: Vec<_> =
        sphere.normals.iter().map(|&normal| Q15::normal(normal).expect("a normal")).collect();
    let q15: Picture = light
        .iter()
        .map(|light| shader.polynomial((degree, light), (order, &material), &normals))
        .collect::<Result<_, _>>()
        .expect("it fits");
    Errors { f32: error(&in_f32(&light), &expected), worst, q15: error(&q15, &expected) }
}

/// The number of terms that the runtime keeps of a scene within a tolerance relative to the peak,
/// under each shipped light.
pub fn terms_within(scene: &Scene, tolerance: f32) -> Vec<usize> {
    let table = scene.whole_table();
    let (degree, order) = (table.gram.degree, table.gram.order);
    let material = scenes::material(&table, order);
    let basis = OwnedBasis::<f32>::new(&table);
    let mut shader = Shader::new(basis.basis().expect("a basis"), table.count());
    let normals = OwnedNormals::new(&[[0.0, 0.0, 1.0]]);
    let terms = |light: &Named| {
        let light = light.luminance();
        let channel = ((degree, light.as_slice()), (order, material.as_slice()));
        let within = shader.within(&[channel], &normals, Tolerance::OfPeak(tolerance));
        within.expect("a tolerance above zero")[0].1.terms
    };
    scenes::lights(degree).entries.iter().map(terms).collect()
}
