//! Objects over each other, drawn from palettes, each pixel of which is sent once.

use crate::paint::DisplayColor;
use eigenshade::object::{NormalMap, ShadowedObject};
use eigenshade::screen::{Dithered, Painted, Palette, Pixel, Sent, Target};
use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::primitives::Rectangle;

/// Pixels of a row that are drawn and sent together.
const RUN: usize = 256;

/// The colors of a [`Layer`]: those of a [`Palette`], as they are or [`Dithered`].
#[derive(Clone, Copy, Debug)]
pub enum Colors<'a> {
    /// Each rounded to the nearest color of the display.
    Nearest(&'a Palette),
    /// With ordered dithering on displays of 16 bits a pixel.
    Dithered(Dithered<'a>),
}

impl<'a> From<&'a Palette> for Colors<'a> {
    fn from(palette: &'a Palette) -> Self {
        Self::Nearest(palette)
    }
}

impl<'a> From<Dithered<'a>> for Colors<'a> {
    fn from(dithered: Dithered<'a>) -> Self {
        Self::Dithered(dithered)
    }
}

/// An object of a [`Frame`], and where it is; `P` is the display's [`DisplayColor::Pixel`].
#[derive(Clone, Copy, Debug)]
pub struct Layer<'a, P> {
    top_left: Point,
    object: Object<'a, P>,
}

/// The object of a layer.
#[derive(Clone, Copy, Debug)]
enum Object<'a, P> {
    Normals(NormalMap<'a>, Colors<'a>),
    Painted(Painted<'a>),
    Shadowed(&'a ShadowedObject<'a>, &'a [P]),
}

impl<'a, P: Pixel> Layer<'a, P> {
    /// An object whose map begins at this point, in the colors of a `&Palette` or of
    /// [`Palette::dithered`].
    #[must_use]
    pub fn new(top_left: Point, map: NormalMap<'a>, colors: impl Into<Colors<'a>>) -> Self {
        Self { top_left, object: Object::Normals(map, colors.into()) }
    }

    /// A textured object that begins at this point, in the colors of its palettes.
    #[must_use]
    pub const fn painted(top_left: Point, painted: Painted<'a>) -> Self {
        Self { top_left, object: Object::Painted(painted) }
    }

    /// An object with shadows that begins at this point, in the colors of its codes:
    /// [`ShadowedObject::colors`] makes them in every frame whose light turns.
    #[must_use]
    pub const fn shadowed(
        top_left: Point,
        object: &'a ShadowedObject<'a>,
        colors: &'a [P],
    ) -> Self {
        Self { top_left, object: Object::Shadowed(object, colors) }
    }

    /// Draws the part in a row of pixels, which begins at a point.
    fn draw(&self, start: Point, row: &mut [P]) {
        let (width, Point { x, y }) = (row.len(), self.top_left);
        let [x, y] = [x.saturating_sub(start.x), y.saturating_sub(start.y)];
        if let Ok(mut target) = Target::new(row, width) {
            let mut target = target.at(x, y);
            match &self.object {
                Object::Normals(map, Colors::Nearest(palette)) => palette.draw(map, &mut target),
                Object::Normals(map, Colors::Dithered(palette)) => palette.draw(map, &mut target),
                Object::Painted(painted) => painted.draw(&mut target),
                Object::Shadowed(object, colors) => object.draw(colors, &mut target),
            }
        }
    }
}

/// An area with objects over each other, the last one above, on a background: the fastest way to draw
/// objects that move or whose light turns.
///
/// Each pixel of the area is sent once, row by row. Outlines are mixed with what is below them. Memory:
/// a buffer of 256 pixels.
///
/// ```
/// # use eigenshade::object::NormalMap;
/// # use eigenshade::screen::{Palette, Sent};
/// # use eigenshade_embedded_graphics::{Frame, Layer};
/// # use embedded_graphics::mock_display::MockDisplay;
/// # use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// # let mut display = MockDisplay::<Rgb565>::new();
/// # display.set_allow_overdraw(true);
/// # let mut codes = [NormalMap::BACKGROUND; 40 * 40];
/// # NormalMap::sphere(40, &mut codes)?;
/// # let map = NormalMap::new(40, 40, codes.as_flattened())?;
/// # let (steel, gold) = (Palette::default(), Palette::default());
/// let area = Rectangle::new(Point::zero(), Size::new(60, 50));
/// let layers =
///     [Layer::new(Point::zero(), map, &steel), Layer::new(Point::new(9, 5), map, gold.dithered())];
/// Frame::new(area, &layers, Rgb565::BLUE).draw(&mut display).unwrap();
///
/// // Of later frames, what changed: here, nothing.
/// let mut sent = Sent::<50>::default();
/// for expected in [60 * 50, 0] {
///     let frame = Frame::new(area, &layers, Rgb565::BLUE);
///     assert_eq!(frame.draw_changed(&mut display, &mut sent).unwrap(), expected);
/// }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a, C: DisplayColor> {
    area: Rectangle,
    layers: &'a [Layer<'a, C::Pixel>],
    background: C,
}

