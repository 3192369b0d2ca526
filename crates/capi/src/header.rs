//! A test that the header declares the constants, types and functions of this library, and nothing
//! else.

use crate::boundary::{Input, Output};
use crate::status::{STATUSES, eigenshade_message};
use crate::{eigenshade_version, float, integers};
use core::ffi::c_char;
use core::marker::PhantomData;
use eigenshade::index::{light, material};
use eigenshade::sphere::{self, q15, q31};
use eigenshade::{Q15, Q31};
use std::collections::BTreeSet;
use std::string::String;
use std::vec::Vec;
use std::{format, vec};

const HEADER: &str = include_str!("../include/eigenshade.h");

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
    usize: "size_t" f32: "float" i8: "int8_t" i16: "int16_t" i32: "int32_t" i64: "int64_t"
    Q15: "int16_t" Q31: "int32_t"
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

impl<T: Declared, const N: usize> Declared for [T; N] {
    fn declare(name: &str) -> String {
        T::declare(&format!("{name}[{N}]"))
    }
}

/// Not in the header.
impl<Q> Declared for PhantomData<Q> {
    fn declare(_: &str) -> String {
        String::new()
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

/// The constants. Those of both integer formats are equal.
const CONSTANTS: [(&str, usize); 17] = [
    ("DEGREE", sphere::DEGREE),
    ("DEGREE", q15::DEGREE),
    ("DEGREE", q31::DEGREE),
    ("ORDER", sphere::ORDER),
    ("LIGHT", light::count(sphere::DEGREE)),
    ("MATERIAL", material::count(sphere::ORDER)),
    ("COMPONENTS", sphere::COMPONENTS),
    ("PROFILES", q15::PROFILES),
    ("PROFILES", q31::PROFILES),
    ("TRANSFER_F32", sphere::TRANSFER),
    ("TRANSFER", q15::TRANSFER),
    ("TRANSFER", q31::TRANSFER),
    ("SCENE_F32", sphere::SCENE),
    ("SCENE_Q15", q15::SCENE),
    ("SCENE_Q31", q31::SCENE),
    ("WORKSPACE_F32", sphere::WORKSPACE),
    ("WORKSPACE", q31::WORKSPACE),
];

#[test]
fn the_header_declares_this_library() {
    let code = HEADER.split("/*").map(|part| part.split_once("*/").map_or(part, |(_, code)| code));
    let code = code.collect::<String>();
    let (directives, code): (Vec<&str>, Vec<&str>) =
        code.lines().partition(|line| line.starts_with('#'));
    let mut code = code.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");

    let mut expected = vec!["#define EIGENSHADE_H".into()];
    expected.push(concat!("#define EIGENSHADE_VERSION \"", env!("CARGO_PKG_VERSION"), "\"").into());
    for (name, value) in CONSTANTS {
        expected.push(format!("#define EIGENSHADE_{name} {value}"));
        code = code.replace(&format!("[EIGENSHADE_{name}]"), &format!("[{value}]"));
    }
    expected.dedup();
    let defines = directives.into_iter().filter(|line| line.starts_with("#define"));
    assert_eq!(defines.collect::<Vec<_>>(), expected);

    let _: extern "C" fn() -> *const c_char = eigenshade_version;
    let _: extern "C" fn(i32) -> *const c_char = eigenshade_message;
    let others = vec![
        "const char *eigenshade_version(void);".into(),
        "const char *eigenshade_message(int32_t status);".into(),
    ];
    let expected = [
        statuses(),
        others,
        float::functions(),
        integers::q15_functions(),
        integers::q31_functions(),
    ];
    // Several functions take the same structure.
    for expected in expected.concat().into_iter().collect::<BTreeSet<_>>() {
        assert!(code.contains(&expected), "the header lacks `{expected}`");
        code = code.replacen(&expected, "", 1);
    }
    let rest = code.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(rest, "extern \"C\" { }", "this is not in the library");
}

/// The comments on both integer formats are the same.
#[test]
fn the_comments_on_integers_are_the_same() {
    let comments = |format: &str| {
        let items = HEADER.split("\n\n").filter(|item| item.contains(&format!("_{format}")));
        let comments = items.flat_map(str::lines);
        let comments = comments.filter(|line| line.trim_start().starts_with(['/', '*']));
        let comments = comments.map(|line| line.replace("q15", "q31").replace("2^15", "2^31"));
        comments.collect::<Vec<_>>()
    };
    assert_eq!(comments("q15"), comments("q31"));
}
