//! The header `include/eigenshade_table.h`.

use crate::constants::{CONSTANTS, TABLE};
use std::format;
use std::string::String;
use std::vec::Vec;

/// The header.
pub(crate) fn header() -> String {
    let defines: Vec<_> = CONSTANTS
        .iter()
        .map(|(name, text, value)| format!("/** {text} */\n#define EIGENSHADE_{name} {value}\n"))
        .collect();
    format!(
        "/* The sizes of the table that the library was built with. The example table_header writes \
         this\nfile. */\n\n#ifndef EIGENSHADE_TABLE_H\n#define EIGENSHADE_TABLE_H\n\n/** A \
         checksum of these sizes: compare it with `eigenshade_table()`. */\n#define EIGENSHADE_TABLE {TABLE}u\n\n{}\n\
         #endif\n",
        defines.join("\n")
    )
}
