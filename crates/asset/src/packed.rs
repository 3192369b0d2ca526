//! Packs an object for the runtime: one normal and one base color a pixel, and a few regions of the
//! same metallic and roughness.

use crate::texels::Texels;
use eigenshade::object::{NormalMap, Region};
use eigenshade::{Gloss, Normal};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::srgb;
use eigenshade_shading::shader::fault;
use eigenshade_shading::textured::{KNOTS, Texel};
use eigenshade_table::object::{Pixel, encode};

/// The most regions of an object.
pub const MOST_REGIONS: usize = 16;

/// How far metallic and the logarithm of the roughness of a pixel may be from those of its region.
const CLOSE: [f64; 2] = [0.1, 0.15];

/// The share of pixels that may be farther.
const FAR: f64 = 0.05;

/// Rounds of the search for regions, and the most pixels that it looks at.
const ROUNDS: usize = 20;
const SAMPLED: usize = 1 << 16;

/// An object in the file format of the runtime.
#[derive(Clone, Debug, PartialEq)]
pub struct Packed {
    /// The file.
    pub bytes: Vec<u8>,
    /// The regions, the largest first.
    pub regions: Vec<Found>,
}

/// A region, and how its pixels differ from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// The region.
    pub region: Region,
    /// The number of its pixels.
    pub pixels: usize,
    /// The roughness that one in twenty of its pixels is below, and that one in twenty is above.
    pub roughness: [f32; 2],
}

impl Packed {
    /// Packs the pixels of an object into as few regions as keep 19 of 20 pixels within 0.1 in
    /// metallic and 15 % in roughness, or into `most`, from 1 to [`MOST_REGIONS`].
    ///
    /// # Errors
    ///
    /// If a normal is not visible, or a material is out of range.
    pub fn of(texels: &Texels, most: usize) -> Result<Self> {
        let pixels = means(texels);
        let sampled = pixels.iter().step_by(pixels.len().div_ceil(SAMPLED).max(1));
        let centers = centers(&sampled.map(place).collect::<Vec<_>>(), most);
        let mut members: Vec<Vec<&Texel>> = vec![Vec::new(); centers.len()];
        let nearest: Vec<usize> =
            pixels.iter().map(|pixel| nearest(place(pixel), &centers)).collect();
        nearest.iter().zip(&pixels).for_each(|(&region, pixel)| members[region].push(pixel));
        let mut order: Vec<usize> =
            (0..members.len()).filter(|&one| !members[one].is_empty()).collect();
        order.sort_by_key(|&one| core::cmp::Reverse(members[one].len()));
        let regions = order.iter().map(|&one| found(&members[one])).collect::<Result<Vec<_>>>()?;
        let mut records = Vec::with_capacity(pixels.len());
        for ((covered, pixel), of) in texels.pixels.iter().zip(&pixels).zip(nearest) {
            let number = order.iter().position(|&one| one == of).unwrap_or_default();
            let [u, v] = code(pixel.normal)?;
            let [r, g, b] = base_color(pixel, &regions[number].region);
            let coverage = (255.0 * covered.coverage).round() as u8;
            records.push(Pixel {
                column: covered.column as u16,
                row: covered.row as u16,
                region: number as u16,
                record: [u, v, r, g, b, coverage],
            });
        }
        let of_regions: Vec<_> = regions.iter().map(|found| found.region.bytes()).collect();
        Ok(Self { bytes: encode([texels.size as u16; 2], &of_regions, &records), regions })
    }
}

/// The mean of the texels of each pixel.
fn means(texels: &Texels) -> Vec<Texel> {
    let mut shown = texels.texels.iter().zip(&texels.shares);
    let mean = |count: usize| {
        let mut mean = Texel::default();
        for (texel, &share) in shown.by_ref().take(count) {
            let to = mean.matte.iter_mut().chain(&mut mean.reflectance);
            let from = texel.matte.iter().chain(&texel.reflectance);
            to.zip(from).for_each(|(sum, part)| *sum += share * part);
            let normals = mean.normal.iter_mut().zip(texel.normal);
            normals.for_each(|(sum, part)| *sum += f64::from(share) * part);
            mean.roughness += share * texel.roughness;
            mean.metallic += share * texel.metallic;
        }
        mean
    };
    texels.pixels.iter().map(|covered| covered.texels).map(mean).collect()
}

