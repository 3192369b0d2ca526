//! Renders an object to texels: for each pixel its coverage, and the normals and material
//! parameters to shade.

mod sample;

use crate::asset::Asset;
use crate::tangents::{self, Tangent};
use eigenshade_generator::object::facet::{Frame, Plane};
use eigenshade_generator::object::points::Point;
use eigenshade_generator::object::surface::{Surface, View};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::visible;
use eigenshade_model::vector::dot;
use eigenshade_shading::picture::Pixel;
use eigenshade_shading::textured::Texel;
use sample::{Sampler, Shown};
use std::ops::Range;

/// Samples across the picture, at most.
const SAMPLES: usize = 4096;

/// Samples across a pixel, at most.
const PER_PIXEL: usize = 4;

/// Of 4 x 4 samples the columns, row by row, of those that have points: one in each row and column.
const CHOSEN: [usize; PER_PIXEL] = [1, 3, 0, 2];

/// The largest picture, in pixels across.
const MOST_SIDE: usize = 4096;

/// How far behind its plane a back hides, in the unit of the surface: the two sides of a sheet do
/// not hide each other.
const BEHIND: f64 = 4e-6;

/// The cosine of the largest angle between the normals of samples that are shaded together: 11
/// degrees.
const TOGETHER: f64 = 0.98;

/// The least difference from 1 of the length of averaged normals that widens the roughness: textures
/// have 16 bits.
const ROUNDED: f64 = 1e-4;

/// The pixels of a square picture that an object covers, and the points to shade in each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Texels {
    /// Pixels across and down.
    pub size: usize,
    /// The pixels, row by row from the top.
    pub pixels: Vec<Covered>,
    /// The points to shade, pixel by pixel.
    pub texels: Vec<Texel>,
    /// The share of its pixel's covered part that each texel has.
    pub shares: Vec<f32>,
}

/// A pixel that an object covers at least in part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Covered {
    /// Column, from the left.
    pub column: usize,
    /// Row, from the top.
    pub row: usize,
    /// The covered share.
    pub coverage: f64,
    /// The number of texels.
    pub texels: usize,
}

impl Covered {
    /// The pixel of a picture.
    #[must_use]
    pub fn pixel(&self) -> Pixel {
        let Self { column, row, coverage, .. } = *self;
        Pixel { column, row, coverage, is_inside: coverage >= 0.5 }
    }
}

/// The samples of a picture, from which its texels are made row by row.
pub struct Samples<'a> {
    /// Pixels across and down.
    size: usize,
    /// Samples across a pixel.
    across: usize,
    asset: &'a Asset,
    surface: Surface,
    frame: Frame,
    tangents: Vec<[Tangent; 3]>,
    /// The facet that each sample shows, row by row upward; `u32::MAX` without one.
    front: Vec<u32>,
}

impl<'a> Samples<'a> {
    /// The samples of the picture that [`Texels::of`] makes.
    ///
    /// # Errors
    ///
    /// As [`Texels::of`].
    pub fn new(file: &InputFile, asset: &'a Asset, size: usize, view: &View) -> Result<Self> {
        let sampled = || {
            if !(2..=MOST_SIDE).contains(&size) {
                let what = format!("a picture of an object {size} pixels wide");
                return Err(Error::new(what, format!("use 2 to {MOST_SIDE}")));
            }
            let surface = Surface::new(file, &asset.mesh, view)?;
            let across = (SAMPLES / size).clamp(1, PER_PIXEL);
            let samples = across * size;
            let margin = samples as f64 / size as f64 * 0.5;
            let frame = Frame::square(&surface.facets, samples, margin);
            let tangents = tangents::of(asset, &surface, view);
            let mut sampler = Sampler::new(asset, &surface, &frame, &tangents);
            let front = front(&mut sampler, &surface, &frame, samples);
            if front.iter().all(|facet| *facet == u32::MAX) {
                let remedy = "turn it with --view or --rotate-object, or draw it larger";
                return Err(Error::new("nothing of it is seen", remedy));
            }
            Ok(Self { size, across, asset, surface, frame, tangents, front })
        };
        sampled().map_err(|error| error.in_file(file.path()))
    }

