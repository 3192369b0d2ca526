//! The header `include/eigenshade_presets.h`.

use std::format;
use std::string::{String, ToString};

macro_rules! names {
    ($($constant:ident $name:literal)*) => {
        [$($name),*]
    };
}

const START: &str = "\
/* The shipped lights and materials in color, as `eigenshade list` names them, each in float (f32)
and in integers (q15); up to 16 small sources of the lights that have some, in the order of their
worth, and the errors with the first ones, for `eigenshade_gloss_fewest_sources_f32`; and the gloss
of the materials. A program contains only those that it names.

The example presets_header writes this file. */

#ifndef EIGENSHADE_PRESETS_H
#define EIGENSHADE_PRESETS_H

#include \"eigenshade.h\"

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

macro_rules! counted {
    ($($constant:ident $name:literal)*) => {
        [$(($name, eigenshade::presets::sources::$constant.len())),*]
    };
}

/// The header.
pub(crate) fn header() -> String {
    let mut text = START.to_string();
    let lights: &[&str] = &eigenshade::each_preset_light!(names);
    let materials: &[&str] = &eigenshade::each_preset_material!(names);
    for (kind, names) in [("light", lights), ("material", materials)] {
        for format in ["f32", "q15"] {
            text += "\n";
            for name in names {
                let of_kind = format!("eigenshade_color_{kind}_{format}_t");
                text +=
                    &format!("extern const struct {of_kind} eigenshade_{kind}_{name}_{format};\n");
            }
        }
    }
    text += "\n";
    let sources: &[(&str, usize)] = &eigenshade::each_preset_sources!(counted);
    for (name, count) in sources {
        let constant = format!("eigenshade_sources_{name}_f32[{count}]");
        text += &format!("extern const struct eigenshade_source_f32_t {constant};\n");
    }
    text += "\n";
    for (name, count) in sources {
        let rows = count + 1;
        text += &format!("extern const float eigenshade_source_errors_{name}_f32[{rows}][6];\n");
    }
    text += "\n";
    let glosses: &[&str] = &eigenshade::each_preset_gloss!(names);
    for name in glosses {
        let constant = format!("eigenshade_gloss_{name}_f32");
        text += &format!("extern const struct eigenshade_gloss_f32_t {constant};\n");
    }
    text + END
}
