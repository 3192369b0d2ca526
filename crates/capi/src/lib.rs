//! The shipped table of [`eigenshade`] for firmware written in C: the headers in `include` and a
//! static library.
//!
//! `cbindgen` writes `include/eigenshade.h` from the documented functions and structures of this
//! crate; a program links only what it calls.
//!
//! On bare metal the static library has a panic handler. In release builds the handler calls an
//! undefined symbol, so a reachable panic fails to link, and so does a program whose linker keeps
//! unused functions: `-Wl,--gc-sections` is required, as the symbol's name says. In builds with
//! debug assertions, which check their arithmetic, the handler halts.
#![no_std]

// On a host, std handles panics.
#[cfg(not(target_os = "none"))]
extern crate std;

mod table;

mod constants;

mod status;

mod boundary;

mod records_f32;

mod records_q15;

mod format;

mod quantize;

mod float;

mod integers;

mod sources;

mod steps;

mod effects;

mod packed_object;

mod picture;

mod baked;

mod object;

mod row;

mod target;

mod draw;

mod meter;

mod memory;

mod nodes;

mod palette;

mod linear_palette;

mod shadowed_object;

mod export;

mod export_f32;

mod export_inputs_f32;

mod export_q15;

mod export_inputs_q15;

mod presets;

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    #[cfg(debug_assertions)]
    loop {
        core::hint::spin_loop();
    }
    #[cfg(not(debug_assertions))]
    {
        #[expect(unsafe_code, reason = "the symbol is undefined on purpose")]
        unsafe extern "C" {
            fn eigenshade_link_with_gc_sections_or_a_panic_can_be_reached() -> !;
        }
        #[expect(unsafe_code, reason = "never linked, so never called")]
        // SAFETY: a program with this call is not linked.
        unsafe {
            eigenshade_link_with_gc_sections_or_a_panic_can_be_reached()
        }
    }
}
