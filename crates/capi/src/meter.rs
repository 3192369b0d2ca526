//! The exposure of a picture, metered row by row.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::draw::exposing;
use crate::format::Format;
use crate::object::Object;
use crate::picture::{Opened, Shade};
use crate::status::Status;

/// The brightness of a picture's pixels, to meter its exposure. A meter of zeros has counted
/// nothing.
#[repr(C)]
pub struct Meter {
    /// Private to the library.
    pub counts: [u32; 257],
}

// SAFETY: consists of numbers.
unsafe impl Plain for Meter {}

// It has the bytes of the runtime's meter, which consists of such numbers.
const _: () = assert!(size_of::<Meter>() == size_of::<eigenshade::screen::Meter>());
const _: () = assert!(align_of::<Meter>() == align_of::<eigenshade::screen::Meter>());

/// Counts the pixels of a row, once everything is checked.
pub(crate) fn count<F: Format>(
    picture: Result<Opened<impl Shade<F>>, Status>,
    object: Result<impl Object<F>, Status>,
    row: usize,
    meter: &Output<Meter>,
) -> Result<(), Status> {
    let (picture, object) = (picture?, object?);
    let [_, height] = object.size();
    if row >= height {
        return Err(Status::Row);
    }
    let exposed = exposing::<F>(&picture, 1.0)?;
    disjoint(&[meter.place()], &object.places())?;
    disjoint(&[meter.place()], &picture.places)?;
    // SAFETY: C promises a meter, which overlaps no other.
    let [meter] = unsafe { meter.array(1) }? else { return Err(Status::Internal) };
    // SAFETY: both consist of 257 numbers, and no other reference exists.
    let meter = unsafe { &mut *core::ptr::from_mut(meter).cast::<eigenshade::screen::Meter>() };
    for (_, _, normal) in object.row(row) {
        meter.add_linear(exposed(normal));
    }
    Ok(())
}

pub(crate) fn exposure(meter: &Input<Meter>, exposure: &Output<f32>) -> Result<(), Status> {
    let meter = meter.value()?;
    disjoint(&[exposure.place()], &[Place::of(meter)])?;
    // SAFETY: both consist of 257 numbers.
    let meter = unsafe { &*core::ptr::from_ref(meter).cast::<eigenshade::screen::Meter>() };
    let found = meter.exposure().ok_or(Status::Dark)?.factor();
    // SAFETY: it overlaps no other.
    *unsafe { exposure.zeroed() }? = found;
    Ok(())
}
