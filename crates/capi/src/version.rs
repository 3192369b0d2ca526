//! Which eigenshade this is.

use core::ffi::{CStr, c_char};

/// The version that this header belongs to: compare it with `eigenshade_version()`.
pub const EIGENSHADE_VERSION: &str = "0.1.0";

const STATED: &CStr =
    match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(version) => version,
        Err(_) => panic!("a version has no zero in it"),
    };

/// The library's version, a static string. Never fails.
#[expect(unsafe_code, reason = "an exported symbol")]
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_version() -> *const c_char {
    STATED.as_ptr()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_header_says_the_package_version() {
        assert_eq!(STATED.to_str(), Ok(EIGENSHADE_VERSION));
    }
}
