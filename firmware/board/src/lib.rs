//! What a program needs of an emulated board: start-up, a voice, a count of
//! instructions, a painted stack.
//!
//! Which board it is follows from the target: see `memory/`.
#![no_std]

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;

pub mod voice;

pub mod clock;

pub mod stack;

pub mod measure;

mod panic;

pub use measure::{Passes, holds, measure, measure_named};
pub use voice::{exit, say, say_character, say_number};

/// Makes the function of this name the program.
#[macro_export]
macro_rules! program {
    ($body:path) => {
        #[$crate::entry]
        fn start() -> ! {
            $body();
            $crate::exit(true)
        }
    };
}
