//! The table that `EIGENSHADE_TABLE` named when the module was built: `build.rs` writes it.

include!(concat!(env!("OUT_DIR"), "/table.rs"));

/// The same table in mantissas of 15 bits.
#[cfg(feature = "q15")]
pub mod q15 {
    include!(concat!(env!("OUT_DIR"), "/table_q15.rs"));
}

/// The same table in mantissas of 31 bits.
#[cfg(feature = "q31")]
pub mod q31 {
    include!(concat!(env!("OUT_DIR"), "/table_q31.rs"));
}
