//! Code that the commands of the program `eigenshade` share.

pub mod description;

pub mod table;

pub mod picture;

pub mod object;

pub mod picture_file;

#[cfg(feature = "generate")]
pub mod reading;

pub mod output;

pub mod export;

pub mod messages;

pub mod presets;

pub mod sharpness;
