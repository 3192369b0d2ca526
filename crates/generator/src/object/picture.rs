//! Pictures of an object's normals: which normal each pixel shows, and how much of the pixel the
//! object covers.

use crate::object::depth_buffer::DepthBuffer;
use crate::object::facet::{Facet, Frame, Plane};
use crate::object::surface::{Surface, View};
use crate::object::{mesh, normal_map};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::visible;
use std::ops::Range;

/// Samples across the picture of a mesh, at most.
const SAMPLES: usize = 4096;

/// Samples across a pixel of a mesh, at most.
const PER_PIXEL: usize = 4;

/// The largest picture of a mesh, in pixels across.
const MOST_SIDE: usize = 4096;

/// A picture of normals.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// The pixels, row by row from the top; `None` without an object.
    pub pixels: Vec<Option<Shown>>,
}

/// The content of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// The unit normal, z >= 0: the mean over the covered part.
    pub normal: [f64; 3],
    /// The share of the pixel that the object covers, above 0 and at most 1.
    pub coverage: f64,
}

impl Picture {
    /// The picture of a mesh (.obj, .stl, .ply) from +z in orthographic view, in `size` x `size`
    /// pixels with a margin of half a pixel around the longer side of the object.
    ///
    /// Each pixel has 4 x 4 samples, up to 4096 across the picture: from 2048 pixels on, 2 x 2, and
    /// from 4096 on, one. Normals are those of the [`Surface`]; one that points away where its facet
    /// is seen is moved to the rim. A facet that faces away hides what is behind it and shows
    /// nothing.
    ///
    /// Memory: that of reading the mesh, 72 bytes for each facet unless it is flat, 20 for each
    /// sample and 96 for each pixel.
    ///
    /// # Errors
    ///
    /// Those of [`mesh::surface`]; if no facet faces the camera or all are thinner than a sample, or
    /// the size is not 2 to 4096.
    pub fn of_mesh(file: impl Into<InputFile>, size: usize, view: &View) -> Result<Self> {
        let file = file.into();
        let drawn = || {
            if !(2..=MOST_SIDE).contains(&size) {
                let remedy = format!("use 2 to {MOST_SIDE}");
                return Err(Error::new(format!("a picture of a mesh {size} pixels wide"), remedy));
            }
            let across = (SAMPLES / size).clamp(1, PER_PIXEL);
            let samples = across * size;
            let surface = mesh::surface(&file, view)?;
            let facets = &surface.facets;
            let mut sums = Sums::new(size, size);
            each_sample(&surface, size, samples, |row, column, normal| {
                // Samples run upward.
                sums.add([column / across, size - 1 - row / across], normal, 1.0);
            });
            let picture = sums.picture((across * across) as f64);
            picture.ok_or_else(|| {
                if facets.iter().any(|facet| facet.projected_area > 0.0) {
                    let what = format!("it is thinner than a sample, 1/{samples} of the picture");
                    return Error::new(what, "draw it larger, or make it thicker");
                }
                let remedy =
                    "turn it so that the camera at +z sees it, with corners counterclockwise";
                Error::new("no facet of it faces the camera", remedy)
            })
        };
        drawn().map_err(|error| error.in_file(file.path()))
    }

    /// The picture of a normal map: see [`normal_map::load`] and [`normal_map::normals`]. Opacity is
    /// coverage. With a `size`, the map shrinks until its longer side has that many pixels; each
    /// pixel is the mean of those that it replaces.
    ///
    /// # Errors
    ///
    /// Those of [`normal_map::load`] and [`normal_map::normals`]; if the size is larger than the map
    /// or 0, or no pixel shows an object.
    pub fn of_map(
        file: impl Into<InputFile>,
        size: Option<usize>,
        flip_green: bool,
    ) -> Result<Self> {
        let file = file.into();
        let map = normal_map::load(&file, flip_green)?;
        let drawn = || {
            let longer = map.width.max(map.height);
            let size = size.unwrap_or(longer);
            if !(1..=longer).contains(&size) {
                let what =
                    format!("the map is {} x {}, and {size} asked for", map.width, map.height);
                return Err(Error::new(what, format!("ask for at most {longer}")));
            }
            let [width, height] = [map.width, map.height]
                .map(|side| ((side * size) as f64 / longer as f64).round().max(1.0) as usize);
            let mut sums = Sums::new(width, height);
            for (place, pixel) in normal_map::shown(&map).enumerate() {
                let Some((normal, coverage)) = pixel? else { continue };
                let (row, column) = (place / map.width, place % map.width);
                for (down, tall) in parts(row, map.height, height) {
                    for (across, wide) in parts(column, map.width, width) {
                        sums.add([across, down], normal, coverage * tall * wide);
                    }
                }
            }
            sums.picture(1.0).ok_or_else(|| {
                let what =
                    "no pixel of it is opaque and holds a normal (a vector of length 1/2 to 3/2)";
                Error::new(what, "check that it is a normal map")
            })
        };
        drawn().map_err(|error| error.in_file(file.path()))
    }
}

