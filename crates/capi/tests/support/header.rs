//! The C header that cbindgen makes from the sources.

use std::path::{Path, PathBuf};

/// The command that writes it.
pub const COMMAND: &str = "cargo run -p eigenshade-capi --example header";

/// The sources with exported items, in the order of the header.
const SOURCES: [&str; 5] = ["sizes.rs", "status.rs", "float.rs", "q15.rs", "q31.rs"];

/// Its path.
pub fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("include/eigenshade.h")
}

/// Its text.
pub fn text() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut config =
        cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    let preamble = include_str!("preamble.txt").trim_end();
    config.header = Some(format!("/* {COMMAND}\n\n{preamble} */"));
    config.after_includes = Some(format!(
        "\n/**\n * The version of this header: compare it with `eigenshade_version()`.\n */\n\
         #define EIGENSHADE_VERSION \"{}\"",
        env!("CARGO_PKG_VERSION")
    ));
    let mut builder = cbindgen::Builder::new().with_config(config);
    for source in SOURCES {
        builder = builder.with_src(root.join("src").join(source));
    }
    let mut text = Vec::new();
    builder.generate().expect("the sources").write(&mut text);
    // In C this heading is left out.
    String::from_utf8(text).expect("text").replace(" * # Safety\n *\n", "")
}
