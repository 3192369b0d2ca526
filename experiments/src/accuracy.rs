//! Errors of truncated sums and of tables against direct integration under environment maps.
//!
//! The error of a map is the rms over the sphere's normals and the three channels, relative to the
//! largest |I| of the direct integration over all of them.

use eigenshade_generator::direct::Surroundings;
use eigenshade_generator::material::brdf::{Brdf, Measure, Surface};
use eigenshade_index::{light, material};
use eigenshade_model::database::{Lights, Named};
use eigenshade_model::error::Result;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::special::spherical_harmonic::azimuth;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::parallel;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_shading::sphere_rings::{Ring, rings};
use eigenshade_table::Table;
use indicatif::ProgressBar;

/// The widest spacing of normals in radians.
const WIDEST: f64 = 0.06;
/// Spacing of the normals, in widths of the narrowest lobe.
const SPACING: f64 = 1.25;
/// The number of normals integrated at a time.
const BATCH: usize = 16;

/// r, g, b by normal and then by map.
type Images = Vec<Vec<[f64; 3]>>;

/// A surface under environment maps, integrated directly.
pub struct Reference<'a> {
    surface: &'a Surface,
    rings: Vec<Ring>,
    images: Images,
    /// The peak of each map.
    peaks: Vec<f64>,
}

/// The spacing of normals, in radians, that resolves a surface's lobe.
#[must_use]
pub fn spacing(surface: &Surface) -> f64 {
    let width = (0..surface.channels()).map(|c| surface.channel(c).width()).fold(1.0, f64::min);
    (SPACING * width).min(WIDEST)
}

impl<'a> Reference<'a> {
    /// Integrates the surface; `fineness` as in [`Surroundings::irradiance`].
    #[must_use]
    pub fn new(
        surface: &'a Surface,
        maps: &Surroundings,
        spacing: f64,
        fineness: f64,
        progress: &ProgressBar,
    ) -> Self {
        let rings = rings(spacing);
        let normals: Vec<[f64; 3]> = rings.iter().flat_map(Ring::normals).collect();
        let brdfs: Vec<&dyn Brdf> = (0..surface.channels()).map(|c| surface.channel(c)).collect();
        let batches: Vec<&[[f64; 3]]> = normals.chunks(BATCH).collect();
        progress.set_length(batches.len() as u64);
        let images: Images = parallel::map(batches.len(), progress, |k| {
            maps.irradiance(&brdfs, batches[k], fineness)
        })
        .into_iter()
        .flatten()
        .map(|channels| {
            let of =
                |map: usize| [0, 1, 2].map(|c: usize| channels[c.min(channels.len() - 1)][map][c]);
            (0..maps.maps()).map(of).collect()
        })
        .collect();
        // A narrow lobe peaks where it mirrors the sun, which is between the normals of the rings.
        let mirrors: Vec<[f64; 3]> = (0..maps.maps()).map(|map| maps.mirror(map)).collect();
        let at_mirrors = maps.irradiance(&brdfs, &mirrors, fineness);
        let largest = |map: usize| {
            let channels = &at_mirrors[map];
            let mirrored = [0, 1, 2].map(|c: usize| channels[c.min(channels.len() - 1)][map][c]);
            let images = images.iter().flat_map(|maps| maps[map]);
            images.chain(mirrored).fold(0.0, |most: f64, i| most.max(i.abs()))
        };
        let peaks = (0..maps.maps()).map(largest).collect();
        Self { surface, rings, images, peaks }
    }

    /// The number of normals.
    #[must_use]
    pub fn normals(&self) -> usize {
        self.images.len()
    }

    /// The integrated images, by normal and then by map.
    #[must_use]
    pub fn images(&self) -> &[Vec<[f64; 3]>] {
        &self.images
    }

    /// The error for each map of the direct sum (15) up to a degree and an order. `lights` are the
    /// projections of the maps and must reach the degree.
    #[must_use]
    pub fn of_sum(&self, lights: &Lights, degree: usize, order: usize) -> Vec<f64> {
        let material = self.surface.project(order, Measure::Projected).material;
        let modes_at = DirectSum::new(degree, order);
        let count = light::count(degree);
        let hidden = ProgressBar::hidden();
        let images = parallel::map(self.rings.len(), &hidden, |k| {
            let ring = &self.rings[k];
            let (sine, cosine) = ring.slant.sin_cos();
            let modes = modes_at.at([sine, 0.0, cosine]);
            let scattered = material.rgb.each_ref().map(|channel| modes.scatter(channel));
            let profile =
                |light: &Named, c: usize| modes.profile(&light.rgb[c][..count], &scattered[c]);
            let profiles: Vec<[Vec<f64>; 3]> =
                lights.entries.iter().map(|light| [0, 1, 2].map(|c| profile(light, c))).collect();
            let top = degree.cast_signed();
            let at = |tilt: &f64| {
                let waves: Vec<f64> = (-top..=top).map(|m| azimuth(m, *tilt)).collect();
                let sum = |profile: &Vec<f64>| waves.iter().zip(profile).map(|(a, b)| a * b).sum();
                profiles.iter().map(|channels| channels.each_ref().map(sum)).collect()
            };
            ring.tilts.iter().map(at).collect::<Images>()
        });
        self.errors(&images.into_iter().flatten().collect::<Images>())
    }

    /// The error for each map of a table with all of its components, in f64.
    ///
    /// # Errors
    ///
    /// If the lights have a lower degree than the table.
    pub fn of_table(&self, lights: &Lights, table: &Table) -> Result<Vec<f64>> {
        let (degree, order) = (table.gram.degree, table.gram.order);
        let lights = lights.truncated(degree);
        let mut material = self.surface.project(order, Measure::Projected).material;
        for channel in &mut material.rgb {
            channel.truncate(material::count(order));
        }
        let basis = OwnedBasis::<f64>::new(table);
        let mut shader = Shader::new(basis.any().map_err(fault)?, table.count());
        let normals: Vec<[f64; 3]> = self.rings.iter().flat_map(Ring::normals).collect();
        let normals = OwnedNormals::new(&normals);
        let mut images: Images = vec![Vec::new(); self.images.len()];
        for light in &lights.entries {
            let [r, g, b] = shader.color((degree, light), (order, &material), &normals)?;
            for (image, ((r, g), b)) in images.iter_mut().zip(r.into_iter().zip(g).zip(b)) {
                image.push([r, g, b]);
            }
        }
        Ok(self.errors(&images))
    }

    /// The first map under which the material is black.
    #[must_use]
    pub fn black(&self) -> Option<usize> {
        self.peaks.iter().position(|peak| *peak == 0.0)
    }

    /// The rms over normals and channels relative to the peak, by map.
    fn errors(&self, images: &[Vec<[f64; 3]>]) -> Vec<f64> {
        let weights =
            self.rings.iter().flat_map(|ring| std::iter::repeat_n(ring.weight, ring.tilts.len()));
        let mut squares = vec![0.0; self.peaks.len()];
        for ((weight, reference), ours) in weights.zip(&self.images).zip(images) {
            for ((square, reference), ours) in squares.iter_mut().zip(reference).zip(ours) {
                let channels = reference.iter().zip(ours).map(|(a, b)| (a - b) * (a - b));
                *square += weight * channels.sum::<f64>() / 3.0;
            }
        }
        squares.iter().zip(&self.peaks).map(|(square, peak)| square.sqrt() / peak).collect()
    }
}
