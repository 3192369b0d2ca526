//! `export --lang rust` and `--lang c`: source that compiles and holds the numbers of the files.

use crate::compiled::output_of;
use crate::support::{
    BASIS, Folder, PAIR, SOURCES, assert_contains, repository, repository_text, stderr,
};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::shipped;
use eigenshade_table::material;
use std::process::Command;

/// Two lights in color and materials in gray, whose names are no identifiers.
fn named() -> Folder {
    let folder = Folder::new();
    folder.replace("materials.csv", "material-0", "01-felt /*");
    folder.replace("materials.csv", "material-1", "Ω 2");
    folder
}

/// The numbers that source should hold, as text: name, then coefficients in f32, channel by
/// channel, three for each.
fn expected(folder: &Folder) -> Vec<Vec<f32>> {
    let lights = read_lights(folder.path("lights.csv"), None).expect("lights").entries;
    let materials = read_materials(folder.path("materials.csv"), None).expect("materials").entries;
    let channels = lights.into_iter().chain(materials).flat_map(|entry| entry.rgb);
    channels.map(|channel| channel.iter().map(|&number| number as f32).collect()).collect()
}

/// Asserts that a program printed these in each format: lines of bits of f32, or of mantissas and
/// exponents.
fn assert_printed(text: &str, formats: &[&str], expected: &[Vec<f32>]) {
    assert_eq!(text.lines().count(), formats.len() * expected.len(), "{text}");
    let all = formats.iter().flat_map(|format| expected.iter().map(move |one| (*format, one)));
    for (line, (format, expected)) in text.lines().zip(all) {
        let found: Vec<i64> =
            line.split_whitespace().map(|word| word.parse().expect("a number")).collect();
        if format == "f32" {
            let bits: Vec<i64> = expected.iter().map(|number| number.to_bits().into()).collect();
            assert_eq!(found, bits);
            continue;
        }
        // Pairs of mantissa and exponent: within half a unit, or a unit at the largest mantissa.
        let pairs = found.chunks(2);
        assert_eq!(pairs.len(), expected.len());
        for (pair, number) in pairs.zip(expected) {
            let unit = 2f64.powi(pair[1] as i32);
            let error = (pair[0] as f64 * unit - f64::from(*number)).abs();
            assert!(error <= if pair[0].abs() == 32_767 { unit } else { unit / 2.0 }, "{number}");
        }
        let most = found.chunks(2).map(|pair| pair[0].abs()).max();
        assert!(most >= Some(1 << 14), "{most:?}");
    }
}

/// The constants of the exported lights and materials in Rust and in C, in the order of
/// [`expected`].
const CONSTANTS: [(&str, &str); 7] = [
    ("light::LIGHT_0", "light_light_0"),
    ("light::LIGHT_1", "light_light_1"),
    ("light::LIGHT_2", "light_light_2"),
    ("material::_01_FELT", "material_01_felt"),
    ("material::_2", "material_2"),
    ("material::MATERIAL_2", "material_material_2"),
    ("material::MATERIAL_3", "material_material_3"),
];

#[test]
fn rust_source_compiles_and_holds_the_numbers() {
    let folder = named();
    let mut modules = Vec::new();
    for format in ["f32", "q15"] {
        folder.ok(&format!("export --lang rust --format {format} {PAIR} --out {format}.rs"));
        modules.push((format!("of_{format}"), folder.read(&format!("{format}.rs"))));
        let formatted = Command::new("rustfmt")
            .args(["--check", "--edition", "2024"])
            .arg(folder.path(&format!("{format}.rs")))
            .output();
        // The component may be missing.
        if let Ok(output) = formatted {
            let text = String::from_utf8_lossy(&output.stdout);
            assert!(!text.contains("Diff in"), "{text}");
        }
    }
    // A table too.
    folder.ok(BASIS);
    folder.ok("export --lang rust --table b.bin --out table.rs");
    modules.push(("table".to_owned(), folder.read("table.rs")));
    let mut body = String::new();
    for (constant, _) in CONSTANTS {
        body += &format!(
            "for channel in [of_f32::{constant}.r, of_f32::{constant}.g, of_f32::{constant}.b] {{
                for number in channel.coefficients() {{ print!(\"{{}} \", number.to_bits()); }}
                println!();
            }}\n"
        );
    }
    let orders: Vec<usize> = material::indices(7).map(|(o, ..)| o).collect();
    let of_material = format!("channel.exponents()[{orders:?}[_k]]");
    for (constant, _) in CONSTANTS {
        let exponent =
            if constant.starts_with("light") { "channel.exponent()" } else { &of_material };
        body += &format!(
            "for channel in [of_q15::{constant}.r, of_q15::{constant}.g, of_q15::{constant}.b] {{
                for (_k, number) in channel.mantissas().iter().enumerate() {{
                    print!(\"{{}} {{}} \", number.0, {exponent});
                }}
                println!();
            }}\n"
        );
    }
    body += "let _ = table::COMPONENTS;";
    let text = output_of("exported", &modules, &body);
    assert_printed(&text, &["f32", "q15"], &expected(&folder));
}

