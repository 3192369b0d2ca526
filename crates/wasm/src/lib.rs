//! eigenshade as a WebAssembly module with plain exports.
//!
//! Functions compute. Globals are addresses of fixed buffers in linear memory, which the page fills
//! before a call and reads after it. The package for web pages wraps both. Only for
//! `wasm32-unknown-unknown`; on other targets the crate is empty.
#![cfg(target_arch = "wasm32")]
#![no_std]

mod palette;
mod pixels;

// For its exports.
use eigenshade_wasm_setup as _;

unsafe extern "C" {
    /// An undefined symbol: a module with a reachable panic imports it, and a
    /// test of the package for web pages fails.
    safe fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    a_panic_can_be_reached()
}
