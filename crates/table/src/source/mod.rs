//! Records as Rust source: the body of a module with a constant for a record, a static for each of
//! its arrays, and lines for macros of the runtime that name the shape of its loops. The source
//! names the runtime as `eigenshade`.

pub mod floats;
pub mod integers;

use crate::record::{Item, Size, Visitor};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{Arguments, Write};

/// Records as constants.
#[derive(Debug, Default)]
struct Constants {
    /// Their text.
    text: String,
    /// Bytes of all arrays.
    bytes: usize,
    /// The fields of the current record.
    fields: String,
}

impl Constants {
    /// Adds `const NAME` of the record that `visit` shows, whose type is `path<'static>`.
    fn add(&mut self, name: &str, path: &str, visit: impl FnOnce(&mut Self)) {
        let _ = writeln!(self.text, "const {name}: {path}<'static> = {{");
        visit(self);
        let _ = writeln!(self.text, "{path} {{\n{}}}\n}};", core::mem::take(&mut self.fields));
    }

    /// Their text below two lines that say what made it and how large the arrays are.
    fn headed(self, command: &str) -> String {
        format!("// {command}\n// {} bytes of tables\n{}", self.bytes, self.text)
    }
}

impl Visitor for Constants {
    fn size(&mut self, name: &'static str, size: impl Size) {
        let _ = write!(self.fields, "    {name}: ");
        let _ = size.write(&mut self.fields);
        self.fields += ",\n";
    }

    fn array<T: Item>(&mut self, name: &'static str, items: &[T]) {
        let of_static = name.to_uppercase();
        let _ = writeln!(self.fields, "    {name}: &{of_static},");
        self.text += &array(&of_static, items);
        self.bytes += size_of_val(items);
    }
}

/// A static array of these items.
fn array<T: Item>(name: &str, items: &[T]) -> String {
    let (kind, count) = (T::TYPE, items.len());
    // The items of a record are named without a path.
    let named = kind.contains("::") && count > 0;
    let scope = if named { "use eigenshade::specialized::record::*; " } else { "" };
    let (open, close) = if named { ("{ ", " }") } else { ("", "") };
    format!("static {name}: [{kind}; {count}] = {open}{scope}{items:?}{close};\n")
}

/// A line of text.
fn line(text: &mut String, line: Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}

/// Items with spaces between them.
fn words(items: impl IntoIterator<Item: ToString>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    items.join(" ")
}
