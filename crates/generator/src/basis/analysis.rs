//! The principal components of a scene, computed azimuth by azimuth, and the table of the first of
//! them.

use crate::basis::canonical::{self, Ranked};
use crate::basis::database::{in_range, material_weights};
use crate::basis::eigenimages::{
    Azimuth, REPORTED, Selected, constant_coordinates, orthonormality,
};
use crate::basis::gram;
use crate::basis::moments::{self, LightMoments, MaterialMoments};
use crate::basis::pca::{Block, principal};
use crate::basis::profile;
use eigenshade_model::database::{self, Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_model::parallel;
use eigenshade_model::selection::{self, Kept};
use eigenshade_table::scene::{self, Criterion, Store};
use eigenshade_table::{Component, GramFactor, MeanImage, Profile, Scene, Summary, Table};
use faer::Mat;

/// Singular values below this fraction of the root of the database's energy, constant included, are
/// rounding: that of sums over forty columns.
const ROUNDING: f64 = 1e-14;

/// All components of a scene; a table keeps the first of them.
pub(crate) struct Analysis {
    scene: Scene,
    light: LightMoments,
    materials: MaterialMoments,
    /// Number of lights and of materials.
    entries: [usize; 2],
    gram: GramFactor,
    kept: Kept,
    azimuths: Vec<Azimuth>,
    /// The profiles whose singular value exceeds the rounding, in canonical order.
    ranked: Vec<Ranked>,
    /// Singular values up to this are rounding or below the cut-off.
    weakest: f64,
}

impl Analysis {
    /// Analyzes lights and materials that have exactly the scene's degree and order.
    ///
    /// # Errors
    ///
    /// The errors of `basis::build`.
    pub(crate) fn new(scene: &Scene, lights: &Lights, materials: &Materials) -> Result<Self> {
        let criterion = scene.basis.criterion;
        let weights = database::weights(&lights.entries, &scene.light.weights)?;
        let light = LightMoments::weighted(lights, scene.light.normalize, &weights)?;
        let weights = material_weights(scene, lights, materials)?;
        let of_materials = MaterialMoments::weighted(materials, weights);
        let gram = gram::of_sphere(scene.degree(), scene.order());
        let kept = Kept { selection: selection::highest(&gram, scene.basis.modes) };
        let azimuths = parallel::map(gram.degree + 1, &(), |azimuth| {
            analyze(&gram, &kept, (&light, &of_materials), &scene.basis, azimuth)
        });
        // Report the first fault by azimuth, regardless of which thread found one first.
        let azimuths = azimuths.into_iter().collect::<Result<Vec<_>>>()?;
        let whole = moments::deviations(&light, &of_materials, Criterion::ImageCentered, 0);
        let size = azimuths[0].block.images(&gram, &whole).norm_l2();
        in_range(size)?;
        let strongest = largest_of(&azimuths, |azimuth| &azimuth.principal.singular_values);
        let weakest = (ROUNDING * size).max(scene.basis.rank_cutoff * strongest);
        Ok(Self {
            scene: scene.clone(),
            light,
            materials: of_materials,
            entries: [lights.entries.len(), materials.entries.len()],
            ranked: ranked(&azimuths, criterion, weakest),
            gram,
            kept,
            azimuths,
            weakest,
        })
    }

    /// Order m and eigenvalue of every component, in canonical order.
    pub(crate) fn spectrum(&self) -> Vec<(i32, Option<f64>)> {
        let both = |profile: &Ranked| {
            let (azimuth, eigenvalue) = (profile.azimuth, profile.eigenvalue);
            let orders = canonical::orders(azimuth).iter();
            orders.map(move |sign| (sign * azimuth as i32, eigenvalue))
        };
        self.ranked.iter().flat_map(both).collect()
    }

    /// Mean energy of the images about their mean, including the energy below the cut-off.
    pub(crate) fn energy(&self) -> f64 {
        self.energy_of(|_| true)
    }

    /// The energy below the cut-off, which belongs to no component.
    pub(crate) fn dropped(&self) -> f64 {
        self.energy_of(|value| value <= self.weakest)
    }

    fn energy_of(&self, taken: impl Fn(f64) -> bool) -> f64 {
        let squares = |azimuth: &Azimuth| {
            let signs = if azimuth.block.azimuth == 0 { 1.0 } else { 2.0 };
            let values = azimuth.principal.singular_values.iter().rev();
            let sum: f64 = values.filter(|value| taken(**value)).map(|x| x * x).sum();
            signs * sum
        };
        self.azimuths.iter().map(squares).sum()
    }

    /// The mean image at the nodes, weighted, if the criterion has one.
    pub(crate) fn mean_values(&self) -> Option<Vec<f64>> {
        let values = self.azimuths[0].block.space.node_values(&self.mean_coordinates()?);
        Some(values.col(0).iter().copied().collect())
    }

    /// E{L_0^0} times the ambient image of the mean material.
    fn mean_coordinates(&self) -> Option<Mat<f64>> {
        if self.scene.basis.criterion != Criterion::Standard {
            return None;
        }
        let mut material = self.materials.mean.clone();
        material.iter_mut().for_each(|b| *b *= self.light.ambient_mean);
        let deviation = moments::Deviation { degree: 0, material };
        Some(self.azimuths[0].block.images(&self.gram, &[deviation]))
    }

    /// The mean image of a table, with its coefficients in the table's components.
    fn mean_image(&self, table: &Table, tolerance: f64) -> Option<MeanImage> {
        let space = &self.azimuths[0].block.space;
        let coordinates = self.mean_coordinates()?;
        let series: Vec<f64> = space.chebyshev(&coordinates).col(0).iter().copied().collect();
        let node_values = space.node_values(&coordinates);
        let along = |profile: &Profile| {
            let values = profile.node_values.iter().zip(node_values.col(0).iter());
            values.map(|(a, b)| a * b).sum()
        };
        let of = |component: &Component| match component.order {
            0 => along(&table.profiles[component.profile]),
            _ => 0.0,
        };
        let coefficients = table.components.iter().map(of).collect();
        let length = profile::trimmed_length(&series, 0, tolerance);
        Some(MeanImage { chebyshev: series[..length].to_vec(), coefficients })
    }

    /// The complete table of the first `count` components; each polynomial is within `tolerance`
    /// times its profile's largest value.
    pub(crate) fn table(&self, count: usize, tolerance: f64) -> Table {
        let largest = largest_of(&self.azimuths, |azimuth| &azimuth.block.singular_values);
        let threshold = self.scene.basis.rank_cutoff * largest;
        let ranks = self.azimuths.iter().map(|azimuth| azimuth.block.rank(threshold));
        let energy = self.energy();
        let [lights, materials] = self.entries;
        let mut table = Table {
            summary: Summary {
                ranks: ranks.collect(),
                largest_singular_value: largest,
                lights,
                materials,
                energy,
                energy_kept: 1.0,
                orthonormality: 0.0,
                roundings: Vec::new(),
            },
            scene: self.scene.clone(),
            gram: self.gram.clone(),
            selection: self.kept.selection.clone(),
            components: Vec::new(),
            profiles: Vec::new(),
            mean: None,
            spectrum: self.spectrum(),
            transfers: Vec::new(),
        };
        let selected = Selected::new(&self.azimuths, &self.ranked, count);
        selected.write(&mut table, &self.azimuths, threshold, tolerance);
        table.mean = self.mean_image(&table, tolerance);
        if energy > 0.0 {
            let left = table.energy_left(table.components.len());
            table.summary.energy_kept = (1.0 - left / energy).max(0.0);
        }
        table.summary.orthonormality = orthonormality(&table, REPORTED);
        table
    }
}

fn largest_of(azimuths: &[Azimuth], values: fn(&Azimuth) -> &[f64]) -> f64 {
    azimuths.iter().flat_map(values).copied().fold(0.0, f64::max)
}

fn analyze(
    gram: &GramFactor,
    kept: &Kept,
    (light, materials): (&LightMoments, &MaterialMoments),
    basis: &scene::Basis,
    azimuth: usize,
) -> Result<Azimuth> {
    let criterion = basis.criterion;
    let keeps = |l, o, p, q| kept.keeps(gram, azimuth, (l, o, p, q));
    let block = match basis.store {
        Store::Modes => Block::new(gram, azimuth, &keeps)?,
        _ => Block::without_modes(gram, azimuth, &keeps)?,
    };
    let deviations = moments::deviations(light, materials, criterion, azimuth);
    let images = block.images(gram, &deviations);
    let constant = (criterion == Criterion::ImageCentered && azimuth == 0)
        .then(|| constant_coordinates(gram, &block.space));
    let principal = principal(&images, constant.as_deref(), azimuth)?;
    Ok(Azimuth { block, principal })
}

/// All profiles whose singular value exceeds `weakest`, in canonical order.
fn ranked(azimuths: &[Azimuth], criterion: Criterion, weakest: f64) -> Vec<Ranked> {
    let mut ranked = Vec::new();
    if criterion == Criterion::ImageCentered {
        ranked.push(Ranked { azimuth: 0, number: usize::MAX, eigenvalue: None });
    }
    for azimuth in azimuths {
        for (number, value) in azimuth.principal.singular_values.iter().enumerate() {
            if *value > weakest {
                let eigenvalue = Some(value * value);
                ranked.push(Ranked { azimuth: azimuth.block.azimuth, number, eigenvalue });
            }
        }
    }
    canonical::sort(&mut ranked);
    ranked
}
