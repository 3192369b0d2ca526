//! The weights with which pixels see light and patches, and the transports that are known.

use crate::material::{self, Material};
use eigenshade_model::reference::DirectSum;
use eigenshade_table::light;
use faer::{Mat, MatRef, Par};

/// Light in columns, whose rows are the `FINE` cells of directions.
#[derive(Clone, Copy)]
pub struct Columns<'a> {
    /// If given, the first (degree + 1)² columns are the harmonics.
    pub degree: Option<usize>,
    /// The harmonics, if any, then others.
    pub all: MatRef<'a, f32>,
}

/// The weights of what pixels see, a column for each.
#[derive(Clone)]
pub(crate) struct Weights {
    /// Of each cell, for columns that are harmonics.
    harmonics: Mat<f32>,
    /// Of each cell, for other columns; empty if there are none.
    others: Mat<f32>,
    patches: Mat<f32>,
    /// Transports to harmonics that are known.
    open: Mat<f32>,
}

/// [`Weights`] of one pixel.
pub(crate) struct PixelWeights<'a> {
    pub harmonics: &'a mut [f32],
    pub others: &'a mut [f32],
    pub patches: &'a mut [f32],
    pub open: &'a mut [f32],
}

impl Columns<'_> {
    /// The number of columns that are harmonics.
    fn harmonics(&self) -> usize {
        self.degree.map_or(0, light::count)
    }
}

impl Weights {
    /// Zeros for a light and these numbers of patches and pixels.
    pub fn new(light: Columns<'_>, patches: usize, pixels: usize) -> Self {
        let harmonics = light.harmonics();
        let cells = light.all.nrows();
        let others = if harmonics < light.all.ncols() { cells } else { 0 };
        let [harmonics, others, patches, open] =
            [cells, others, patches, harmonics].map(|rows| Mat::zeros(rows, pixels));
        Self { harmonics, others, patches, open }
    }

    /// The weights of one pixel.
    pub fn pixel(&mut self, pixel: usize) -> PixelWeights<'_> {
        PixelWeights {
            harmonics: self.harmonics.col_as_slice_mut(pixel),
            others: self.others.col_as_slice_mut(pixel),
            patches: self.patches.col_as_slice_mut(pixel),
            open: self.open.col_as_slice_mut(pixel),
        }
    }

    /// The transports of the pixels, where patches have these radiances.
    pub fn product(&self, light: Columns<'_>, radiances: Option<MatRef<'_, f32>>) -> Mat<f32> {
        let (harmonics, columns) = (self.open.nrows(), light.all.ncols());
        let mut product = Mat::<f32>::zeros(self.open.ncols(), columns);
        product.as_mut().subcols_mut(0, harmonics).copy_from(self.open.transpose());
        let mut add = |from: usize, weights: &Mat<f32>, light: MatRef<'_, f32>| {
            faer::linalg::matmul::matmul(
                product.as_mut().subcols_mut(from, light.ncols()),
                faer::Accum::Add,
                weights.transpose(),
                light,
                1.0,
                Par::Seq,
            );
        };
        add(0, &self.harmonics, light.all.subcols(0, harmonics));
        if harmonics < columns {
            add(harmonics, &self.others, light.all.subcols(harmonics, columns - harmonics));
        }
        if let Some(radiances) = radiances {
            add(0, &self.patches, radiances.transpose());
        }
        product
    }
}

/// The transports of pixels that see all, which are known for series.
pub(crate) struct Open<'a> {
    sum: DirectSum,
    /// The coefficients of each material that is a series.
    pub materials: Vec<Option<&'a [f64]>>,
}

impl<'a> Open<'a> {
    pub fn new(degree: usize, materials: &[Material<'a>]) -> Self {
        let series = |material: &Material<'a>| match material {
            Material::Formula(_) => None,
            Material::Series(coefficients) => Some(*coefficients),
        };
        let materials: Vec<_> = materials.iter().map(series).collect();
        let order = materials.iter().flatten().map(|one| material::order(one)).max();
        Self { sum: DirectSum::new(degree, order.unwrap_or(0)), materials }
    }

    /// Adds a share of the transports at a normal to each blend of the materials.
    pub fn add(
        &self,
        normal: [f64; 3],
        share: f64,
        blends: &[Vec<f64>],
        weights: &mut [PixelWeights<'_>],
    ) {
        if share <= 0.0 || self.materials.iter().all(Option::is_none) {
            return;
        }
        let modes = self.sum.at(normal);
        for (material, coefficients) in self.materials.iter().enumerate() {
            let Some(coefficients) = coefficients else { continue };
            let transport = modes.transport(&modes.scatter(coefficients));
            for (weights, blend) in weights.iter_mut().zip(blends) {
                let share = share * blend[material];
                for (sum, one) in weights.open.iter_mut().zip(&transport) {
                    *sum += (share * one) as f32;
                }
            }
        }
    }
}
