//! Light between walls: half a sphere by formulas, a pit and sheets by two nested sums over triangles,
//! and the changes that pages state.

use super::cases::{glossy, matte, pit, sheets, triangles};
use super::oracle::{Glossy, Sky, hit, is_hit, percent};
use super::{every, lights, lobby, object, surface};
use eigenshade_generator::material::brdf::Lambertian;
use eigenshade_generator::object::mesh_data::Mesh;
use eigenshade_model::vector::dot;
use eigenshade_shadows::lit::BOUNCES;
use eigenshade_shadows::material::Material;
use eigenshade_shadows::object::Object;
use eigenshade_shadows::pixels::Pixels;
use report::shadow_shapes::SHAPES;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const ALBEDO: f64 = 0.8;

fn irradiance(object: &Object, light: &[f64]) -> Vec<f64> {
    object.irradiance(light, &[1.0]).into_iter().map(f64::from).collect()
}

/// The inside of the lower half of a unit sphere.
fn half_sphere() -> Mesh {
    let (rings, sides) = (80, 160);
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        let polar = FRAC_PI_2 * f64::from(ring) / f64::from(rings);
        for side in 0..sides {
            let (y, x) = (TAU * f64::from(side) / f64::from(sides)).sin_cos();
            mesh.corners.push([polar.sin() * x, polar.sin() * y, -polar.cos()]);
        }
    }
    for (ring, side) in (0..rings).flat_map(|ring| (0..sides).map(move |side| (ring, side))) {
        let at = |ring: i32, side: i32| (ring * sides + side % sides) as u32;
        let [a, b] = [at(ring, side), at(ring, side + 1)];
        let [c, d] = [at(ring + 1, side + 1), at(ring + 1, side)];
        mesh.triangles.extend([[a, c, b], [a, d, c]]);
    }
    mesh
}

/// Every part of a sphere receives the same share of the light from any other, its area over that of
/// the sphere, so that reflected light is the same everywhere.
#[test]
fn half_a_sphere_reflects_as_formulas() {
    let light = lobby();
    let surface = surface(&half_sphere(), false);
    let brdf = Lambertian::new(ALBEDO).unwrap();
    // The sphere has been scaled.
    let radius = surface.facets[0].corners[0].iter().map(|x| x * x).sum::<f64>().sqrt();
    let [sky, coarse] = [10_000, 4000].map(|count| Sky::new(&light, count, 0.0));
    let direct = |sky: &Sky, point: [f64; 3]| {
        let normal = point.map(|x| -x);
        let seen = |[x, y, z]: [f64; 3]| {
            let cosine = dot(normal, [x, y, z]);
            // The chord is as long as twice the cosine.
            if cosine > 0.0 && point[2] + 2.0 * cosine * z > 0.0 { cosine } else { 0.0 }
        };
        sky.0.iter().map(|(along, radiance)| seen(*along) * radiance).sum::<f64>()
    };
    // Of the sphere.
    let covered = 0.5;
    let count = 300;
    let mean = (0..count).map(|k| {
        let z = -1.0 + (f64::from(k) + 0.5) / f64::from(count);
        let (sine, cosine) = (2.399_963_229_728_653 * f64::from(k)).sin_cos();
        let across = (1.0 - z * z).sqrt();
        direct(&coarse, [across * cosine, across * sine, z])
    });
    let share = covered * mean.sum::<f64>() / f64::from(count);
    let of = |bounces| irradiance(&object(&surface, 24, Material::Formula(&brdf), bounces), &light);
    let none = of(0);
    let pixels = Pixels::new(&surface, 24).unwrap();
    let expected = pixels.points().into_iter().map(|points| {
        let all = points.iter().map(|point| direct(&sky, point.position.map(|x| x / radius)));
        ALBEDO / PI * all.sum::<f64>() / points.len() as f64
    });
    let expected: Vec<f64> = expected.collect();
    let white = expected.iter().copied().fold(0.0, f64::max);
    let apart = percent(&expected, &none);
    println!("shadows alone: {apart:.3} %");
    assert!(apart < 0.5);
    for (bounces, reflected) in [
        (1, ALBEDO * share),
        (2, ALBEDO * share * (1.0 + ALBEDO * covered)),
        (BOUNCES, ALBEDO * share / (1.0 - ALBEDO * covered)),
    ] {
        let expected = ALBEDO / PI * reflected;
        let errors = of(bounces).into_iter().zip(&none).map(|(one, none)| one - none - expected);
        let square: f64 = errors.map(|error| error * error).sum();
        let rms = 100.0 * (square / none.len() as f64).sqrt() / white;
        println!("{bounces} bounces, {:.1} % of white: {rms:.3} %", 100.0 * expected / white);
        assert!(rms < 0.3);
    }
}

