//! Objects with shadows, as `eigenshade pack-object --shadows` writes them.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Place, Plain, disjoint};
use crate::constants::OBJECT_COEFFICIENTS;
use crate::draw::Display;
use crate::format::Format;
use crate::memory::{Memory, assert_fits, try_write, written};
use crate::row::Row;
use crate::status::Status;
use crate::target::{Drawn, Encoding, Target, Window};
use core::ffi::c_void;
use eigenshade::screen::{self, Exposure, Pixel};
use eigenshade::{Error, Rgb, object};

/// An object with shadows, as `eigenshade pack-object --shadows` writes it. May be kept in flash.
#[repr(C)]
pub struct ShadowedObject {
    /// Number of bytes.
    pub length: usize,
    /// The file; the caller's.
    pub bytes: *const u8,
}

/// The size of an object with shadows, the number of its codes, and the degree of its light.
#[repr(C)]
pub struct ShadowedObjectHeader {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Number of codes: as many colors a frame has.
    pub codes: usize,
    /// The largest degree of a light.
    pub degree: usize,
}

/// The coefficients of an object with shadows under one light, once they were found. It has no
/// pointers, so it may be moved.
#[repr(C)]
pub struct ObjectCoefficients {
    /// Private to the library.
    pub words: [u32; OBJECT_COEFFICIENTS],
}

// SAFETY: all of its fields are plain.
unsafe impl Plain for ShadowedObject {}
// SAFETY: as above.
unsafe impl Plain for ShadowedObjectHeader {}
// SAFETY: consists of numbers.
unsafe impl Plain for ObjectCoefficients {}

impl Memory for ObjectCoefficients {
    type Value = Rgb<object::ObjectCoefficients>;
    const MARK: Mark = Mark::OBJECT_COEFFICIENTS;
    const MISSING: Status = Status::Coefficients;
}

const _: () = assert_fits::<ObjectCoefficients>();

/// An object that was checked, and where it lies.
struct Opened<'a> {
    object: object::ShadowedObject<'a>,
    places: [Place; 2],
}

fn open(object: &Input<ShadowedObject>) -> Result<Opened<'_>, Status> {
    let object = object.value()?;
    // SAFETY: C promises `length` bytes.
    let bytes = unsafe { Input(object.bytes).array(object.length) }?;
    let places = [Place::of(object), Place::of(bytes)];
    Ok(Opened { object: object::ShadowedObject::new(bytes)?, places })
}

pub(crate) fn header(
    object: &Input<ShadowedObject>,
    header: &Output<ShadowedObjectHeader>,
) -> Result<(), Status> {
    let Opened { object, places } = open(object)?;
    disjoint(&[header.place()], &places)?;
    // SAFETY: it overlaps no other.
    *unsafe { header.zeroed() }? = ShadowedObjectHeader {
        width: object.width(),
        height: object.height(),
        codes: object.codes(),
        degree: object.degree(),
    };
    Ok(())
}

pub(crate) fn coefficients<F: Format>(
    object: &Input<ShadowedObject>,
    light: &Input<F::Light>,
    coefficients: &Output<ObjectCoefficients>,
) -> Result<(), Status> {
    let (Opened { object, places }, light) = (open(object)?, F::light(light.value()?)?);
    F::check(light.value)?;
    disjoint(&[coefficients.place()], &places)?;
    disjoint(&[coefficients.place()], &light.places)?;
    let find = |to: &mut _| {
        F::object_coefficients(&object, light.value, to).map_err(|error| match error {
            Error::Beyond { .. } => Status::LightBeyond,
            other => other.into(),
        })
    };
    // SAFETY: it overlaps no other.
    unsafe { try_write(coefficients, find) }
}

