//! What a result needs said of it.

pub mod albedo;
pub mod economy;
pub mod ringing;
