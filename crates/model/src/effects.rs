//! Light and material of some effects: c = L (x) b restricted to their modes, as a sum of
//! at most two products again, ambient and the rest.

use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::{light, material};

/// One channel's light for each product, to go with [`materials`] one by one.
#[must_use]
pub fn lights(degree: usize, light: &[f64], effects: Effects) -> Vec<Vec<f64>> {
    let of = |is_ambient: bool| {
        let kept = |l: usize| (l == 0) == is_ambient;
        let each = light::indices(degree).zip(light);
        each.map(|((l, _), &value)| if kept(l) { value } else { 0.0 }).collect()
    };
    products(effects, light, of)
}

/// One channel's material for each product, to go with [`lights`] one by one.
#[must_use]
pub fn materials(order: usize, material: &[f64], effects: Effects) -> Vec<Vec<f64>> {
    let of = |is_ambient: bool| {
        let kept = |o: usize| is_ambient || effects.keeps(1, o);
        let each = material::indices(order).zip(material);
        each.map(|((o, _, _), &b)| if kept(o) { b } else { 0.0 }).collect()
    };
    products(effects, material, of)
}

/// Of all effects there is one product, of things as they are.
fn products(effects: Effects, whole: &[f64], of: impl Fn(bool) -> Vec<f64>) -> Vec<Vec<f64>> {
    if effects.is_all() {
        return vec![whole.to_vec()];
    }
    let ambient = effects.has(Effect::Ambient).then(|| of(true));
    let rest = effects.is_directional().then(|| of(false));
    ambient.into_iter().chain(rest).collect()
}
