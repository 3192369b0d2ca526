//! The contribution of each effect of a scene: the error of its picture without the effect.

use super::pictures::{Picture, Sphere, difference, peak};
use super::scenes::{self, Scene};
use eigenshade::{Light, Rotation};
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::light;
use eigenshade_table::Table;

/// Spacing of the 900 normals in radians.
pub const SPACING: f64 = 0.06;

/// Degree and order of the complete picture.
pub const FULL: (usize, usize) = (9, 7);

/// Errors: root mean square over the sphere, relative to the peak.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shares {
    /// The error of leaving out each effect that has modes in the scene.
    pub effects: Vec<(&'static str, f64)>,
    /// The error of showing luminance instead of color, and of keeping the picture while the light
    /// turns by 30 degrees about the vertical.
    pub demands: Vec<(&'static str, f64)>,
    /// The error of the scene's truncation compared with degree 9 and order 7.
    pub left_out: f64,
}

/// The shares of a scene under its light.
pub fn shares(scene: &Scene, table: &Table) -> Shares {
    let sphere = Sphere::new(SPACING);
    let (degree, order) = (table.scene.degree(), table.scene.material.order);
    let light = scene.light(degree);
    let material = scenes::material(table, order);
    let of = |light: &[Vec<f64>], wanted: Effects| {
        sphere.direct((degree, light), (order, &material), wanted)
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
        let grey = of(&[luminance(&light)], wanted);
        shares.demands.push(("colour", share(&difference(&whole, &grey))));
    }
    if scene.turns {
        let turned: Vec<Vec<f64>> = light.iter().map(|light| turned(degree, light)).collect();
        shares.demands.push(("turning", share(&difference(&of(&turned, wanted), &whole))));
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

fn luminance(light: &[Vec<f64>]) -> Vec<f64> {
    let channels = light[0].iter().zip(&light[1]).zip(&light[2]);
    channels.map(|((&r, &g), &b)| eigenshade_model::database::luminance([r, g, b])).collect()
}

/// A light turned by 30 degrees about the vertical, y.
fn turned(degree: usize, light: &[f64]) -> Vec<f64> {
    const DEGREE: usize = FULL.0;
    let half = std::f64::consts::PI / 12.0;
    let rotation = Rotation::from_quaternion([0.0, half.sin(), 0.0, half.cos()]);
    let light = Light::new(degree, light).expect("as many coefficients as it has");
    let turned = light.turned::<{ light::count(DEGREE) }, { Light::<f64>::turn_len(DEGREE) }>(
        &rotation.expect("a quaternion of length one"),
    );
    turned.expect("room for degree 9").to_vec()
}
