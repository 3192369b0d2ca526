//! Light and material restricted to some effects.
//!
//! The restriction of c = L (x) b to their modes is again a sum of at most two products: ambient
//! and the rest.

use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::{light, material};

/// One channel of a light for each product. The k-th goes with the k-th of [`materials`].
#[must_use]
pub fn lights(degree: usize, light: &[f64], effects: Effects) -> Vec<Vec<f64>> {
    let of = |is_ambient: bool| {
        let kept = |l: usize| (l == 0) == is_ambient;
        let each = light::indices(degree).zip(light);
        each.map(|((l, _), &value)| if kept(l) { value } else { 0.0 }).collect()
    };
    products(effects, light, of)
}

/// One channel of a material for each product. The k-th goes with the k-th of [`lights`].
#[must_use]
pub fn materials(order: usize, material: &[f64], effects: Effects) -> Vec<Vec<f64>> {
    let of = |is_ambient: bool| {
        let kept = |o: usize| is_ambient || effects.keeps(1, o);
        let each = material::indices(order).zip(material);
        each.map(|((o, _, _), &b)| if kept(o) { b } else { 0.0 }).collect()
    };
    products(effects, material, of)
}

/// With all effects there is a single product of the unchanged coefficients.
fn products(effects: Effects, whole: &[f64], of: impl Fn(bool) -> Vec<f64>) -> Vec<Vec<f64>> {
    if effects.is_all() {
        return vec![whole.to_vec()];
    }
    let ambient = effects.has(Effect::Ambient).then(|| of(true));
    let rest = effects.is_directional().then(|| of(false));
    ambient.into_iter().chain(rest).collect()
}
