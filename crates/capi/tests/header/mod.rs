//! The header, as cbindgen makes it of the sources now.

use std::path::{Path, PathBuf};

/// What makes it.
pub const COMMAND: &str = "cargo run -p eigenshade-capi --example header";

/// The crate's sources that C sees something of, in the header's order.
const SOURCES: [&str; 6] = ["version.rs", "sizes.rs", "status.rs", "float.rs", "q15.rs", "q31.rs"];

/// Where it stands.
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
    // What Rust's docs head so is a paragraph like the others.
    String::from_utf8(text).expect("text").replace(" * # Safety\n *\n", "")
}
