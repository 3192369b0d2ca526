//! Linear palettes: the irradiances of a frame by normal, for objects with base colors of their own.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Place, Plain, disjoint};
use crate::constants::LINEAR_PALETTE;
use crate::draw::{Display, exposing_mirrored};
use crate::format::Format;
use crate::memory::{Marked, Memory, all_written, assert_fits, write};
use crate::nodes::{self, Nodes};
use crate::packed_object::{self, PackedObject};
use crate::picture;
use crate::status::Status;
use crate::target::{Drawn, Target, Window};
use eigenshade::screen::{self, Painted, Pixel};

/// The irradiances of a region of a textured object under one light, by normal, once it was filled:
/// 13 KB. It has no pointers, so it may be moved.
#[repr(C)]
pub struct LinearPalette {
    /// Private to the library.
    pub words: [u32; LINEAR_PALETTE],
}

// SAFETY: consists of numbers.
unsafe impl Plain for LinearPalette {}

impl Memory for LinearPalette {
    type Value = screen::LinearPalette;
    const MARK: Mark = Mark::LINEAR_PALETTE;
    const MISSING: Status = Status::Palette;
}

const _: () = assert_fits::<LinearPalette>();

pub(crate) fn fill<F: Format>(
    tinted: &Input<F::PictureBuffer>,
    plain: &Input<F::PictureBuffer>,
    exposure: f32,
    nodes: &Input<Nodes>,
    palette: &Output<LinearPalette>,
) -> Result<(), Status> {
    let tinted = picture::open_mirrored::<F>(tinted)?;
    let plain = picture::open_mirrored::<F>(plain)?;
    let of_tinted = exposing_mirrored::<F>(&tinted, exposure)?;
    let of_plain = exposing_mirrored::<F>(&plain, exposure)?;
    let nodes = nodes::or_all(nodes)?;
    disjoint(&[palette.place()], &tinted.places)?;
    disjoint(&[palette.place()], &plain.places)?;
    disjoint(&[palette.place()], &[Place::of(nodes)])?;
    let exposed = |normal| [of_tinted(normal), of_plain(normal)];
    // SAFETY: it overlaps no other.
    unsafe { write(palette, |palette| palette.fill_mirrored(nodes, exposed)) }
}

/// An object in the colors of a frame.
struct Textured<'a>(Painted<'a, Marked<screen::LinearPalette>>);

impl<P: Pixel> Drawn<P> for Textured<'_> {
    fn draw(&self, target: &mut screen::Target<'_, P>) {
        self.0.draw(target);
    }
}

/// Draws an object from palettes. RGB888 and RGBA8888 have no dithering.
pub(crate) fn draw(
    object: &Input<PackedObject>,
    palettes: &Input<LinearPalette>,
    count: usize,
    display: &Input<Display>,
    target: &Input<Target>,
    is_dithered: bool,
) -> Result<(), Status> {
    let window = Window::of(target)?;
    let packed_object::Opened { object, places } = packed_object::open(object, window.rows_of())?;
    // SAFETY: C promises `count` palettes.
    let palettes = unsafe { all_written(palettes, count) }?;
    let Display(display) = display.value()?;
    window.apart_from(&places)?;
    window.apart_from(&[Place::of(palettes), Place::of(display)])?;
    let painted = object.painted(palettes, display)?;
    let painted = if is_dithered { painted.dithered() } else { painted };
    // SAFETY: the pixels overlap no other.
    unsafe { window.draw([object.width(), object.height()], &Textured(painted)) }
}
