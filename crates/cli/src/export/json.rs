//! Arrays as JSON: an object with, for each name, meaning, axes, shape, unit and values.

use super::array::Array;
use eigenshade_model::error::{Error, Result};
use serde::{Serialize, Serializer};

/// The text of the file. Values are in one list, the last axis fastest; NaN is `null`. Numbers read
/// back as the same bits.
///
/// # Errors
///
/// Cannot fail in practice: names, numbers and texts always have a form in JSON.
pub fn text(arrays: &[Array]) -> Result<String> {
    let text = serde_json::to_string(&ByName(arrays));
    Ok(text.map_err(|error| Error::new(error.to_string(), "report it"))? + "\n")
}

struct ByName<'a>(&'a [Array]);

impl Serialize for ByName<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|array| (array.name, array)))
    }
}