/// Code in C that prints numbers as bits.
const PRINT_BITS: &str = r#"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
static void print(const float *numbers, size_t count) {
  for (size_t k = 0; k < count; k++) {
    uint32_t bits;
    memcpy(&bits, &numbers[k], sizeof bits);
    printf("%" PRIu32 " ", bits);
  }
}
"#;

/// Code in C that prints lights and materials.
const PRINT: &str = r#"
static void light_f32(eigenshade_light_f32_t light) {
  print(light.coefficients, light.length);
  printf("\n");
}
static void material_f32(eigenshade_material_f32_t material) {
  print(material.coefficients, material.length);
  printf("\n");
}
static void light_q15(eigenshade_light_q15_t light) {
  for (size_t k = 0; k < light.length; k++) printf("%d %d ", light.mantissas[k], (int)light.exponent);
  printf("\n");
}
static void material_q15(eigenshade_material_q15_t material) {
  static const size_t counts[] = {1, 2, 5, 8, 14, 20, 30, 40};
  size_t o = 0;
  for (size_t k = 0; k < material.length; k++) {
    while (k >= counts[o]) o++;
    printf("%d %d ", material.mantissas[k], material.exponents[o]);
  }
  if (material.exponents_length != material.order + 1) printf("exponents");
  printf("\n");
}
"#;

/// Compiles a program as C and as C++, runs both, and returns what each prints.
fn printed_in_c(folder: &Folder, program: &str) -> Vec<String> {
    let sources = [("cc", "c99", "main.c"), ("c++", "c++17", "main.cpp")];
    let printed = sources.into_iter().map(|(compiler, standard, source)| {
        folder.write(source, program);
        let output = Command::new(compiler)
            .arg(format!("-std={standard}"))
            .args(["-Wall", "-Wextra", "-Wconversion", "-Wpedantic", "-Werror", "-o", "program"])
            .arg("-I")
            .arg(repository().join("crates/capi/include").canonicalize().expect("a path"))
            .arg(source)
            .current_dir(folder.path("."))
            .output()
            .expect("a compiler");
        assert!(output.status.success(), "{}", stderr(&output));
        let output = Command::new(folder.path("program")).output().expect("the program runs");
        assert!(output.status.success(), "{:?}", output.status);
        String::from_utf8(output.stdout).expect("text")
    });
    printed.collect()
}

#[test]
fn c_headers_compile_and_hold_the_numbers() {
    let folder = named();
    let mut body = String::new();
    for format in ["f32", "q15"] {
        folder.ok(&format!("export --lang c --format {format} {PAIR} --out {format}.h"));
        for (_, name) in CONSTANTS {
            let kind = name.split('_').next().expect("a kind");
            for channel in ["r", "g", "b"] {
                body += &format!("  {kind}_{format}({name}_{format}.{channel});\n");
            }
        }
    }
    folder.ok("pack-object sphere --size 16 --out ball.bin");
    folder.ok("pack-object sphere --size 16 --out ball.h");
    assert!(folder.read("ball.h").lines().all(|line| line.len() <= 100));
    let codes = folder.bytes("ball.bin");
    let sum: usize = codes.iter().enumerate().map(|(k, &code)| k * usize::from(code)).sum();
    body += &format!(
        "  size_t sum = 0;
  const eigenshade_normal_map_t *map = &normal_map_ball;
  for (size_t k = 0; k < map->length; k++) sum += k * map->codes[k];
  if (map->width != 16 || map->height != 16 || map->length != {}) return 1;
  if (sum != {sum}) return 2;\n",
        codes.len()
    );
    let twice = "#include \"f32.h\"\n#include \"q15.h\"\n#include \"ball.h\"\n".repeat(2);
    let program = format!("{twice}{PRINT_BITS}{PRINT}int main(void) {{\n{body}  return 0;\n}}\n");
    for text in printed_in_c(&folder, &program) {
        assert_printed(&text, &["f32", "q15"], &expected(&folder));
    }
}

/// Code in C that prints the numbers of sources and of a gloss.
const PRINT_HIGHLIGHTS: &str = r#"
static void source(const eigenshade_source_f32_t *one) {
  print(one->direction, 3);
  print(one->energy, 3);
  print(&one->spread, 1);
  printf("\n");
}
static void gloss(const eigenshade_gloss_f32_t *one) {
  print(&one->roughness, 1);
  print(one->reflectance, 3);
  print(one->grazing, 3);
  print(one->albedo, 3);
  printf("\n");
}
"#;

