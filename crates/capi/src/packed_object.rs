//! Textured objects, as `eigenshade pack-object` writes them.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::format::Format;
use crate::status::Status;
use eigenshade::object::{Object, Region};

/// A textured object, as `eigenshade pack-object` writes it. May be kept in flash.
#[repr(C)]
pub struct PackedObject {
    /// Number of bytes.
    pub length: usize,
    /// The file; the caller's.
    pub bytes: *const u8,
}

/// The size of a textured object and the number of its regions.
#[repr(C)]
pub struct ObjectHeader {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Number of regions.
    pub regions: usize,
}

// SAFETY: all of its fields are plain.
unsafe impl Plain for PackedObject {}
// SAFETY: as above.
unsafe impl Plain for ObjectHeader {}

/// An object, of which some rows were checked.
pub(crate) struct Opened<'a> {
    pub(crate) object: Object<'a>,
    pub(crate) places: [Place; 2],
}

/// A first row and a number of rows: all, and none.
pub(crate) const ALL_ROWS: [usize; 2] = [0, usize::MAX];
pub(crate) const NO_ROWS: [usize; 2] = [0; 2];

/// The object, with these rows checked.
pub(crate) fn open(object: &Input<PackedObject>, rows: [usize; 2]) -> Result<Opened<'_>, Status> {
    let object = object.value()?;
    // SAFETY: C promises `length` bytes.
    let bytes = unsafe { Input(object.bytes).array(object.length) }?;
    let places = [Place::of(object), Place::of(bytes)];
    Ok(Opened { object: Object::of_rows(bytes, rows)?, places })
}

impl Opened<'_> {
    /// The region of this number.
    pub(crate) fn region(&self, number: usize) -> Result<Region, Status> {
        self.object.regions().nth(number).ok_or(Status::Region)
    }
}

pub(crate) fn header(
    object: &Input<PackedObject>,
    header: &Output<ObjectHeader>,
) -> Result<(), Status> {
    let Opened { object, places } = open(object, ALL_ROWS)?;
    disjoint(&[header.place()], &places)?;
    let (width, height, regions) = (object.width(), object.height(), object.regions().len());
    // SAFETY: it overlaps no other.
    *unsafe { header.zeroed() }? = ObjectHeader { width, height, regions };
    Ok(())
}

pub(crate) fn materials<F: Format>(
    object: &Input<PackedObject>,
    region: usize,
    buffer: &Output<F::MaterialBuffer>,
    tinted: &Output<F::Material>,
    plain: &Output<F::Material>,
) -> Result<(), Status> {
    let object = open(object, NO_ROWS)?;
    let region = object.region(region)?;
    disjoint(&[buffer.place(), tinted.place(), plain.place()], &object.places)?;
    // SAFETY: nothing overlaps.
    let (buffer, tinted, plain) = unsafe { (buffer.zeroed()?, tinted.zeroed()?, plain.zeroed()?) };
    [*tinted, *plain] = F::materials(&region, buffer)?;
    Ok(())
}
