//! No program can panic: where the linker finds that one could, it finds this call of
//! a function that does not exist.

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    #[expect(unsafe_code, reason = "to name what no one defines")]
    unsafe extern "C" {
        fn a_panic_can_be_reached() -> !;
    }
    #[expect(unsafe_code, reason = "never linked, so never called")]
    // SAFETY: a program with this call is not linked.
    unsafe {
        a_panic_can_be_reached()
    }
}
