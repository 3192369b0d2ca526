//! Effects are sets of degrees and orders.

use crate::tolerances;
use eigenshade::index::material;
use eigenshade::{Effect, Effects, Light, Material};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::{fixtures, largest};
use std::ops::RangeInclusive;

/// The degrees l and the orders o of each effect.
const MODES: [(Effect, RangeInclusive<usize>, RangeInclusive<usize>); 4] = [
    (Effect::Ambient, 0..=0, 0..=5),
    (Effect::Diffuse, 1..=17, 0..=0),
    (Effect::Broad, 1..=17, 1..=3),
    (Effect::Gloss, 1..=17, 4..=5),
];

/// d of an effect is d of the light and the material without all other degrees and orders. At degree
/// 17, rows have more groups than the kernels for the usual degrees.
#[test]
fn effects_are_the_modes_of_their_degrees_and_orders() {
    for degree in [5, 17] {
        let mut numbers = Numbers(3);
        let lights = fixtures::lights(degree, 3, &mut numbers);
        let materials = fixtures::materials(5, 3, &mut numbers);
        let (light, material) = (lights.entries[0].luminance(), materials.entries[1].luminance());
        let owned = OwnedBasis::<f64>::new(&fixtures::table(&fixtures::scene(lights, materials)));
        let basis = owned.basis().expect("a basis");
        let project = |light: &[f64], material: &[f64], effects: Effects| {
            let light = Light::new(light).expect("a light");
            let material = Material::new(material).expect("a material");
            let mut workspace = vec![0.0; basis.workspace_len()];
            let mut d = vec![0.0; basis.components()];
            basis
                .project_effects_into(&light, &material, effects, &mut workspace, &mut d)
                .expect("sizes");
            d
        };
        let whole = largest(project(&light, &material, Effects::ALL));
        for (effect, degrees, orders) in MODES {
            let (mut of_light, mut of_material) = (light.clone(), material.clone());
            for (k, number) in of_light.iter_mut().enumerate() {
                *number *= f64::from(u8::from(degrees.contains(&k.isqrt())));
            }
            for ((o, _, _), number) in material::indices(5).zip(&mut of_material) {
                *number *= f64::from(u8::from(orders.contains(&o)));
            }
            let found = project(&light, &material, Effects::NONE.with(effect));
            let expected = project(&of_light, &of_material, Effects::ALL);
            let apart = largest(found.iter().zip(&expected).map(|(a, b)| a - b));
            assert!(apart <= tolerances::DENSE_PROJECTION * whole, "{effect:?}: {apart}");
        }
    }
}
