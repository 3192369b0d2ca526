//! Draws objects row by row.

use crate::paint::{DisplayColor, Place, Shader};
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

/// Draws the part of an object that is inside the target. `row` gives the pixels of one of its rows
/// from the left, with at most one gap between two runs of them.
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
    I: Iterator<Item = P> + Clone,
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
        let mut places = row((y - object.top_left.y) as usize).filter(inside);
        loop {
            // The display needs the length of a run before its colors.
            let mut ahead = places.clone();
            let Some(first) = ahead.next() else { break };
            let left = first.column();
            let next = |&(place, column): &(P, usize)| place.column() == column;
            let count = 1 + ahead.zip(left + 1..).take_while(next).count();
            let start = Point::new(object.top_left.x + left as i32, y);
            let area = Rectangle::new(start, Size::new(count as u32, 1));
            target.fill_contiguous(&area, places.by_ref().take(count).map(color))?;
        }
    }
    Ok(())
}
