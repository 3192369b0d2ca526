//! The library exports what the header declares, and the C program of `example/` passes its checks
//! on the host, compiled with sanitizers and linked with the static library.
#![cfg(all(unix, not(feature = "own-table")))]

#[path = "support/golden_header.rs"]
mod golden_header;

#[path = "support/pictures.rs"]
mod pictures;

#[path = "support/program.rs"]
mod program;

use eigenshade::object::{Disc, NormalMap, Object};
use eigenshade::presets::{light, material};
use eigenshade::screen::{Display, LinearPalette, Meter, Palette, Target, Tone};
use eigenshade::sphere::{self, q15};
use eigenshade::{Effect, Error, Material};
use pictures::objects;
use program::{compiled, library, run};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

#[test]
fn the_library_exports_the_functions_of_the_header() {
    let symbols = run(Command::new("nm").args(["-g", "--defined-only"]).arg(library()));
    let names = symbols.lines().filter_map(|line| Some(line.rsplit_once(' ')?.1));
    // On some systems C's names have an underscore in front.
    let names = names.map(|name| name.trim_start_matches('_'));
    let exported: BTreeSet<&str> = names.filter(|name| name.starts_with("eigenshade_")).collect();
    let headers = concat!(
        include_str!("../include/eigenshade.h"),
        include_str!("../include/eigenshade_presets.h"),
    );
    // Functions and constants, but no types.
    let names = headers.lines().filter_map(|line| {
        let is_function = ["eigenshade_status ", "const char *", "uint32_t "];
        let end = match line.strip_prefix("extern const ") {
            Some(_) => line.find([';', '['])?,
            None if is_function.iter().any(|start| line.starts_with(start)) => line.find('(')?,
            None => return None,
        };
        line.get(..end)?.split([' ', '*']).next_back()
    });
    let declared: BTreeSet<&str> = names.collect();
    assert_eq!(exported, declared);
}

#[test]
fn the_checks_hold_under_sanitizers() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("example");
    let sources = "host print all checks golden_vectors faults target_faults object_faults color textured shadowed";
    let sources: Vec<PathBuf> =
        sources.split(' ').map(|name| example.join(format!("{name}.c"))).collect();
    let sources: Vec<&Path> = sources.iter().map(PathBuf::as_path).collect();
    let golden = golden_header::text().expect("the golden file");
    let objects = objects::text().expect("objects");
    let headers = [("golden.h", &*golden), ("objects.h", &*objects)];
    let program = compiled("checks", &sources, &headers);
    let pictures = pictures::lines().expect("pictures");
    assert_eq!(run(&mut Command::new(program)), format!("{pictures}0 faults\n"));
}

/// Masks one preset of each in a format, in the second channel a shorter one, and prints numbers.
const MASKS: &str = "\
#include \"eigenshade_presets.h\"
#include <stdio.h>

