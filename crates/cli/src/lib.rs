//! Code that the commands of the program `eigenshade` share.

pub mod description;
pub mod export;
pub mod messages;
pub mod object;
pub mod object_description;
pub mod output;
pub mod picture;
pub mod picture_file;
#[cfg(feature = "generate")]
pub mod pixels;
pub mod table;
