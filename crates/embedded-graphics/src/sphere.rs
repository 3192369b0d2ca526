//! A sphere.

use crate::paint::{DisplayColor, Shader};
use crate::rows;
use eigenshade::Error;
use eigenshade::object::Disc;
use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::primitives::Rectangle;

/// A sphere of any diameter up to [`Disc::MOST`] pixels.
///
/// The rest of the target stays. The sphere has the pixels that the circle covers by half or more; on
/// a background of one color, [`over`](Self::over) blends the rim.
#[derive(Debug)]
pub struct Sphere<'p, P, C> {
    top_left: Point,
    disc: Disc,
    diameter: u32,
    paint: &'p P,
    below: Option<C>,
}

impl<'p, P: Shader, C: DisplayColor> Sphere<'p, P, C> {
    /// A sphere that fills a square of `diameter` pixels.
    ///
    /// # Errors
    ///
    /// As [`Disc::new`].
    pub fn new(top_left: Point, diameter: u32, paint: &'p P) -> Result<Self, Error> {
        let disc = Disc::new(diameter as usize)?;
        Ok(Self { top_left, disc, diameter, paint, below: None })
    }

    /// The same on a background of one color, with which the pixels of the rim are mixed.
    #[must_use]
    pub fn over(self, background: C) -> Self {
        Self { below: Some(background), ..self }
    }
}

impl<P, C> Dimensions for Sphere<'_, P, C> {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(self.top_left, Size::new_equal(self.diameter))
    }
}

impl<P: Shader, C: DisplayColor> Drawable for Sphere<'_, P, C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        rows::draw(target, self.bounding_box(), self.below, self.paint, |row| self.disc.row(row))
    }
}
