//! The shipped table of [`eigenshade`] for firmware written in C: the header
//! `include/eigenshade.h` and a static library.
//!
//! The steps are: compute the transfer of a material, relight it with a light, collapse the
//! coefficients to a scene, and shade normals with the scene. They exist in `f32` ([`float`]) and
//! in integers ([`q15`], [`q31`]); a program links only what it calls.
//!
//! The caller owns every array. No function allocates, keeps a pointer, or has state, so all may be
//! called from interrupts and threads at once on separate arguments. Pointers must not be NULL and
//! must be aligned, which is checked. Arguments that are written to must not overlap others, which
//! is checked too.
//!
//! On bare metal the static library has a panic handler. In release builds it calls an undefined
//! symbol, so a reachable panic fails to link, provided that the linker drops unused functions
//! (`-Wl,--gc-sections`). In builds with debug assertions, which check their arithmetic, it halts.
#![no_std]

// On a host, std handles panics.
#[cfg(not(target_os = "none"))]
extern crate std;

mod sizes;

mod status;

mod boundary;

pub mod float;

mod integers;

pub mod q15;

pub mod q31;

pub use sizes::{
    EIGENSHADE_COMPONENTS, EIGENSHADE_DEGREE, EIGENSHADE_LIGHT, EIGENSHADE_MATERIAL,
    EIGENSHADE_ORDER, EIGENSHADE_PROFILES, EIGENSHADE_SCENE_F32, EIGENSHADE_SCENE_Q15,
    EIGENSHADE_SCENE_Q31, EIGENSHADE_TRANSFER, EIGENSHADE_TRANSFER_F32, EIGENSHADE_WORKSPACE,
    EIGENSHADE_WORKSPACE_F32, eigenshade_version,
};
pub use status::{Status, eigenshade_message};

#[cfg(all(target_os = "none", debug_assertions))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}

#[cfg(all(target_os = "none", not(debug_assertions)))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    #[expect(unsafe_code, reason = "the symbol is undefined on purpose")]
    unsafe extern "C" {
        fn eigenshade_a_panic_can_be_reached() -> !;
    }
    #[expect(unsafe_code, reason = "never linked, so never called")]
    // SAFETY: a program with this call is not linked.
    unsafe {
        eigenshade_a_panic_can_be_reached()
    }
}
