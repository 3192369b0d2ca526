//! A table: the eigenimages of a sphere, and what they serve for.

use crate::arrays::{
    Numbers, leading, normals, of_channels, of_matrices, of_rows, placed, raised, refused,
};
use crate::light::Light;
use crate::material::Material;
use crate::picture;
use crate::reading::{self, Reading};
use crate::table_arrays;
use crate::work::{done, input_file};
use eigenshade_cli::table;
use eigenshade_generator::basis::estimate::Estimate;
use eigenshade_generator::scene_file;
use eigenshade_model::error::Result;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::overflow;
use eigenshade_model::parallel;
use eigenshade_table::light as positions;
use eigenshade_table::material::count;
use numpy::{IntoPyArray as _, PyArray1, PyArray2, PyArray3, ToPyArray as _};
use pyo3::basic::CompareOp;
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// The number of normals that one step shades.
const BATCH: usize = 1024;

/// A table of eigenimages: U, M and what projects a light on a material, d = UᵀMc.
///
/// ``Table(name="color")`` is a shipped one: ``color`` (160 components of degree 9 and order 7),
/// ``sphere`` (the one that devices have), ``curet`` (the paper's materials) or ``pbr`` (degree and
/// order 12, for glTF materials).
///
/// Modes s = (l, m, o, p, q) are in the order of ``modes``, c_s = L_l^m b_op^q. "(n)" is an
/// equation of Nillius and Eklundh, ICCV 2003.
#[pyclass(module = "eigenshade", frozen)]
pub struct Table {
    table: Arc<eigenshade_table::Table>,
    evaluator: Arc<Evaluator<Arc<eigenshade_table::Table>>>,
}

#[pymethods]
impl Table {
    #[new]
    #[pyo3(signature = (name = "color"))]
    fn new(name: &str) -> PyResult<Self> {
        let bytes = table::shipped(name.as_ref()).ok_or_else(|| {
            let what = format!("`{name}` is not a shipped table");
            refused(what, "use color, sphere, curet or pbr, or read a file with `Table.load`")
        })?;
        Ok(Self::of(table::decode(bytes).map_err(raised)?))
    }

