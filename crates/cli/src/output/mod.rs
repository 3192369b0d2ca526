//! Output of the commands: files, rows, messages.

pub mod collision;
pub mod destination;
pub mod invocation;
pub mod message;
pub mod number;
pub mod rows;
#[cfg(unix)]
pub mod signals;