#[test]
fn a_pit_and_sheets_reflect_as_the_oracle() {
    let light = lobby();
    for (name, mesh) in [("pit", pit(0.4, 0.8)), ("sheets", sheets())] {
        let surface = surface(&mesh, true);
        let triangles = triangles(&surface);
        let pixels = Pixels::new(&surface, 32).unwrap();
        let chosen: Vec<_> = pixels.points().into_iter().step_by(17).collect();
        for (brdf, material) in [matte(), glossy([0.5, 0.9, 0.0])] {
            let albedo = match material {
                Glossy::Matte(albedo) => albedo,
                Glossy::Ggx(_) => material.albedo(2000),
            };
            let [none, one] = [0, 1].map(|bounces| {
                irradiance(&every(17, &surface, 32, Material::Formula(&*brdf), bounces), &light)
            });
            let white = one.iter().copied().fold(0.0, f64::max);
            let found: Vec<f64> = one.iter().zip(&none).map(|(a, b)| a - b).collect();
            let inner = Sky::new(&light, 500, 0.5);
            let blocked = |from, along| is_hit(&triangles, from, along);
            let radiance = |from: [f64; 3], along: [f64; 3]| {
                let Some((place, normal)) = hit(&triangles, from, along) else { return 0.0 };
                if dot(normal, along) >= 0.0 {
                    return 0.0;
                }
                albedo / PI * inner.matte(place, normal, &blocked)
            };
            let outer = Sky::of(1500, 0.0, |_| 1.0);
            let expected = outer.reflected(&chosen, material, &radiance);
            let [apart, most] = [
                percent(&expected, &found) * expected.iter().copied().fold(0.0, f64::max) / white,
                100.0 * expected.iter().copied().fold(0.0, f64::max) / white,
            ];
            println!("{name}: {apart:.3} % of white, the most {most:.1} %");
            assert!(apart < 0.2, "{name}");
        }
    }
}

/// The rms of the change in percent of white, the median over all lights.
fn change(before: &Object, after: &Object) -> f64 {
    let all = lights().entries.into_iter().map(|light| {
        let [_, green, _] = &light.rgb;
        percent(&irradiance(after, green), &irradiance(before, green))
    });
    let mut all: Vec<f64> = all.collect();
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

/// Stated in docs/shadows.md: for the coin and the bowl, the change by one reflection and by all.
#[test]
fn bounces_change_pictures_as_stated() {
    for ((name, mesh), stated) in [(SHAPES[0], [4.6, 7.5]), (SHAPES[5], [5.4, 10.4])] {
        let surface = surface(&mesh(), false);
        let brdf = Lambertian::new(ALBEDO).unwrap();
        let [none, one, all] =
            [0, 1, BOUNCES].map(|bounces| object(&surface, 32, Material::Formula(&brdf), bounces));
        for (stated, after) in stated.into_iter().zip([&one, &all]) {
            let found = change(&none, after);
            println!("{name}: {found:.2} %");
            assert!((found - stated).abs() < 0.5, "{name}");
        }
    }
}
