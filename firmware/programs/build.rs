//! Tables and golden vectors as statics, and the linker script of the start-up code.

#[path = "build/folded.rs"]
mod folded;

#[path = "build/ladder.rs"]
mod ladder;

#[path = "../../crates/testing/src/golden/record.rs"]
#[expect(dead_code, reason = "it writes such files as well")]
mod record;

use eigenshade_table::quantize::{Format, QuantizedParts};
use eigenshade_table::{rust_quantized, rust_source};
use record::{Golden, Row};
use std::path::PathBuf;
use std::{env, fs, process};

/// The table of light of degree 2 on Lambertian materials, and how far its polynomials are trimmed.
const LAMBERTIAN: (&str, f64) = ("../tables/lambertian.bin", 2e-4);

/// The tables of `../scenes`, whose polynomials are as short as the scene's tolerance allows.
/// Color and rotation change no number of a table: three scenes share the last.
const SCENES: [&str; 8] = [
    "ambient_lambertian",
    "ambient_velvet",
    "sky_lambertian",
    "park_lambertian",
    "park_lambertian_fine",
    "studio_plaster",
    "studio_velvet",
    "sun_leather",
];

/// The golden vectors.
const GOLDEN: &str = "../../tests/golden/sphere.csv";

fn main() {
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
    let tables = lambertian().and_then(|()| ladder::all()?.iter().try_for_each(rung));
    let tables = tables.and_then(|()| SCENES.into_iter().try_for_each(scene));
    if let Err(error) = tables.and_then(|()| golden(GOLDEN)).and_then(|()| one_material()) {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

/// Writes the statics of the Lambertian table.
fn lambertian() -> Result<(), String> {
    let (from, tolerance) = LAMBERTIAN;
    let mut table = decoded(from)?;
    eigenshade_table::trim::trim(&mut table, tolerance);
    bake(&table, "lambertian", from)
}

/// Writes the statics of a table of the ladder.
fn rung(rung: &ladder::Rung) -> Result<(), String> {
    bake(&rung.of(&decoded(&rung.from)?), &rung.name, &rung.from)
}

/// The table at `from`.
fn decoded(from: &str) -> Result<eigenshade_table::Table, String> {
    println!("cargo::rerun-if-changed={from}");
    let bytes = fs::read(from).map_err(|error| format!("{from}: {error}"))?;
    eigenshade_table::decode(&bytes).map_err(|error| format!("{from}: {error}"))
}

/// Writes the statics of a table made from the one at `from` to the output folder: `name`.rs,
/// `name`_q15.rs and `name`_q31.rs.
fn bake(table: &eigenshade_table::Table, name: &str, from: &str) -> Result<(), String> {
    let command = format!("build.rs, from {from}");
    for (format, suffix) in [(Format::Q15, "q15"), (Format::Q31, "q31")] {
        let parts = QuantizedParts::new(table, format, format.tolerance())
            .map_err(|error| format!("{from}: {error}"))?;
        write(&format!("{name}_{suffix}.rs"), &rust_quantized::module(&parts, &command))?;
    }
    write(&format!("{name}.rs"), &rust_source::module(table, &command))
}

/// Writes the statics of a scene to the output folder: `name`.rs, and `name`_q15.rs with its
/// material folded in.
fn scene(name: &str) -> Result<(), String> {
    let from = format!("../scenes/{name}.bin");
    let table = decoded(&from)?;
    let command = format!("build.rs, from {from}");
    let database = format!("../scenes/{}", table.scene.material.database);
    let in_q15 = folded::module(&table, &database, &command);
    write(&format!("{name}_q15.rs"), &in_q15.map_err(|error| format!("{from}: {error}"))?)?;
    write(&format!("{name}.rs"), &rust_source::module(&table, &command))
}

/// Writes the golden vectors as statics, a module for each format.
fn golden(from: &str) -> Result<(), String> {
    println!("cargo::rerun-if-changed={from}");
    let text = fs::read_to_string(from).map_err(|error| format!("{from}: {error}"))?;
    let golden = Golden::parse(&text).map_err(|fault| format!("{from}: {fault}"))?;
    for (format, kind) in [("f32", "f32"), ("q15", "eigenshade::Q15"), ("q31", "eigenshade::Q31")] {
        let number = |text: &String| match format {
            "f32" => format!("{text}_f32"),
            _ => format!("{kind}({text})"),
        };
        let list = |row: &Row| row.numbers.iter().map(number).collect::<Vec<_>>().join(", ");
        let plain = |row: &Row| {
            if format == "f32" { list(row) } else { row.numbers.join(", ") }
        };
        let exponents = |row: &Row| format!("{:?}", row.exponents);
        let one = |row: &Row| row.exponents.first().copied().unwrap_or(0);
        let answer = if format == "f32" { "f32" } else { "i32" };
        let (mut pairs, mut inputs) = (Vec::new(), String::new());
        for (number, pair) in golden.pairs().into_iter().enumerate() {
            let row = |array| golden.find(format, pair, array);
            let (light, material) = (row("light")?, row("material")?);
            let (d, irradiance) = (row("d")?, row("irradiance")?);
            pairs.push(format!(
                "super::Pair {{ light: &LIGHT_{number}, material: &MATERIAL_{number}, \
                 d: (&[{}], {}), irradiance: (&[{}], {}) }}",
                plain(d),
                one(d),
                plain(irradiance),
                one(irradiance),
            ));
            inputs += &format!(
                "pub static LIGHT_{number}: (&[{kind}], i32) = (&[{}], {});\n\
                 pub static MATERIAL_{number}: (&[{kind}], &[i8]) = (&[{}], &{});\n",
                list(light),
                one(light),
                list(material),
                exponents(material),
            );
        }
        let normals = golden.find(format, [""; 3], "normals")?;
        let mut text = format!(
            "pub static NORMALS: [{kind}; {}] = [{}];\n\
             {inputs}pub static PAIRS: [super::Pair<{kind}, {answer}>; {}] = [{}];\n",
            normals.numbers.len(),
            list(normals),
            pairs.len(),
            pairs.join(",\n"),
        );
        if format == "f32" {
            let tolerance = golden.find(format, [""; 3], "tolerance")?;
            text += &format!("pub const TOLERANCE: f32 = {};\n", tolerance.numbers.join(""));
        }
        write(&format!("golden_{format}.rs"), &text)?;
    }
    Ok(())
}

/// Writes the shipped table in Q15 for the golden file's first material alone: the
/// material is folded in here, and what takes materials in is left out.
fn one_material() -> Result<(), String> {
    use eigenshade::sphere::q15::{BASIS, PROFILES, TRANSFER, WORKSPACE};
    let from = "../../tables/sphere.bin";
    let table = decoded(from)?;
    let mut parts = QuantizedParts::new(&table, Format::Q15, Format::Q15.tolerance())
        .map_err(|error| format!("{from}: {error}"))?;
    for numbers in [&mut parts.polar, &mut parts.factors] {
        numbers.clear();
    }
    for exponents in [&mut parts.polar_exponents, &mut parts.factor_exponents] {
        exponents.clear();
    }
    let golden = fs::read_to_string(GOLDEN).map_err(|error| format!("{GOLDEN}: {error}"))?;
    let golden = Golden::parse(&golden)?;
    let pair = *golden.pairs().first().ok_or("no pair")?;
    let row = golden.find("q15", pair, "material")?;
    let mantissas: Vec<eigenshade::Q15> =
        row.integers()?.into_iter().map(|one| eigenshade::Q15(one as i16)).collect();
    let exponents: Vec<i8> = row.exponents.iter().map(|&one| one as i8).collect();
    let (mut numbers, mut of_profiles) = ([eigenshade::Q15(0); TRANSFER], [0; PROFILES]);
    eigenshade::quantized::Material::new(&exponents, &mantissas)
        .and_then(|material| {
            BASIS.transfer_into(&material, &mut [0; WORKSPACE], &mut numbers, &mut of_profiles)
        })
        .map_err(|error| error.to_string())?;
    let numbers = numbers.map(|eigenshade::Q15(number)| i32::from(number));
    let text = rust_quantized::module(&parts, "build.rs, of one material")
        + &rust_quantized::transfer(Format::Q15, &numbers, &of_profiles);
    write("one_material.rs", &text)
}

/// Writes a file of the output folder.
fn write(name: &str, text: &str) -> Result<(), String> {
    let to = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?).join(name);
    fs::write(&to, text).map_err(|error| format!("{}: {error}", to.display()))
}
