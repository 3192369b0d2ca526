//! A material.

use crate::arrays::{Numbers, channels, of_channels, refused, triples};
use crate::shipped;
use crate::work::{done, input_file};
use eigenshade_generator::material::analytic::{Analytic, Model, Shares};
use eigenshade_generator::material::brdf::{Measure, Surface};
use eigenshade_generator::material::files::{self, Source};
use eigenshade_generator::material::fit::fit;
use eigenshade_generator::material::measurements::{Measured, Measurement};
use eigenshade_model::database::{Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::source::Gloss;
use eigenshade_shading::presets;
use eigenshade_shading::sources::gloss::{Fitter, of_measured};
use eigenshade_table::material;
use numpy::{PyArray2, ToPyArray as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::f64::consts::FRAC_PI_2;
use std::path::{Path, PathBuf};

/// An isotropic material: its BRDF as Koenderink-van Doorn coefficients b_op^q in 1/sr.
///
/// ``Material(coefficients, name="material")`` takes an array of shape (n,) or (3, n), in the order
/// of ``indices``.
#[pyclass(module = "eigenshade", frozen)]
#[derive(Clone)]
pub struct Material {
    pub entry: Named,
    pub order: usize,
    pub gloss: Option<Gloss>,
}

#[pymethods]
impl Material {
    #[new]
    #[pyo3(signature = (coefficients, name = "material"))]
    fn new(coefficients: Numbers<'_>, name: &str) -> PyResult<Self> {
        let rgb = channels(&coefficients, "coefficients of a material")?;
        let found = rgb[0].len();
        let order = (0..=MOST_ORDER).find(|&order| material::count(order) == found);
        let order = order.ok_or_else(|| {
            let counts: Vec<String> =
                [0, 1, 2, 7, 12].map(|order| material::count(order).to_string()).into();
            let remedy =
                format!("give {}, .. for the orders 0, 1, 2, 7, 12, ..", counts.join(", "));
            refused(format!("a material of {found} coefficients"), &remedy)
        })?;
        Ok(Self { entry: Named { name: name.to_owned(), rgb }, order, gloss: None })
    }

    /// A glTF metallic-roughness material: a GGX lobe over a matte base.
    ///
    /// ``color`` is one number or three, linear, or ``"#b87333"`` in sRGB. Order 7 suits roughness
    /// 0.6 and above, 12 with ``Table("pbr")`` 0.5; below, highlights come from the sources of the
    /// light.
    #[staticmethod]
    #[pyo3(signature = (color, *, metallic = 0.0, roughness = 0.5, order = 7, name = "gltf"))]
    fn gltf(
        py: Python<'_>,
        color: Color,
        metallic: f64,
        roughness: f64,
        order: usize,
        name: &str,
    ) -> PyResult<Self> {
        let base = color.shares()?;
        if !(0.0..=1.0).contains(&metallic) {
            return Err(refused(format!("metallic is {metallic}"), "give 0 to 1"));
        }
        let analytic = Analytic::gltf(name, base, metallic, roughness);
        done(py, "material", move || of_surface(&analytic.surface()?, order))
    }

    /// A matte material that reflects the share ``albedo`` of the light; a color as in ``gltf``.
    #[staticmethod]
    #[pyo3(signature = (albedo, *, name = "lambertian"))]
    fn lambertian(py: Python<'_>, albedo: Color, name: &str) -> PyResult<Self> {
        let analytic = Analytic {
            name: name.to_owned(),
            model: Model::Lambertian,
            albedo: Some(albedo.shares()?),
            sigma: None,
            roughness: None,
            f0: None,
        };
        done(py, "material", move || of_surface(&analytic.surface()?, 0))
    }

    /// A shipped material at an order of its own: 7, or 12 for ``Table("pbr")``.
    #[staticmethod]
    #[pyo3(signature = (name, *, order = 7))]
    fn shipped(name: &str, order: usize) -> PyResult<Self> {
        let mut all = shipped::materials(order)?;
        let place = all.iter().position(|one| one.entry.name == name);
        let names = || all.iter().map(|one| one.entry.name.clone()).collect();
        let missing = || PyValueError::new_err(shipped::missing("material", name, names()));
        Ok(all.swap_remove(place.ok_or_else(missing)?))
    }

    /// Reads a material CSV of the program, measurements (a CSV, a CUReT folder), a MERL
    /// ``.binary`` or a ``.toml`` of formulas. ``name`` is one of several; ``order`` is that of the
    /// fit.
    #[staticmethod]
    #[pyo3(signature = (path, *, order = None, name = None))]
    fn load(
        py: Python<'_>,
        path: PathBuf,
        order: Option<usize>,
        name: Option<String>,
    ) -> PyResult<Self> {
        done(py, "material", move || of_file(&path, order, name.as_deref()))
    }

    /// Fits measurements by weighted least squares: a row for each, ``directions`` (N, 4) with θ_i,
    /// φ_i, θ_r and φ_r in radians, ``values`` (N, 3) the BRDF in 1/sr.
    #[staticmethod]
    #[pyo3(signature = (directions, values, *, order = 7, name = "material"))]
    fn fit(
        py: Python<'_>,
        directions: Numbers<'_>,
        values: Numbers<'_>,
        order: usize,
        name: &str,
    ) -> PyResult<Self> {
        let array = directions.as_array();
        let values = triples(&values, "values")?;
        if array.shape() != [values.len(), 4] || values.is_empty() {
            let what = format!("directions have the shape {:?}", array.shape());
            return Err(refused(what, "give a row of four angles for each row of `values`"));
        }
        let mut samples = Vec::new();
        for (number, (row, rgb)) in array.outer_iter().zip(values).enumerate() {
            let [theta_i, phi_i, theta_r, phi_r] = [0, 1, 2, 3].map(|k| row[k]);
            let is_polar = |angle: f64| (0.0..=FRAC_PI_2).contains(&angle);
            let is_finite = (phi_i - phi_r).is_finite() && rgb.iter().all(|one| one.is_finite());
            if !(is_polar(theta_i) && is_polar(theta_r) && is_finite) {
                let what = format!("measurement {number} has θ {theta_i} and {theta_r}, {rgb:?}");
                return Err(refused(what, "give θ from 0 to π/2, and finite numbers"));
            }
            samples.push(Measurement { theta_i, theta_r, delta_phi: phi_i - phi_r, rgb });
        }
        let measured = Measured { name: name.to_owned(), samples };
        done(py, "material", move || of_measurements(measured, order))
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        &self.entry.name
    }

    /// The largest o.
    #[getter]
    fn order(&self) -> usize {
        self.order
    }

    /// b_op^q: float64 (3, n), 1/sr.
    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        of_channels(py, &self.entry.rgb)
    }

    /// o, p and q of each coefficient: int64 (n, 3).
    #[getter]
    fn indices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i64>>> {
        let rows: Vec<Vec<i64>> = material::indices(self.order)
            .map(|(o, p, q)| vec![o as i64, p as i64, q as i64])
            .collect();
        Ok(PyArray2::from_vec2(py, &rows)?)
    }

    /// The GGX lobe over a matte base that reflects small sources: a dictionary with ``roughness``,
    /// and ``f0``, ``f90`` and ``albedo`` in red, green and blue. ``None`` if it is not known.
    #[getter]
    fn gloss<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(Gloss { roughness, reflectance, grazing, albedo }) = self.gloss else {
            return Ok(None);
        };
        let gloss = PyDict::new(py);
        gloss.set_item("roughness", roughness)?;
        for (name, rgb) in [("f0", reflectance), ("f90", grazing), ("albedo", albedo)] {
            gloss.set_item(name, rgb.to_pyarray(py))?;
        }
        Ok(Some(gloss))
    }

    fn __repr__(&self) -> String {
        format!("<Material {}, order {}>", self.entry.name, self.order)
    }
}

