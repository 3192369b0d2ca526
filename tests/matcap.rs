//! The error of a bilinear look-up in a matcap against the scene that it was made of.

use eigenshade::object::{Disc, Matcap};
use eigenshade::presets::{light, material};
use eigenshade::{Argument, Error, Rgb, sphere};
use eigenshade_testing::{fixtures, median_and_largest};
use std::f64::consts::TAU;

/// The rms errors in the documentation of [`Matcap`], in the median and at worst.
const STATED: [(usize, f64, f64); 5] = [
    (64, 1.3e-2, 4e-2),
    (128, 6e-3, 1.9e-2),
    (256, 2.8e-3, 8.6e-3),
    (512, 1.3e-3, 4e-3),
    (1024, 6e-4, 1.8e-3),
];

/// The same at 256 texels for an engine that multiplies normals by 0.495, with the margin that it
/// needs and without.
const WITH_MARGIN: (f64, f64) = (3.3e-3, 1.05e-2);
const WITHOUT_MARGIN: (f64, f64) = (1.5e-2, 3.8e-2);

/// The unit normal in a place of the square, row and column counted in texels from the top left, by
/// the definition: outside the disc that of the rim.
fn normal([column, row]: [f64; 2], size: usize, radius: f64) -> [f64; 3] {
    let size = size as f64;
    let (x, y) = ((2.0 * column / size - 1.0) / radius, (1.0 - 2.0 * row / size) / radius);
    let length = x.hypot(y);
    if length < 1.0 { [x, y, (1.0 - x * x - y * y).sqrt()] } else { [x / length, y / length, 0.0] }
}

#[test]
fn texels_have_the_normals_of_their_centers() {
    for (size, radius) in [(1, 1.0), (2, 1.0), (33, 1.0), (64, 0.99), (1024, 0.992)] {
        let texels = Matcap::new(size).unwrap().with_radius(radius).unwrap();
        let mut count = 0;
        for (index, texel) in texels.enumerate() {
            assert_eq!((texel.index(), texel.row()), (index, index / size));
            let center = [texel.column(), texel.row()].map(|place| place as f64 + 0.5);
            let exact = normal(center, size, radius.into());
            let found = texel.normal().components().map(f64::from);
            for (found, exact) in found.into_iter().zip(exact) {
                // At the rim the root doubles the digits that rounding takes.
                assert!((found - exact).abs() < if exact < 0.05 { 4e-4 } else { 1e-5 });
            }
            count += 1;
        }
        assert_eq!(count, size * size);
    }
    assert_eq!(Matcap::new(0).err(), Some(Error::Size { found: 0 }));
    for radius in [0.0, -0.5, 1.01, f32::NAN] {
        let refused = Matcap::new(8).unwrap().with_radius(radius);
        assert_eq!(refused.err(), Some(Error::Outside { argument: Argument::Radius }));
    }
    assert_eq!([Matcap::THREE_JS, Matcap::BLENDER], [2.0 * 0.495, 2.0 * 0.496]);
}

/// A scene in color, and the peak of its brightest channel.
struct Lit {
    scene: sphere::color::Scene,
    peak: f64,
}

impl Lit {
    /// Gold paint under each light, and each material in the lobby.
    fn all() -> Vec<Self> {
        let lights = light::ALL.map(|(_, light)| (light, material::GOLD_METALLIC_PAINT));
        let materials = material::ALL.map(|(_, material)| (light::LOBBY, material));
        let lit = |(light, material)| {
            let scene = sphere::color::scene(light, material).unwrap();
            let pixels = Disc::new(64).unwrap().filter(|pixel| pixel.coverage() >= 128);
            let pixels = pixels.map(|pixel| scene.shade(pixel.normal()).largest());
            let peak = pixels.fold(0.0, f32::max).into();
            Self { scene, peak }
        };
        lights.into_iter().chain(materials).map(lit).collect()
    }

    fn shade(&self, normal: [f64; 3]) -> [f64; 3] {
        let color: Rgb<f32> = self.scene.shade(fixtures::normal(normal));
        <[f32; 3]>::from(color).map(f64::from)
    }

    /// The rms error over a disc of an engine that multiplies normals by `factor`.
    fn error(&self, size: usize, radius: f64, factor: f64) -> f64 {
        const COUNT: usize = 1500;
        let mut squares = 0.0;
        for k in 0..COUNT {
            // Evenly over the area of the disc.
            let distance = ((k as f64 + 0.5) / COUNT as f64).sqrt();
            let (y, x) = (0.618_033_988_75 * TAU * k as f64).sin_cos();
            let (x, y) = (distance * x, distance * y);
            let exact = self.shade([x, y, (1.0 - x * x - y * y).max(0.0).sqrt()]);
            // In texels, from the center of the one at the top left.
            let place = |along: f64| (factor * along + 0.5) * size as f64 - 0.5;
            let (column, row) = (place(x), place(-y));
            let mut found = [0.0; 3];
            for [right, down] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]] {
                let (i, j) = (column.floor() + right, row.floor() + down);
                let weight = (1.0 - (column - i).abs()) * (1.0 - (row - j).abs());
                // Clamped to the edge, as engines do.
                let [i, j] = [i, j].map(|place| place.clamp(0.0, size as f64 - 1.0) + 0.5);
                let texel = self.shade(normal([i, j], size, radius));
                found.iter_mut().zip(texel).for_each(|(sum, value)| *sum += weight * value);
            }
            squares += found.iter().zip(exact).map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / 3.0;
        }
        (squares / COUNT as f64).sqrt() / self.peak
    }
}

#[test]
fn look_ups_are_as_exact_as_stated() {
    let all = Lit::all();
    let check = |name: &str, stated: (f64, f64), error: &dyn Fn(&Lit) -> f64| {
        let [median, worst] = median_and_largest(all.iter().map(error).collect::<Vec<f64>>());
        println!("{name}: median {median:.2e}, worst {worst:.2e}");
        // Not more than stated, nor much less.
        for (found, stated) in [(median, stated.0), (worst, stated.1)] {
            assert!(found <= stated && found > 0.75 * stated, "{name}: {found:e}, not {stated:e}");
        }
    };
    for (size, median, worst) in STATED {
        check(&size.to_string(), (median, worst), &|lit| lit.error(size, 1.0, 0.5));
    }
    check("three.js", WITH_MARGIN, &|lit| lit.error(256, Matcap::THREE_JS.into(), 0.495));
    check("three.js, no margin", WITHOUT_MARGIN, &|lit| lit.error(256, 1.0, 0.495));
}
