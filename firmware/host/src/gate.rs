//! What must not be in a linked program.

use crate::Result;
use crate::board::Board;
use crate::linked::Linked;

/// What is kept out, and whether a name is one of it.
type Gate = (&'static str, fn(&str) -> bool);

const GATES: [Gate; 4] = [
    ("panic machinery", is_panic),
    ("core::fmt", is_formatting),
    ("a heap", is_heap),
    ("arithmetic in f64", is_f64),
];

/// Checks a program.
///
/// # Errors
///
/// The first thing that is in it and must not be, by name.
pub fn check(board: Board, program: &str, linked: &Linked) -> Result<()> {
    let fault = |what: &str, found: &str| {
        Err(format!("{program} on {}: {what} is linked: {found}", board.name()))
    };
    for (what, is_it) in GATES {
        if let Some(found) = linked.names.iter().find(|name| is_it(name)) {
            return fault(what, found);
        }
    }
    let of_f32 = linked.names.iter().find(|name| is_f32(name));
    if let (false, Some(found)) = (board.takes_floats(), of_f32) {
        return fault("arithmetic in f32", found);
    }
    match linked.sizes().initialised {
        0 => Ok(()),
        bytes => fault(".data", &format!("{bytes} bytes; make the statics constant or zero")),
    }
}

fn is_panic(name: &str) -> bool {
    ["core::panicking", "rust_begin_unwind", "panic_handler", "a_panic_can_be_reached"]
        .iter()
        .any(|part| name.contains(part))
}

fn is_formatting(name: &str) -> bool {
    name.contains("core::fmt")
}

fn is_heap(name: &str) -> bool {
    ["__rust_alloc", "__rust_no_alloc_shim", "GlobalAlloc", "malloc", "alloc::alloc"]
        .iter()
        .any(|part| name.contains(part))
}

/// The last part of a path, without arguments.
fn last(name: &str) -> &str {
    name.rsplit("::").next().unwrap_or(name)
}

/// Run-time functions of the Arm interface, or of GCC's: `__aeabi_dadd`, `__adddf3`.
fn is_f64(name: &str) -> bool {
    let name = last(name);
    let arm = name.strip_prefix("__aeabi_");
    arm.is_some_and(|rest| {
        rest.starts_with('d') && !rest.starts_with("div")
            || rest.starts_with("cd")
            || rest.ends_with("2d")
    }) || gcc(name, "df")
}

/// The same of single precision: `__aeabi_fmul`, `__mulsf3`, `__floatsisf`.
fn is_f32(name: &str) -> bool {
    let name = last(name);
    let arm = name.strip_prefix("__aeabi_");
    arm.is_some_and(|rest| rest.starts_with('f') || rest.starts_with("cf") || rest.ends_with("2f"))
        || gcc(name, "sf")
        || name == "sqrtf"
}

/// `__addsf3`, `__lesf2`, `__floatsisf`, `__fixsfsi`, `__extendsfdf2`.
fn gcc(name: &str, mode: &str) -> bool {
    let Some(rest) = name.strip_prefix("__") else { return false };
    let operation = rest.trim_end_matches(|c: char| c.is_ascii_digit());
    operation.ends_with(mode)
        || ["fix", "trunc", "extend"]
            .iter()
            .any(|kind| operation.starts_with(kind) && operation.contains(mode))
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
