//! A display for tests.

use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use std::convert::Infallible;

/// A display that counts what it is sent, and refuses what is not one row of its own pixels.
pub struct Screen<C> {
    size: Size,
    pub pixels: Vec<Option<C>>,
    pub windows: usize,
}

impl<C: PixelColor> Screen<C> {
    pub fn new(width: u32, height: u32) -> Self {
        let pixels = vec![None; (width * height) as usize];
        Self { size: Size::new(width, height), pixels, windows: 0 }
    }

    pub fn drawn(&self) -> usize {
        self.pixels.iter().flatten().count()
    }
}

impl<C> OriginDimensions for Screen<C> {
    fn size(&self) -> Size {
        self.size
    }
}

impl<C: PixelColor> DrawTarget for Screen<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, _: I) -> Result<(), Infallible> {
        unreachable!("pixel by pixel")
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        assert_eq!(area.intersection(&self.bounding_box()), *area);
        assert!(area.size.height == 1 && area.size.width > 0);
        let mut colors = colors.into_iter();
        for Point { x, y } in area.points() {
            let place = &mut self.pixels[y as usize * self.size.width as usize + x as usize];
            assert!(place.replace(colors.next().unwrap()).is_none(), "{x}, {y}: drawn twice");
        }
        assert!(colors.next().is_none());
        self.windows += 1;
        Ok(())
    }
}
