//! Pictures baked into maps.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, disjoint};
use crate::format::Format;
use crate::picture::{Opened, Shade, matte_scene};
use crate::records_f32::PictureF32;
use crate::status::Status;
use eigenshade::Rgb;

pub(crate) fn bake<F: Format>(
    picture: &Input<PictureF32>,
    size: usize,
    texels: &Output<F::Texel>,
    length: usize,
    baked: &Output<F::Baked>,
) -> Result<(), Status> {
    let scene = matte_scene(picture)?;
    check_size(size, length)?;
    let written = [texels.place_of_array(length)?, baked.place()];
    disjoint(&written, &[Place::of(picture.value()?)])?;
    // SAFETY: C promises memory for `length` texels; nothing overlaps.
    let (numbers, baked) = unsafe { (texels.zeroed_array(length)?, baked.zeroed()?) };
    let third = length / 3;
    let (r, rest) = numbers.split_at_mut_checked(third).ok_or(Status::Internal)?;
    let (g, b) = rest.split_at_mut_checked(third).ok_or(Status::Internal)?;
    let exponents = F::bake(scene.view()?, size, Rgb::new(r, g, b))?;
    *baked = F::baked(size, texels.0, length, exponents);
    Ok(())
}

pub(crate) fn open<F: Format>(baked: &Input<F::Baked>) -> Result<Opened<impl Shade<F>>, Status> {
    let baked = baked.value()?;
    let (size, texels, length, exponents) = F::maps(baked);
    check_size(size, length)?;
    // SAFETY: C promises `length` texels.
    let texels = unsafe { texels.array(length) }?;
    let places = [Place::of(baked), Place::of(texels)];
    let third = length / 3;
    let (r, rest) = texels.split_at_checked(third).ok_or(Status::Internal)?;
    let (g, b) = rest.split_at_checked(third).ok_or(Status::Internal)?;
    Ok(Opened { shade: F::look_up(size, Rgb::new(r, g, b), exponents)?, exponents, places })
}

/// Checks the size of three baked maps, and the number of their texels.
fn check_size(size: usize, length: usize) -> Result<(), Status> {
    // The size is checked first, so that nothing wraps.
    if (2..=4096).contains(&size) && length == 3 * size * size {
        Ok(())
    } else {
        Err(Status::Baked)
    }
}
