//! A clock that counts instructions: under `-icount shift=0` an instruction takes one
//! nanosecond of the board's time.
//!
//! `SysTick` on Arm, in steps of 40 or 62.5 instructions; `minstret` on RISC-V.

use core::arch::asm;

/// A running clock.
pub struct Clock {
    #[cfg(target_arch = "arm")]
    counter: cortex_m::peripheral::SYST,
}

/// How far a clock counts before it starts again.
#[cfg(target_arch = "arm")]
const MASK: u32 = 0x00ff_ffff;
#[cfg(not(target_arch = "arm"))]
const MASK: u32 = u32::MAX;

impl Clock {
    /// Starts the clock.
    #[cfg(target_arch = "arm")]
    #[must_use]
    pub fn start() -> Self {
        #[expect(
            unsafe_code,
            reason = "a program has one clock, and nothing else takes peripherals"
        )]
        let mut counter = unsafe { cortex_m::Peripherals::steal() }.SYST;
        counter.set_clock_source(cortex_m::peripheral::syst::SystClkSource::Core);
        counter.set_reload(MASK);
        counter.clear_current();
        counter.enable_counter();
        Self { counter }
    }

    /// Starts the clock.
    #[cfg(not(target_arch = "arm"))]
    #[must_use]
    pub fn start() -> Self {
        Self {}
    }

    #[cfg(target_arch = "arm")]
    fn now(&self) -> u32 {
        let _ = &self.counter;
        // It counts down.
        MASK - cortex_m::peripheral::SYST::get_current()
    }

    #[cfg(target_arch = "riscv32")]
    fn now(&self) -> u32 {
        riscv::register::minstret::read() as u32
    }

    #[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
    fn now(&self) -> u32 {
        0
    }

    /// Ticks that something takes; less than 16 million.
    pub fn ticks(&self, something: impl FnOnce()) -> u32 {
        let before = self.now();
        something();
        self.now().wrapping_sub(before) & MASK
    }
}

/// Runs 2 x `turns` instructions, to tell how long a tick is.
#[expect(unsafe_code, reason = "only a loop written in instructions has a known length")]
pub fn run_two_instructions(turns: u32) {
    // SAFETY: the loop changes its own register and the flags alone.
    #[cfg(target_arch = "arm")]
    unsafe {
        asm!("2:", "subs {0}, #1", "bne 2b", inout(reg) turns => _, options(nomem, nostack));
    }
    // SAFETY: as above.
    #[cfg(target_arch = "riscv32")]
    unsafe {
        asm!("2:", "addi {0}, {0}, -1", "bnez {0}, 2b", inout(reg) turns => _, options(nomem, nostack));
    }
    #[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
    // SAFETY: no instruction at all.
    unsafe {
        asm!("/* {0} */", in(reg) turns, options(nomem, nostack));
    }
}
