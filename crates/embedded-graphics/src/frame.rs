//! Objects over each other, drawn from palettes, each pixel of which is sent once.

use crate::paint::DisplayColor;
use eigenshade::object::NormalMap;
use eigenshade::screen::{Palette, Sent, Target};
use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::primitives::Rectangle;

/// Pixels of a row that are drawn and sent together.
const RUN: usize = 128;

/// An object of a [`Frame`]: its normals, where it is, and its colors.
#[derive(Clone, Copy, Debug)]
pub struct Layer<'a> {
    top_left: Point,
    map: NormalMap<'a>,
    palette: &'a Palette,
    is_dithered: bool,
}

impl<'a> Layer<'a> {
    /// An object whose map begins at this point.
    #[must_use]
    pub const fn new(top_left: Point, map: NormalMap<'a>, palette: &'a Palette) -> Self {
        Self { top_left, map, palette, is_dithered: false }
    }

    /// This object with ordered dithering on displays of 16 bits a pixel.
    #[must_use]
    pub const fn dithered(self) -> Self {
        Self { is_dithered: true, ..self }
    }

    /// Draws the part in a row of pixels, which begins at a point.
    fn draw<C: DisplayColor>(&self, start: Point, row: &mut [C::Pixel]) {
        let (width, Point { x, y }) = (row.len(), self.top_left - start);
        if let Ok(mut target) = Target::new(row, width) {
            let mut target = target.at(x, y);
            if self.is_dithered {
                self.palette.draw_dithered(&self.map, &mut target);
            } else {
                self.palette.draw(&self.map, &mut target);
            }
        }
    }
}

impl Dimensions for Layer<'_> {
    fn bounding_box(&self) -> Rectangle {
        let size = Size::new(self.map.width() as u32, self.map.height() as u32);
        Rectangle::new(self.top_left, size)
    }
}

/// Objects over each other, the last one above, on a background: the fastest way to draw objects
/// that move or whose light turns.
///
/// Each pixel of the rectangle around them is sent once, row by row. Outlines are mixed with what is
/// below them. Memory: a buffer of 128 pixels.
///
/// ```
/// # use eigenshade::object::NormalMap;
/// # use eigenshade::screen::{Palette, Sent};
/// # use eigenshade_embedded_graphics::{Frame, Layer};
/// # use embedded_graphics::mock_display::MockDisplay;
/// # use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
/// # let mut display = MockDisplay::<Rgb565>::new();
/// # display.set_allow_overdraw(true);
/// # let mut codes = [NormalMap::BACKGROUND; 40 * 40];
/// # NormalMap::sphere(40, &mut codes)?;
/// # let map = NormalMap::new(40, 40, codes.as_flattened())?;
/// # let (steel, gold) = (Palette::default(), Palette::default());
/// let layers = [Layer::new(Point::zero(), map, &steel), Layer::new(Point::new(9, 5), map, &gold)];
/// let frame = Frame::new(&layers, Rgb565::BLUE);
/// frame.draw(&mut display).unwrap();
///
/// // Of later frames, what changed: nothing here.
/// let mut sent = Sent::<48>::default();
/// assert_eq!(frame.draw_changed(&mut display, &mut sent).unwrap(), 49 * 45);
/// assert_eq!(frame.draw_changed(&mut display, &mut sent).unwrap(), 0);
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a, C> {
    layers: &'a [Layer<'a>],
    background: C,
}

impl<'a, C: DisplayColor> Frame<'a, C> {
    /// These objects, where there is none this color.
    #[must_use]
    pub const fn new(layers: &'a [Layer<'a>], background: C) -> Self {
        Self { layers, background }
    }

    /// Sends only runs of up to 128 pixels of a row that are not as they were sent last. `sent` has a
    /// part for each: rows x (columns / 128, rounded up). Use it for this frame alone. Returns the
    /// number of pixels that were sent.
    ///
    /// # Errors
    ///
    /// The display's.
    pub fn draw_changed<D: DrawTarget<Color = C>, const N: usize>(
        &self,
        target: &mut D,
        sent: &mut Sent<N>,
    ) -> Result<usize, D::Error> {
        self.send(target, |run, pixels| sent.changed(run, pixels))
    }

    /// Sends runs that are wanted. Returns the number of their pixels.
    fn send<D: DrawTarget<Color = C>>(
        &self,
        target: &mut D,
        mut wanted: impl FnMut(usize, &[C::Pixel]) -> bool,
    ) -> Result<usize, D::Error> {
        let area = self.bounding_box();
        let visible = area.intersection(&target.bounding_box());
        let mut buffer = [self.background.pixel(); RUN];
        let (mut run, mut count) = (0, 0);
        for y in visible.rows() {
            let mut columns = visible.columns();
            while let Some(x) = columns.next() {
                let rest = columns.len().min(RUN - 1);
                columns = x + 1 + rest as i32..columns.end;
                let pixels = buffer.get_mut(..=rest).unwrap_or_default();
                pixels.fill(self.background.pixel());
                for layer in self.layers {
                    layer.draw::<C>(Point::new(x, y), pixels);
                }
                if wanted(run, pixels) {
                    let colors = pixels.iter().map(|&pixel| C::of_pixel(pixel));
                    let size = Size::new(pixels.len() as u32, 1);
                    target.fill_contiguous(&Rectangle::new(Point::new(x, y), size), colors)?;
                    count += pixels.len();
                }
                run += 1;
            }
        }
        Ok(count)
    }
}

impl<C> Dimensions for Frame<'_, C> {
    fn bounding_box(&self) -> Rectangle {
        let corners = self.layers.iter().filter_map(|layer| {
            let area = layer.bounding_box();
            Some((area.top_left, area.bottom_right()?))
        });
        let around = corners.reduce(|(from, to), (others_from, others_to)| {
            (from.component_min(others_from), to.component_max(others_to))
        });
        around.map_or(Rectangle::zero(), |(from, to)| Rectangle::with_corners(from, to))
    }
}

impl<C: DisplayColor> Drawable for Frame<'_, C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        self.send(target, |_, _| true).map(drop)
    }
}