#[test]
fn sources_and_gloss_compile_and_hold_the_numbers() {
    let folder = Folder::new();
    let inputs = "--light studio --material gold-metallic-paint --sources 4";
    for (lang, file) in [("rust", "scene.rs"), ("c", "scene.h")] {
        folder.ok(&format!("export --lang {lang} {inputs} --out {file}"));
    }
    let lights = shipped::sources().expect("sources");
    let studio = lights.iter().find(|light| light.name == "studio").expect("the studio");
    let sources = studio.first(4);
    assert_eq!(sources.len(), 4);
    let glosses = shipped::glosses().expect("gloss");
    let gold = glosses.iter().find(|one| one.name == "gold-metallic-paint").expect("gold").gloss;
    let line = |numbers: Vec<f64>| numbers.iter().map(|&number| number as f32).collect();
    let mut expected: Vec<Vec<f32>> = sources
        .iter()
        .map(|one| line([&one.direction[..], &one.energy, &[one.spread]].concat()))
        .collect();
    let colors = [&[gold.roughness][..], &gold.reflectance, &gold.grazing, &gold.albedo];
    expected.push(line(colors.concat()));

    let program = format!(
        "#include \"scene.h\"\n{PRINT_BITS}{PRINT_HIGHLIGHTS}int main(void) {{
  for (size_t k = 0; k < sizeof sources_studio_f32 / sizeof *sources_studio_f32; k++)
    source(&sources_studio_f32[k]);
  gloss(&gloss_gold_metallic_paint_f32);
  return 0;\n}}\n"
    );
    for text in printed_in_c(&folder, &program) {
        assert_printed(&text, &["f32"], &expected);
    }
    // The page's example makes the runtime's types.
    let page = repository_text("docs/commands.md");
    let (_, example) = page.split_once("```rust\n").expect("an example");
    let (example, _) = example.split_once("```").expect("its end");
    let body = "for &(name, of_light) in scene::sources::ALL {
            assert_eq!(name, \"studio\");
            for &(direction, energy, spread) in of_light {
                for number in [direction, energy].concat() { print!(\"{} \", number.to_bits()); }
                println!(\"{}\", spread.to_bits());
            }
        }
        for &(name, (roughness, f0, albedo, f90)) in scene::gloss::ALL {
            assert_eq!(name, \"gold-metallic-paint\");
            print!(\"{} \", roughness.to_bits());
            for number in [f0, f90, albedo].concat() { print!(\"{} \", number.to_bits()); }
        }";
    let modules = [("scene".to_owned(), folder.read("scene.rs"))];
    let made = format!(
        "fn made() -> Result<(), eigenshade::Error> {{
                        use eigenshade::{{Gloss, Source}};
            use scene::{{gloss, sources}};
            {example}
            let first = sources::ALL[0].1;
            let made = first.iter().map(record).collect::<Result<Vec<_>, _>>()?;
            for (made, given) in made.iter().zip(first) {{
                let energy = made.energy();
                assert_eq!([energy.r, energy.g, energy.b], given.1);
            }}
            let grazing = gloss.grazing();
            assert_eq!([grazing.r, grazing.g, grazing.b], gloss::ALL[0].1.3);
            Ok(())
        }}
        assert!(made().is_ok());
        {body}"
    );
    assert_printed(&output_of("highlights", &modules, &made), &["f32"], &expected);

    // JavaScript has them with the channels.
    let js = folder.ok(&format!("export --lang js {inputs}"));
    let count = |name: &str| {
        let (_, list) = js.split_once(name).expect("a list");
        let (list, _) = list.split_once("])").expect("its end");
        list.split(',').filter(|number| !number.trim().is_empty()).count()
    };
    assert_eq!(count("sources: new Float32Array(["), 7 * sources.len());
    assert_eq!(count("gloss: new Float32Array(["), 10);
}

#[test]
fn sources_fit_a_material_in_integers() {
    let folder = Folder::new();
    folder.write("lights.sources.csv", format!("{SOURCES}light-0,{LAMP}\nx\u{202e}y,{LAMP}\n"));
    // A name that turns the direction of text around, in comments of a header.
    folder.write("named.csv", folder.read("lights.csv").replace("light-0", "x\u{202e}y"));
    folder.write("named.sources.csv", folder.read("lights.sources.csv"));
    let material = "--material nylon --format q15";
    folder.ok(&format!(
        "export --lang c --light lights.csv:light-0 {material} --sources 4 --out a.h"
    ));
    folder.ok("export --lang c --light named.csv:x\u{202e}y --sources 1 --out b.h");
    let more =
        format!("export --lang c --light lights.csv:light-0 {material} --sources 2 --out c.h");
    let one = "note: `light-0` has 1 source, of 2 asked for";
    assert_contains(&folder.messages(&more), &[one]);
    let call = "  (void)sizeof(eigenshade_residual_q15(&light_light_0_q15, sources_light_0_f32,
                                       sources_light_0_count, 0, 0));
  printf(\"%d\\n\", sources_light_0_count);";
    for (header, count) in [("a.h", "1\n"), ("c.h", "1\n")] {
        let program = format!(
            "#include \"{header}\"\n#include \"b.h\"\n#include <stdio.h>\n\
             int main(void) {{\n{call}\n  \
             (void)material_nylon_q15, (void)gloss_nylon_f32, (void)light_x_y_f32;\n  \
             return (int)sources_x_y_f32[0].spread;\n}}\n"
        );
        assert_eq!(printed_in_c(&folder, &program), [count, count]);
    }
}

const LAMP: &str = "0,0,1,1,1,1,0.1";