static void print(size_t largest, size_t length, const NUMBER *numbers) {
  printf(\"%zu\", largest);
  for (size_t k = 0; k < length; k++) printf(\" %.9g\", (double)numbers[k]);
  puts(\"\");
}

int main(void) {
  static eigenshade_light_buffer_FORMAT_t light_buffer;
  static eigenshade_material_buffer_FORMAT_t material_buffer;
  eigenshade_color_light_FORMAT_t light = eigenshade_light_lobby_FORMAT, L;
  eigenshade_color_material_FORMAT_t material = eigenshade_material_gold_metallic_paint_FORMAT, M;
  light.g.degree = 2;
  light.g.length = 9;
  material.g.order = 4;
  material.g.length = 14;
  SHORTER
  for (int32_t effect = EIGENSHADE_EFFECT_AMBIENT; effect <= EIGENSHADE_EFFECT_GLOSS; effect++) {
    if (eigenshade_mask_light_FORMAT(&light, effect, &light_buffer, &L)) return 1;
    if (eigenshade_mask_material_FORMAT(&material, effect, &material_buffer, &M)) return 1;
    print(L.r.degree, L.r.length, L.r.NUMBERS);
    print(L.g.degree, L.g.length, L.g.NUMBERS);
    print(L.b.degree, L.b.length, L.b.NUMBERS);
    print(M.r.order, M.r.length, M.r.NUMBERS);
    print(M.g.order, M.g.length, M.g.NUMBERS);
    print(M.b.order, M.b.length, M.b.NUMBERS);
  }
  return 0;
}
";

/// What `MASKS` prints, from the coefficients of light and material.
fn masked<S: Copy + Default>(
    light: [&[S]; 3],
    material: [&[S]; 3],
    number: fn(S) -> f32,
) -> Vec<Vec<f32>> {
    let [r, g, b] = light;
    let lights = [(9.0, r), (2.0, &g[..9]), (9.0, b)];
    let [r, g, b] = material;
    let materials = [(7.0, r), (4.0, &g[..14]), (7.0, b)];
    let mut lines = Vec::new();
    for effect in Effect::ALL {
        let line = |(largest, from): (f32, &[S]), mask: &dyn Fn(&mut [S])| {
            let mut numbers = from.to_vec();
            mask(&mut numbers);
            [largest].into_iter().chain(numbers.into_iter().map(number)).collect()
        };
        lines.extend(lights.map(|from| line(from, &|numbers| effect.mask_light(numbers))));
        lines.extend(materials.map(|from| line(from, &|numbers| effect.mask_material(numbers))));
    }
    lines
}

/// C masks the coefficients that Rust does, in both formats to the bit.
#[test]
fn masks_are_those_of_rust() {
    let of_float = masked(
        light::LOBBY.map(|light| light.coefficients()).into(),
        material::GOLD_METALLIC_PAINT.map(|material| material.coefficients()).into(),
        |number| number,
    );
    let of_integers = masked(
        light::q15::LOBBY.map(|light| light.mantissas()).into(),
        material::q15::GOLD_METALLIC_PAINT.map(|material| material.mantissas()).into(),
        |number| number.0.into(),
    );
    for (format, number, numbers, shorter, expected) in [
        ("f32", "float", "coefficients", "", of_float),
        ("q15", "int16_t", "mantissas", "material.g.exponents_length = 5;", of_integers),
    ] {
        let text = MASKS.replace("FORMAT", format).replace("SHORTER", shorter);
        let text = text.replace("NUMBERS", numbers).replace("NUMBER", number);
        let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("masks_{format}.c"));
        fs::write(&source, text).expect("the program is written");
        let name = format!("masks_{format}");
        let printed = run(&mut Command::new(compiled(&name, &[&source], &[])));
        let numbers = |line: &str| -> Vec<f32> {
            line.split(' ').map(|number| number.parse().expect("a number")).collect()
        };
        let found: Vec<Vec<f32>> = printed.lines().map(numbers).collect();
        assert_eq!(found, expected, "{format}");
    }
}

/// The README's examples in C.
fn examples() -> [&'static str; 5] {
    let texts = include_str!("../README.md").split("```c\n").skip(1);
    let texts: Vec<&str> = texts.filter_map(|text| text.split("```").next()).collect();
    texts.try_into().expect("five examples")
}

/// The README's second example meters a picture as Rust does, in floats and in integers to a step of
/// the meter, an eighth of a power of two.
#[test]
fn the_readme_meters_an_exposure() {
    let [_, meter, ..] = examples();
    let main = "#include <stdio.h>\nint main(void) {\n  float exposure = 7;\n  \
                static eigenshade_picture_f32_t picture;\n  eigenshade_status status = \
                eigenshade_picture_begin_f32(&eigenshade_light_studio_f32, \
                &eigenshade_material_gold_metallic_paint_f32, &picture);\n  status |= \
                metered(&picture, &exposure);\n  printf(\"%.9g\\n\", exposure);\n  \
                return status;\n}\n";
    let scene =
        sphere::color::scene(light::STUDIO, material::GOLD_METALLIC_PAINT).expect("a scene");
    let mut of_rust = Meter::default();
    Disc::new(64).into_iter().flatten().for_each(|pixel| of_rust.add(scene.shade(pixel.normal())));
    let expected = of_rust.exposure().expect("it is lit").factor();
    for format in ["f32", "q15"] {
        let text = meter.replace("picture_f32", &format!("picture_{format}"));
        let text = text.replace("row_f32", &format!("row_{format}"));
        let main = ["picture_", "begin_", "studio_", "paint_"]
            .into_iter()
            .fold(main.to_owned(), |text, name| {
                text.replace(&format!("{name}f32"), &format!("{name}{format}"))
            });
        let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("meter_{format}.c"));
        fs::write(&source, text + &main).expect("the example is written");
        let name = format!("meter_{format}");
        let printed = run(&mut Command::new(compiled(&name, &[&source], &[])));
        let found: f32 = printed.trim().parse().expect("an exposure");
        println!("{format}: {found} {expected}");
        // A pixel beside the border of a step may be counted on its other side.
        assert!((found / expected).log2().abs() < 0.126, "{format}: {found} {expected}");
    }
}

/// The README's fifth example draws brighter highlights, in both formats.
#[test]
fn the_readme_draws_highlights() {
    let [plain, .., glossy] = examples();
    let main = "#include <stdio.h>\nint main(void) {\n  static uint16_t other[240 * 240];\n  \
                const eigenshade_target_t target = {.pixels = other, .length = sizeof other, \
                .stride = 480, .width = 240, .height = 240};\n  \
                const int status = draw() || draw_glossy(&target);\n  \
                for (size_t k = 0; k < 240 * 240; k++) printf(\"%u %u\\n\", (unsigned)screen[k], \
                (unsigned)other[k]);\n  return status;\n}\n";
    for format in ["f32", "q15"] {
        // The sources and the gloss stay in float.
        let of_float = ["gloss_gold_metallic_paint_", "sources_lobby_", "eigenshade_source_"];
        let glossy = of_float.into_iter().fold(glossy.replace("f32", format), |text, name| {
            text.replace(&format!("{name}{format}"), &format!("{name}f32"))
        });
        let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("glossy_{format}.c"));
        fs::write(&source, plain.to_owned() + &glossy + main).expect("the examples are written");
        let name = format!("glossy_{format}");
        let text = run(&mut Command::new(compiled(&name, &[&source], &[])));
        // Levels of green, of which 63 is white.
        let green = |column| {
            text.lines().map(move |line| {
                let pixel = line.split(' ').nth(column).and_then(|pixel| pixel.parse::<u16>().ok());
                (pixel.expect("a pixel") >> 5) & 63
            })
        };
        let sum = |column| green(column).map(u64::from).sum::<u64>();
        let [without, with] = [0, 1].map(sum);
        assert!(without.abs_diff(with) < without / 20, "{format}: {without}, {with}");
        let sharper = green(0).zip(green(1)).filter(|(without, with)| *with > without + 5).count();
        assert!(sharper > 200, "{format}: {sharper}");
    }
}

