//! The images of `eigenshade shade`: every light on every material, by any method.

use eigenshade::screen::NegativePolicy;
use eigenshade::truncation::{Tolerance, Truncation};
use eigenshade_cli::messages::{Ringing, print_message, progress_bar, truncation_lines};
use eigenshade_cli::output::{Rows, exact};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::parallel::Progress;
use eigenshade_model::reference::{light_products, material_products};
use eigenshade_model::{overflow, reference_image};
use eigenshade_shading::integer_shader::{self, IntegerShader};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::preview::Preview;
use eigenshade_shading::shader::{Lit, OwnedNormals, Shader, fault};
use eigenshade_table::Table;
use eigenshade_table::effect::Effects;

/// The most numbers of eigenimages in f64 in memory: 1 GiB.
const MOST_IN_F64: usize = 1 << 27;

/// The inputs of the images.
pub struct Images {
    pub table: Table,
    pub lights: Lights,
    pub materials: Materials,
    pub normals: Vec<[f64; 3]>,
    pub components: usize,
    pub effects: Effects,
    /// A share of white.
    pub tolerance: Option<f64>,
    /// The error of the number format, as a share of the peak.
    pub rounding: f64,
}

/// How the runtime computes a pixel.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    Eigen,
    Polynomial,
    /// Looked up in a baked map.
    Baked {
        /// Texels on each side.
        size: usize,
    },
}

/// Where the irradiance goes.
pub struct Output<'a> {
    pub rows: Rows<'a>,
    pub negatives: NegativePolicy,
    /// The least irradiance so far that was clamped.
    pub least: f64,
    pub ringing: Ringing,
}

impl Images {
    fn pairs(&self) -> impl Iterator<Item = (&Named, &Named)> {
        let materials = &self.materials.entries;
        let lights = self.lights.entries.iter();
        lights.flat_map(move |light| materials.iter().map(move |material| (light, material)))
    }

    /// Writes the images by the direct sum over modes.
    pub fn modes(&self, out: &mut Output<'_>) -> Result<()> {
        let (lights, materials) = (&self.lights, &self.materials);
        let (effects, normals) = (self.effects, &self.normals);
        let images = {
            let progress = progress_bar("normals", normals.len());
            reference_image::images_of_effects(lights, materials, effects, normals, &progress)
        };
        for (pair, (light, material)) in self.pairs().enumerate() {
            out.record((light, material), images.iter().flat_map(|of_pairs| of_pairs[pair]));
            for (normal, of_pairs) in images.iter().enumerate() {
                for (channel, value) in of_pairs[pair].iter().enumerate() {
                    overflow::check(&[*value], &light.rgb[channel], &material.rgb[channel])
                        .map_err(|error| error.of(overflow::pair(light, material)))?;
                }
                out.row((light, material), normal, of_pairs[pair])?;
            }
        }
        Ok(())
    }

    /// Writes the images in integers.
    pub fn integers(&self, shader: &mut IntegerShader, out: &mut Output<'_>) -> Result<()> {
        let normals = integer_shader::normals(&self.normals)?;
        let (degree, order) = (self.lights.degree, self.materials.order);
        self.channels(out, |light, material| {
            let lights = light_products(degree, light, self.effects);
            let materials = material_products(order, material, self.effects);
            let mut image = vec![0.0; normals.len()];
            for (light, material) in lights.iter().zip(&materials) {
                let product = shader.polynomial(light, material, &normals)?;
                image.iter_mut().zip(product).for_each(|(sum, value)| *sum += value);
            }
            Ok(image)
        })
    }

    /// Writes the images in f64, eigenimage by eigenimage.
    pub fn doubles(&self, out: &mut Output<'_>) -> Result<()> {
        let evaluator = Evaluator::new(&self.table).with_components(self.components);
        let evaluator = evaluator.with_effects(self.effects)?;
        let numbers = self.components.min(self.table.count()).saturating_mul(self.normals.len());
        if numbers > MOST_IN_F64 {
            let what = format!("{numbers} numbers of eigenimages are too many in f64");
            let remedy =
                format!("shade fewer normals, for at most {MOST_IN_F64}, or use --format f32");
            return Err(Error::new(what, remedy));
        }
        let eigenimages = evaluator.eigenimages(&self.normals);
        self.channels(out, |light, material| {
            let image = eigenimages.reconstruct(&evaluator.project(light, material)?);
            overflow::checked(image, light, material)
        })
    }