/// Metallic and the logarithm of the roughness, in units of what is close.
fn place(pixel: &Texel) -> [f64; 2] {
    let roughness = f64::from(pixel.roughness.max(KNOTS[0]));
    let [of_metallic, of_roughness] = CLOSE;
    [f64::from(pixel.metallic) / of_metallic, roughness.ln() / of_roughness]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}

fn nearest(place: [f64; 2], centers: &[[f64; 2]]) -> usize {
    let distances = centers.iter().map(|&center| distance(place, center)).enumerate();
    distances.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(number, _)| number)
}

/// The fewest centers that are close to most places, at most `most`.
fn centers(places: &[[f64; 2]], most: usize) -> Vec<[f64; 2]> {
    let mut centers = vec![mean(places.iter().copied())];
    loop {
        for _ in 0..ROUNDS {
            let mut members = vec![Vec::new(); centers.len()];
            places.iter().for_each(|&place| members[nearest(place, &centers)].push(place));
            members.retain(|members| !members.is_empty());
            let moved: Vec<_> =
                members.into_iter().map(|members| mean(members.into_iter())).collect();
            if moved == centers {
                break;
            }
            centers = moved;
        }
        let away = |place: &[f64; 2]| distance(*place, centers[nearest(*place, &centers)]);
        let far = places.iter().filter(|&place| away(place) > 1.0).count();
        if centers.len() >= most || far as f64 <= FAR * places.len() as f64 {
            return centers;
        }
        let farthest = places.iter().max_by(|a, b| away(a).total_cmp(&away(b)));
        centers.extend(farthest.copied());
    }
}

fn mean(places: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    let (mut sum, mut count) = ([0.0; 2], 0.0_f64);
    for place in places {
        sum = [sum[0] + place[0], sum[1] + place[1]];
        count += 1.0;
    }
    sum.map(|sum| sum / count.max(1.0))
}

/// The region of some pixels, at least one.
fn found(pixels: &[&Texel]) -> Result<Found> {
    let count = pixels.len() as f64;
    let mean = |of: &dyn Fn(&Texel) -> f32| {
        (pixels.iter().map(|pixel| f64::from(of(pixel))).sum::<f64>() / count) as f32
    };
    let metallic = mean(&|pixel| pixel.metallic).clamp(0.0, 1.0);
    let region = Region::new(metallic, mean(&|pixel| pixel.roughness).clamp(0.0, 1.0));
    // (1 - metallic)(1 - f0) of the mean color.
    let f0 = mean(&|pixel| pixel.reflectance.iter().sum::<f32>() / 3.0);
    let matte = ((1.0 - metallic) * (1.0 - f0)).clamp(0.0, 1.0);
    let region = region.and_then(|region| region.with_matte(matte)).map_err(fault)?;
    let mut roughness: Vec<f32> = pixels.iter().map(|pixel| pixel.roughness).collect();
    roughness.sort_by(f32::total_cmp);
    let [low, high] = [roughness.len() / 20, roughness.len() - 1 - roughness.len() / 20];
    Ok(Found { region, pixels: pixels.len(), roughness: [roughness[low], roughness[high]] })
}

/// The base color in sRGB with which the region has a pixel's matte part and reflectance: exactly, if
/// the region is of plastic or of metal alone, and else their sum.
fn base_color(pixel: &Texel, region: &Region) -> [u8; 3] {
    let metallic = region.metallic();
    let plain = Gloss::DIELECTRIC * (1.0 - metallic);
    [0, 1, 2].map(|c: usize| {
        let of_base = pixel.matte[c] + pixel.reflectance[c] - plain;
        let linear = of_base / (region.matte() + metallic);
        srgb::srgb(f64::from(linear))
    })
}

fn code([x, y, z]: [f64; 3]) -> Result<[u8; 2]> {
    let normal = Normal::new(x as f32, y as f32, z as f32);
    normal.map(NormalMap::code).map_err(|error| Error::new(error.to_string(), "check the object"))
}
