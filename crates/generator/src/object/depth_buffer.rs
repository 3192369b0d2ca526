//! A depth buffer with whole tiles of samples: a facet behind everything in a tile is decided once
//! for the tile.
//!
//! Tiles never change the result: it is the same as testing every sample of every facet.

use crate::object::facet::{Placed, Plane, samples_within};
use std::ops::Range;

/// Width of a tile in samples.
const TILE: usize = 16;

/// Facets up to this size, in samples, are tested sample by sample.
const SMALL: f64 = 2.0 * TILE as f64;

/// The depths of the nearest surfaces, each minus the contact distance of its facet.
pub(super) struct DepthBuffer {
    samples: usize,
    /// Number of tiles across.
    tiles: usize,
    front: Vec<f64>,
    /// The smallest `front` in each tile; out of date where `has_changed` is set.
    least: Vec<f64>,
    has_changed: Vec<bool>,
}

impl DepthBuffer {
    pub(super) fn new(samples: usize) -> Self {
        let tiles = samples.div_ceil(TILE);
        Self {
            samples,
            tiles,
            front: vec![f64::NEG_INFINITY; samples * samples],
            least: vec![f64::NEG_INFINITY; tiles * tiles],
            has_changed: vec![false; tiles * tiles],
        }
    }

    /// Draws a facet.
    pub(super) fn draw(&mut self, facet: &Placed) {
        let plane = Plane::new(facet);
        for part in self.parts(facet) {
            if self.is_behind(&part, &plane, -facet.contact, f64::le) || part.is_outside(&plane) {
                continue;
            }
            facet.visit(&plane, [part.rows, part.columns], |row, column, depth| {
                let front = &mut self.front[row * self.samples + column];
                let depth = depth - facet.contact;
                if depth > *front {
                    *front = depth;
                    self.has_changed[row / TILE * self.tiles + column / TILE] = true;
                }
            });
        }
    }

    /// The number of samples where a facet is drawn.
    pub(super) fn covered(&self) -> usize {
        self.front.iter().filter(|depth| depth.is_finite()).count()
    }

    /// Visits the samples of a facet where nothing lies in front in a drawn picture, with index and
    /// depth.
    pub(super) fn visit_seen(&mut self, facet: &Placed, mut with: impl FnMut(usize, f64)) {
        let plane = Plane::new(facet);
        for part in self.parts(facet) {
            if self.is_behind(&part, &plane, facet.contact, f64::lt) || part.is_outside(&plane) {
                continue;
            }
            facet.visit(&plane, [part.rows, part.columns], |row, column, depth| {
                let place = row * self.samples + column;
                if depth + facet.contact >= self.front[place] {
                    with(place, depth);
                }
            });
        }
    }

    /// The samples that a facet may cover, split into tiles, or as one part if they are few.
    fn parts(&self, facet: &Placed) -> Vec<Part> {
        let [rows, columns] = facet.ranges(self.samples);
        let is_small = [0, 1].map(|axis| facet.range(axis)).iter().all(|[a, b]| b - a <= SMALL);
        if is_small || rows.is_empty() || columns.is_empty() {
            return vec![Part { rows, columns, tile: None }];
        }
        let mut parts = Vec::new();
        for row in rows.start / TILE..rows.end.div_ceil(TILE) {
            let of_row = row * TILE..((row + 1) * TILE).min(self.samples);
            let ends = [of_row.start as f64 + 0.5, of_row.end as f64 - 0.5];
            let [left, right] = facet.band(ends);
            // Add one sample on each side, which exceeds any rounding.
            let columns = samples_within([left - 1.0, right + 1.0], self.samples);
            if columns.is_empty() {
                continue;
            }
            parts.extend((columns.start / TILE..columns.end.div_ceil(TILE)).map(|column| Part {
                rows: of_row.clone(),
                columns: column * TILE..((column + 1) * TILE).min(self.samples),
                tile: Some(row * self.tiles + column),
            }));
        }
        parts
    }

