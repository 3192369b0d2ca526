//! The version of the library.

use core::ffi::{CStr, c_char};

const VERSION: &CStr =
    match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(version) => version,
        Err(_) => panic!("a version has no zero in it"),
    };

/// The library's version, a static string: compare it with EIGENSHADE_VERSION of the header.
/// Never fails.
#[expect(unsafe_code, reason = "an exported symbol")]
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_version() -> *const c_char {
    VERSION.as_ptr()
}