    /// Writes the images in f32.
    pub fn floats(&self, way: Way, out: &mut Output<'_>) -> Result<()> {
        let basis = OwnedBasis::new(&self.table)?;
        let mut shader = Shader::new(basis.basis().map_err(fault)?, self.components)
            .with_transfers(basis.transfers())
            .with_effects(self.effects)?;
        if let Some(tolerance) = self.tolerance {
            return self.within(&mut shader, tolerance, out);
        }
        let normals = OwnedNormals::new(&self.normals);
        let each = normals.each()?;
        self.channels(out, |light, material| match way {
            Way::Eigen => shader.eigen(light, material, &each),
            Way::Polynomial => shader.polynomial(light, material, &normals),
            Way::Baked { size } => shader.baked(light, material, &each, size),
        })
    }

    /// Writes the images of polynomials within a tolerance, and reports what was kept.
    fn within(&self, shader: &mut Shader<'_>, share: f64, out: &mut Output<'_>) -> Result<()> {
        let normals = OwnedNormals::new(&self.normals);
        let mut chosen: Vec<(Truncation, f64)> = Vec::new();
        self.colors(out, |channels| {
            let exposure = Preview::new(shader, None).exposure(&channels)?.factor();
            let tolerance = Tolerance::OfWhite { share: share as f32, exposure };
            let shaded = shader.within(&channels, &normals, tolerance)?;
            let mut rgb = [const { Vec::new() }; 3];
            for (channel, (irradiance, report)) in rgb.iter_mut().zip(shaded) {
                *channel = irradiance;
                chosen.push((report, exposure.into()));
            }
            Ok(rgb)
        })?;
        truncation_lines(&chosen, self.components, self.rounding).iter().for_each(print_message);
        Ok(())
    }

    /// Writes the images; `irradiance` computes one channel at a time.
    fn channels<S: Copy + Into<f64>>(
        &self,
        out: &mut Output<'_>,
        mut irradiance: impl FnMut(&[f64], &[f64]) -> Result<Vec<S>>,
    ) -> Result<()> {
        self.colors(out, |[red, green, blue]| {
            let mut channel = |(light, material): Lit<'_>| irradiance(light, material);
            Ok([channel(red)?, channel(green)?, channel(blue)?])
        })
    }

    /// Writes the images; `irradiance` computes all three channels.
    fn colors<S: Copy + Into<f64>>(
        &self,
        out: &mut Output<'_>,
        mut irradiance: impl FnMut([Lit<'_>; 3]) -> Result<[Vec<S>; 3]>,
    ) -> Result<()> {
        let progress =
            progress_bar("images", self.lights.entries.len() * self.materials.entries.len());
        for (light, material) in self.pairs() {
            let channel = |c: usize| (light.rgb[c].as_slice(), material.rgb[c].as_slice());
            let [red, green, blue] = irradiance([0, 1, 2].map(channel))
                .map_err(|error| error.of(overflow::pair(light, material)))?;
            let all = red.iter().chain(&green).chain(&blue);
            out.record((light, material), all.map(|&value| value.into()));
            for (normal, ((&r, &g), &b)) in red.iter().zip(&green).zip(&blue).enumerate() {
                out.row((light, material), normal, [r.into(), g.into(), b.into()])?;
            }
            progress.advance();
        }
        Ok(())
    }
}

impl Output<'_> {
    /// Records the values of an image before they are clamped.
    fn record(&mut self, (light, material): (&Named, &Named), values: impl Iterator<Item = f64>) {
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let (least, largest) = values.fold(none, |(a, b), one| (a.min(one), b.max(one)));
        self.ringing.record(|| overflow::pair(light, material), least, largest);
    }

    fn row(
        &mut self,
        (light, material): (&Named, &Named),
        normal: usize,
        mut rgb: [f64; 3],
    ) -> Result<()> {
        if let Some(least) = self.negatives.apply(&mut rgb) {
            self.least = self.least.min(least);
        }
        let [r, g, b] = rgb.map(exact);
        self.rows.row([&light.name, &material.name, &normal.to_string(), &r, &g, &b])
    }
}
