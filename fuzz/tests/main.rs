//! The runtime's tests that need none of the host's crates.

#[path = "../../tests/found.rs"]
mod found;
#[path = "../../tests/parts.rs"]
mod parts;
#[path = "../../tests/runtime.rs"]
mod runtime;
#[path = "../../tests/wire_files/mod.rs"]
mod wire_files;
