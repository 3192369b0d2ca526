//! eigenshade as a WebAssembly module with plain exports.
//!
//! Functions compute; globals are addresses of fixed buffers in linear memory, which the
//! page fills before a call and reads after it. `eigenshade.mjs` wraps both. Built for
//! `wasm32-unknown-unknown` alone: elsewhere the crate is empty.
#![cfg(target_arch = "wasm32")]
#![no_std]

#[cfg(feature = "f32")]
mod floats;

#[cfg(feature = "map")]
mod map;

#[cfg(feature = "nine-terms")]
mod nine_terms;

// For its exports.
use eigenshade_wasm_setup as _;

unsafe extern "C" {
    /// Nowhere: a module in which the compiler sees a way to a panic imports this, and
    /// `tests/module.test.mjs` fails.
    safe fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    a_panic_can_be_reached()
}
