//! The parts that all programs share: golden vectors, inputs and drawings.
//!
//! `operations.csv` lists the programs. `relight_q15`, for example, is the function `relight` of
//! `operations_q15.rs`, with the shipped table in Q15 as the module `table`.
#![no_std]

use eigenshade::Error;
use eigenshade::object::{NormalMap, Object, ShadowedObject};
use eigenshade::screen::{Display, Tone};

/// The library's table in Q15, with the transfer of one material.
pub mod one_material {
    include!(concat!(env!("OUT_DIR"), "/one_material.rs"));
}

pub mod golden;

/// The highlights of four sources.
pub mod highlights {
    use eigenshade::Rgb;
    use eigenshade::q15::Lobe;

    include!(concat!(env!("OUT_DIR"), "/highlights.rs"));
}

pub mod inputs;

pub mod split_sum;

pub mod drawing;

/// Runs one function of a source as the program. The build script derives the function and the
/// module `table` from the program's row.
#[macro_export]
macro_rules! program {
    () => {
        include!(concat!(env!("OUT_DIR"), "/programs/", env!("CARGO_BIN_NAME"), ".rs"));
    };
}

/// The display of all programs.
pub static DISPLAY: Display = Display::new(Tone::Filmic);

/// Pixels across a picture of a sphere.
pub const BALL: usize = 240;

/// The sphere's codes, of two bytes.
pub static CODES: [u8; 2 * BALL * BALL] = *include_bytes!(concat!(env!("OUT_DIR"), "/ball.bin"));

/// The normals of a sphere.
///
/// # Errors
///
/// None: the size is right.
pub fn ball() -> Result<NormalMap<'static>, Error> {
    NormalMap::new(BALL, BALL, &CODES)
}

/// A textured plastic sphere of 120 x 120 pixels.
///
/// # Errors
///
/// None: the build script wrote it.
pub fn object() -> Result<Object<'static>, Error> {
    Object::new(include_bytes!(concat!(env!("OUT_DIR"), "/object.bin")))
}

/// An object with shadows of 96 x 96 pixels.
///
/// # Errors
///
/// None: the build script wrote it.
pub fn shadowed() -> Result<ShadowedObject<'static>, Error> {
    ShadowedObject::new(include_bytes!(concat!(env!("OUT_DIR"), "/shadowed.bin")))
}
