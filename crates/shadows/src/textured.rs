//! Objects that shadow themselves in glTF's materials, whose base color differs from pixel to
//! pixel.
//!
//! The BRDF of one roughness is a sum of three: a matte base W of albedo 1 under a lobe without
//! reflectance, the lobes L_0 without reflectance and L_1 with the reflectance 1. A point with the
//! matte share a and the reflectance f0 has a (W - L_0) + (1 - f0) L_0 + f0 L_1. By its base color
//! and by its metallic m, that is base color x T + P. T has the matte share s,
//! s (W - L_0) + m (L_1 - L_0). P, which a black base color has, is (1 - p) L_0 + p L_1 with
//! p = 0.04 (1 - m).

use crate::directions::{FINE, cells};
use crate::eigenimages::eigenimages;
use crate::light_root::{LightRoot, Turns};
use crate::lit::BOUNCES;
use crate::material::Material;
use crate::object::{RANK, smoothed};
use crate::packed::{Compression, packed};
use crate::pixels::MOST_SIDE;
use crate::transport::{Facing, Surroundings, blended};
use crate::visibility::{Occluders, Place};
use crate::weights::Columns;
use eigenshade_asset::asset::Asset;
use eigenshade_asset::texels::{Samples, Texels};
use eigenshade_generator::material::brdf::Ggx;
use eigenshade_generator::object::points::Point;
use eigenshade_generator::object::surface::View;
use eigenshade_model::database::Lights;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::parallel::Progress;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_model::srgb;
use eigenshade_shading::textured::{KNOTS, Texel};
use eigenshade_table::highlights::DIELECTRIC;
use eigenshade_table::light;
use eigenshade_table::shadowed::Tint;
use faer::Mat;

/// The share of the covered area whose roughness may be below, and above, the range that is named.
const BEYOND: f64 = 0.05;

/// The pixels of an object in its own materials, seen from +z.
pub struct Textured {
    size: usize,
    /// The column and row of each pixel that shows the object, and its coverage of 255.
    pub pixels: Vec<([usize; 2], u8)>,
    /// The texels of each pixel.
    texels: Vec<Vec<Part>>,
    occluders: Occluders,
    /// The one roughness, the mean over the covered area.
    pub roughness: f32,
    /// The roughness that one twentieth of the area is below, and that one is above.
    pub roughnesses: [f32; 2],
    /// Whether a material had an occlusion map.
    pub has_occlusion: bool,
    /// How many times its parts reflect light to each other, [`BOUNCES`] unless changed.
    pub bounces: usize,
}

/// A part of a pixel with one normal.
struct Part {
    texel: Texel,
    share: f64,
    places: Vec<Place>,
}

/// The transports of an object in its own materials.
pub struct TexturedTransports {
    size: usize,
    degree: usize,
    /// The column and row of each pixel that shows the object, and its coverage of 255.
    pub pixels: Vec<([usize; 2], u8)>,
    /// The base color of each pixel, linear: that with which its T and P have its matte part and
    /// reflectance, which is the base color itself but for 0 < metallic < 1.
    pub base_colors: Vec<[f64; 3]>,
    /// A row for the T of each pixel, then one for each P, and a column for each coefficient of the
    /// light.
    pub transports: Mat<f32>,
}

impl Textured {
    /// The pixels of a picture of an asset, sampled as [`Texels::of`], without its occlusion, which
    /// is in the shadows.
    ///
    /// # Errors
    ///
    /// If the size is not 2 to 512; and as [`Texels::of`].
    pub fn new(file: &InputFile, mut asset: Asset, size: usize, view: &View) -> Result<Self> {
        if !(2..=MOST_SIDE).contains(&size) {
            let what = format!("an object with shadows {size} pixels wide");
            return Err(Error::new(what, format!("use 2 to {MOST_SIDE}")).in_file(file.path()));
        }
        let occlusion = asset.materials.iter_mut().map(|one| one.occlusion_map.take());
        let has_occlusion = occlusion.fold(false, |any, one| any | one.is_some());
        let samples = Samples::new(file, &asset, size, view)?;
        let (texels, points) = samples.with_points();
        let Texels { pixels, texels, shares, .. } = texels;
        let mut parts = texels.into_iter().zip(shares).zip(points);
        let part = |((texel, share), points): ((Texel, f32), Vec<Point>)| Part {
            texel,
            share: share.into(),
            places: points.iter().map(Place::from).collect(),
        };
        let texels: Vec<Vec<Part>> = pixels
            .iter()
            .map(|pixel| parts.by_ref().take(pixel.texels).map(part).collect())
            .collect();
        let mut found = Self {
            size,
            pixels: pixels
                .iter()
                .map(|one| ([one.column, one.row], (255.0 * one.coverage).round() as u8))
                .collect(),
            texels,
            occluders: Occluders::new(&samples.surface().facets),
            roughness: 0.0,
            roughnesses: [0.0; 2],
            has_occlusion,
            bounces: BOUNCES,
        };
        found.roughness = found.mean(|texel| texel.roughness.into()) as f32;
        found.roughnesses = found.range();
        Ok(found)
    }

