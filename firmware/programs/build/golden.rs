//! The golden vectors as statics.

#[path = "../../../crates/testing/src/golden/record.rs"]
#[expect(dead_code, reason = "it writes such files as well")]
mod record;

use crate::{Result, read};
pub use record::{Golden, Row};

const PATH: &str = "../../tests/golden/sphere.csv";

/// The golden file.
pub fn file() -> Result<Golden> {
    Golden::parse(&read(PATH)?).map_err(|fault| format!("{PATH}: {fault}"))
}

/// A module for each format.
pub fn modules() -> Result<String> {
    let golden = file()?;
    let formats = [("f32", "f32"), ("q15", "eigenshade::Q15")];
    formats.iter().map(|(format, number)| module(&golden, format, number)).collect()
}

fn module(golden: &Golden, format: &str, kind: &str) -> Result<String> {
    let float = format == "f32";
    // Coefficients of the format, and results, which are plain integers in the integer formats.
    let number =
        |text: &String| if float { format!("{text}_f32") } else { format!("{kind}({text})") };
    let list = |row: &Row| row.numbers.iter().map(number).collect::<Vec<_>>().join(", ");
    let results = |row: &Row| if float { list(row) } else { row.numbers.join(", ") };
    let exponent = |row: &Row| row.exponents.first().copied().unwrap_or(0);
    let (mut pairs, mut statics) = (String::new(), String::new());
    for (place, pair) in golden.pairs().into_iter().enumerate() {
        let row = |array| golden.find(format, pair, array);
        let (light, material) = (row("light")?, row("material")?);
        let (d, irradiance) = (row("d")?, row("irradiance")?);
        pairs += &format!(
            "super::Pair {{ light: &LIGHT_{place}, material: &MATERIAL_{place}, \
             d: (&[{}], {}), irradiance: (&[{}], {}) }},\n",
            results(d),
            exponent(d),
            results(irradiance),
            exponent(irradiance),
        );
        statics += &format!(
            "pub static LIGHT_{place}: super::Light<Format> = (&[{}], {});\n\
             pub static MATERIAL_{place}: super::Material<Format> = (&[{}], &{:?});\n",
            list(light),
            exponent(light),
            list(material),
            material.exponents,
        );
    }
    if float {
        let tolerance = golden.find(format, [""; 3], "tolerance")?;
        statics += &format!("pub const TOLERANCE: f32 = {};\n", tolerance.numbers.join(""));
    }
    let normals = golden.find(format, [""; 3], "normals")?;
    let (result, count) = (if float { "f32" } else { "i32" }, golden.pairs().len());
    Ok(format!(
        "/// Golden vectors in this format.\n\
         #[expect(missing_docs, reason = \"generated\")]\n\
         pub mod {format} {{\n\
         pub type Format = {kind};\n\
         pub static NORMALS: [Format; {}] = [{}];\n\
         {statics}pub static PAIRS: [super::Pair<Format, {result}>; {count}] = [{pairs}];\n}}\n",
        normals.numbers.len(),
        list(normals),
    ))
}
