//! Notes about a result.

pub mod albedo;
pub mod economy;
pub mod ringing;
