//! Materials of glTF whose color, metallic and roughness differ from pixel to pixel.
//!
//! For one roughness r, the BRDF is linear in the matte share and in f0, so that the irradiance of a
//! normal n is E = base (1 - metallic) (1 - f0) D(n) + f0 S_r(n) + R_r(n), channel by channel, with
//! f0 = 0.04 (1 - metallic) + base metallic: the BRDF is that of the mixed f0, not a mixture of two
//! BRDFs. The images D, S and R of a light do not depend on the material's color. Up to
//! [`EXACT`] values of roughness have images of their own. Other pictures blend the images of five
//! roughnesses.

use crate::shader::{OwnedNormals, Shader, fault};
use eigenshade::{Material, Rgb};
use eigenshade_model::database::Named;
use eigenshade_model::error::Result;
use eigenshade_model::highlights::Highlights;
use eigenshade_model::shipped;
use eigenshade_model::source::{Gloss, Source};
use eigenshade_table::material::count;

/// A point to shade: its normal and its material.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Texel {
    /// The unit normal, z >= 0.
    pub normal: [f64; 3],
    /// base (1 - metallic) (1 - f0), times the occlusion, by channel.
    pub matte: [f32; 3],
    /// f0, the reflectance at normal incidence, by channel.
    pub reflectance: [f32; 3],
    /// The share of metal, which the packed object needs beside the sums above.
    pub metallic: f32,
    /// The perceptual roughness. The images take one below 0.2 as 0.2, highlights as it is.
    pub roughness: f32,
}

/// The roughnesses whose images are blended.
pub const KNOTS: [f32; 5] = [0.2, 0.35, 0.6, 0.825, 1.0];

/// The most values of roughness that have their own images.
pub const EXACT: usize = 5;

/// The largest order of the shorter series of parts.
const SHORT_ORDER: usize = 7;

/// Pixels that are shaded together.
const BAND: usize = 1 << 16;

/// The coefficients of matte, rim and metal at a roughness, to an order of at most 12.
///
/// # Errors
///
/// If the roughness is not from 0 to 1.
pub fn parts(order: usize, roughness: f32) -> Result<[Vec<f64>; 3]> {
    let wide = |part: &[f32]| part.iter().take(count(order)).map(|&b| f64::from(b)).collect();
    Ok(if order <= SHORT_ORDER {
        Material::metallic_roughness_parts(roughness).map_err(fault)?.map(|part| wide(&part))
    } else {
        let parts = Material::metallic_roughness_parts_of_order_12(roughness).map_err(fault)?;
        parts.map(|part| wide(&part))
    })
}

/// The weights of the images of [`KNOTS`] at any roughness: a table from 0.2 to 1, linear between
/// its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Weights(Vec<[f64; 5]>);

impl Weights {
    /// The shipped weights.
    ///
    /// # Errors
    ///
    /// As [`shipped::roughness_weights`].
    pub fn shipped() -> Result<Self> {
        shipped::roughness_weights().map(Self)
    }

    /// Weights of equally spaced roughnesses from 0.2 to 1, two or more.
    #[must_use]
    pub fn new(rows: Vec<[f64; 5]>) -> Self {
        Self(rows)
    }

    /// The weights at a roughness.
    #[must_use]
    pub fn at(&self, roughness: f32) -> [f32; 5] {
        let last = self.0.len() - 1;
        let first = f64::from(KNOTS[0]);
        let place = ((f64::from(roughness) - first) / (1.0 - first)).clamp(0.0, 1.0) * last as f64;
        let row = (place as usize).min(last - 1);
        let share = place - row as f64;
        let [low, high] = [self.0[row], self.0[row + 1]];
        [0, 1, 2, 3, 4].map(|k| (low[k] + share * (high[k] - low[k])) as f32)
    }
}

/// The roughnesses that have images.
#[derive(Clone, Debug, PartialEq)]
pub struct Blend(Kind);

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Exact(Vec<f32>),
    Knots(Weights),
}

