//! Arrays with names, axes and units, and as JSON: an object with, for each name, meaning, axes,
//! shape, unit and values.

use eigenshade_model::error::{Error, Result};
use serde::{Serialize, Serializer};

/// One array of an export.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Array {
    /// Its name in the file.
    #[serde(skip)]
    pub name: &'static str,
    /// A description of the values.
    pub meaning: &'static str,
    /// What each axis counts, as many as the shape has numbers.
    pub axes: Vec<&'static str>,
    /// Length of each axis; empty for a single value.
    pub shape: Vec<usize>,
    /// Unit of the values; `1` if they have none.
    pub unit: &'static str,
    /// The values, the last axis fastest.
    pub values: Values,
}

/// The values of an array.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Values {
    /// Real numbers; NaN where there is none.
    Floats(Vec<f64>),
    /// Whole numbers.
    Integers(Vec<i64>),
    /// Names.
    Texts(Vec<String>),
}

impl Values {
    fn len(&self) -> usize {
        match self {
            Self::Floats(values) => values.len(),
            Self::Integers(values) => values.len(),
            Self::Texts(values) => values.len(),
        }
    }
}

impl From<Vec<f64>> for Values {
    fn from(values: Vec<f64>) -> Self {
        Self::Floats(values)
    }
}

impl From<Vec<i64>> for Values {
    fn from(values: Vec<i64>) -> Self {
        Self::Integers(values)
    }
}

impl From<Vec<String>> for Values {
    fn from(values: Vec<String>) -> Self {
        Self::Texts(values)
    }
}

impl Array {
    /// The array `name` with the given axes, each with its length.
    ///
    /// # Panics
    ///
    /// If the values do not fill the axes, which is a fault of the caller.
    #[must_use]
    pub fn new<const N: usize>(
        (name, meaning, unit): (&'static str, &'static str, &'static str),
        axes: [(&'static str, usize); N],
        values: impl Into<Values>,
    ) -> Self {
        let values = values.into();
        let (axes, shape): (Vec<_>, Vec<usize>) = axes.into_iter().unzip();
        assert_eq!(values.len(), shape.iter().product::<usize>(), "the shape of {name}");
        Self { name, meaning, axes, shape, unit, values }
    }
}

/// The text of a JSON file. Values are in one list, the last axis fastest; NaN is `null`. Numbers
/// read back as the same bits. Cannot fail in practice: names, numbers and texts always have a form
/// in JSON.
pub fn json(arrays: &[Array]) -> Result<String> {
    let text = serde_json::to_string(&ByName(arrays));
    Ok(text.map_err(|error| Error::new(error.to_string(), "report it"))? + "\n")
}

struct ByName<'a>(&'a [Array]);

impl Serialize for ByName<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|array| (array.name, array)))
    }
}