    /// The surface of the object.
    #[must_use]
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// The texels of these rows, counted from the top.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>) -> Texels {
        self.visit(rows, |_| {})
    }

    /// The texels of all rows, and of each the points of up to four samples, whose normals are
    /// those of their facets toward the camera.
    #[must_use]
    pub fn with_points(&self) -> (Texels, Vec<Vec<Point>>) {
        let mut points = Vec::new();
        let texels = self.visit(0..self.size, |members| {
            let samples = self.across * self.size;
            let chosen = |place: &&usize| {
                let [right, up] = [*place % samples, *place / samples].map(|k| k % self.across);
                CHOSEN.get(up) == Some(&right)
            };
            let mut found: Vec<Point> =
                members.iter().filter(chosen).map(|&place| self.point(place)).collect();
            if found.is_empty() {
                found.extend(members.get(members.len() / 2).map(|&place| self.point(place)));
            }
            points.push(found);
        });
        (texels, points)
    }

    /// The point of a sample that shows the object.
    fn point(&self, place: usize) -> Point {
        let samples = self.across * self.size;
        let [column, row] = [place % samples, place / samples];
        let facet = &self.surface.facets[self.front[place] as usize];
        let plane = Plane::new(&self.frame.place(facet));
        let weights = plane.weights(column as f64 + 0.5, row as f64 + 0.5);
        let weights = weights.unwrap_or([1.0 / 3.0; 3]);
        let position = [0, 1, 2].map(|axis: usize| {
            (0..3).map(|corner| weights[corner] * facet.corners[corner][axis]).sum()
        });
        let sign = if facet.projected_area > 0.0 { 1.0 } else { -1.0 };
        let facet = facet.normal.map(|along| sign * along);
        let pixel = [column / self.across, self.size - 1 - row / self.across];
        Point { pixel, position, normal: facet, facet }
    }

    /// The texels of some rows; `kept` is called with the samples of each.
    fn visit(&self, rows: Range<usize>, mut kept: impl FnMut(&[usize])) -> Texels {
        let Self { size, across, .. } = *self;
        let mut sampler = Sampler::new(self.asset, &self.surface, &self.frame, &self.tangents);
        let mut texels = Texels { size, ..Texels::default() };
        let samples = across * size;
        for row in rows {
            for column in 0..size {
                let mut groups = Vec::new();
                for place in places(samples, across, [column, row]) {
                    let facet = self.front[place];
                    let shown = sampler.shown(facet, place % samples, place / samples);
                    shown.into_iter().for_each(|shown| add(&mut groups, &shown, place));
                }
                texels.push([column, row], &groups, across * across, &mut kept);
            }
        }
        texels
    }
}

impl Texels {
    /// The picture of an object from +z in orthographic view, in `size` x `size` pixels with a
    /// margin of half a pixel around its longer side.
    ///
    /// Each pixel has 4 x 4 samples, up to 4096 across the picture. Textures are filtered for the
    /// area of a sample. Samples whose normals are within 11 degrees are one texel: the mean of
    /// their normals, albedo and reflectance. Where the normal map shortens the mean normal to a
    /// length l, the roughness is widened as Toksvig's: α² + 2 (1 - l) / l in place of α².
    ///
    /// Memory: 260 bytes for each triangle, 12 for each sample, and that of the object.
    ///
    /// # Errors
    ///
    /// If a corner is not finite, nothing is seen, or the size is not 2 to 4096.
    pub fn of(file: &InputFile, asset: &Asset, size: usize, view: &View) -> Result<Self> {
        Ok(Samples::new(file, asset, size, view)?.rows(0..size))
    }