/// A color as a caller writes it.
#[derive(FromPyObject)]
enum Color {
    Hex(String),
    Gray(f64),
    Rgb([f64; 3]),
}

impl Color {
    fn shares(&self) -> PyResult<Shares> {
        match self {
            Self::Gray(gray) => Ok(Shares::Gray(*gray)),
            Self::Rgb(rgb) => Ok(Shares::Rgb(*rgb)),
            Self::Hex(text) => text.parse().map_err(|expected: String| {
                refused(format!("the color \"{text}\": {expected}"), "give one of these")
            }),
        }
    }
}

/// The largest order of a material.
const MOST_ORDER: usize = 64;
/// The order of the shipped table.
const ORDER: usize = 7;

fn of_surface(surface: &Surface, order: usize) -> Result<Material> {
    if order > MOST_ORDER {
        let what = format!("a material of order {order}");
        return Err(Error::new(what, format!("ask for at most {MOST_ORDER}")));
    }
    let entry = surface.project(order, Measure::default()).material;
    let gloss = Fitter::default().named(surface)?.gloss;
    Ok(Material { entry, order, gloss: Some(gloss) })
}

fn of_measurements(measured: Measured, order: usize) -> Result<Material> {
    let gloss = of_measured(&measured)?.gloss;
    let (mut materials, _) = fit(&[measured], order, &mut |_, _| {})?;
    Ok(Material { entry: materials.entries.remove(0), order, gloss: Some(gloss) })
}

fn of_file(path: &Path, order: Option<usize>, name: Option<&str>) -> Result<Material> {
    let is_csv = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("csv"));
    if is_csv && has_coefficients(&input_file(path))? {
        return of_coefficients(path, order, name);
    }
    let order = order.unwrap_or(ORDER);
    let mut sources = files::read(input_file(path))?;
    if let Some(name) = name {
        sources.retain(|source| source.name() == name);
    }
    let count = sources.len();
    match sources.pop() {
        Some(source) if count == 1 => match source {
            Source::Measured(measured) => of_measurements(measured, order),
            Source::Surface(surface) => of_surface(&surface, order),
        },
        _ => {
            let what = format!("{count} of its materials have the name that is asked for");
            Err(Error::new(what, "give the `name` of one").in_file(path))
        }
    }
}

/// Whether the columns of a CSV are those of coefficients.
fn has_coefficients(file: &InputFile) -> Result<bool> {
    let text = file.text()?;
    let header = text.lines().find(|line| !line.starts_with('#')).unwrap_or_default();
    let columns: Vec<&str> = header.split(',').map(str::trim).collect();
    Ok(["o", "p", "q"].iter().all(|column| columns.contains(column)))
}

/// One material of a CSV of coefficients, with the gloss beside it.
fn of_coefficients(path: &Path, order: Option<usize>, name: Option<&str>) -> Result<Material> {
    let source = presets::Source::of_file(path, name.map(str::to_owned));
    let found = source.materials(usize::MAX)?;
    if let Some(order) = order.filter(|order| *order > found.order) {
        let what = format!("its materials have order {}, not {order}", found.order);
        return Err(Error::new(what, "give an `order` up to that").in_file(path));
    }
    let materials = found.truncated(order.unwrap_or(found.order));
    let Materials { order, entries } = materials;
    let entry = source.only(entries)?;
    let gloss = source.gloss(&entry.name)?.map(|named| named.gloss);
    Ok(Material { entry, order, gloss })
}
