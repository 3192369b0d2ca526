//! Descriptions of files, as text and as JSON.

use crate::messages::{grouped, printable};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Number, Value};
use std::collections::BTreeMap;
use std::fmt;

/// Named values, and the lengths of named parts in bytes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Description {
    fields: Vec<(String, String)>,
    parts: Vec<(String, usize)>,
}

impl Description {
    /// Adds a value.
    pub fn field(&mut self, name: impl Into<String>, value: impl ToString) {
        self.fields.push((name.into(), value.to_string()));
    }

    /// Adds a part.
    pub fn part(&mut self, name: impl Into<String>, bytes: usize) {
        self.parts.push((name.into(), bytes));
    }
}

/// A line for each value and each part.
impl fmt::Display for Description {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, value) in &self.fields {
            writeln!(f, "{name:<24} {}", printable(value))?;
        }
        for (name, bytes) in &self.parts {
            writeln!(f, "{name:<24} {:>9} bytes", grouped(*bytes))?;
        }
        Ok(())
    }
}

/// A map of the values, numbers as such, and of `bytes`, a map of the parts. Names have underscores
/// for blanks.
impl Serialize for Description {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let key = |name: &str| name.replace(' ', "_");
        let mut map = serializer.serialize_map(None)?;
        for (name, value) in &self.fields {
            let number = value.parse::<Number>().map(Value::Number);
            let value = number.unwrap_or_else(|_| Value::String(value.clone()));
            map.serialize_entry(&key(name), &value)?;
        }
        let parts = self.parts.iter().map(|(name, bytes)| (key(name), *bytes));
        map.serialize_entry("bytes", &parts.collect::<BTreeMap<_, _>>())?;
        map.end()
    }
}
