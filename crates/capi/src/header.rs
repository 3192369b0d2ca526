//! A test that the headers declare the constants, types and functions of this library, and nothing
//! else.

use crate::boundary::{Input, Mark, Output};
use crate::color::Channels;
use crate::constants::CONSTANTS;
use crate::status::{STATUSES, eigenshade_message};
use crate::{
    color, eigenshade_table, eigenshade_version, float, integers, presets, presets_header,
    table_header,
};
use core::ffi::c_char;
use eigenshade::{Display, Meter, Q15};
use std::collections::BTreeSet;
use std::string::String;
use std::vec::Vec;
use std::{format, vec};

const HEADER: &str = include_str!("../include/eigenshade.h");
const COLOR: &str = include_str!("../include/eigenshade_color.h");

/// A type that the header knows.
pub(crate) trait Declared {
    /// Declares a name of this type.
    fn declare(name: &str) -> String;
    /// Defines the structure that the type is or points to.
    fn define() -> String {
        String::new()
    }
}

macro_rules! numbers {
    ($($type:ty: $in_c:literal)*) => {$(
        impl Declared for $type {
            fn declare(name: &str) -> String {
                format!("{} {name}", $in_c)
            }
        }
    )*};
}
numbers! {
    usize: "size_t" f32: "float" i8: "int8_t" u8: "uint8_t" i16: "int16_t" u16: "uint16_t"
    i32: "int32_t" i64: "int64_t" Mark: "uint32_t" Display: "struct eigenshade_display_t"
    Q15: "int16_t"
}

impl<T: Declared> Declared for Input<T> {
    fn declare(name: &str) -> String {
        format!("const {}", T::declare(&format!("*{name}")))
    }
    fn define() -> String {
        T::define()
    }
}

impl<T: Declared> Declared for Output<T> {
    fn declare(name: &str) -> String {
        T::declare(&format!("*{name}"))
    }
    fn define() -> String {
        T::define()
    }
}

/// What points to an array is declared as a pointer to its first number.
impl<T: Declared, const N: usize> Declared for [T; N] {
    fn declare(name: &str) -> String {
        if name.starts_with('*') { T::declare(name) } else { T::declare(&format!("{name}[{N}]")) }
    }
}

/// Three channels have a name and a structure of their own.
impl<T: Declared> Declared for Channels<T> {
    fn declare(name: &str) -> String {
        T::declare(name).replacen("eigenshade_", "eigenshade_color_", 1)
    }
    fn define() -> String {
        structure::<Self>(&["r", "g", "b"].map(T::declare))
    }
}

/// Counts that C only keeps.
impl Declared for Meter {
    fn declare(name: &str) -> String {
        format!("struct eigenshade_meter_t {name}")
    }
    fn define() -> String {
        structure::<Self>(&["uint32_t counts[257]".into()])
    }
}

/// Defines a structure of these fields.
pub(crate) fn structure<T: Declared>(fields: &[String]) -> String {
    let structure = T::declare("");
    let fields = fields.iter().filter(|field| !field.is_empty());
    let fields: String = fields.map(|field| format!("{field}; ")).collect();
    format!("typedef {structure}{{ {fields}}} {};", structure.replace("struct ", "").trim())
}

/// Declares a function.
pub(crate) fn function(name: &str, arguments: &[String]) -> String {
    format!("eigenshade_status eigenshade_{name}({});", arguments.join(", "))
}

/// Defines the type of statuses.
fn statuses() -> Vec<String> {
    let mut names = String::new();
    for status in STATUSES {
        let mut name = String::new();
        for letter in format!("{status:?}").chars() {
            name.extend(letter.is_uppercase().then_some('_'));
            name.extend(letter.to_uppercase());
        }
        names += &format!("EIGENSHADE_STATUS{name} = {}, ", *status as i32);
    }
    vec![
        format!("enum eigenshade_status : int32_t {{ {names}}};"),
        "typedef enum eigenshade_status eigenshade_status;".into(),
        "typedef int32_t eigenshade_status;".into(),
    ]
}

