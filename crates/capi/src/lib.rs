//! The shipped table of [`eigenshade`] for firmware written in C: the headers in `include` and a
//! static library.
//!
//! The headers document every function. The modules `float` and `integers` hold those of one
//! channel, for `f32` and for Q15, the module `color` those of three; a program links only
//! what it calls.
//!
//! On bare metal the static library has a panic handler. In release builds it calls an undefined
//! symbol, so a reachable panic fails to link, and so does a program whose linker keeps unused
//! functions: `-Wl,--gc-sections` is required, as the symbol's name says. In builds with debug
//! assertions, which check their arithmetic, it halts.
#![no_std]

// On a host, std handles panics.
#[cfg(not(target_os = "none"))]
extern crate std;

mod table;

mod constants;

mod status;

mod boundary;

mod export;

mod float;

mod integers;

mod color;

mod presets;

#[cfg(test)]
mod presets_header;

#[cfg(test)]
mod table_header;

#[cfg(test)]
mod header;

use core::ffi::c_char;

#[expect(unsafe_code, reason = "an exported symbol")]
#[unsafe(no_mangle)]
extern "C" fn eigenshade_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

#[expect(unsafe_code, reason = "an exported symbol")]
#[unsafe(no_mangle)]
extern "C" fn eigenshade_table() -> u32 {
    constants::TABLE
}

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
