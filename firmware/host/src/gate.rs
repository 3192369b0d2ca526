//! A linked program: its sizes and symbols, the gates, which are what it must not contain, and the
//! test that each gate works.

use crate::Result;
use crate::program::{AN386, Board, MICROBIT};
use crate::toolchain;
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

pub struct Linked {
    pub sizes: Sizes,
    /// Names of all functions and statics, demangled.
    pub names: Vec<String>,
}

impl Linked {
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
}

/// Whether a symbol is one that a gate refuses.
type Refused = fn(&str) -> bool;

/// The forbidden kinds of symbols, and whether a name belongs to them.
const GATES: [(&str, Refused); 4] = [
    ("panic machinery", |name| has(name, &PANIC)),
    ("core::fmt", |name| name.contains("core::fmt")),
    ("a heap", |name| has(name, &HEAP)),
    ("arithmetic in f64", is_f64),
];
const PANIC: [&str; 4] =
    ["core::panicking", "rust_begin_unwind", "panic_handler", "a_panic_can_be_reached"];
const HEAP: [&str; 5] =
    ["__rust_alloc", "__rust_no_alloc_shim", "GlobalAlloc", "malloc", "alloc::alloc"];

fn has(name: &str, parts: &[&str]) -> bool {
    parts.iter().any(|part| name.contains(part))
}

pub fn check(board: Board, program: &str, linked: &Linked) -> Result<()> {
    let fault = |what: &str, found: &str| {
        Err(format!("{program} on {}: {what} is linked: {found}", board.name))
    };
    for (what, is_it) in GATES {
        if let Some(found) = linked.names.iter().find(|name| is_it(name)) {
            return fault(what, found);
        }
    }
    let of_f32 = linked.names.iter().find(|name| is_f32(name));
    if let (false, Some(found)) = (board.is_large, of_f32) {
        return fault("arithmetic in f32", found);
    }
    match linked.sizes.initialized {
        0 => Ok(()),
        bytes => fault(".data", &format!("{bytes} bytes; make the statics constant or zero")),
    }
}

/// The last segment of a path.
fn last(name: &str) -> &str {
    name.rsplit("::").next().unwrap_or(name)
}

/// Whether this is an `f64` routine of the Arm or the GCC run-time library: `__aeabi_dadd`,
/// `__adddf3`.
fn is_f64(name: &str) -> bool {
    let name = last(name);
    let arm = name.strip_prefix("__aeabi_");
    arm.is_some_and(|rest| {
        rest.starts_with('d') && !rest.starts_with("div")
            || rest.starts_with("cd")
            || rest.ends_with("2d")
    }) || gcc(name, "df")
}

/// Whether this is an `f32` routine: `__aeabi_fmul`, `__mulsf3`, `__floatsisf`.
fn is_f32(name: &str) -> bool {
    let name = last(name);
    let arm = name.strip_prefix("__aeabi_");
    arm.is_some_and(|rest| rest.starts_with('f') || rest.starts_with("cf") || rest.ends_with("2f"))
        || gcc(name, "sf")
        || name == "sqrtf"
}

/// Whether this is a GCC routine of the given mode: `__addsf3`, `__lesf2`, `__floatsisf`,
/// `__fixsfsi`, `__extendsfdf2`.
fn gcc(name: &str, mode: &str) -> bool {
    let Some(rest) = name.strip_prefix("__") else { return false };
    let operation = rest.trim_end_matches(|c: char| c.is_ascii_digit());
    operation.ends_with(mode)
        || ["fix", "trunc", "extend"]
            .iter()
            .any(|kind| operation.starts_with(kind) && operation.contains(mode))
}

/// The step that rejects a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    Linker,
    Check,
}

/// A program of `gates/`, the board for which it is rejected, at which step, and a part of the
/// error.
const REJECTED: [(&str, Board, Step, &str); 6] = [
    ("panics", AN386, Step::Linker, "undefined symbol: a_panic_can_be_reached"),
    ("formats", AN386, Step::Check, "core::fmt is linked"),
    ("doubles", AN386, Step::Check, "arithmetic in f64 is linked"),
    ("floats", MICROBIT, Step::Check, "arithmetic in f32 is linked"),
    ("initialized", MICROBIT, Step::Check, ".data is linked"),
    ("allocates", AN386, Step::Check, "a heap is linked"),
];

/// Builds and checks each program of `gates/`, which has one forbidden thing, and prints the
/// errors.
pub fn test() -> Result<()> {
    for (program, board, step, reason) in REJECTED {
        let built = toolchain::build(&[board.target], "gates", &[program], "3");
        let checked = match step {
            Step::Linker => built,
            Step::Check => {
                built?;
                let linked = Linked::read(&toolchain::binary(board.target, program))?;
                check(board, program, &linked)
            }
        };
        match checked {
            Err(fault) if fault.contains(reason) => {
                let line = fault.lines().find(|line| line.contains(reason)).unwrap_or_default();
                println!("{program}: rejected: {}", line.trim());
            }
            Err(fault) => {
                return Err(format!("{program} is rejected, but not with `{reason}`: {fault}"));
            }
            Ok(()) => return Err(format!("{program} is accepted, but must be rejected")),
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{is_f32, is_f64};

    #[test]
    fn float_routines_have_these_names() {
        for name in ["__aeabi_dadd", "__aeabi_cdcmple", "__aeabi_f2d", "__muldf3", "__ledf2"] {
            assert!(is_f64(name), "{name}");
        }
        for name in ["__floatunsidf", "__fixdfsi", "__extendsfdf2", "compiler_builtins::__divdf3"] {
            assert!(is_f64(name), "{name}");
        }
        for name in ["__aeabi_fmul", "__aeabi_ui2f", "__addsf3", "__lesf2", "__fixunssfsi"] {
            assert!(is_f32(name), "{name}");
        }
        for name in ["__aeabi_memcpy4", "__aeabi_idiv", "__aeabi_uldivmod", "__muldi3", "main"] {
            assert!(!is_f64(name) && !is_f32(name), "{name}");
        }
    }
}