impl Blend {
    /// The images of a picture with texels of these roughnesses: their own, up to [`EXACT`], or
    /// those of [`KNOTS`].
    ///
    /// # Errors
    ///
    /// As [`Weights::shipped`].
    pub fn of(roughnesses: impl IntoIterator<Item = f32>) -> Result<Self> {
        let mut found: Vec<f32> = Vec::new();
        for roughness in roughnesses {
            let roughness = roughness.max(KNOTS[0]);
            if !found.contains(&roughness) {
                found.push(roughness);
            }
            if found.len() > EXACT {
                return Ok(Self(Kind::Knots(Weights::shipped()?)));
            }
        }
        Ok(Self(Kind::Exact(found)))
    }

    fn roughnesses(&self) -> &[f32] {
        match &self.0 {
            Kind::Exact(found) => found,
            Kind::Knots(_) => &KNOTS,
        }
    }

    fn weights(&self, roughness: f32) -> [f32; 5] {
        match &self.0 {
            Kind::Knots(weights) => weights.at(roughness),
            Kind::Exact(found) => {
                let roughness = roughness.max(KNOTS[0]);
                [0, 1, 2, 3, 4].map(|k| f32::from(u8::from(found.get(k) == Some(&roughness))))
            }
        }
    }
}

/// The irradiance of each texel under a light, without `sources`, and by these sources.
///
/// The light has at most the degree of the shader's table, and `order` is at most the table's. The
/// matte part of a source is reflected by the same texel. `blend` is of these texels, or of a picture
/// that they are part of.
///
/// # Errors
///
/// Those of [`Shader::polynomial`], and if a roughness is not from 0 to 1.
pub fn irradiance(
    shader: &mut Shader<'_>,
    light: &Named,
    order: usize,
    (blend, texels): (&Blend, &[Texel]),
    sources: &[Source],
) -> Result<Vec<Rgb<f32>>> {
    let [matte, ..] = parts(order, 1.0)?;
    let of_knots = blend.roughnesses().iter().map(|roughness| parts(order, *roughness));
    let of_knots = of_knots.collect::<Result<Vec<_>>>()?;
    let mut colors = Vec::with_capacity(texels.len());
    for band in texels.chunks(BAND) {
        let normals: Vec<[f64; 3]> = band.iter().map(|texel| texel.normal).collect();
        let normals = OwnedNormals::new(&normals);
        let weights: Vec<[f32; 5]> =
            band.iter().map(|texel| blend.weights(texel.roughness)).collect();
        let mut rgb = [const { Vec::new() }; 3];
        for (channel, sums) in rgb.iter_mut().enumerate() {
            let light = &light.rgb[channel];
            *sums = shader.polynomial(light, &matte, &normals)?;
            sums.iter_mut().zip(band).for_each(|(sum, texel)| *sum *= texel.matte[channel]);
            for (knot, [_, rim, metal]) in of_knots.iter().enumerate() {
                let rim = shader.polynomial(light, rim, &normals)?;
                let metal = shader.polynomial(light, metal, &normals)?;
                let images = rim.into_iter().zip(metal).zip(band.iter().zip(&weights));
                for (sum, ((rim, metal), (texel, weights))) in sums.iter_mut().zip(images) {
                    *sum += weights[knot] * (texel.reflectance[channel] * metal + rim);
                }
            }
        }
        let [r, g, b] = rgb;
        let band = band.iter().zip(r.into_iter().zip(g).zip(b));
        colors.extend(band.map(|(texel, ((r, g), b))| {
            let lit = if sources.is_empty() { [0.0; 3] } else { texel.highlights(sources) };
            let [x, y, z] = lit.map(|value| value as f32);
            Rgb::new(r + x, g + y, b + z)
        }));
    }
    Ok(colors)
}

impl Texel {
    /// The lobe over a matte base.
    #[must_use]
    pub fn gloss(&self) -> Gloss {
        let albedo = |c: usize| match 1.0 - f64::from(self.reflectance[c]) {
            rest if rest > 0.0 => (f64::from(self.matte[c]) / rest).min(1.0),
            _ => 0.0,
        };
        Gloss {
            roughness: self.roughness.into(),
            reflectance: self.reflectance.map(f64::from),
            grazing: [1.0; 3],
            albedo: [0, 1, 2].map(albedo),
        }
    }