/// Visits the samples that show a facet, row by row upward, with the unit normal there, z >= 0.
fn each_sample(
    surface: &Surface,
    size: usize,
    samples: usize,
    mut with: impl FnMut(usize, usize, [f64; 3]),
) {
    let facets = &surface.facets;
    let frame = frame(facets, size, samples);
    let mut last: Option<(u32, Plane)> = None;
    for (place, number) in in_front(facets, &frame, samples).into_iter().enumerate() {
        let Some(facet) = facets.get(number as usize) else { continue };
        let (row, column) = (place / samples, place % samples);
        if surface.normals.is_empty() {
            with(row, column, facet.normal);
            continue;
        }
        let (_, plane) = match last.take() {
            Some(same) if same.0 == number => last.insert(same),
            _ => last.insert((number, Plane::new(&frame.place(facet)))),
        };
        let weights = plane.weights(column as f64 + 0.5, row as f64 + 0.5);
        let normal =
            weights.map_or(facet.normal, |weights| surface.normal(number as usize, weights));
        with(row, column, toward_camera(normal).unwrap_or(facet.normal));
    }
}

/// The unit vector along this one, moved to the rim if it points away.
pub(super) fn toward_camera([x, y, z]: [f64; 3]) -> Option<[f64; 3]> {
    visible([x, y, z.max(0.0)]).ok()
}

/// The frame of a picture with a margin of half a pixel.
pub(super) fn frame(facets: &[Facet], size: usize, samples: usize) -> Frame {
    Frame::square(facets, samples, samples as f64 / size as f64 * 0.5)
}

/// The number of the facet that each sample shows, row by row upward; beyond all facets, if none.
pub(super) fn in_front(facets: &[Facet], frame: &Frame, samples: usize) -> Vec<u32> {
    let mut buffer = DepthBuffer::new(samples);
    for facet in facets {
        buffer.draw(&frame.place(facet));
    }
    let mut shown = vec![u32::MAX; samples * samples];
    let mut depths = vec![f64::NEG_INFINITY; samples * samples];
    for (number, facet) in (0..).zip(facets) {
        if facet.projected_area > 0.0 {
            buffer.visit_seen(&frame.place(facet), |place, depth| {
                if depth > depths[place] {
                    (depths[place], shown[place]) = (depth, number);
                }
            });
        }
    }
    shown
}

/// The pixels of `to` that pixel number `place` of `from` falls into, each with the share of it
/// that this pixel covers.
fn parts(place: usize, from: usize, to: usize) -> impl Iterator<Item = (usize, f64)> {
    // In units of 1 / (from to) of the side, so that all ends are whole.
    let (start, end) = (place * to, (place + 1) * to);
    let pixels: Range<usize> = start / from..end.div_ceil(from);
    pixels.map(move |pixel| {
        let covered = end.min((pixel + 1) * from) - start.max(pixel * from);
        (pixel, covered as f64 / from as f64)
    })
}

/// The sums of normals and of coverage for each pixel.
struct Sums {
    width: usize,
    height: usize,
    sums: Vec<([f64; 3], f64)>,
}

impl Sums {
    fn new(width: usize, height: usize) -> Self {
        Self { width, height, sums: vec![([0.0; 3], 0.0); width * height] }
    }

    fn add(&mut self, [column, row]: [usize; 2], normal: [f64; 3], weight: f64) {
        let (sum, covered) = &mut self.sums[row * self.width + column];
        *covered += weight;
        sum.iter_mut().zip(normal).for_each(|(sum, n)| *sum += weight * n);
    }

    /// The picture, if it shows anything. A pixel that is covered completely has this weight.
    fn picture(self, whole: f64) -> Option<Picture> {
        let shown = |(sum, covered): ([f64; 3], f64)| {
            let normal = visible(sum).ok()?;
            Some(Shown { normal, coverage: (covered / whole).min(1.0) })
        };
        let pixels: Vec<_> = self.sums.into_iter().map(shown).collect();
        let any = pixels.iter().any(Option::is_some);
        any.then_some(Picture { width: self.width, height: self.height, pixels })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shrinking_keeps_all_of_each_pixel() {
        for (from, to) in [(1, 1), (7, 7), (7, 3), (10, 5), (64, 5), (9, 8)] {
            let mut sums = vec![0.0; to];
            for place in 0..from {
                let all: f64 = parts(place, from, to)
                    .map(|(pixel, share)| {
                        sums[pixel] += share;
                        share * from as f64 / to as f64
                    })
                    .sum();
                assert!((all - 1.0).abs() < 1e-12, "{place} of {from} to {to}: {all}");
            }
            assert!(sums.iter().all(|sum| (sum - 1.0).abs() < 1e-12), "{from} to {to}: {sums:?}");
        }
    }
}
