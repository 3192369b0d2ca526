//! Draws objects row by row.

use crate::paint::{DisplayColor, Place, Shader};
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;
use heapless::Vec;

/// Pixels of a row that are sent together: a display needs their number before their colors.
struct Run<C> {
    start: i32,
    colors: Vec<C, RUN>,
}

/// Most pixels of a run.
const RUN: usize = 64;

impl<C: DisplayColor> Run<C> {
    fn continues(&self, column: i32) -> bool {
        !self.colors.is_full() && column == self.start + self.colors.len() as i32
    }

    fn push(&mut self, color: C) {
        // There is room: a full run does not continue.
        let _ = self.colors.push(color);
    }

    fn send<D: DrawTarget<Color = C>>(&mut self, target: &mut D, y: i32) -> Result<(), D::Error> {
        if !self.colors.is_empty() {
            let size = Size::new(self.colors.len() as u32, 1);
            let area = Rectangle::new(Point::new(self.start, y), size);
            target.fill_contiguous(&area, self.colors.iter().copied())?;
            self.colors.clear();
        }
        Ok(())
    }
}

/// Draws the part of an object that is inside the target. `row` gives the pixels of one of its rows
/// from the left.
///
/// A pixel that the object covers in part is mixed with `below`; without it, the object has the
/// pixels that it covers by half or more.
pub fn draw<D, P, I>(
    target: &mut D,
    object: Rectangle,
    below: Option<D::Color>,
    shader: &impl Shader,
    row: impl Fn(usize) -> I,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
    P: Place,
    I: Iterator<Item = P>,
{
    let visible = object.intersection(&target.bounding_box());
    let columns = visible.columns();
    let columns = columns.start - object.top_left.x..columns.end - object.top_left.x;
    let color = |place: P| {
        let color: D::Color = shader.color(place);
        match (below, place.coverage()) {
            (Some(below), coverage @ 0..=254) => color.over(below, coverage),
            _ => color,
        }
    };
    for y in visible.rows() {
        let inside = |place: &P| {
            let is_covered = below.is_some() || place.coverage() >= 128;
            is_covered && columns.contains(&(place.column() as i32))
        };
        let mut run = Run { start: 0, colors: Vec::new() };
        for place in row((y - object.top_left.y) as usize).filter(inside) {
            let column = object.top_left.x + place.column() as i32;
            if !run.continues(column) {
                run.send(target, y)?;
                run.start = column;
            }
            run.push(color(place));
        }
        run.send(target, y)?;
    }
    Ok(())
}