    fn highlights(&self, sources: &[Source]) -> [f64; 3] {
        Highlights::new(&self.gloss(), sources).irradiance(self.normal)
    }

    /// The coefficients of its material, to an order of at most 12.
    ///
    /// # Errors
    ///
    /// If the roughness is not from 0 to 1.
    pub fn material(&self, order: usize) -> Result<[Vec<f64>; 3]> {
        let [matte, rim, metal] = parts(order, self.roughness)?;
        Ok([0, 1, 2].map(|c: usize| {
            let [of_matte, of_metal] = [self.matte[c], self.reflectance[c]].map(f64::from);
            let sums = matte.iter().zip(&rim).zip(&metal);
            sums.map(|((matte, rim), metal)| of_matte * matte + rim + of_metal * metal).collect()
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::owned_basis::OwnedBasis;
    use crate::shader::fitted;

    /// Texels of one material against the coefficients of the whole material, of the peak.
    const OF_PARTS: f64 = 1e-5;

    fn normals(count: usize) -> Vec<[f64; 3]> {
        let normal = |k: usize| {
            let square = (k as f64 + 0.5) / count as f64;
            let (sine, cosine) = (2.4 * k as f64).sin_cos();
            [square.sqrt() * cosine, square.sqrt() * sine, (1.0 - square).sqrt()]
        };
        (0..count).map(normal).collect()
    }

    #[test]
    fn parts_add_up_to_the_material() {
        for (table, order) in [(shipped::TABLE, 7), (shipped::PBR, 12)] {
            let table = eigenshade_table::decode(table).expect("a table");
            let owned = OwnedBasis::new(&table).expect("a basis");
            let materials = shipped::materials().expect("materials");
            let lights = shipped::lights().expect("lights");
            let (lights, _) = fitted(&table, &lights, &materials);
            let mut shader = Shader::new(owned.basis().expect("a basis"), 46);
            let normals = normals(500);
            let shown = OwnedNormals::new(&normals);
            for (base, metallic, roughness) in [
                ([0.9f32, 0.5, 0.3], 1.0f32, 0.2f32),
                ([0.1, 0.6, 0.9], 0.0, 0.37),
                ([0.5, 0.5, 0.02], 0.5, 0.61),
                ([1.0, 1.0, 1.0], 0.0, 1.0),
            ] {
                let reflectance = base.map(|base| 0.04 + (base - 0.04) * metallic);
                let matte =
                    [0, 1, 2].map(|c: usize| base[c] * (1.0 - metallic) * (1.0 - reflectance[c]));
                let texel = |normal: &[f64; 3]| Texel {
                    normal: *normal,
                    matte,
                    reflectance,
                    metallic,
                    roughness,
                };
                let texels: Vec<Texel> = normals.iter().map(texel).collect();
                let whole = texels[0].material(order).expect("a material");
                let blend = Blend::of([roughness]).expect("an image");
                for light in &lights.entries {
                    let found = irradiance(&mut shader, light, order, (&blend, &texels), &[]);
                    let found = found.expect("colors");
                    let mut expected = Vec::new();
                    for (light, material) in light.rgb.iter().zip(&whole) {
                        expected
                            .push(shader.polynomial(light, material, &shown).expect("an image"));
                    }
                    let peak = expected.iter().flatten().fold(0.0f32, |most, e| most.max(e.abs()));
                    for (k, found) in found.into_iter().enumerate() {
                        for (found, expected) in <[f32; 3]>::from(found).iter().zip(&expected) {
                            let apart = f64::from((found - expected[k]).abs() / peak);
                            assert!(apart < OF_PARTS, "{}, {roughness}: {apart:e}", light.name);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn knots_have_their_own_images() {
        let weights = Weights::shipped().expect("weights");
        for (k, knot) in KNOTS.into_iter().enumerate() {
            let found = weights.at(knot);
            for (other, weight) in found.into_iter().enumerate() {
                let expected = if other == k { 1.0 } else { 0.0 };
                assert!((weight - expected).abs() < 2e-5, "{knot}: {found:?}");
            }
        }
        assert_eq!(weights.at(0.0), weights.at(0.2));
        assert_eq!(weights.at(2.0), weights.at(1.0));
    }
}