    /// The parts of all pixels, each with its covered area.
    fn parts(&self) -> impl Iterator<Item = (&Part, f64)> {
        self.pixels.iter().zip(&self.texels).flat_map(|((_, coverage), texels)| {
            texels.iter().map(move |part| (part, part.share * f64::from(*coverage)))
        })
    }

    /// The mean over the covered area.
    fn mean(&self, of: impl Fn(&Texel) -> f64) -> f64 {
        let add = |[sum, all]: [f64; 2], (part, area): (&Part, f64)| {
            [sum + area * of(&part.texel), all + area]
        };
        let [sum, all] = self.parts().fold([0.0; 2], add);
        if all > 0.0 { sum / all } else { 0.0 }
    }

    fn range(&self) -> [f32; 2] {
        let mut all: Vec<(f32, f64)> =
            self.parts().map(|(part, area)| (part.texel.roughness, area)).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let total: f64 = all.iter().map(|(_, area)| area).sum();
        [BEYOND, 1.0 - BEYOND].map(|share| {
            let mut area = 0.0;
            let found = all.iter().find(|one| {
                area += one.1;
                area > share * total
            });
            found.map_or(self.roughness, |one| one.0)
        })
    }

    /// Whether the roughness is within a share of the 5th and of the 95th percentile over the
    /// covered area.
    #[must_use]
    pub fn is_of_one_roughness(&self, within: f32) -> bool {
        let [low, high] = self.roughnesses.map(|one| one.max(KNOTS[0]));
        let one = self.roughness.max(KNOTS[0]);
        low * (1.0 + within) >= one && high <= one * (1.0 + within)
    }

    /// The irradiance of each pixel in three channels under a light that has a radiance in each
    /// direction.
    ///
    /// Light between walls has the albedo of the mean base color in each channel.
    ///
    /// # Errors
    ///
    /// If the roughness is above 1.
    pub fn irradiances(
        &self,
        radiance: impl Fn([f64; 3]) -> [f64; 3],
        progress: &impl Progress,
    ) -> Result<Vec<[f32; 3]>> {
        let blends = |texel: &Texel| {
            let blend = |channel: usize| {
                let [matte, f0] = [texel.matte, texel.reflectance].map(|of| f64::from(of[channel]));
                vec![matte, 1.0 - f0 - matte, f0]
            };
            [0, 1, 2].map(blend).to_vec()
        };
        let cells = cells(FINE);
        let lights =
            Mat::from_fn(cells.len(), 3, |cell, channel| radiance(cells[cell].0)[channel] as f32);
        let found = self.blended(&blends, |albedos| albedos, None, &lights, progress)?;
        let of_pixel = |pixel| [0, 1, 2].map(|channel: usize| found[channel][(pixel, channel)]);
        Ok((0..self.pixels.len()).map(of_pixel).collect())
    }

    /// The transports of light of a degree.
    ///
    /// Light between walls has the albedo of the mean base color, without its hue.
    ///
    /// # Errors
    ///
    /// If the roughness is above 1.
    pub fn transports(
        &self,
        degree: usize,
        progress: &impl Progress,
    ) -> Result<TexturedTransports> {
        let blends = |texel: &Texel| {
            let [matte, metallic, plain] = shares(texel);
            vec![vec![matte, -matte - metallic, metallic], vec![0.0, 1.0 - plain, plain]]
        };
        let cells = cells(FINE);
        let mut harmonics = Mat::<f32>::zeros(cells.len(), light::count(degree));
        for (cell, (direction, _)) in cells.iter().enumerate() {
            let all = spherical_harmonic::all(degree, *direction);
            all.into_iter().enumerate().for_each(|(k, one)| harmonics[(cell, k)] = one as f32);
        }
        let gray = |albedos: [f64; 3]| [albedos.iter().sum::<f64>() / 3.0; 2];
        let found = self.blended(&blends, gray, Some(degree), &harmonics, progress)?;
        let count = self.pixels.len();
        Ok(TexturedTransports {
            size: self.size,
            degree,
            pixels: self.pixels.clone(),
            base_colors: self.texels.iter().map(|parts| base_color(parts)).collect(),
            transports: Mat::from_fn(2 * count, harmonics.ncols(), |row, column| {
                found[row / count][(row % count, column)]
            }),
        })
    }

