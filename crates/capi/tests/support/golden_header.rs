//! The golden file as a C header of constant arrays.

#[path = "../../../testing/src/golden/record.rs"]
#[expect(dead_code, reason = "writing is not used here")]
mod record;

use record::{Golden, Row};

const FILE: &str = include_str!("../../../../tests/golden/sphere.csv");

/// Its text.
pub fn text() -> Result<String, String> {
    let golden = Golden::parse(FILE)?;
    let mut text = String::from(
        "/* cargo run -p eigenshade-capi --example golden_header */\n\n#include <stdint.h>\n\n",
    );
    let pairs = golden.pairs();
    text += &format!("#define GOLDEN_PAIRS {}\n", pairs.len());
    text += &array("float", "golden_tolerance", golden.find("f32", [""; 3], "tolerance")?);
    for (format, kind) in [("f32", "float"), ("q15", "int16_t")] {
        let normals = golden.find(format, [""; 3], "normals")?;
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let of_axis = normals.numbers.iter().skip(axis).step_by(3).cloned().collect();
            let row = Row { numbers: of_axis, ..normals.clone() };
            text += &array(kind, &format!("golden_{name}_{format}"), &row);
        }
        let (count, upper) = (normals.numbers.len() / 3, format.to_uppercase());
        text += &format!("#define GOLDEN_NORMALS_{upper} {count}\n");
        let answer = if format == "f32" { "float" } else { "int32_t" };
        for (name, kind, exponent) in [
            ("light", kind, "int32_t"),
            ("material", kind, "int8_t"),
            ("d", answer, "int32_t"),
            ("irradiance", answer, "int32_t"),
        ] {
            let rows = pairs.iter().map(|&pair| golden.find(format, pair, name));
            let rows = rows.collect::<Result<Vec<&Row>, String>>()?;
            text += &arrays(kind, &format!("golden_{name}_{format}"), &rows, |row| &row.numbers);
            if format != "f32" {
                let name = format!("golden_{name}_exponents_{format}");
                text += &arrays(exponent, &name, &rows, |row| &row.exponents);
            }
        }
    }
    Ok(text)
}

/// A C literal. The least 32-bit integer has none of its own.
fn literal(kind: &str, number: &str) -> String {
    match (kind, number) {
        ("float", number) if number.contains(['.', 'e']) => format!("{number}f"),
        ("float", number) => format!("{number}.0f"),
        (_, "-2147483648") => "INT32_MIN".into(),
        (_, number) => number.into(),
    }
}

fn list<T: ToString>(kind: &str, numbers: &[T]) -> String {
    let numbers: Vec<String> =
        numbers.iter().map(|number| literal(kind, &number.to_string())).collect();
    let lines: Vec<String> = numbers.chunks(8).map(|line| line.join(", ")).collect();
    lines.join(",\n  ")
}

fn array(kind: &str, name: &str, row: &Row) -> String {
    let numbers = list(kind, &row.numbers);
    format!("static const {kind} {name}[{}] = {{\n  {numbers}\n}};\n", row.numbers.len())
}

/// One array for each pair.
fn arrays<T: ToString>(
    kind: &str,
    name: &str,
    rows: &[&Row],
    numbers: impl Fn(&Row) -> &Vec<T>,
) -> String {
    let length = rows.first().map_or(0, |row| numbers(row).len());
    let lists: Vec<String> =
        rows.iter().map(|row| format!("{{\n  {}\n}}", list(kind, numbers(row)))).collect();
    format!("static const {kind} {name}[][{length}] = {{ {} }};\n", lists.join(", "))
}
