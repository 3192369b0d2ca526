//! A linked program: its sizes and symbols.

use crate::Result;
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, elf};
use std::path::Path;

/// Bytes of a linked program.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sizes {
    /// In flash: code, tables, and initial values of statics.
    pub flash: u64,
    /// Statics in RAM.
    pub ram: u64,
    /// Statics in RAM with an initial value other than zero.
    pub initialized: u64,
}

/// A linked program.
#[derive(Clone, Debug)]
pub struct Linked {
    sizes: Sizes,
    /// Names of all functions and statics, demangled.
    pub names: Vec<String>,
}

impl Linked {
    /// Reads a program.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or is not an ELF file.
    pub fn read(path: &Path) -> Result<Self> {
        let fault = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let bytes = std::fs::read(path).map_err(|error| fault(&error))?;
        let file = object::File::parse(&*bytes).map_err(|error| fault(&error))?;
        let mut sizes = Sizes::default();
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
            let has = |flag: elf::SectionFlags| sh_flags.0 & flag.0 != 0;
            let (allocated, written) = (has(elf::SHF_ALLOC), has(elf::SHF_WRITE));
            // Reserved for the stack or a heap, not used by statics.
            let reserved =
                matches!(section.name(), Ok(".stack" | ".heap" | ".uninit" | ".text.dummy"));
            if !allocated || reserved {
                continue;
            }
            let empty = section.kind() == object::SectionKind::UninitializedData;
            if !empty {
                sizes.flash += section.size();
            }
            if written {
                sizes.ram += section.size();
            }
            if written && !empty {
                sizes.initialized += section.size();
            }
        }
        let names = file
            .symbols()
            .filter(|symbol| symbol.is_definition() || symbol.is_undefined())
            .filter_map(|symbol| symbol.name().ok())
            .filter(|name| !name.is_empty() && !name.starts_with('$'))
            .map(|name| format!("{:#}", rustc_demangle::demangle(name)))
            .collect();
        Ok(Self { sizes, names })
    }

    /// Its sizes.
    pub const fn sizes(&self) -> Sizes {
        self.sizes
    }
}
