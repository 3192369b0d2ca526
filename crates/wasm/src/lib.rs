//! eigenshade as a WebAssembly module with plain exports.
//!
//! Functions compute; globals are addresses of fixed buffers in linear memory, which the
//! page fills before a call and reads after it. `eigenshade.mjs` wraps both. Built for
//! `wasm32-unknown-unknown` alone: elsewhere the crate is empty.
#![cfg(target_arch = "wasm32")]
#![no_std]

#[cfg(feature = "f32")]
mod floats;

#[cfg(feature = "nine-terms")]
mod nine_terms;

// For its exports.
use eigenshade_wasm_setup as _;

/// Nothing here panics, so nothing links this.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
