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
struct Mapped<'a> {
    palette: &'a screen::Palette,
    map: NormalMap<'a>,
}

impl Drawn for Mapped<'_> {
    fn size(&self) -> [usize; 2] {
        [self.map.width(), self.map.height()]
    }

    fn draw<P: Pixel>(&self, target: &mut screen::Target<'_, P>) {
        self.palette.draw(&self.map, target);
    }
}

/// The same with ordered dithering.
struct Dithered<'a>(Mapped<'a>);

impl Drawn for Dithered<'_> {
    fn size(&self) -> [usize; 2] {
        self.0.size()
    }

    fn draw<P: Pixel>(&self, target: &mut screen::Target<'_, P>) {
        self.0.palette.dithered().draw(&self.0.map, target);
    }
}

/// Draws an object from a palette.
pub(crate) fn draw(
    palette: &Input<Palette>,
    map: &Input<object::NormalMap>,
    target: &Input<Target>,
) -> Result<(), Status> {
    drawn(palette, map, target, |mapped| mapped)
}

/// [`draw`] with ordered dithering, which RGB888 has none of.
pub(crate) fn draw_dithered(
    palette: &Input<Palette>,
    map: &Input<object::NormalMap>,
    target: &Input<Target>,
) -> Result<(), Status> {
    drawn(palette, map, target, Dithered)
}

/// Draws an object, once everything is checked.
fn drawn<'a, D: Drawn>(
    palette: &'a Input<Palette>,
    map: &'a Input<object::NormalMap>,
    target: &Input<Target>,
    how: impl FnOnce(Mapped<'a>) -> D,
) -> Result<(), Status> {
    let (colors, map, window) = (written(palette)?, normal_map(map)?, Window::of(target)?);
    window.apart_from(&map.places)?;
    window.apart_from(&[Place::of(palette.value()?)])?;
    // SAFETY: the pixels overlap no other.
    unsafe { window.draw(&how(Mapped { palette: colors, map: map.map })) }
}
