//! Objects that are drawn: discs and normal maps.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, Plain};
use crate::format::Format;
use crate::status::Status;
use eigenshade::object::Disc;

/// The visible normals of an object, as `eigenshade pack-object` makes them from a mesh or a
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
        self.disc.row(row).map(|pixel| (pixel.column(), pixel.coverage(), F::of_disc(pixel)))
    }
}

/// A normal map that was checked.
pub(crate) struct Map<'a> {
    pub(crate) map: eigenshade::object::NormalMap<'a>,
    pub(crate) places: [Place; 2],
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

/// Writes the codes of a sphere.
pub(crate) fn sphere(diameter: usize, codes: &Output<u8>, length: usize) -> Result<(), Status> {
    disc(diameter)?;
    if length != 2 * diameter * diameter {
        return Err(Status::NormalMap);
    }
    // SAFETY: C promises `length` bytes; nothing else is in use.
    let codes = unsafe { codes.array(length) }?;
    Ok(eigenshade::object::NormalMap::sphere(diameter, codes.as_chunks_mut().0)?)
}
