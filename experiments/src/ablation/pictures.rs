//! Pictures of a sphere by the direct sum (15): what each effect of a scene contributes, the errors
//! of the scene's table, and those of nine terms.

use super::scenes::{self, Scene};
use crate::sphere::{Picture, Sphere, peak};
use eigenshade::{Light, NineTerms, Normal, Q15, Tolerance};
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::rotation::Rotation;
use eigenshade_shading::integer_shader::{self, IntegerShader};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::reference_image::images_of_effects;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_shading::sphere_rings::rings;
use eigenshade_testing::largest;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// The 900 normals at which pictures are compared.
fn sphere() -> Sphere {
    Sphere::new(rings(0.06))
}

/// The picture of each light on one material, by the direct sum over some effects.
pub fn direct(sphere: &Sphere, lights: &Lights, on: &Materials, wanted: Effects) -> Vec<Picture> {
    let images = images_of_effects(lights, on, wanted, &sphere.normals, &());
    let of_light = |light: usize| {
        [0, 1, 2].map(|c| images.iter().map(|of_normal| of_normal[light][c]).collect())
    };
    (0..lights.entries.len()).map(of_light).collect()
}

/// Errors of a scene's picture under its light, relative to the peak: of leaving out each effect
/// that has modes in the scene; of showing luminance instead of `color`; of keeping the picture
/// while the light is `turning` by 30 degrees about the vertical; and what is `left out` by the
/// scene's truncation, compared with degree 9 and order 7.
pub fn shares(scene: &Scene) -> BTreeMap<&'static str, f64> {
    let table = scene.whole_table();
    let sphere = self::sphere();
    let light = scene.light(table.scene.degree());
    let material = scenes::material(&table, table.scene.material.order);
    let picture = |light: &Lights, wanted| direct(&sphere, light, &material, wanted).remove(0);
    let wanted = table.effects();
    let whole = picture(&light, wanted);
    let mut shares = BTreeMap::new();
    for effect in Effect::ALL.into_iter().filter(|&effect| wanted.has(effect)) {
        let picture = picture(&light, Effects::NONE.with(effect));
        if peak(&picture) > 0.0 {
            shares.insert(effect.name(), sphere.rms(&picture) / peak(&whole));
        }
    }
    if scene.channels == 3 {
        let mut gray = light.clone();
        gray.entries[0].remove_color();
        shares.insert("color", sphere.error(&picture(&gray, wanted), &whole));
    }
    if scene.turns {
        let about_y = Rotation { alpha: PI / 6.0, beta: 0.0, gamma: 0.0 };
        let mut turned = light.clone();
        for channel in &mut turned.entries[0].rgb {
            *channel = about_y.turn(light.degree, channel);
        }
        shares.insert("turning", sphere.error(&picture(&turned, wanted), &whole));
    }
    let material = scenes::material(&table, 7);
    let all = direct(&sphere, &scene.light(9), &material, Effects::ALL).remove(0);
    shares.insert("left out", sphere.error(&whole, &all));
    shares
}

/// Errors of a scene's table with the boards' polynomials, root mean square over the sphere
/// relative to the peak: in f32 under the scene's own light, in f32 under the shipped light with
/// the largest error, and in Q15 under the scene's own light.
pub fn errors(scene: &Scene) -> [f64; 3] {
    let table = scene.whole_table();
    let sphere = self::sphere();
    let (degree, order) = (table.gram.degree, table.gram.order);
    let materials = scenes::material(&table, order);
    let (lights, material) = (scene.lights(degree), &materials.entries[0]);
    let expected = direct(&sphere, &lights, &materials, table.effects());
    let basis = OwnedBasis::new(&table);
    let mut shader = Shader::new(basis.basis().expect("a basis"), table.count());
    let normals = OwnedNormals::new(&sphere.normals);
    let mut in_f32 = |light: &Named| -> Picture {
        let picture = shader.color(light, material, &normals).expect("it fits");
        picture.map(|channel| channel.into_iter().map(f64::from).collect())
    };
    let pairs = lights.entries.iter().zip(&expected);
    let errors: Vec<f64> =
        pairs.map(|(light, expected)| sphere.error(&in_f32(light), expected)).collect();
    let own = lights.entries.iter().position(|light| light.name == scene.light);
    let own = own.expect("a shipped light");
    let mut shader = IntegerShader::<Q15>::new(&table, table.count()).expect("Q15 serves it");
    let normals = integer_shader::normals(&sphere.normals).expect("normals");
    let q15 = lights.entries[own].rgb.each_ref();
    let q15 =
        q15.map(|light| shader.polynomial(light, &material.rgb[0], &normals).expect("it fits"));
    [errors[own], largest(errors), sphere.error(&q15, &expected[own])]
}

/// The terms that the runtime keeps within a tolerance of the peak, under each shipped light.
pub fn terms_within(scene: &Scene, tolerance: f32) -> Vec<usize> {
    let table = scene.whole_table();
    let (degree, order) = (table.gram.degree, table.gram.order);
    let material = scenes::material(&table, order).entries[0].luminance();
    let basis = OwnedBasis::new(&table);
    let mut shader = Shader::new(basis.basis().expect("a basis"), table.count());
    let normals = OwnedNormals::new(&[[0.0, 0.0, 1.0]]);
    let terms = |light: &Named| {
        let light = light.luminance();
        let channel = (light.as_slice(), material.as_slice());
        let within = shader.within(&[channel], &normals, Tolerance::OfPeak(tolerance));
        within.expect("a tolerance above zero")[0].1.terms
    };
    scene.lights(degree).entries.iter().map(terms).collect()
}

/// Errors under each shipped light on a Lambertian material, of the formula of Ramamoorthi and
/// Hanrahan for light of degree 2, and of the nine coefficients that are best for light of degree
/// 9: root mean square over the sphere, relative to the peak of the direct sum of degree 9.
pub fn of_nine_terms() -> Vec<[f64; 2]> {
    let scene = Scene::named("park_lambertian");
    let sphere = self::sphere();
    let normals = sphere.normals.iter().map(|&[x, y, z]| Normal::new(x, y, z));
    let normals: Vec<Normal<f64>> = normals.collect::<Result<_, _>>().expect("visible normals");
    let roots: Vec<f64> = sphere.weights.iter().map(|weight| weight.sqrt()).collect();
    let unit = |term: usize| std::array::from_fn(|k| f64::from(u8::from(k == term)));
    let of_term = |k: usize, term: usize| roots[k] * NineTerms::new(unit(term)).shade(normals[k]);
    let terms = DMatrix::from_fn(roots.len(), 9, of_term).svd(true, true);
    let lights = scene.lights(9);
    let material = scenes::material(&scene.whole_table(), 0);
    let error = |(light, whole): (&Named, &Picture)| {
        let expected = DVector::from_fn(roots.len(), |k, _| roots[k] * whole[0][k]);
        // No cut-off is needed: the nine terms are independent.
        let best = terms.solve(&expected, 0.0).expect("both sides of the decomposition");
        let best = NineTerms::new(std::array::from_fn(|term| best[term]));
        let light = Light::new(&light.rgb[0][..9]).expect("light of degree 2");
        [NineTerms::lambertian(&light, 1.0), best].map(|formula| {
            let nine: Vec<f64> = normals.iter().map(|&normal| formula.shade(normal)).collect();
            sphere.error(&[nine.clone(), nine.clone(), nine], whole)
        })
    };
    let pictures = direct(&sphere, &lights, &material, Effects::ALL);
    lights.entries.iter().zip(&pictures).map(error).collect()
}