/// The sphere of the README of the runtime, of this many pixels across.
fn gold_sphere(size: usize) -> Result<Vec<u16>, Error> {
    let display = Display::new(Tone::Filmic);
    let scene = q15::color::scene(light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT)?;
    let exposure = scene.exposure_by_factor(1.5)?;
    let mut screen = vec![0; size * size];
    let mut target = Target::new(&mut screen, size)?;
    for pixel in Disc::new(size)? {
        pixel.put(&mut target, display.rgb565(exposure.of(scene.shade(pixel.normal_q15()))));
    }
    Ok(screen)
}

/// The README's sphere is that of the README of the runtime: in integers the same pixels, in floats
/// to one level of a channel.
#[test]
fn the_readme_draws_the_same_sphere_as_rust() {
    let [example, ..] = examples();
    let main = "#include <stdio.h>\nint main(void) {\n  const eigenshade_status status = draw();\n  \
                for (size_t k = 0; k < 240 * 240; k++) printf(\"%u\\n\", (unsigned)screen[k]);\n  \
                return status;\n}\n";
    let drawn = |format: &str| -> Vec<u16> {
        let example = example.replace("f32", format);
        let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("readme_{format}.c"));
        fs::write(&source, example + main).expect("the example is written");
        let name = format!("readme_{format}");
        let program = compiled(&name, &[&source], &[]);
        let text = run(&mut Command::new(program));
        text.lines().map(|line| line.parse().expect("a pixel")).collect()
    };
    let expected = gold_sphere(240).expect("a sphere");
    assert!(drawn("q15") == expected);
    for (found, expected) in drawn("f32").into_iter().zip(expected) {
        assert_near(found, expected);
    }
}

/// Pixels that differ by one level of a channel at most.
fn assert_near(found: u16, expected: u16) {
    for (low, bits) in [(0, 5), (5, 6), (11, 5)] {
        let level = |pixel: u16| (pixel >> low) & ((1 << bits) - 1);
        assert!(level(found).abs_diff(level(expected)) <= 1);
    }
}

/// The README's third example sends the bytes of a palette's picture under turned light: in integers
/// those of Rust.
#[test]
fn the_readme_sends_frames() {
    let [_, _, frames, ..] = examples();
    let main = "#include <stdio.h>\nvoid send(const uint8_t *bytes, size_t length) {\n  \
                for (size_t k = 0; k < length; k++) printf(\"%u\\n\", (unsigned)bytes[k]);\n}\n\
                int main(void) {\n  static const float quaternion[4] = {1, -2, 3, 4};\n  \
                return begin() || draw_frame(quaternion);\n}\n";
    let drawn = |format: &str, number: &str| -> Vec<u8> {
        let text = (frames.to_owned() + main).replace("f32", format).replace("float", number);
        let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("frames_{format}.c"));
        fs::write(&source, text).expect("the example is written");
        let name = format!("frames_{format}");
        let text = run(&mut Command::new(compiled(&name, &[&source], &[])));
        text.lines().map(|line| line.parse().expect("a byte")).collect()
    };
    let expected = gold_frame(240).expect("a frame");
    assert!(drawn("q15", "int32_t") == expected.as_flattened());
    let found = drawn("f32", "float");
    for (found, expected) in found.as_chunks().0.iter().zip(expected) {
        assert_near(u16::from_be_bytes(*found), u16::from_be_bytes(expected));
    }
    assert_eq!(found.len(), 2 * 240 * 240);
}

