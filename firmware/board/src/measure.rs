//! Instructions and stack of one operation.
//!
//! Under `-icount shift=0` an instruction takes one nanosecond of the board's time, so `SysTick`
//! counts instructions, in steps of 40 or 62.5. Only on Arm is there a count; elsewhere all are 0.

use crate::{print, print_u32, stack};
use core::hint::black_box;

/// Instructions of the loop that calibrates the clock.
const CALIBRATION: u32 = 1 << 20;

/// How often an operation is repeated.
#[derive(Clone, Copy, Debug)]
pub struct Passes(pub u32);

/// Prints how many bytes of RAM an operation's inputs and results take if they are not statics.
pub fn holds(bytes: usize) {
    print("holds");
    print_u32(bytes as u32);
    print("\n");
}

/// Measures an operation on each of the inputs, `passes` times each, and prints
///
/// ```text
/// tick INSTRUCTIONS TICKS
/// count OPERATIONS TICKS TICKS_OF_AN_EMPTY_LOOP
/// stack BYTES
/// ```
///
/// A count includes reading the input and writing the result. The operation is inlined into the
/// loop, as in a program that draws an image, unless it is a function of its own.
pub fn measure<I, O>(inputs: &[I], Passes(passes): Passes, mut operation: impl FnMut(&I) -> O) {
    let clock = Clock::start();
    print("tick");
    print_u32(CALIBRATION);
    print_u32(clock.ticks(|| run_two_instructions(CALIBRATION / 2)));
    let count = passes * inputs.len() as u32;
    let empty = clock.ticks(|| run(inputs, black_box(passes), &mut |_| ()));
    let ticks = clock.ticks(|| run(inputs, black_box(passes), &mut operation));
    print("\ncount");
    print_u32(count);
    print_u32(ticks);
    print_u32(empty);
    let bytes = stack::used(|| run(inputs, black_box(1), &mut operation));
    print("\nstack");
    print_u32(bytes);
    print("\n");
}

/// [`measure`] for one of several operations of a program: prints `operation NAME` first.
pub fn measure_named<I, O>(
    name: &str,
    inputs: &[I],
    passes: Passes,
    operation: impl FnMut(&I) -> O,
) {
    print("operation ");
    print(name);
    print("\n");
    measure(inputs, passes, operation);
}

/// Runs the operation on each input `passes` times. Not inlined, so that it exists once.
#[inline(never)]
fn run<I, O>(inputs: &[I], passes: u32, operation: &mut impl FnMut(&I) -> O) {
    for _ in 0..passes {
        for input in inputs {
            black_box(operation(black_box(input)));
        }
    }
}

/// A clock that counts instructions.
struct Clock {
    #[cfg(target_arch = "arm")]
    counter: cortex_m::peripheral::SYST,
}

/// The largest count, after which the clock starts again from 0.
const MASK: u32 = 0x00ff_ffff;

impl Clock {
    /// Starts the clock.
    #[cfg(target_arch = "arm")]
    fn start() -> Self {
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
    fn start() -> Self {
        Self {}
    }

    #[cfg(target_arch = "arm")]
    fn now(&self) -> u32 {
        let _ = &self.counter;
        // It counts down.
        MASK - cortex_m::peripheral::SYST::get_current()
    }

    #[cfg(not(target_arch = "arm"))]
    fn now(&self) -> u32 {
        0
    }

    /// Number of ticks that a call takes, below 16 million.
    fn ticks(&self, operation: impl FnOnce()) -> u32 {
        let before = self.now();
        operation();
        self.now().wrapping_sub(before) & MASK
    }
}

/// Runs 2 x `turns` instructions, to calibrate the clock.
#[cfg_attr(
    target_arch = "arm",
    expect(unsafe_code, reason = "only a loop written in instructions has a known length")
)]
fn run_two_instructions(turns: u32) {
    // SAFETY: the loop changes only its own register and the flags.
    #[cfg(target_arch = "arm")]
    unsafe {
        core::arch::asm!("2:", "subs {0}, #1", "bne 2b", inout(reg) turns => _, options(nomem, nostack));
    }
    #[cfg(not(target_arch = "arm"))]
    let _ = turns;
}
