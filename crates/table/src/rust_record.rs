//! A record as Rust source: a constant, with a static for each array.

use eigenshade_index::record::{Item, Size, Visitor};
use std::fmt::Write;

/// Records as constants.
#[derive(Debug, Default)]
pub(crate) struct Constants {
    /// Their text.
    pub(crate) text: String,
    /// Bytes of all arrays.
    pub(crate) bytes: usize,
    /// The fields of the current record.
    fields: String,
}

impl Constants {
    /// Adds `const NAME` of the record that `visit` shows, whose type is `path<'static, number>`.
    pub(crate) fn add(
        &mut self,
        name: &str,
        path: &str,
        number: &str,
        visit: impl FnOnce(&mut Self),
    ) {
        let _ = writeln!(self.text, "const {name}: {path}<'static, {number}> = {{");
        visit(self);
        let _ = writeln!(self.text, "{path} {{\n{}}}\n}};", std::mem::take(&mut self.fields));
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
pub(crate) fn array<T: Item>(name: &str, items: &[T]) -> String {
    let (kind, count) = (T::TYPE, items.len());
    // The items of a record are named without a path.
    let named = kind.contains("::") && count > 0;
    let scope = if named { "use eigenshade::index::record::*; " } else { "" };
    let (open, close) = if named { ("{ ", " }") } else { ("", "") };
    format!("static {name}: [{kind}; {count}] = {open}{scope}{items:?}{close};\n")
}
