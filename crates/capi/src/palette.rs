//! Palettes: the colors of a frame by normal.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Place, Plain, disjoint};
use crate::constants::PALETTE;
use crate::draw::{Display, exposing_mirrored};
use crate::format::Format;
use crate::memory::{Memory, assert_fits, write, written};
use crate::nodes::{self, Nodes};
use crate::object::{self, normal_map};
use crate::picture;
use crate::status::Status;
use crate::target::{Drawn, Target, Window};
use eigenshade::object::NormalMap;
use eigenshade::screen::{self, Pixel};

/// The colors of one material under one light, by normal, once it was filled: 8.7 KB. It has no
/// pointers, so it may be moved.
#[repr(C)]
pub struct Palette {
    /// Private to the library.
    pub words: [u32; PALETTE],
}

// SAFETY: consists of numbers.
unsafe impl Plain for Palette {}

impl Memory for Palette {
    type Value = screen::Palette;
    const MARK: Mark = Mark::PALETTE;
    const MISSING: Status = Status::Palette;
}

const _: () = assert_fits::<Palette>();

pub(crate) fn fill<F: Format>(
    picture: &Input<F::PictureBuffer>,
    exposure: f32,
    display: &Input<Display>,
    nodes: &Input<Nodes>,
    palette: &Output<Palette>,
) -> Result<(), Status> {
    let picture = picture::open_mirrored::<F>(picture)?;
    let exposed = exposing_mirrored::<F>(&picture, exposure)?;
    let Display(display) = display.value()?;
    let nodes = nodes::or_all(nodes)?;
    disjoint(&[palette.place()], &picture.places)?;
    disjoint(&[palette.place()], &[Place::of(display), Place::of(nodes)])?;
    // SAFETY: it overlaps no other.
    unsafe { write(palette, |palette| palette.fill_mirrored(nodes, display, exposed)) }
}

/// The object of a normal map in the colors of a palette.
struct Mapped<'a, const IS_DITHERED: bool> {
    palette: &'a screen::Palette,
    map: NormalMap<'a>,
}

impl<P: Pixel, const IS_DITHERED: bool> Drawn<P> for Mapped<'_, IS_DITHERED> {
    fn draw(&self, target: &mut screen::Target<'_, P>) {
        if IS_DITHERED {
            self.palette.dithered().draw(&self.map, target);
        } else {
            self.palette.draw(&self.map, target);
        }
    }
}

/// Draws an object from a palette. RGB888 and RGBA8888 have no dithering.
pub(crate) fn draw<const IS_DITHERED: bool>(
    palette: &Input<Palette>,
    map: &Input<object::NormalMap>,
    target: &Input<Target>,
) -> Result<(), Status> {
    let (colors, map, window) = (written(palette)?, normal_map(map)?, Window::of(target)?);
    window.apart_from(&map.places)?;
    window.apart_from(&[Place::of(palette.value()?)])?;
    let size = [map.map.width(), map.map.height()];
    // SAFETY: the pixels overlap no other.
    unsafe { window.draw(size, &Mapped::<IS_DITHERED> { palette: colors, map: map.map }) }
}
