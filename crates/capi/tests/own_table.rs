//! A program in C with a table of its own: that of the scene that `EIGENSHADE_SCENE` names.
#![cfg(all(unix, feature = "own-table"))]

#[path = "../src/table.rs"]
mod table;

#[path = "../src/constants.rs"]
mod constants;

#[path = "../src/table_header.rs"]
mod table_header;

#[path = "support/program.rs"]
mod program;

use eigenshade::presets::{light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT};
use eigenshade::{Q15, q15};
use program::{compiled, run};
use std::fs;
use std::path::Path;
use std::process::Command;
use table::{DEGREE, ORDER};

/// The middle row of a sphere under presets, shortened to the table's degree and order.
const PROGRAM: &str = "\
#include \"eigenshade_presets.h\"
#include <stdio.h>

int main(void) {
  static eigenshade_picture_q15_t picture;
  eigenshade_color_light_q15_t light = eigenshade_light_lobby_q15;
  eigenshade_color_material_q15_t material = eigenshade_material_gold_metallic_paint_q15;
  eigenshade_irradiance_q15_t found = {0, 0, 0, {0, 0, 0}};
  puts(eigenshade_table() == EIGENSHADE_TABLE ? \"its table\" : \"another table\");
  light.r.degree = light.g.degree = light.b.degree = EIGENSHADE_DEGREE;
  light.r.length = light.g.length = light.b.length = EIGENSHADE_LIGHT;
  material.r.order = material.g.order = material.b.order = EIGENSHADE_ORDER;
  material.r.length = material.g.length = material.b.length = EIGENSHADE_MATERIAL;
  material.r.exponents_length = material.g.exponents_length = EIGENSHADE_ORDER + 1;
  material.b.exponents_length = EIGENSHADE_ORDER + 1;
  puts(eigenshade_message(eigenshade_picture_begin_q15(&eigenshade_light_lobby_q15, &material,
                                                       &picture)));
  puts(eigenshade_message(eigenshade_picture_begin_q15(&light, &material, &picture)));
  eigenshade_picture_shade_q15(&picture, 0, 19661, 26214, &found);
  printf(\"%d %d %d\\n\", (int)found.r, (int)found.g, (int)found.b);
  return 0;
}
";

#[test]
fn c_draws_with_the_table_of_a_scene() {
    let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join("own_table.c");
    fs::write(&source, PROGRAM).expect("the program is written");
    let header = table_header::header();
    let program = compiled("own_table", &[&source], &[("eigenshade_table.h", &header)]);

    let light = LOBBY.map(|light| {
        let mantissas = &light.mantissas()[..(DEGREE + 1).pow(2)];
        q15::Light::new(light.exponent(), mantissas).expect("a light")
    });
    let material = GOLD_METALLIC_PAINT.map(|material| {
        let length = eigenshade_table::material::count(ORDER);
        let (exponents, mantissas) = (material.exponents(), material.mantissas());
        q15::Material::new(&exponents[..=ORDER], &mantissas[..length]).expect("a material")
    });
    let scene = table::q15::color::scene(light, material).expect("a scene");
    let normal = q15::Normal::from_unit(Q15(0), Q15(19_661), Q15(26_214)).expect("a normal");
    let found = scene.shade(normal);
    let expected = format!(
        "its table\nthe degree of the light is above that of the table or object; leave out the coefficients above\n\
         success\n{} {} {}\n",
        found.r, found.g, found.b
    );
    assert_eq!(run(&mut Command::new(program)), expected);
}
