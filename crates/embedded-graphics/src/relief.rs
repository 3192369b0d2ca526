//! An object drawn from a map of its normals.

use crate::paint::{DisplayColor, Shader};
use crate::rows;
use eigenshade::object::NormalMap;
use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::primitives::Rectangle;

/// A relief, or any object, from a [`NormalMap`]: `eigenshade pack-object` makes such a map from a
/// mesh or a normal map.
#[derive(Debug)]
pub struct Relief<'p, 'm, P, C> {
    top_left: Point,
    map: NormalMap<'m>,
    paint: &'p P,
    below: Option<C>,
}

impl<'p, 'm, P: Shader, C: DisplayColor> Relief<'p, 'm, P, C> {
    /// An object whose map begins at this point, with the pixels that it covers by half or more.
    pub const fn new(top_left: Point, map: NormalMap<'m>, paint: &'p P) -> Self {
        Self { top_left, map, paint, below: None }
    }

    /// This object on a background of one color, with which the pixels of the outline are mixed.
    #[must_use]
    pub fn over(self, background: C) -> Self {
        Self { below: Some(background), ..self }
    }
}

impl<P, C> Dimensions for Relief<'_, '_, P, C> {
    fn bounding_box(&self) -> Rectangle {
        let size = Size::new(self.map.width() as u32, self.map.height() as u32);
        Rectangle::new(self.top_left, size)
    }
}

impl<P: Shader, C: DisplayColor> Drawable for Relief<'_, '_, P, C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        rows::draw(target, self.bounding_box(), self.below, self.paint, |row| self.map.row(row))
    }
}