    /// Reads a table that ``eigenshade basis`` wrote.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        Ok(Self::of(done(py, "table", move || table::read(input_file(path)))?))
    }

    /// Makes the table of a scene file.
    #[staticmethod]
    fn make(py: Python<'_>, scene: PathBuf) -> PyResult<Self> {
        let made = move || {
            let loaded = scene_file::load(input_file(scene))?;
            Estimate::of(&loaded).check()?;
            loaded.build()
        };
        Ok(Self::of(done(py, "eigenimages", made)?))
    }

    /// The largest degree l of the light.
    #[getter]
    fn degree(&self) -> usize {
        self.table.gram.degree
    }

    /// The largest order o of the BRDF.
    #[getter]
    fn order(&self) -> usize {
        self.table.gram.order
    }

    /// The number K of eigenimages.
    #[getter]
    fn components(&self) -> usize {
        self.table.count()
    }

    /// d = UᵀMc of a light on a material: float64 (3, K). Degrees and orders beyond the table's are
    /// dropped.
    fn project<'py>(
        &self,
        py: Python<'py>,
        light: &Light,
        material: &Material,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        Ok(of_channels(py, &self.projected(light, material).map_err(raised)?))
    }

    /// The matrix from the light of one channel to d, channel by channel of the material: float64
    /// (3, K, (degree + 1)²). With ``light.truncated(table.degree)``, as the shipped lights have degree
    /// 32, ``matrix[0] @ light.coefficients[0]`` is ``project(light, material)[0]``, less its value
    /// under no light for a table with a mean image.
    fn matrix<'py>(
        &self,
        py: Python<'py>,
        material: &Material,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let (rows, columns) = (self.components(), positions::count(self.degree()));
        let of_channel = |channel: &Vec<f64>| -> Result<Vec<f64>> {
            let channel = &channel[..channel.len().min(count(self.order()))];
            let transfer = self.evaluator.transfer(channel)?;
            let dark = self.evaluator.relight(&transfer, &[]);
            let mut matrix = vec![0.0; rows * columns];
            let mut light = vec![0.0; columns];
            for column in 0..columns {
                light[column] = 1.0;
                let d = self.evaluator.relight(&transfer, &light);
                light[column] = 0.0;
                for (row, (d, dark)) in d.iter().zip(&dark).enumerate() {
                    matrix[row * columns + column] = d - dark;
                }
            }
            Ok(matrix)
        };
        let rgb = &material.entry.rgb;
        let matrices: Result<Vec<_>> = rgb.iter().map(of_channel).collect();
        Ok(of_matrices(py, (rows, columns), &matrices.map_err(raised)?))
    }

    /// The eigenimages U_i at normals (.., 3): float64 (.., K). An image is ``eigenimages(n) @
    /// d.T``.
    fn eigenimages<'py>(
        &self,
        py: Python<'py>,
        normals: Numbers<'_>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let places = leading(&normals);
        let normals = self::normals(&normals)?;
        let (evaluator, count) = (Arc::clone(&self.evaluator), self.components());
        let rows: Vec<Vec<f64>> = done(py, "eigenimages", move || {
            let images = evaluator.eigenimages(&normals);
            Ok((0..count).map(|k| images.eigenimage(k)).collect())
        })?;
        placed(&of_rows(py, &rows).getattr("T")?, places, Some(rows.len()))
    }

    /// The mean image at normals (.., 3): float64 (..,). It is 0 for an image-centered table.
    fn mean_image<'py>(
        &self,
        py: Python<'py>,
        normals: Numbers<'_>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let images = self.evaluator.eigenimages(&self::normals(&normals)?);
        placed(&images.mean().to_pyarray(py), leading(&normals), None)
    }

    /// The irradiance of normals (.., 3) in f64, with the BRDF's albedo in it: float64 (.., 3).
    fn shade<'py>(
        &self,
        py: Python<'py>,
        light: &Light,
        material: &Material,
        normals: Numbers<'_>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let places = leading(&normals);
        let normals = self::normals(&normals)?;
        let d = self.projected(light, material).map_err(raised)?;
        let evaluator = Arc::clone(&self.evaluator);
        let rgb = done(py, "irradiance", move || {
            let batches: Vec<_> = normals.chunks(BATCH).collect();
            let found = parallel::map(batches.len(), &(), |k| {
                let images = evaluator.eigenimages(batches[k]);
                d.each_ref().map(|d| images.reconstruct(d))
            });
            let channel =
                |c: usize| found.iter().map(|rgb| &rgb[c][..]).collect::<Vec<_>>().concat();
            Ok([0, 1, 2].map(channel))
        })?;
        placed(&of_channels(py, &rgb).getattr("T")?, places, Some(3))
    }

    /// The picture of a sphere, ``size`` pixels across, in the numbers of a device's f32: float32
    /// (size, size, 4), linear red, green, blue and the covered share of a pixel.
    ///
    /// The first ``sources`` of the light become highlights by the gloss of the material. The light
    /// has no window, which the program chooses by itself.
    #[pyo3(signature = (light, material, size = 240, *, sources = 0))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        light: &Light,
        material: &Material,
        size: usize,
        sources: usize,
    ) -> PyResult<Bound<'py, PyArray3<f32>>> {
        if !(2..=8192).contains(&size) {
            return Err(refused(format!("{size} pixels across"), "ask for 2 to 8192"));
        }
        let (table, light, material) = (Arc::clone(&self.table), light.clone(), material.clone());
        let drawn = move || picture::of_sphere(&table, &light, &material, size, sources);
        Ok(done(py, "picture", drawn)?.into_pyarray(py))
    }

    /// c = Ud of coefficients (3, K) or (K,), (42): float64 (3, modes) or (modes,).
    fn lift<'py>(&self, py: Python<'py>, d: Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        d.matmul(self.mode_coefficients(py)?.getattr("T")?)
    }

    /// Reads components, light and material off a picture.
    ///
    /// ``picture`` has linear irradiances, (.., 3) or gray (..,); ``normals`` (.., 3) those of its
    /// pixels, with NaN or zeros where there is no object; ``mask`` (..,) the weight of each pixel.
    /// ``noise`` is the standard deviation of a pixel, by default that of the residual. The
    /// statistics are those of the shipped lights and materials that the table was made of.
    #[pyo3(signature = (picture, normals, mask = None, *, noise = None))]
    fn read(
        &self,
        py: Python<'_>,
        picture: Numbers<'_>,
        normals: Numbers<'_>,
        mask: Option<Numbers<'_>>,
        noise: Option<f64>,
    ) -> PyResult<Reading> {
        let pixels = reading::pixels(&picture, &normals, mask.as_ref())?;
        let table = Arc::clone(&self.table);
        done(py, "reading", move || reading::read(&table, &pixels, noise))
    }

    /// l, m, o, p and q of each mode: int64 (modes, 5).
    #[getter]
    fn modes<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<i64>> {
        table_arrays::modes(&self.table).into_pyarray(py)
    }

    /// A, with a row for each node of the quadrature in the slant; M = AᵀA between modes of one m:
    /// float64 (nodes, modes).
    #[getter]
    fn gram_factor<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        table_arrays::gram_factor(&self.table).into_pyarray(py)
    }

    /// M of (23), the scalar products of the modes: float64 (modes, modes), 110 MB at degree 9 and
    /// order 7.
    #[getter]
    fn gram<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let factor = self.gram_factor(py);
        let gram = factor.getattr("T")?.matmul(factor)?;
        // The factor has the slant alone, and modes of different m are orthogonal.
        let columns = self.modes(py).getattr("T")?.get_item(1)?;
        let rows = columns.call_method1("reshape", ((-1, 1),))?;
        gram.mul(rows.rich_compare(columns, CompareOp::Eq)?)
    }

    /// cos α at the nodes: float64 (nodes,).
    #[getter]
    fn nodes<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.table.gram.nodes.to_pyarray(py)
    }

    /// The square roots of the nodes' weights: float64 (nodes,).
    #[getter]
    fn root_weights<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.table.gram.root_weights.to_pyarray(py)
    }

    /// e of (30), the mean of each mode: float64 (modes,).
    #[getter]
    fn mode_means<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        table_arrays::mode_means(&self.table).into_pyarray(py)
    }

    /// U over modes: float64 (modes, K).
    #[getter]
    fn mode_coefficients<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        Ok(table_arrays::mode_coefficients(&self.table)?.into_pyarray(py))
    }

    /// UᵀM: float64 (K, modes).
    #[getter]
    fn projection<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        Ok(table_arrays::projection(&self.table)?.into_pyarray(py))
    }

    /// m of each component: int64 (K,).
    #[getter]
    fn component_m<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        let orders: Vec<i64> = self.table.components.iter().map(|one| one.order.into()).collect();
        orders.into_pyarray(py)
    }

    /// The profiles √w u(α) of the components at the nodes: float64 (nodes, K).
    #[getter]
    fn profiles<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        table_arrays::by_component(&self.table, |profile| &profile.node_values).into_pyarray(py)
    }

    /// The Chebyshev coefficients of u / sin^|m| in 2 cos(α) - 1: float64 (terms, K).
    #[getter]
    fn series<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        table_arrays::by_component(&self.table, |profile| &profile.chebyshev).into_pyarray(py)
    }

    /// The eigenvalue of each component, (24): float64 (K,). NaN for the constant of an
    /// image-centered table.
    #[getter]
    fn eigenvalues<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let values = self.table.components.iter().map(|one| one.eigenvalue.unwrap_or(f64::NAN));
        values.collect::<Vec<_>>().into_pyarray(py)
    }

    /// The eigenvalues of all components, kept or not: float64 (n,).
    #[getter]
    fn spectrum<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let values = self.table.spectrum.iter().map(|one| one.1.unwrap_or(f64::NAN));
        values.collect::<Vec<_>>().into_pyarray(py)
    }

    /// The mean energy of the images of the database about their mean.
    #[getter]
    fn energy(&self) -> f64 {
        self.table.summary.energy
    }

    fn __repr__(&self) -> String {
        let (degree, order, count) = (self.degree(), self.order(), self.components());
        format!("<Table of degree {degree}, order {order}, {count} components>")
    }
}

impl Table {
    fn of(table: eigenshade_table::Table) -> Self {
        let table = Arc::new(table);
        let evaluator = Arc::new(Evaluator::new(Arc::clone(&table)));
        Self { table, evaluator }
    }

    fn projected(&self, light: &Light, material: &Material) -> Result<[Vec<f64>; 3]> {
        let (light, material) = picture::fitted(&self.table, light, material);
        let channel = |c: usize| {
            let d = self.evaluator.project(&light.rgb[c], &material.rgb[c])?;
            overflow::checked(d, &light.rgb[c], &material.rgb[c])
                .map_err(|error| error.of(overflow::pair(&light, &material)))
        };
        Ok([channel(0)?, channel(1)?, channel(2)?])
    }
}
