//! Values at the nodes of a map of normals, every eighth code of each axis of a [`NormalCode`]. The
//! three low bits of a code are the place between two nodes.

use crate::nodes::{Nodes, SIDE};
use crate::normal::Normal;
use crate::normal_code::{NormalCode, RIM, normal_at, normal_q15_at};
use crate::q15;

/// Bits of a node's place after the binary point, in codes.
const POINT: u32 = 4;

/// A [`Normal`] or a [`q15::Normal`].
pub trait AnyNormal: sealed::AnyNormal {}
impl AnyNormal for Normal {}
impl AnyNormal for q15::Normal {}

mod sealed {
    use super::{Normal, POINT, normal_at, normal_q15_at, q15};

    pub trait AnyNormal {
        /// The normal at a point of the map of codes, in units of 2^-[`POINT`] of a code.
        fn of_point(point: [i32; 2]) -> Self;
    }
    impl AnyNormal for Normal {
        #[inline]
        fn of_point(point: [i32; 2]) -> Self {
            normal_at::<POINT>(point)
        }
    }
    impl AnyNormal for q15::Normal {
        #[inline]
        fn of_point(point: [i32; 2]) -> Self {
            normal_q15_at::<POINT>(point)
        }
    }
}

/// Row by row from the bottom.
#[derive(Clone, Debug)]
pub struct Grid<T>(pub [T; SIDE * SIDE]);

impl<T: Copy> Grid<T> {
    /// Sets nodes by their normals. Nodes beyond the rim of a sphere have the normals of the rim.
    /// Other nodes stay.
    #[inline]
    pub fn fill<N: AnyNormal>(&mut self, nodes: &Nodes, mut value: impl FnMut(N) -> T) {
        let rows = self.0.as_chunks_mut::<SIDE>().0;
        for (row, (places, used)) in rows.iter_mut().zip(nodes.0).enumerate() {
            for (column, node) in places.iter_mut().enumerate() {
                if used >> column & 1 == 1 {
                    *node = value(N::of_point(point([column, row])));
                }
            }
        }
    }

    /// [`fill`](Self::fill) of four nodes at a time, with the values of [`Normal::mirrored`] in its
    /// order. If one of them is set, all are.
    #[inline]
    pub fn fill_mirrored<N: AnyNormal>(
        &mut self,
        nodes: &Nodes,
        mut values: impl FnMut(N) -> [T; 4],
    ) {
        let last = SIDE - 1;
        let used = |row: usize| nodes.0.get(row).copied().unwrap_or_default();
        for row in 0..=last / 2 {
            let used = used(row) | used(last - row);
            for column in (0..=last / 2)
                .filter(|column| used >> column & 1 == 1 || used >> (last - column) & 1 == 1)
            {
                let places = [[column, row], [last - column, row]];
                let opposite = places.map(|[column, row]| [column, last - row]);
                let values = values(N::of_point(point([column, row])));
                for ([column, row], value) in places.into_iter().chain(opposite).zip(values) {
                    if let Some(node) = self.0.get_mut(row * SIDE + column) {
                        *node = value;
                    }
                }
            }
        }
    }

    /// The values around a code, from the lower left to the upper right, and the way between them
    /// in eighths, to the right and up.
    #[inline(always)]
    pub fn around(&self, code: NormalCode) -> Option<([T; 4], [u32; 2])> {
        let ([column, row], ways) = code.cell();
        let cell = self.0.get(row * SIDE + column..).and_then(|nodes| nodes.first_chunk());
        let &[a, b, .., c, d] = cell.map(|cell: &[T; SIDE + 2]| cell)?;
        Some(([a, b, c, d], ways))
    }
}

/// The point of a node in units of 2^-[`POINT`] of a code: its place, or the nearest one of the rim.
fn point(node: [usize; 2]) -> [i32; 2] {
    let point = node.map(|place| (8 * place as i32 - 128) << POINT);
    let [u, v] = point;
    let (square, rim) = ((u * u + v * v).cast_unsigned(), (RIM as i32) << POINT);
    if square <= (rim * rim).cast_unsigned() {
        return point;
    }
    // Above zero, which a compiler does not see.
    let distance = square.isqrt().cast_signed().max(1);
    point.map(|along| along * rim / distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_formats_have_the_same_nodes() {
        for (row, used) in Nodes::ALL.0.into_iter().enumerate() {
            for column in (0..SIDE).filter(|column| used >> column & 1 == 1) {
                let point = point([column, row]);
                let floats = normal_at::<POINT>(point).components();
                let integers = normal_q15_at::<POINT>(point).components();
                let square: f32 = floats.iter().map(|along| along * along).sum();
                assert!((square - 1.0).abs() < 1e-4, "{floats:?}");
                for (float, integer) in floats.into_iter().zip(integers) {
                    assert!((32_768.0 * float - f32::from(integer.0)).abs() < 3.0);
                }
            }
        }
    }
}
