//! Arrays with names and shapes.

/// One array of an export.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Its name in the file.
    pub name: &'static str,
    /// Length of each axis; empty for a single value.
    pub shape: Vec<usize>,
    /// The values, the last axis fastest.
    pub values: Values,
}

/// The values of an array.
#[derive(Clone, Debug, PartialEq)]
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
    /// The array `name` of a shape.
    ///
    /// # Panics
    ///
    /// If the values do not fill the shape, which is a fault of the caller.
    #[must_use]
    pub fn new<const N: usize>(
        name: &'static str,
        shape: [usize; N],
        values: impl Into<Values>,
    ) -> Self {
        let values = values.into();
        assert_eq!(values.len(), shape.iter().product::<usize>(), "the shape of {name}");
        Self { name, shape: shape.to_vec(), values }
    }
}
