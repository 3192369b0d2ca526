//! The common part of the measured programs, without an operation.
#![no_std]
#![no_main]

programs::program!();

fn empty() {
    board::measure(&[0_u32; 16], board::Passes(64), |_| ());
}