impl<'a, C: DisplayColor> Frame<'a, C> {
    /// An area with these objects, the places of which are on the display, and with this color where
    /// there is none.
    #[must_use]
    pub const fn new(area: Rectangle, layers: &'a [Layer<'a, C::Pixel>], background: C) -> Self {
        Self { area, layers, background }
    }

    /// Sends only runs of up to 256 pixels of a row of the area that are not as they were sent last.
    /// `sent` has a part for each, rows x (columns / 256, rounded up); use it for this area of this
    /// display alone, and a new one once something else was drawn there. Returns the number of pixels
    /// that were sent.
    ///
    /// # Errors
    ///
    /// The display's. What was not sent is sent by the next call.
    pub fn draw_changed<D: DrawTarget<Color = C>, const N: usize>(
        &self,
        target: &mut D,
        sent: &mut Sent<N>,
    ) -> Result<usize, D::Error> {
        let mut count = 0;
        self.runs(target, |target, run, pixels, area| {
            let is_sent = sent.send(run, pixels, |pixels| send(target, area, pixels))?;
            count += if is_sent { pixels.len() } else { 0 };
            Ok(())
        })?;
        Ok(count)
    }

    /// Draws every run, and calls a function with the target, the run's number in the area, its
    /// pixels and their place.
    fn runs<D: DrawTarget<Color = C>>(
        &self,
        target: &mut D,
        mut run: impl FnMut(&mut D, usize, &[C::Pixel], &Rectangle) -> Result<(), D::Error>,
    ) -> Result<(), D::Error> {
        let visible = self.area.intersection(&target.bounding_box());
        let (columns, first) = (visible.columns(), self.area.top_left);
        let runs = (self.area.size.width as usize).div_ceil(RUN);
        let mut buffer = [self.background.pixel(); RUN];
        for y in visible.rows() {
            for number in 0..runs {
                // Of the area, whatever part of it is visible.
                let start = first.x + (number * RUN) as i32;
                let place = start.max(columns.start)..(start + RUN as i32).min(columns.end);
                let Some(pixels) = buffer.get_mut(..place.len()) else { continue };
                if pixels.is_empty() {
                    continue;
                }
                let at = Point::new(place.start, y);
                pixels.fill(self.background.pixel());
                for layer in self.layers {
                    layer.draw(at, pixels);
                }
                let area = Rectangle::new(at, Size::new(pixels.len() as u32, 1));
                run(target, (y - first.y) as usize * runs + number, pixels, &area)?;
            }
        }
        Ok(())
    }
}

/// Sends pixels of a row.
fn send<C: DisplayColor, D: DrawTarget<Color = C>>(
    target: &mut D,
    area: &Rectangle,
    pixels: &[C::Pixel],
) -> Result<(), D::Error> {
    target.fill_contiguous(area, pixels.iter().map(|&pixel| C::of_pixel(pixel)))
}

impl<C: DisplayColor> Dimensions for Frame<'_, C> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<C: DisplayColor> Drawable for Frame<'_, C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        self.runs(target, |target, _, pixels, area| send(target, area, pixels))
    }
}