/// A frame of the README's third example.
fn gold_frame(size: usize) -> Result<Vec<[u8; 2]>, Error> {
    let display = Display::new(Tone::Filmic);
    let rotation = eigenshade::q15::Rotation::from_quaternion([1, -2, 3, 4])?;
    let turned = light::q15::LOBBY.turned::<{ sphere::LIGHT }>(&rotation)?;
    let gold = q15::color::transfer(material::q15::GOLD_METALLIC_PAINT)?;
    let scene = q15::color::relight(&gold, turned.lights()?)?;
    let exposure = scene.exposure_by_factor(1.5)?;
    let mut codes = vec![NormalMap::BACKGROUND; size * size];
    NormalMap::sphere(size, &mut codes)?;
    let map = NormalMap::new(size, size, codes.as_flattened())?;
    let mut palette = Palette::default();
    palette.fill_mirrored(&map.nodes(), &display, |normal: eigenshade::q15::Normal| {
        scene.shade_mirrored(normal).map(|irradiance| exposure.of(irradiance))
    });
    let mut screen = vec![[0; 2]; size * size];
    palette.draw(&map, &mut Target::new(&mut screen, size)?);
    Ok(screen)
}

/// A frame of the README's fourth example in one format, as Rust draws it.
macro_rules! plastic_frame {
    ($object:expr, $lights:path, $sphere:ident, $rotation:expr, $materials:ident, $material:expr) => {{
        let turned = $lights.turned::<{ sphere::LIGHT }>(&$rotation?)?;
        let region = $object.regions().next().expect("it has one");
        let parts = region.$materials()?;
        let [tinted, plain] = parts.each_ref().map(|numbers| {
            let scene = $sphere::color::scene(turned.lights()?, $material(numbers)?)?;
            Ok::<_, Error>((scene.exposure_by_factor(1.5)?, scene))
        });
        let parts = [tinted?, plain?];
        let mut palette = LinearPalette::default();
        palette.fill_mirrored(&$object.nodes(0), |normal| {
            parts.each_ref().map(|(exposure, scene)| {
                scene.shade_mirrored(normal).map(|irradiance| exposure.of(irradiance))
            })
        });
        let mut screen = vec![[0; 2]; 120 * 120];
        let display = Display::new(Tone::Filmic);
        let painted = $object.painted(core::slice::from_ref(&palette), &display)?;
        painted.draw(&mut Target::new(&mut screen, 120)?);
        Ok::<_, Error>(screen)
    }};
}

/// The README's fourth example sends the bytes of a textured object under turned light: in both
/// formats those of Rust.
#[test]
fn the_readme_sends_textured_frames() {
    let [.., frames, _] = examples();
    let main = "#include <stdio.h>\nvoid send(const uint8_t *bytes, size_t length) {\n  \
                for (size_t k = 0; k < length; k++) printf(\"%u\\n\", (unsigned)bytes[k]);\n}\n\
                int main(void) {\n  static const float quaternion[4] = {1, -2, 3, 4};\n  \
                return begin() || draw_frame(quaternion);\n}\n";
    let bytes = objects::plastic().expect("an object");
    let header = objects::header(&[("eigenshade_object_t", "watch", bytes.clone())]);
    let drawn = |format: &str, number: &str| -> Vec<u8> {
        let text = (frames.to_owned() + main).replace("f32", format).replace("float", number);
        let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("textured_{format}.c"));
        fs::write(&source, text).expect("the example is written");
        let name = format!("textured_{format}");
        let program = compiled(&name, &[&source], &[("watch.h", &header)]);
        let text = run(&mut Command::new(program));
        text.lines().map(|line| line.parse().expect("a byte")).collect()
    };
    let of_rust = || -> Result<_, Error> {
        let object = Object::new(&bytes)?;
        let rotation = eigenshade::Rotation::from_quaternion([1.0, -2.0, 3.0, 4.0]);
        let of_floats =
            plastic_frame!(object, light::LOBBY, sphere, rotation, materials, Material::new)?;
        let rotation = eigenshade::q15::Rotation::from_quaternion([1, -2, 3, 4]);
        let of_integers = plastic_frame!(
            object,
            light::q15::LOBBY,
            q15,
            rotation,
            materials_q15,
            eigenshade::q15::MaterialBuffer::material
        )?;
        Ok((of_floats, of_integers))
    };
    let (of_floats, of_integers) = of_rust().expect("frames");
    assert!(drawn("q15", "int32_t") == of_integers.as_flattened());
    assert!(drawn("f32", "float") == of_floats.as_flattened());
    assert!(of_floats.iter().filter(|pixel| **pixel != [0; 2]).count() > 11_000);
}
