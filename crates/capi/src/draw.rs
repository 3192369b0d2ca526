//! Draws objects with every pixel shaded.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Place};
use crate::format::Format;
use crate::object::Object;
use crate::picture::{Opened, Shade, ShadeMirrored};
use crate::row::Row;
use crate::status::Status;
use crate::target::{Target, Window};
use core::ops::Range;
use eigenshade::Rgb;
use eigenshade::screen::Linear;

/// A tone curve and the sRGB encoding, as a table of 774 bytes: `eigenshade_display_linear` clips
/// colors brighter than white, `eigenshade_display_reinhard` and `eigenshade_display_filmic`
/// compress them.
pub struct Display(pub(crate) eigenshade::screen::Display);

/// What shades and exposes a normal.
#[inline]
pub(crate) fn exposing<F: Format>(
    picture: &Opened<impl Shade<F>>,
    exposure: f32,
) -> Result<impl Fn(F::Normal) -> Rgb<Linear>, Status> {
    let exposure = F::exposure(exposure, picture.exponents)?;
    Ok(move |normal| F::exposed((picture.shade)(normal), exposure))
}

/// What shades and exposes a normal and its mirror images.
#[inline]
pub(crate) fn exposing_mirrored<F: Format>(
    picture: &Opened<impl ShadeMirrored<F>>,
    exposure: f32,
) -> Result<impl Fn(F::Normal) -> [Rgb<Linear>; 4], Status> {
    let exposure = F::exposure(exposure, picture.exponents)?;
    Ok(move |normal| (picture.shade)(normal).map(|irradiance| F::exposed(irradiance, exposure)))
}

/// Draws an object, once everything is checked.
pub(crate) fn draw<F: Format>(
    picture: Result<Opened<impl Shade<F>>, Status>,
    object: Result<impl Object<F>, Status>,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Result<(), Status> {
    let (picture, object) = (picture?, object?);
    let exposed = exposing::<F>(&picture, exposure)?;
    let (display, target) = (Input(display), Input(target));
    let Display(display) = display.value()?;
    let window = Window::of(&target)?;
    window.apart_from(&object.places())?;
    window.apart_from(&picture.places)?;
    window.apart_from(&[Place::of(display)])?;
    let draw = |row, columns: &Range<usize>, mut pixels: Row<'_>| {
        for (column, coverage, normal) in object.row(row) {
            if columns.contains(&column) {
                pixels.put(column - columns.start, coverage, display, exposed(normal));
            }
        }
        Ok(())
    };
    // SAFETY: the pixels overlap no other.
    unsafe { window.rows(object.size(), draw) }
}
