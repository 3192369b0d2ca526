//! The exposure of a picture, metered row by row.
#![expect(unsafe_code, reason = "memory of C")]

use super::format::Format;
use super::picture::{Opened, Picture, Shade};
use super::rows::{NormalMap, Row, Shape, disc, exposing, normal_map};
use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::export::export;
use crate::status::Status;
use eigenshade::Meter;

// The structure of C.
const _: () = assert!(size_of::<Meter>() == size_of::<[u32; 257]>());
const _: () = assert!(align_of::<Meter>() == align_of::<u32>());

// SAFETY: 257 numbers, by their size; zeros are a meter that has counted nothing.
unsafe impl Plain for Meter {}

/// Counts the pixels of a row, once everything is checked.
fn counted<F: Format>(
    shape: Shape<impl Row<F>>,
    picture: &Opened<impl Shade<F>>,
    row: usize,
    meter: &Output<Meter>,
    read: &[Place],
) -> Result<(), Status> {
    let [_, height] = shape.size;
    if row >= height {
        return Err(Status::Row);
    }
    let exposed = exposing::<F>(picture, 1.0)?;
    disjoint(&[meter.place()], read)?;
    disjoint(&[meter.place()], &picture.places)?;
    // SAFETY: C promises a meter, which overlaps no other.
    let [meter] = unsafe { meter.array(1) }? else { return Err(Status::Internal) };
    for (_, _, normal) in shape.row {
        meter.add_linear(exposed(normal)?);
    }
    Ok(())
}

pub(crate) fn color_meter_disc_row<F: Format>(
    picture: Input<impl Picture<F>>,
    diameter: usize,
    row: usize,
    meter: Output<Meter>,
) -> Result<(), Status> {
    let picture = picture.value()?.open()?;
    counted::<F>(disc::<F>(diameter, row)?, &picture, row, &meter, &[])
}

pub(crate) fn color_meter_normal_map_row<F: Format>(
    picture: Input<impl Picture<F>>,
    map: Input<NormalMap>,
    row: usize,
    meter: Output<Meter>,
) -> Result<(), Status> {
    let (picture, map) = (picture.value()?.open()?, map.value()?);
    let (shape, of_codes) = normal_map::<F>(map, row)?;
    counted::<F>(shape, &picture, row, &meter, &[Place::of(map), of_codes])
}

fn meter_exposure(meter: Input<Meter>, exposure: Output<f32>) -> Result<(), Status> {
    let meter = meter.value()?;
    disjoint(&[exposure.place()], &[Place::of(meter)])?;
    let found = meter.exposure().ok_or(Status::Dark)?.factor();
    // SAFETY: it overlaps no other.
    *unsafe { exposure.zeroed() }? = found;
    Ok(())
}

export! { functions "f32"
    meter_exposure(meter: Input<Meter>, exposure: Output<f32>)
}