    /// Whether every depth of the facet in a tile, plus `more`, is below everything in front there.
    fn is_behind(
        &mut self,
        part: &Part,
        plane: &Plane,
        more: f64,
        below: fn(&f64, &f64) -> bool,
    ) -> bool {
        part.tile.is_some_and(|tile| {
            let least = self.least(tile);
            let is_below = |nearest: f64| below(&(nearest + more), &least);
            // Test the nearest corner of the facet first, which is cheap.
            least > f64::NEG_INFINITY
                && (is_below(plane.range[1]) || is_below(plane.nearest(part.corners())))
        })
    }

    /// The smallest `front` in a tile.
    fn least(&mut self, tile: usize) -> f64 {
        if self.has_changed[tile] {
            self.has_changed[tile] = false;
            let [row, column] = [tile / self.tiles, tile % self.tiles].map(|first| {
                let first = first * TILE;
                first..(first + TILE).min(self.samples)
            });
            let lines = row.map(|row| &self.front[row * self.samples..][column.clone()]);
            self.least[tile] = lines.flatten().copied().fold(f64::INFINITY, f64::min);
        }
        self.least[tile]
    }
}

/// A range of rows and columns of samples: a tile, or all that a small facet may cover.
struct Part {
    rows: Range<usize>,
    columns: Range<usize>,
    tile: Option<usize>,
}

impl Part {
    /// The samples at the corners; any affine function has its largest value at one of them.
    fn corners(&self) -> [[f64; 2]; 4] {
        let ends = |range: &Range<usize>| [range.start as f64 + 0.5, range.end as f64 - 0.5];
        let ([top, bottom], [left, right]) = (ends(&self.rows), ends(&self.columns));
        [[left, top], [right, top], [left, bottom], [right, bottom]]
    }

    /// Whether the whole part is outside one edge.
    fn is_outside(&self, plane: &Plane) -> bool {
        let sides = self.corners().map(|[x, y]| plane.sides(x, y));
        (0..3).any(|edge| sides.iter().all(|sides| sides[edge] < 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::DepthBuffer;
    use crate::object::facet::{Facet, Placed, Plane, placed};

    /// Facets of all sizes, many of them large and many thin, in a box of side 2.
    fn facets() -> Vec<Facet> {
        let mut state = 5u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(99);
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let mut facet = |k: i32| {
            let size = [1.0, 0.3, 0.02][k as usize % 3];
            let thin = if k % 5 == 0 { 1e-3 } else { 1.0 };
            let center = [0, 1, 2].map(|_| (1.0 - size) * number());
            let corner = |_| {
                let [x, y, z] = [0, 1, 2].map(|_| size * number());
                [center[0] + x, center[1] + thin * y + x, center[2] + 0.2 * z]
            };
            Facet::new([0, 1, 2].map(corner)).expect("an area")
        };
        (0..300).map(&mut facet).collect()
    }

    /// Visits every sample that the facet covers, including hidden ones.
    fn each(facet: &Placed, samples: usize, with: impl FnMut(usize, usize, f64)) {
        facet.visit(&Plane::new(facet), [0..samples, 0..samples], with);
    }

    #[test]
    fn tiles_decide_as_their_samples_do() {
        for samples in [16, 100, 250] {
            let facets = placed(&facets(), samples);
            let mut front = vec![f64::NEG_INFINITY; samples * samples];
            let mut buffer = DepthBuffer::new(samples);
            for facet in &facets {
                buffer.draw(facet);
                each(facet, samples, |row, column, depth| {
                    let front = &mut front[row * samples + column];
                    *front = front.max(depth - facet.contact);
                });
            }
            assert_eq!(buffer.front, front);
            let mut hidden = 0;
            for facet in &facets {
                let (mut covered, mut expected, mut found) = (0, 0, 0);
                each(facet, samples, |row, column, depth| {
                    covered += 1;
                    let front = front[row * samples + column];
                    expected += usize::from(depth + facet.contact >= front);
                });
                buffer.visit_seen(facet, |_, _| found += 1);
                assert_eq!(found, expected);
                hidden += usize::from(expected == 0 && covered > 0);
            }
            assert!(samples < 100 || hidden > 50, "{hidden} of {samples} samples across");
        }
    }
}
