//! Sources of made-up maps, whose lamps are known.

use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::{Ggx, Measure, projection};
use eigenshade_model::reference::DirectSum;
use eigenshade_model::source::Source;
use eigenshade_shading::sources::pursuit::{find, metals};
use eigenshade_shading::sources::response::{Place, Response};

/// Lamps of this radiance within an angle of these directions, on a dim sky.
fn lamps(directions: &[[f64; 3]], angle: f64, radiance: f32) -> EnvironmentMap {
    let (width, height) = (256, 128);
    let mut map = EnvironmentMap { width, height, texels: vec![[0.1; 3]; width * height] };
    for texel in 0..width * height {
        let [x, y, z] = map.direction(texel % width, texel / width);
        let near = |[a, b, c]: &[f64; 3]| a * x + b * y + c * z > angle.cos();
        if directions.iter().any(near) {
            map.texels[texel] = [radiance, 0.5 * radiance, 0.1];
        }
    }
    map
}

/// The energy above the sky of a map of lamps.
fn energy(map: &EnvironmentMap) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (texel, color) in map.texels.iter().enumerate() {
        let solid_angle = map.solid_angle(texel / map.width);
        for (sum, &value) in sums.iter_mut().zip(color) {
            *sum += solid_angle * (f64::from(value) - 0.1);
        }
    }
    sums
}

fn total(sources: &[Source]) -> [f64; 3] {
    [0, 1, 2].map(|c: usize| sources.iter().map(|source| source.energy[c]).sum())
}

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

/// The largest error of an interpolated response, of the largest response.
const INTERPOLATED: f64 = 1e-9;

#[test]
fn responses_are_those_of_the_direct_sum() {
    let brdf = Ggx::new(0.3, 0.9, 0.1).unwrap();
    let material = projection::project(&brdf, 12, Measure::default()).coefficients;
    let response = Response::new((12, 12), &material);
    let sum = DirectSum::new(12, 12);
    let of_all: Vec<f64> = (0..169).map(|k| f64::from(k * 7 % 19) - 9.0).collect();
    let image = response.under(&of_all);
    let (mut most, mut largest) = (0.0_f64, 0.0_f64);
    for k in 0..40 {
        let (slant, tilt) = (0.04 * f64::from(k), 2.4 * f64::from(k));
        let normal = [slant.sin() * tilt.cos(), slant.sin() * tilt.sin(), slant.cos().max(0.0)];
        let at = Place::new(normal, 13);
        let modes = sum.at(normal);
        let scattered = modes.scatter(&material);
        for (harmonic, found) in response.at(&at).into_iter().enumerate() {
            let mut light = vec![0.0; 169];
            light[harmonic] = 1.0;
            let expected = modes.irradiance(&light, &scattered);
            most = most.max((found - expected).abs());
            largest = largest.max(expected.abs());
        }
        let expected = modes.irradiance(&of_all, &scattered);
        most = most.max((image.irradiance(&at) - expected).abs());
        largest = largest.max(expected.abs());
    }
    println!("{:e}", most / largest);
    assert!(most <= INTERPOLATED * largest, "{most:e} {largest:e}");
}

/// How far a source is from a lamp of 0.05 rad, and by how much energies differ: the height
/// of a lobe's peak is wrong by up to 7.5 %, which the energy makes up for.
const PLACE: f64 = 0.01;
const ENERGY: f64 = 0.07;

#[test]
fn a_lamp_is_found_where_it_is() {
    let lamp = [0.48, 0.64, 0.6];
    let map = lamps(&[lamp], 0.05, 50.0);
    let sources = find(&map, &metals(&[0.3]).unwrap(), 1).unwrap();
    let [source] = &sources[..] else { panic!("{sources:?}") };
    assert!(dot(source.direction, lamp).acos() < PLACE, "{source:?}");
    let expected = energy(&map);
    for (found, expected) in source.energy.into_iter().zip(expected).take(2) {
        assert!((found / expected - 1.0).abs() < ENERGY, "{found} {expected}");
    }
    assert!(source.energy[2] < 1e-3 * source.energy[0], "{source:?}");
}

#[test]
fn a_constant_map_has_no_source() {
    let map = EnvironmentMap { width: 16, height: 8, texels: vec![[0.7; 3]; 16 * 8] };
    let sources = find(&map, &metals(&[0.3]).unwrap(), 2).unwrap();
    assert!(total(&sources).iter().all(|&e| e < 1e-3), "{sources:?}");
    let dark = EnvironmentMap { width: 64, height: 32, texels: vec![[0.0; 3]; 64 * 32] };
    let sources = find(&dark, &metals(&[0.3]).unwrap(), 2).unwrap();
    assert!(sources.is_empty(), "{sources:?}");
}

#[test]
fn many_equal_lamps_are_taken_one_by_one() {
    let all: Vec<[f64; 3]> = (0..12)
        .map(|k| {
            let (z, turn) = (0.9 - 0.15 * f64::from(k), 2.4 * f64::from(k));
            let across = (1.0_f64 - z * z).sqrt();
            [across * turn.cos(), across * turn.sin(), z]
        })
        .collect();
    let map = lamps(&all, 0.05, 50.0);
    let sources = find(&map, &metals(&[0.3]).unwrap(), 8).unwrap();
    assert!(sources.len() >= 4, "{sources:?}");
    let limit = 1.05 * energy(&map)[0];
    assert!(total(&sources)[0] < limit, "{:?} {limit}", total(&sources));
    for source in &sources {
        let near = all.iter().map(|&lamp| dot(source.direction, lamp)).fold(-1.0, f64::max);
        assert!(near.acos() < 0.1, "{source:?}");
    }
}