pub(crate) fn colors(
    object: &Input<ShadowedObject>,
    coefficients: &Input<ObjectCoefficients>,
    exposure: f32,
    display: &Input<Display>,
    encoding: i32,
    to: &Output<c_void>,
    length: usize,
) -> Result<(), Status> {
    let Opened { object, places } = open(object)?;
    let of_light = written(coefficients)?;
    let exposure = Exposure::new(exposure)?;
    let Display(display) = display.value()?;
    let encoding = Encoding::new(encoding)?;
    let codes = checked_codes(&object, encoding, length)?;
    let written = [Output(to.0.cast::<u8>()).place_of_array(length)?];
    disjoint(&written, &places)?;
    disjoint(&written, &[Place::of(coefficients.value()?), Place::of(display)])?;
    // SAFETY: C promises as many pixels; they overlap no other.
    let mut row = unsafe { Row::new(encoding, to.0, codes) }?;
    let mut codes = 0..codes;
    // In all encodings by one function, which is smaller than one for each.
    object.shade(of_light, exposure, |color| {
        if let Some(code) = codes.next() {
            row.set(code, display, color);
        }
    });
    Ok(())
}

/// The number of codes. Fails unless `length` is the size of their colors in bytes.
fn checked_codes(
    object: &object::ShadowedObject<'_>,
    encoding: Encoding,
    length: usize,
) -> Result<usize, Status> {
    let codes = object.codes();
    if length == encoding.bytes() * codes { Ok(codes) } else { Err(Status::Colors) }
}

/// An object and the colors of its codes in the encoding of a target; the others are none.
struct Colored<'a> {
    object: object::ShadowedObject<'a>,
    rgb565: &'a [u16],
    high_first: &'a [[u8; 2]],
    rgb888: &'a [[u8; 3]],
    rgba8888: &'a [[u8; 4]],
}

impl Drawn<u16> for Colored<'_> {
    fn draw(&self, target: &mut screen::Target<'_, u16>) {
        self.object.draw(self.rgb565, target);
    }
}

impl Drawn<[u8; 2]> for Colored<'_> {
    fn draw(&self, target: &mut screen::Target<'_, [u8; 2]>) {
        self.object.draw(self.high_first, target);
    }
}

impl Drawn<[u8; 3]> for Colored<'_> {
    fn draw(&self, target: &mut screen::Target<'_, [u8; 3]>) {
        self.object.draw(self.rgb888, target);
    }
}

impl Drawn<[u8; 4]> for Colored<'_> {
    fn draw(&self, target: &mut screen::Target<'_, [u8; 4]>) {
        self.object.draw(self.rgba8888, target);
    }
}

/// The colors of an encoding: as many as it has, or none if this is another encoding.
///
/// # Safety
///
/// C promises as many.
unsafe fn all<'a, P: Pixel + Plain>(
    colors: *const c_void,
    codes: usize,
    is_encoding: bool,
) -> Result<&'a [P], Status> {
    // SAFETY: this function's caller promises as much.
    unsafe { Input(colors.cast::<P>()).array(if is_encoding { codes } else { 0 }) }
}

pub(crate) fn draw(
    object: &Input<ShadowedObject>,
    colors: *const c_void,
    length: usize,
    target: &Input<Target>,
) -> Result<(), Status> {
    let (Opened { object, places }, window) = (open(object)?, Window::of(target)?);
    let encoding = window.encoding;
    let codes = checked_codes(&object, encoding, length)?;
    // SAFETY: C promises as many bytes, which are those of the codes' pixels.
    let (bytes, colored) = unsafe {
        let colored = Colored {
            object,
            rgb565: all(colors, codes, matches!(encoding, Encoding::Rgb565))?,
            high_first: all(colors, codes, matches!(encoding, Encoding::Rgb565HighFirst))?,
            rgb888: all(colors, codes, matches!(encoding, Encoding::Rgb888))?,
            rgba8888: all(colors, codes, matches!(encoding, Encoding::Rgba8888))?,
        };
        (Input(colors.cast::<u8>()).array(length)?, colored)
    };
    window.apart_from(&places)?;
    window.apart_from(&[Place::of(bytes)])?;
    // SAFETY: the pixels overlap no other.
    unsafe { window.draw([object.width(), object.height()], &colored) }
}
