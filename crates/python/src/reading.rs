//! Light and material, read off a picture.

use crate::arrays::{Numbers, leading, of_rows, refused, triples};
use crate::light::Light;
use eigenshade_generator::reading::observation::{EigenimageValues, LARGEST, Observer};
use eigenshade_generator::reading::reader::Reader;
use eigenshade_generator::scene_file;
use eigenshade_model::database::{Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::shipped;
use eigenshade_shading::shader::fitted;
use eigenshade_table::Table;
use numpy::PyArray2;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// The result of ``Table.read``. Channels are red, green and blue, or a single gray one.
#[pyclass(module = "eigenshade", frozen)]
pub struct Reading {
    d: Vec<Vec<f64>>,
    deviations: Vec<Vec<f64>>,
    residual: Vec<f64>,
    light: Light,
    materials: Vec<(String, f64)>,
    pixels: usize,
}

#[pymethods]
impl Reading {
    /// The posterior mean of d: float64 (channels, K).
    #[getter]
    fn d<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        of_rows(py, &self.d)
    }

    /// The posterior standard deviation of d: float64 (channels, K).
    #[getter]
    fn deviations<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        of_rows(py, &self.deviations)
    }

    /// The root mean square of what d leaves of each channel, in its units.
    #[getter]
    fn residual(&self) -> Vec<f64> {
        self.residual.clone()
    }

    /// The light on the likeliest material. Its exposure is that of the picture.
    #[getter]
    fn light(&self) -> Light {
        self.light.clone()
    }

    /// The materials of the database, likeliest first: pairs of a name and the logarithm of the
    /// evidence relative to the first.
    #[getter]
    fn materials(&self) -> Vec<(String, f64)> {
        self.materials.clone()
    }

    /// The number of pixels that were used.
    #[getter]
    fn pixels(&self) -> usize {
        self.pixels
    }

    fn __repr__(&self) -> String {
        let name = self.materials.first().map_or("", |(name, _)| name);
        format!("<Reading of {} pixels, likeliest material {name}>", self.pixels)
    }
}

/// The pixels of a picture that show the object: normal, irradiances, weight.
pub struct Pixels {
    channels: usize,
    each: Vec<([f64; 3], [f64; 3], f64)>,
}

/// The pixels of arrays.
pub fn pixels(
    picture: &Numbers<'_>,
    normals: &Numbers<'_>,
    mask: Option<&Numbers<'_>>,
) -> PyResult<Pixels> {
    let values = picture.as_array();
    let (shape, places) = (values.shape(), leading(normals));
    let channels = match shape {
        _ if shape == places => 1,
        [.., 3] if shape[..shape.len() - 1] == places => 3,
        _ => {
            let what = format!("a picture of shape {shape:?} with normals for {places:?}");
            return Err(refused(what, "give (.., 3) or (..,) with normals (.., 3)"));
        }
    };
    let normals = triples(normals, "normals")?;
    let values: Vec<f64> = values.iter().copied().collect();
    let weights: Vec<f64> = match mask {
        Some(mask) if mask.as_array().shape() != places => {
            let what = format!("a mask of shape {:?} for {places:?}", mask.as_array().shape());
            return Err(refused(what, "give a weight for each pixel"));
        }
        Some(mask) => mask.as_array().iter().copied().collect(),
        None => vec![1.0; normals.len()],
    };
    if let Some(wrong) = weights.iter().find(|one| !(0.0..=LARGEST).contains(*one)) {
        return Err(refused(format!("a weight of {wrong}"), "give weights from 0 to 1e100"));
    }
    let mut each = Vec::new();
    for ((normal, pixel), weight) in normals.into_iter().zip(values.chunks(channels)).zip(weights) {
        let length = normal.iter().map(|one| one * one).sum::<f64>().sqrt();
        if weight > 0.0 && length.is_normal() {
            let normal = normal.map(|one| one / length);
            if normal[2] < 0.0 || pixel.iter().any(|one| !one.is_finite()) {
                let what = format!("a pixel {pixel:?} with the normal {normal:?}");
                let remedy = "give finite numbers and z toward the camera, or mask it";
                return Err(refused(what, remedy));
            }
            each.push((normal, [0, 1, 2].map(|c: usize| pixel[c.min(channels - 1)]), weight));
        }
    }
    let largest = each.iter().flat_map(|one| one.1).fold(0.0, |most: f64, one| most.max(one.abs()));
    if !(LARGEST.recip()..=LARGEST).contains(&largest) {
        let what = match largest {
            0.0 => "all pixels that count are black, or none is left".to_owned(),
            _ => format!("the largest number of the pixels that count is {largest:e}"),
        };
        return Err(refused(what, "show the object, and scale the picture to 1e-100 to 1e100"));
    }
    Ok(Pixels { channels, each })
}

/// Reads pixels by a table that was made of shipped databases.
pub fn read(table: &Table, pixels: &Pixels, noise: Option<f64>) -> Result<Reading> {
    if let Some(noise) = noise.filter(|noise| !(LARGEST.recip()..=LARGEST).contains(noise)) {
        let what = format!("a noise of {noise}");
        return Err(Error::new(what, "give a standard deviation from 1e-100 to 1e100"));
    }
    let scene = &table.scene.material;
    let read = |path: &Path| shipped::materials_in(path).map(|all| (all, usize::MAX));
    let (Materials { order, mut entries }, _) =
        scene_file::together(scene.database.iter().map(PathBuf::from), read)?;
    if !scene.names.is_empty() {
        entries.retain(|entry| scene.names.contains(&entry.name));
    }
    let (lights, materials) = fitted(table, &shipped::lights()?, &Materials { order, entries });
    let reader = Reader::new(table, table.count(), &lights, &materials)?;
    if !reader.is_of_the_database() {
        let what = "the table was not made of the shipped lights and materials";
        return Err(Error::new(what, "read with the program, which takes --light and --material"));
    }
    if pixels.each.len() < table.count() {
        let (found, needed) = (pixels.each.len(), table.count());
        let what = format!("{found} pixels for {needed} components");
        return Err(Error::new(what, "show more of the object, or use a smaller table"));
    }
    let mut observer = Observer::new(EigenimageValues::new(table, table.count()), pixels.channels);
    for (normal, pixel, weight) in &pixels.each {
        observer.see(*normal, &pixel[..pixels.channels], *weight);
    }
    let observation = observer.finish();
    let reading = reader.read(&observation, noise)?;
    let best = &reading.candidates[0];
    let last = best.channels.len() - 1;
    let rgb = [0, 1, 2].map(|c: usize| best.channels[c.min(last)].light.clone());
    let degree = rgb[0].len().isqrt() - 1;
    let named = |one: &eigenshade_generator::reading::light_estimate::Candidate| {
        (materials.entries[one.index].name.clone(), one.evidence - best.evidence)
    };
    Ok(Reading {
        d: reading.channels.iter().map(|one| one.posterior.0.d.clone()).collect(),
        deviations: reading.channels.iter().map(|one| one.posterior.0.deviations.clone()).collect(),
        residual: reading.channels.iter().map(|one| one.posterior.1.residual_rms).collect(),
        light: Light { entry: Named { name: "read".to_owned(), rgb }, degree, sources: Vec::new() },
        materials: reading.candidates.iter().map(named).collect(),
        pixels: pixels.each.len(),
    })
}
