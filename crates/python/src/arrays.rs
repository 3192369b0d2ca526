//! numpy arrays from and to the host's vectors, and errors as Python raises them.

use eigenshade_model::error::Error;
use eigenshade_model::vector::unit;
use numpy::ndarray::{Array2, Array3, ArrayView2};
use numpy::{AllowTypeChange, PyArray2, PyArray3, PyArrayLikeDyn, ToPyArray as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// An array argument: a numpy array of any numeric type, or nested lists.
pub type Numbers<'py> = PyArrayLikeDyn<'py, f64, AllowTypeChange>;

/// A `ValueError` in the words of the program.
#[expect(clippy::needless_pass_by_value, reason = "for `map_err`")]
pub fn raised(error: Error) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A `ValueError` that says what is wrong and what to do.
pub fn refused(what: impl Into<String>, remedy: &str) -> PyErr {
    raised(Error::new(what, remedy))
}

/// Three rows, one for each channel.
pub fn of_channels<'py>(py: Python<'py>, rgb: &[Vec<f64>; 3]) -> Bound<'py, PyArray2<f64>> {
    of_rows(py, rgb.as_slice())
}

/// Rows of the same length.
pub fn of_rows<'py>(py: Python<'py>, rows: &[Vec<f64>]) -> Bound<'py, PyArray2<f64>> {
    let length = rows.first().map_or(0, Vec::len);
    Array2::from_shape_fn((rows.len(), length), |(row, k)| rows[row][k]).to_pyarray(py)
}

/// Matrices of the same size.
pub fn of_matrices<'py>(
    py: Python<'py>,
    size: (usize, usize),
    matrices: &[Vec<f64>],
) -> Bound<'py, PyArray3<f64>> {
    let shape = (matrices.len(), size.0, size.1);
    Array3::from_shape_fn(shape, |(k, i, j)| matrices[k][i * size.1 + j]).to_pyarray(py)
}

/// The channels of an array of shape (n,), which is gray, or (3, n).
pub fn channels(numbers: &Numbers<'_>, what: &str) -> PyResult<[Vec<f64>; 3]> {
    let array = numbers.as_array();
    let rows = match *array.shape() {
        [count] => vec![array.to_shape((1, count)).expect("the same numbers").row(0).to_vec(); 3],
        [3, _] => array.outer_iter().map(|row| row.iter().copied().collect()).collect(),
        _ => {
            let what = format!("{what} have the shape {:?}", array.shape());
            return Err(refused(what, "give (n,) for gray, or (3, n) for red, green and blue"));
        }
    };
    if let Some(wrong) = rows.iter().flatten().find(|one| !one.is_finite()) {
        return Err(refused(format!("{what} have a {wrong}"), "give finite numbers"));
    }
    Ok(rows.try_into().expect("three rows"))
}

/// The rows of an array of shape (.., 3).
pub fn triples(numbers: &Numbers<'_>, what: &str) -> PyResult<Vec<[f64; 3]>> {
    let array = numbers.as_array();
    if array.shape().last() != Some(&3) {
        let what = format!("{what} have the shape {:?}", array.shape());
        return Err(refused(what, "give three numbers along the last axis"));
    }
    let flat = array.to_shape((array.len() / 3, 3)).expect("the same numbers");
    let view: ArrayView2<'_, f64> = flat.view();
    Ok(view.outer_iter().map(|row| [row[0], row[1], row[2]]).collect())
}

/// The shape of an array without its last axis.
pub fn leading(numbers: &Numbers<'_>) -> Vec<usize> {
    let shape = numbers.as_array().shape().to_vec();
    shape[..shape.len().saturating_sub(1)].to_vec()
}

/// An array with rows for places of this shape.
pub fn placed<'py>(
    rows: &Bound<'py, PyAny>,
    mut places: Vec<usize>,
    columns: Option<usize>,
) -> PyResult<Bound<'py, PyAny>> {
    places.extend(columns);
    rows.call_method1("reshape", (places,))
}

/// Unit normals of an array of shape (.., 3), of any length above 0 and facing the camera.
pub fn normals(numbers: &Numbers<'_>) -> PyResult<Vec<[f64; 3]>> {
    let checked = |(number, [x, y, z]): (usize, [f64; 3])| {
        if !(x.hypot(y).hypot(z).is_normal() && z >= 0.0) {
            let what = format!("normal {number} is ({x}, {y}, {z})");
            return Err(refused(what, "give vectors with a length, and z toward the camera"));
        }
        Ok(unit([x, y, z]))
    };
    triples(numbers, "normals")?.into_iter().enumerate().map(checked).collect()
}
