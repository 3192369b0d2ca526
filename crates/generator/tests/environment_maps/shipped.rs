//! The maps of the repository: all decode, and keep what is in them.

use crate::tolerances::LIGHT_PROJECTION;
use eigenshade_generator::light::convention::exchanged;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::{named_maps, project};
use eigenshade_model::database::Lights;
use eigenshade_model::inputs::coefficient_csv::{read_lights, write_lights};
use eigenshade_model::inputs::rounding::{LIGHT_DIGITS, rounded};
use std::f64::consts::PI;

const MAPS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/maps");
const LIGHTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/lights.csv");

#[test]
fn every_map_decodes_and_keeps_its_negative_texels() {
    let maps = named_maps(&[MAPS]).unwrap();
    assert_eq!(maps.len(), 18);
    for (name, path) in maps {
        let map = EnvironmentMap::from_path(path).unwrap();
        assert_eq!((map.width, map.height), (512, 256));
        let (mut total, mut negative) = ([0.0; 3], [0.0; 3]);
        for (k, texel) in map.texels.iter().enumerate() {
            let row = (k / map.width) as f64;
            let (top, bottom) = (PI * row / 256.0, PI * (row + 1.0) / 256.0);
            let solid_angle = 2.0 * PI / 512.0 * (top.cos() - bottom.cos());
            for channel in 0..3 {
                let value = f64::from(texel[channel]) * solid_angle;
                total[channel] += value;
                negative[channel] += value.min(0.0);
            }
        }
        let integrals = map.negative_integral();
        for channel in 0..3 {
            assert!(negative[channel] < 0.0);
            let error = |a: f64, b: f64| (a - b).abs() / total[channel];
            assert!(error(integrals.total[channel], total[channel]) < LIGHT_PROJECTION);
            assert!(error(integrals.negative[channel], negative[channel]) < LIGHT_PROJECTION);
            let ambient = project(&map, 0)[channel][0] * (4.0 * PI).sqrt();
            assert!(error(ambient, total[channel]) < LIGHT_PROJECTION);
        }
        println!(
            "{name}: integral {:.4?}, negative {:.4?}, share {:.2} %",
            integrals.total,
            integrals.negative,
            100.0 * integrals.negative_share()
        );
    }
}

#[test]
fn the_shipped_lights_are_those_of_the_maps() {
    let shipped = read_lights(LIGHTS, None).unwrap();
    assert_eq!((shipped.degree, shipped.entries.len()), (32, 26));
    let degree = 9;
    let shipped = shipped.truncated(degree);
    for (name, path) in named_maps(&[MAPS]).unwrap() {
        let rgb = project(&EnvironmentMap::from_path(path).unwrap(), degree);
        let entry = shipped.entries.iter().find(|entry| entry.name == name).unwrap();
        for (shipped, made) in entry.rgb.iter().flatten().zip(rgb.iter().flatten()) {
            // Half a unit of the last digit, and what another libm may do.
            let rounding = 5e-9 * made.abs() + LIGHT_PROJECTION * rgb[1][0];
            assert!((shipped - made).abs() <= rounding, "{name}: {shipped} for {made}");
        }
    }
    let again = rounded(&shipped, LIGHT_DIGITS);
    assert_eq!(again, shipped);
    let mut text = Vec::new();
    write_lights(&again, &mut text).unwrap();
    assert!(text.starts_with(b"name,l,m,r,g,b\n"));
}

#[test]
fn conventions_are_exchanged_both_ways() {
    let paper = read_lights(LIGHTS, Some(2)).unwrap();
    let graphics = exchanged(&paper);
    assert_eq!(exchanged(&graphics), paper);
    let signs = [1.0, -1.0, 1.0, -1.0, -1.0, -1.0, 1.0, -1.0, 1.0];
    for (paper, graphics) in paper.entries.iter().zip(&graphics.entries) {
        assert_eq!(paper.name, graphics.name);
        for (paper, graphics) in paper.rgb.iter().zip(&graphics.rgb) {
            assert!(paper.iter().zip(signs).zip(graphics).all(|((p, s), g)| p * s == *g));
        }
    }
    let none = Lights { degree: 4, entries: vec![] };
    assert_eq!(exchanged(&none), none);
}