    /// Irradiances of blends of the three materials. `of_channels` gives the albedo of each blend
    /// from the albedos in the three channels.
    fn blended<const N: usize>(
        &self,
        blends: &dyn Fn(&Texel) -> Vec<Vec<f64>>,
        of_channels: impl Fn([f64; 3]) -> [f64; N],
        degree: Option<usize>,
        light: &Mat<f32>,
        progress: &impl Progress,
    ) -> Result<Vec<Mat<f32>>> {
        let roughness = f64::from(self.roughness.max(KNOTS[0]));
        let of = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
        let [matte, black, white] = of.map(|[f0, albedo]| Ggx::new(roughness, f0, albedo));
        let (matte, black, white) = (matte?, black?, white?);
        let materials = [&matte, &black, &white].map(|one| Material::Formula(one));
        let reflected = materials.each_ref().map(Material::albedo);
        let albedos = [0, 1, 2].map(|channel: usize| {
            let matte = self.mean(|texel| texel.matte[channel].into());
            let f0 = self.mean(|texel| texel.reflectance[channel].into());
            let shares = [matte, 1.0 - f0 - matte, f0];
            shares.iter().zip(&reflected).map(|(share, one)| share * one).sum::<f64>()
        });
        let of_parts: Vec<Vec<Vec<f64>>> =
            self.texels.iter().flatten().map(|part| blends(&part.texel)).collect();
        let mut of_parts = of_parts.iter();
        let facings = |parts: &Vec<Part>| -> Vec<Facing<'_>> {
            let facing = |(part, blends): (&Part, _)| Facing {
                normal: part.texel.normal,
                share: part.share,
                places: part.places.clone(),
                blends,
            };
            parts.iter().zip(of_parts.by_ref().map(Vec::as_slice)).map(facing).collect()
        };
        let pixels: Vec<_> = self.texels.iter().map(facings).collect();
        let around = Surroundings { occluders: &self.occluders, bounces: self.bounces };
        let columns = Columns { degree, all: light.as_ref() };
        Ok(blended(&pixels, Some(around), (&materials, &of_channels(albedos)), columns, progress))
    }
}

impl TexturedTransports {
    /// The irradiance of each pixel under a channel of a light.
    #[must_use]
    pub fn irradiance(&self, light: &[f64], channel: usize) -> Vec<f64> {
        let count = self.pixels.len();
        let product = |row: usize| -> f64 {
            self.transports.row(row).iter().zip(light).map(|(a, b)| f64::from(*a) * b).sum()
        };
        let of_pixel =
            |(k, base): (usize, &[f64; 3])| base[channel] * product(k) + product(count + k);
        self.base_colors.iter().enumerate().map(of_pixel).collect()
    }

    /// The file of the runtime's `TexturedObject`, for [smoothed](crate::object::Object::smoothed)
    /// lights like these that turn.
    ///
    /// # Errors
    ///
    /// As [`LightRoot::new`], or if no singular values are found.
    pub fn packed(
        &self,
        lights: &Lights,
        turns: Turns,
        compression: Compression,
    ) -> Result<Vec<u8>> {
        let root = LightRoot::new(&lights.truncated(self.degree), turns)?;
        let transports = smoothed(self.degree, &self.transports);
        let images = eigenimages(&[transports.as_ref()], &[1.0], &root, RANK)?;
        let (mut file, book) =
            packed(&images, self.degree, self.size, &self.pixels, &[[1.0; 3]], compression);
        let plain = book.of_pixel.iter().skip(self.pixels.len());
        let tint = |(code, base): (&u32, &[f64; 3])| Tint {
            code: *code as u16,
            base_color: base.map(srgb::srgb),
        };
        file.tints = plain.zip(&self.base_colors).map(tint).collect();
        Ok(file.encode())
    }
}

/// The matte share of T, the mean of the channels' (1 - metallic) (1 - f0); metallic; and the
/// reflectance of P.
fn shares(texel: &Texel) -> [f64; 3] {
    let metallic = f64::from(texel.metallic).clamp(0.0, 1.0);
    let f0 = texel.reflectance.iter().sum::<f32>() / 3.0;
    [(1.0 - metallic) * (1.0 - f64::from(f0)), metallic, DIELECTRIC * (1.0 - metallic)]
}

/// The base color with which a pixel has the sum of its matte part and its reflectance.
fn base_color(parts: &[Part]) -> [f64; 3] {
    let (mut sums, mut all) = ([0.0; 3], 0.0);
    for Part { texel, share, .. } in parts {
        let [matte, metallic, plain] = shares(texel);
        all += share * (matte + metallic);
        for (channel, sum) in sums.iter_mut().enumerate() {
            let [own, f0] = [texel.matte, texel.reflectance].map(|of| f64::from(of[channel]));
            *sum += share * (own + f0 - plain);
        }
    }
    sums.map(|sum| (sum / all).clamp(0.0, 1.0))
}
