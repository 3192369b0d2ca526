//! Palettes: the colors of a frame by normal.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Place, Plain, disjoint};
use crate::constants::{NODES, PALETTE};
use crate::draw::Display;
use crate::format::Format;
use crate::object::{NormalMap, normal_map};
use crate::picture;
use crate::status::Status;
use crate::target::{Row, Target, Window};
use core::ops::Range;
use eigenshade::{Error, screen};

/// The nodes of a palette that an object needs, once they were found.
#[repr(C)]
pub struct Nodes {
    /// Private to the library.
    pub words: [u64; NODES],
}

/// The colors of one material under one light, by normal, once it was filled: 8.7 KB. It has no
/// pointers, so it may be moved.
#[repr(C)]
pub struct Palette {
    /// Private to the library.
    pub words: [u32; PALETTE],
}

// SAFETY: both consist of numbers.
unsafe impl Plain for Nodes {}
// SAFETY: as above.
unsafe impl Plain for Palette {}

/// The contents of such memory.
#[repr(C)]
struct Marked<T> {
    state: Mark,
    value: T,
}

const _: () = assert!(size_of::<Nodes>() == size_of::<Marked<screen::Nodes>>());
const _: () = assert!(align_of::<Nodes>() == align_of::<Marked<screen::Nodes>>());
const _: () = assert!(size_of::<Palette>() == size_of::<Marked<screen::Palette>>());
const _: () = assert!(align_of::<Palette>() == align_of::<Marked<screen::Palette>>());

/// Memory for a value that consists of numbers.
trait Memory: Plain {
    type Value;
    const MARK: Mark;
    const MISSING: Status;
}

impl Memory for Nodes {
    type Value = screen::Nodes;
    const MARK: Mark = Mark::NODES;
    const MISSING: Status = Status::Nodes;
}

impl Memory for Palette {
    type Value = screen::Palette;
    const MARK: Mark = Mark::PALETTE;
    const MISSING: Status = Status::Palette;
}

/// The value in this memory, unless none was written.
fn written<M: Memory>(memory: &Input<M>) -> Result<&M::Value, Status> {
    let memory = core::ptr::from_ref(memory.value()?).cast::<Marked<M::Value>>();
    // SAFETY: the memory has the size and the alignment of this, and any bytes are valid.
    let Marked { state, value } = unsafe { &*memory };
    if *state == M::MARK { Ok(value) } else { Err(M::MISSING) }
}

/// Writes the value in this memory, from zeros if none was written.
///
/// # Safety
///
/// The memory overlaps nothing that is in use.
unsafe fn write<M: Memory>(
    memory: &Output<M>,
    write: impl FnOnce(&mut M::Value),
) -> Result<(), Status> {
    if written(&Input(memory.0.cast_const())).is_err() {
        // SAFETY: this function's caller promises as much.
        unsafe { memory.zeroed() }?;
    }
    let memory = memory.0.cast::<Marked<M::Value>>();
    // SAFETY: the pointer was checked; the rest is as in `written`.
    let Marked { state, value } = unsafe { &mut *memory };
    write(value);
    *state = M::MARK;
    Ok(())
}

pub(crate) fn nodes(map: &Input<NormalMap>, nodes: &Output<Nodes>) -> Result<(), Status> {
    let map = normal_map(map)?;
    disjoint(&[nodes.place()], &map.places)?;
    // SAFETY: it overlaps no other.
    unsafe { write(nodes, |nodes| *nodes = map.map.nodes()) }
}

pub(crate) fn fill<F: Format>(
    picture: &Input<F::PictureBuffer>,
    exposure: f32,
    display: &Input<Display>,
    nodes: &Input<Nodes>,
    palette: &Output<Palette>,
) -> Result<(), Status> {
    let picture = picture::open_mirrored::<F>(picture)?;
    let exposure = F::exposure(exposure, picture.exponents)?;
    let Display(display) = display.value()?;
    let nodes = if nodes.0.is_null() { &screen::Nodes::ALL } else { written(nodes)? };
    disjoint(&[palette.place()], &picture.places)?;
    disjoint(&[palette.place()], &[Place::of(display), Place::of(nodes)])?;
    let exposed =
        |normal| (picture.shade)(normal).map(|irradiance| F::exposed(irradiance, exposure));
    // SAFETY: it overlaps no other.
    unsafe { write(palette, |palette| F::fill(palette, nodes, display, exposed)) }
}

/// Draws an object from a palette.
pub(crate) fn draw(
    palette: &Input<Palette>,
    map: &Input<NormalMap>,
    target: &Input<Target>,
) -> Result<(), Status> {
    rows(palette, map, target, |palette, map, [x, y], row| {
        match row {
            Row::Rgb565(pixels) => palette.draw(map, &mut of_row(pixels)?.at(x, y)),
            Row::HighFirst(pixels) => palette.draw(map, &mut of_row(pixels)?.at(x, y)),
            Row::Rgb888(pixels) => palette.draw(map, &mut of_row(pixels)?.at(x, y)),
        }
        Ok(())
    })
}

/// [`draw`] with ordered dithering, which RGB888 has none of.
pub(crate) fn draw_dithered(
    palette: &Input<Palette>,
    map: &Input<NormalMap>,
    target: &Input<Target>,
) -> Result<(), Status> {
    rows(palette, map, target, |palette, map, [x, y], row| {
        match row {
            Row::Rgb565(pixels) => palette.dithered().draw(map, &mut of_row(pixels)?.at(x, y)),
            Row::HighFirst(pixels) => palette.dithered().draw(map, &mut of_row(pixels)?.at(x, y)),
            Row::Rgb888(pixels) => palette.draw(map, &mut of_row(pixels)?.at(x, y)),
        }
        Ok(())
    })
}

/// A target of one row.
fn of_row<P>(pixels: &mut [P]) -> Result<screen::Target<'_, P>, Error> {
    let width = pixels.len();
    screen::Target::new(pixels, width)
}

/// Draws rows, once everything is checked: each with the place of the object beside its pixels.
fn rows(
    palette: &Input<Palette>,
    map: &Input<NormalMap>,
    target: &Input<Target>,
    draw: impl Fn(
        &screen::Palette,
        &eigenshade::object::NormalMap<'_>,
        [i32; 2],
        Row<'_>,
    ) -> Result<(), Error>,
) -> Result<(), Status> {
    let (colors, map, window) = (written(palette)?, normal_map(map)?, Window::of(target)?);
    window.apart_from(&map.places)?;
    window.apart_from(&[Place::of(palette.value()?)])?;
    let map = &map.map;
    let draw = |row, columns: &Range<usize>, pixels: Row<'_>| {
        let corner = [columns.start, row].map(|place| (place as i32).wrapping_neg());
        Ok(draw(colors, map, corner, pixels)?)
    };
    // SAFETY: the pixels overlap no other.
    unsafe { window.rows([map.width(), map.height()], draw) }
}
