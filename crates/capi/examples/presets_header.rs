//! Prints the shipped lights and materials as a C header:
//! `cargo run -p eigenshade-capi --example presets_header > crates/capi/include/eigenshade_presets.h`.

macro_rules! names {
    ($($constant:ident $name:literal)*) => {
        [$($name),*]
    };
}

const START: &str = "\
/* The shipped lights and materials in color, as `eigenshade list` names them, each in float (f32)
and in integers (q15). A program contains only those that it names.

The example presets_header writes this file. */

#ifndef EIGENSHADE_PRESETS_H
#define EIGENSHADE_PRESETS_H

#include \"eigenshade_color.h\"

#ifdef __cplusplus
extern \"C\" {
#endif
";

const END: &str = "
#ifdef __cplusplus
}
#endif

#endif
";

fn main() {
    print!("{START}");
    let lights: &[&str] = &eigenshade::each_preset_light!(names);
    let materials: &[&str] = &eigenshade::each_preset_material!(names);
    for (kind, names) in [("light", lights), ("material", materials)] {
        for format in ["f32", "q15"] {
            println!();
            for name in names {
                let of_kind = format!("eigenshade_color_{kind}_{format}_t");
                println!("extern const struct {of_kind} eigenshade_{kind}_{name}_{format};");
            }
        }
    }
    print!("{END}");
}