/// The tone curves.
fn displays() -> Vec<String> {
    let display = "struct eigenshade_display_t";
    let declare = |name: &&str| format!("extern const {display} eigenshade_display_{name};");
    let mut declared: Vec<String> = presets::DISPLAYS.iter().map(declare).collect();
    declared.push(format!("typedef {display} eigenshade_display_t;"));
    declared
}

/// The directives and the rest of a header, without comments and with single spaces.
fn parts(header: &str) -> (Vec<&str>, String) {
    let code = header.split("/*").map(|part| part.split_once("*/").map_or(part, |(_, code)| code));
    let lines = code.flat_map(str::lines);
    let (directives, code): (Vec<&str>, Vec<&str>) = lines.partition(|line| line.starts_with('#'));
    let code = code.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
    (directives, code.replace("( ", "("))
}

/// Checks that a header declares these and nothing else.
fn declares(header: &str, expected: Vec<String>) {
    let (_, mut code) = parts(header);
    for (name, _, value) in CONSTANTS {
        code = code.replace(&format!("[EIGENSHADE_{name}]"), &format!("[{value}]"));
    }
    let (order, count) = (color::ORDER, color::MATERIAL);
    code = code.replace("[EIGENSHADE_METALLIC_ROUGHNESS]", &format!("[{count}]"));
    let exponents = format!("[{}]", order + 1);
    code = code.replace("[EIGENSHADE_METALLIC_ROUGHNESS_ORDER + 1]", &exponents);
    // Several functions take the same structure.
    for expected in expected.into_iter().collect::<BTreeSet<_>>() {
        assert!(code.contains(&expected), "the header lacks `{expected}`");
        code = code.replacen(&expected, "", 1);
    }
    let rest = code.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(rest, "extern \"C\" { }", "this is not in the library");
}

#[test]
fn the_headers_declare_this_library() {
    let (directives, _) = parts(HEADER);
    let version = concat!("#define EIGENSHADE_VERSION \"", env!("CARGO_PKG_VERSION"), "\"");
    let defines = directives.into_iter().filter(|line| line.starts_with("#define"));
    assert_eq!(defines.collect::<Vec<_>>(), ["#define EIGENSHADE_H", version]);

    let _: extern "C" fn() -> *const c_char = eigenshade_version;
    let _: extern "C" fn() -> u32 = eigenshade_table;
    let _: extern "C" fn(i32) -> *const c_char = eigenshade_message;
    let others = vec![
        "const char *eigenshade_version(void);".into(),
        "uint32_t eigenshade_table(void);".into(),
        "const char *eigenshade_message(int32_t status);".into(),
    ];
    let one_channel = [statuses(), others, float::functions(), integers::functions()].concat();
    declares(HEADER, one_channel.clone());
    let of_formats = [color::f32_functions(), color::q15_functions()].concat();
    let others = [color::source_functions(), color::meter_functions()].concat();
    let color = [of_formats, others, displays()].concat();
    let (directives, _) = parts(COLOR);
    let defines = directives.into_iter().filter(|line| line.starts_with("#define"));
    let of_gltf = format!("#define EIGENSHADE_METALLIC_ROUGHNESS {}", color::MATERIAL);
    let order = format!("#define EIGENSHADE_METALLIC_ROUGHNESS_ORDER {}", color::ORDER);
    let sources = format!("#define EIGENSHADE_SOURCES {}", color::SOURCES);
    let expected = ["#define EIGENSHADE_COLOR_H", &order, &of_gltf, &sources];
    assert_eq!(defines.collect::<Vec<_>>(), expected);
    // Its records are made of those of one channel.
    declares(COLOR, color.into_iter().filter(|one| !one_channel.contains(one)).collect());
    assert_eq!(include_str!("../include/eigenshade_presets.h"), presets_header::header());
}

#[test]
#[cfg(not(feature = "own-table"))]
fn the_sizes_are_those_of_the_table() {
    assert_eq!(include_str!("../include/eigenshade_table.h"), table_header::header());
}
