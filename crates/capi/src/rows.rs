//! Rows of RGB565 pixels: a program needs memory for one of them.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::format::Format;
use crate::picture::{Opened, Shade};
use crate::status::Status;
use eigenshade::Rgb;
use eigenshade::object::Disc;
use eigenshade::screen::{Linear, blend565};

/// The visible normals of an object, as `eigenshade pack-normals` makes them from a mesh or a
/// normal map. May be kept in flash.
#[repr(C)]
pub struct NormalMap {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Number of bytes: 2 * width * height.
    pub length: usize,
    /// Two bytes for each pixel, row by row from the top; the caller's.
    pub codes: *const u8,
}

// SAFETY: all of its fields are plain.
unsafe impl Plain for NormalMap {}

/// A tone curve and the sRGB encoding, as a table of 774 bytes: `eigenshade_display_linear` clips
/// colors brighter than white, `eigenshade_display_reinhard` and `eigenshade_display_filmic`
/// compress them.
pub struct Display(pub(crate) eigenshade::screen::Display);

/// Rows of an RGB565 picture, and how bright it is.
pub(crate) struct Target {
    first: usize,
    rows: usize,
    exposure: f32,
    display: Input<Display>,
    pixels: Output<u16>,
    /// Pixels from a row to the next.
    stride: usize,
    length: usize,
}

impl Target {
    /// One row, whose pixels have this length.
    pub(crate) fn row(
        row: usize,
        shown: (f32, *const Display),
        (pixels, length): (*mut u16, usize),
    ) -> Self {
        Self::rows([row, 1], shown, (pixels, 0, length))
    }

    /// The first row and the number of rows, their exposure and display, and their pixels.
    pub(crate) fn rows(
        [first, rows]: [usize; 2],
        (exposure, display): (f32, *const Display),
        (pixels, stride, length): (*mut u16, usize, usize),
    ) -> Self {
        let (display, pixels) = (Input(display), Output(pixels));
        Self { first, rows, exposure, display, pixels, stride, length }
    }

    /// Checks that an object has these rows, and that the pixels have room for them.
    fn check(&self, [width, height]: [usize; 2]) -> Result<(), Status> {
        let has_rows = self.first < height && self.rows <= height - self.first;
        let before = self.rows.saturating_sub(1).saturating_mul(self.stride);
        let fits = self.rows < 2 || self.stride >= width;
        let fits = fits && before.saturating_add(width) <= self.length;
        if has_rows && self.rows > 0 && fits { Ok(()) } else { Err(Status::Row) }
    }
}

/// An object whose rows are drawn.
pub(crate) trait Object<F: Format> {
    /// Width and height.
    fn size(&self) -> [usize; 2];
    /// Where it lies.
    fn places(&self) -> [Place; 2];
    /// The pixels of a row: column, coverage and normal.
    fn row(&self, row: usize) -> impl Iterator<Item = (usize, u8, F::Normal)>;
}

/// A disc of this diameter.
pub(crate) struct Sphere {
    disc: Disc,
    diameter: usize,
}

pub(crate) fn disc(diameter: usize) -> Result<Sphere, Status> {
    let disc = Disc::new(diameter).map_err(|_| Status::Diameter)?;
    Ok(Sphere { disc, diameter })
}

impl<F: Format> Object<F> for Sphere {
    fn size(&self) -> [usize; 2] {
        [self.diameter; 2]
    }

    fn places(&self) -> [Place; 2] {
        [Place::default(); 2]
    }

    fn row(&self, row: usize) -> impl Iterator<Item = (usize, u8, F::Normal)> {
        self.disc.row(row).map(|pixel| (pixel.column(), u8::MAX, F::of_disc(pixel)))
    }
}

/// A normal map that was checked.
pub(crate) struct Map<'a> {
    map: eigenshade::object::NormalMap<'a>,
    places: [Place; 2],
}

pub(crate) fn normal_map(map: &Input<NormalMap>) -> Result<Map<'_>, Status> {
    let map = map.value()?;
    // SAFETY: C promises `length` bytes.
    let codes = unsafe { Input(map.codes).array(map.length) }?;
    let places = [Place::of(map), Place::of(codes)];
    let map = eigenshade::object::NormalMap::new(map.width, map.height, codes);
    Ok(Map { map: map.map_err(|_| Status::NormalMap)?, places })
}

impl<F: Format> Object<F> for Map<'_> {
    fn size(&self) -> [usize; 2] {
        [self.map.width(), self.map.height()]
    }

    fn places(&self) -> [Place; 2] {
        self.places
    }

    fn row(&self, row: usize) -> impl Iterator<Item = (usize, u8, F::Normal)> {
        let pixels = self.map.row(row);
        pixels.map(|pixel| (pixel.column(), pixel.coverage(), F::of_normal_map(pixel)))
    }
}

/// What shades and exposes a normal.
#[inline]
pub(crate) fn exposing<F: Format>(
    picture: &Opened<impl Shade<F>>,
    exposure: f32,
) -> Result<impl Fn(F::Normal) -> Rgb<Linear>, Status> {
    let exposure = F::exposure(exposure, picture.exponents)?;
    Ok(move |normal| F::exposed((picture.shade)(normal), exposure))
}

/// Draws rows of an object, once everything is checked.
pub(crate) fn draw<F: Format>(
    picture: Result<Opened<impl Shade<F>>, Status>,
    object: Result<impl Object<F>, Status>,
    target: &Target,
) -> Result<(), Status> {
    let (picture, object) = (picture?, object?);
    target.check(object.size())?;
    let exposed = exposing::<F>(&picture, target.exposure)?;
    let Display(display) = target.display.value()?;
    let written = [target.pixels.place_of_array(target.length)?];
    disjoint(&written, &object.places())?;
    disjoint(&written, &picture.places)?;
    disjoint(&written, &[Place::of(display)])?;
    // SAFETY: C promises `length` pixels, which overlap no other.
    let pixels = unsafe { target.pixels.array(target.length) }?;
    for row in 0..target.rows {
        let pixels = pixels.get_mut(row * target.stride..).ok_or(Status::Internal)?;
        for (column, coverage, normal) in object.row(target.first + row) {
            let color = exposed(normal);
            if let Some(pixel) = pixels.get_mut(column) {
                *pixel = blend565(*pixel, display.rgb565(color), coverage);
            }
        }
    }
    Ok(())
}
