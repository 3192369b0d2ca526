//! The command line of eigenshade, as a library: what its commands, tests and
//! benches share.

pub mod invocation;

pub mod destination;

pub mod economy;

pub mod collision;

pub mod rows;

pub mod number;

pub mod message;

#[cfg(unix)]
pub mod signals;

pub mod table_file;

pub mod wire_file;

pub mod named;

pub mod ringing;

pub mod albedo;

#[cfg(feature = "generate")]
pub mod compare;

#[cfg(feature = "generate")]
pub mod recorded_errors;
pub mod rounding;

pub mod sphere_view;

pub mod tone;

#[cfg(feature = "generate")]
pub mod linear_image;

#[cfg(feature = "generate")]
pub mod pixel_normals;

#[cfg(feature = "generate")]
pub mod pixel_mask;

#[cfg(feature = "generate")]
pub mod image_reading;

pub mod canvas;

pub mod picture;
