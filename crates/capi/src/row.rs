//! The pixels of a row of a target.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::Output;
use crate::status::Status;
use crate::target::Encoding;
use core::ffi::c_void;
use eigenshade::Rgb;
use eigenshade::screen::{Display, Linear, blend565, blend8888};

/// Pixels of one row.
pub(crate) enum Row<'a> {
    Rgb565(&'a mut [u16]),
    HighFirst(&'a mut [[u8; 2]]),
    Rgb888(&'a mut [[u8; 3]]),
    Rgba8888(&'a mut [[u8; 4]]),
}

impl Row<'_> {
    /// As many pixels of an encoding.
    ///
    /// # Safety
    ///
    /// As for [`Output::array`].
    pub(crate) unsafe fn new(
        encoding: Encoding,
        first: *mut c_void,
        count: usize,
    ) -> Result<Self, Status> {
        // SAFETY: this function's caller promises as much.
        unsafe {
            Ok(match encoding {
                Encoding::Rgb565 => Row::Rgb565(Output(first.cast()).array(count)?),
                Encoding::Rgb565HighFirst => Row::HighFirst(Output(first.cast()).array(count)?),
                Encoding::Rgb888 => Row::Rgb888(Output(first.cast()).array(count)?),
                Encoding::Rgba8888 => Row::Rgba8888(Output(first.cast()).array(count)?),
            })
        }
    }

    /// Sets a pixel.
    pub(crate) fn set(&mut self, index: usize, display: &Display, color: Rgb<Linear>) {
        match self {
            Self::Rgb565(pixels) => {
                if let Some(pixel) = pixels.get_mut(index) {
                    *pixel = display.rgb565(color);
                }
            }
            Self::HighFirst(pixels) => {
                if let Some(pixel) = pixels.get_mut(index) {
                    *pixel = display.rgb565(color).to_be_bytes();
                }
            }
            Self::Rgb888(pixels) => {
                if let Some(pixel) = pixels.get_mut(index) {
                    *pixel = display.rgb888(color).into();
                }
            }
            Self::Rgba8888(pixels) => {
                if let Some(pixel) = pixels.get_mut(index) {
                    let Rgb { r, g, b } = display.rgb888(color);
                    *pixel = [r, g, b, u8::MAX];
                }
            }
        }
    }

    /// Draws over a pixel, which a color covers by `coverage` / 255.
    pub(crate) fn put(
        &mut self,
        index: usize,
        coverage: u8,
        display: &Display,
        color: Rgb<Linear>,
    ) {
        match self {
            Self::Rgb565(pixels) => {
                if let Some(pixel) = pixels.get_mut(index) {
                    *pixel = over565(*pixel, coverage, display, color);
                }
            }
            Self::HighFirst(pixels) => {
                if let Some(pixel) = pixels.get_mut(index) {
                    let below = u16::from_be_bytes(*pixel);
                    *pixel = over565(below, coverage, display, color).to_be_bytes();
                }
            }
            Self::Rgb888(pixels) => {
                if let Some(pixel) = pixels.get_mut(index) {
                    let [r, g, b] = *pixel;
                    let [r, g, b, _] = over8888([r, g, b, u8::MAX], coverage, display, color);
                    *pixel = [r, g, b];
                }
            }
            Self::Rgba8888(pixels) => {
                if let Some(pixel) = pixels.get_mut(index) {
                    *pixel = over8888(*pixel, coverage, display, color);
                }
            }
        }
    }
}

// Once for both byte orders.
#[inline(never)]
fn over565(below: u16, coverage: u8, display: &Display, color: Rgb<Linear>) -> u16 {
    blend565(below, display.rgb565(color), coverage)
}

// Once with opacity and without.
#[inline(never)]
fn over8888(below: [u8; 4], coverage: u8, display: &Display, color: Rgb<Linear>) -> [u8; 4] {
    blend8888(below, display.rgb888(color), coverage)
}
