//! The panic handler of bare metal. In release builds it calls an undefined symbol, so a reachable panic
//! fails to link, provided that the linker drops unused functions (`-Wl,--gc-sections`).
//!
//! In builds with debug assertions, which check their arithmetic, it halts.

#[panic_handler]
#[cfg(debug_assertions)]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}

#[panic_handler]
#[cfg(not(debug_assertions))]
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