    fn push(
        &mut self,
        [column, row]: [usize; 2],
        groups: &[Group],
        samples: usize,
        kept: &mut impl FnMut(&[usize]),
    ) {
        let all: usize = groups.iter().map(|group| group.members.len()).sum();
        let before = self.texels.len();
        for group in groups {
            let Some(texel) = group.texel() else { continue };
            self.texels.push(texel);
            self.shares.push(group.members.len() as f32 / all as f32);
            kept(&group.members);
        }
        let texels = self.texels.len() - before;
        if texels > 0 {
            let coverage = all as f64 / samples as f64;
            self.pixels.push(Covered { column, row, coverage, texels });
        }
    }
}

/// The samples of a pixel; they run upward, pixels downward.
fn places(samples: usize, across: usize, [column, row]: [usize; 2]) -> impl Iterator<Item = usize> {
    let (left, bottom) = (column * across, samples - (row + 1) * across);
    (0..across)
        .flat_map(move |up| (0..across).map(move |right| (bottom + up) * samples + left + right))
}

/// The facet that each sample shows, row by row upward; `u32::MAX` without one.
fn front(sampler: &mut Sampler<'_>, surface: &Surface, frame: &Frame, samples: usize) -> Vec<u32> {
    let mut front = vec![u32::MAX; samples * samples];
    let mut depths = vec![f64::NEG_INFINITY; samples * samples];
    for (number, facet) in (0..).zip(&surface.facets) {
        let Some(shows) = sampler.side(number) else { continue };
        let placed = frame.place(facet);
        let plane = Plane::new(&placed);
        let behind = if shows { 0.0 } else { BEHIND };
        placed.visit(&plane, placed.ranges(samples), |row, column, depth| {
            let place = row * samples + column;
            if depth - behind > depths[place] && !sampler.is_hole(number, column, row) {
                depths[place] = depth - behind;
                front[place] = if shows { number } else { u32::MAX };
            }
        });
    }
    front
}

/// Samples that are shaded together.
struct Group {
    /// Their places.
    members: Vec<usize>,
    /// The normal of the first sample.
    first: [f64; 3],
    /// The sums of the normals of the surface, and of those of its normal map.
    smooth: [f64; 3],
    bumped: [f64; 3],
    matte: [f64; 3],
    reflectance: [f64; 3],
    metallic: f64,
    roughness: f64,
}

fn add(groups: &mut Vec<Group>, shown: &Shown, place: usize) {
    let near = groups.iter().position(|group| dot(group.first, shown.smooth) > TOGETHER);
    let near = near.unwrap_or_else(|| {
        groups.push(Group {
            members: Vec::new(),
            first: shown.smooth,
            smooth: [0.0; 3],
            bumped: [0.0; 3],
            matte: [0.0; 3],
            reflectance: [0.0; 3],
            metallic: 0.0,
            roughness: 0.0,
        });
        groups.len() - 1
    });
    let group = &mut groups[near];
    group.members.push(place);
    group.metallic += f64::from(shown.metallic);
    group.roughness += f64::from(shown.roughness);
    for axis in 0..3 {
        group.smooth[axis] += shown.smooth[axis];
        group.bumped[axis] += shown.bumped[axis];
        group.matte[axis] += f64::from(shown.matte[axis]);
        group.reflectance[axis] += f64::from(shown.reflectance[axis]);
    }
}

impl Group {
    fn texel(&self) -> Option<Texel> {
        let length = |vector: [f64; 3]| dot(vector, vector).sqrt();
        let [x, y, z] = self.bumped;
        let normal = visible([x, y, z.max(0.0)]).or_else(|_| visible(self.smooth)).ok()?;
        let mean = |sum: f64| (sum / self.members.len() as f64) as f32;
        let shortened = length(self.bumped) / length(self.smooth);
        let roughness = match shortened {
            length if length > 0.0 && length < 1.0 - ROUNDED => {
                let alpha = f64::from(mean(self.roughness)).powi(2);
                let wide = alpha * alpha + 2.0 * (1.0 - length) / length;
                wide.min(1.0).sqrt().sqrt() as f32
            }
            _ => mean(self.roughness),
        };
        Some(Texel {
            normal,
            matte: self.matte.map(mean),
            reflectance: self.reflectance.map(mean),
            metallic: mean(self.metallic),
            roughness,
        })
    }
}
