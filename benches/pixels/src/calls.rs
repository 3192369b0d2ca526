//! The calls that are made once for a light or a material, not for each pixel.

use eigenshade::{Light, Material, Tolerance, sphere};
use std::hint::black_box;

/// Name of a scene within a tolerance in docs/performance.md.
pub const WITHIN: &str = "`collapse_within` 1e-2";
/// Name of a projection there.
pub const PROJECT: &str = "`project`";

/// Name of each call in docs/performance.md, and the multiply-adds that it needs at least.
pub const CALLS: [(&str, usize); 5] =
    [("`relight`", 570), ("`collapse`", 650), (WITHIN, 650), ("`transfer`", 5400), (PROJECT, 7200)];

/// A light, a material and what is made of them.
pub struct Inputs {
    light: Vec<f32>,
    material: Vec<f32>,
    transfer: sphere::Transfer,
    d: sphere::Coefficients,
    /// Of a light and a material that grow darker with their degree, as real ones do.
    darker: sphere::Coefficients,
}

impl Inputs {
    /// Their numbers change no count, but those of [`darker`](Self::darker) do.
    pub fn new() -> Self {
        let (light, material) = (vec![0.1; 100], vec![0.1; 40]);
        let of_light = Light::new(9, &light).expect("a light");
        let of_material = Material::new(7, &material).expect("a material");
        let transfer = sphere::transfer(&of_material).expect("it fits");
        let d = sphere::project(&of_light, &of_material).expect("it fits");
        let falling =
            |count: u8| (0..count).map(|k| 1.0 / f32::from(1 + 2 * k)).collect::<Vec<f32>>();
        let darker = (falling(100), falling(40));
        let darker = sphere::project(
            &Light::new(9, &darker.0).expect("a light"),
            &Material::new(7, &darker.1).expect("a material"),
        );
        Self { light, material, transfer, d, darker: darker.expect("it fits") }
    }

    /// One call of the [`CALLS`] of this number.
    pub fn call(&self, which: usize) {
        let light = || Light::new(9, black_box(&self.light)).expect("a light");
        let material = || Material::new(7, black_box(&self.material)).expect("a material");
        match which {
            0 => drop(black_box(sphere::relight(black_box(&self.transfer), &light()))),
            1 => drop(black_box(sphere::collapse(black_box(&self.d)))),
            2 => {
                let (mut lengths, mut room) = ([0; sphere::DEGREE + 1], [0.0; sphere::SCENE]);
                let (d, tolerance) = (black_box(&self.darker), Tolerance::OfPeak(1e-2));
                let found =
                    sphere::BASIS.collapse_within(d, tolerance, &mut lengths, &mut room[..]);
                let _ = black_box(found.map(|(_, told)| told));
            }
            3 => drop(black_box(sphere::transfer(&material()))),
            _ => drop(black_box(sphere::project(&light(), &material()))),
        }
    }
}
