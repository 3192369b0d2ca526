//! No release build can panic: where a program's linker finds that it could, it finds this
//! call of a function that does not exist. It has to be told to drop what is not called
//! (`-Wl,--gc-sections`).
//!
//! Builds with debug assertions check their arithmetic, and halt.

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
    #[expect(unsafe_code, reason = "to name what no one defines")]
    unsafe extern "C" {
        fn eigenshade_a_panic_can_be_reached() -> !;
    }
    #[expect(unsafe_code, reason = "never linked, so never called")]
    // SAFETY: a program with this call is not linked.
    unsafe {
        eigenshade_a_panic_can_be_reached()
    }
}
