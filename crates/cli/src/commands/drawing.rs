//! The message of `render` that names what it drew with.

use eigenshade_model::window::Window;
use eigenshade_shading::estimate::counted;
use std::fmt::{Display, Formatter};
use std::path::Path;

/// The table, components, sources and window of a picture.
pub struct Drawing<'a> {
    pub table: &'a Path,
    pub components: usize,
    pub sources: usize,
    pub window: Window,
}

impl Display for Drawing<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> std::fmt::Result {
        let (table, components) = (self.table.display(), self.components);
        let sources = counted(self.sources);
        write!(out, "drawn with table {table} ({components} components), {sources}, ")?;
        match self.window {
            Window::SincFourth { width } => write!(out, "a window of width {width:.1}"),
            Window::None => write!(out, "no window"),
        }
    }
}
