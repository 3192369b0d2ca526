//! Small defects of the runtime's mathematics that its tests must notice: their list, and a copy of
//! the sources that contains all of them at once, each behind a switch.

use eigenshade_model::error::{Error, Result};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

/// The environment variable that selects a mutation by its number, from 1 on. Without it, or with
/// 0, the copy computes what the sources compute.
pub const VARIABLE: &str = "EIGENSHADE_MUTATION";

/// What the sources of the copy have in addition. The variable is read once.
pub const SWITCH: &str = r#"
extern crate std;

#[inline(always)]
pub(crate) fn mutated(number: usize) -> bool {
    static SELECTED: std::sync::LazyLock<usize> = std::sync::LazyLock::new(|| {
        std::env::var("EIGENSHADE_MUTATION").map_or(0, |number| number.parse().unwrap_or(0))
    });
    *SELECTED == number
}
"#;

/// One mutation: an expression in a file, and the one that replaces it.
#[derive(Clone, Debug, Deserialize)]
pub struct Mutation {
    /// The file, from the root of the repository.
    pub file: String,
    /// Which occurrence of `original` is meant, as "1 of 2". Empty if there is only one.
    pub place: String,
    /// The expression, not in a `const fn`.
    pub original: String,
    /// An expression of the same type.
    pub mutated: String,
}

impl Mutation {
    /// The range of the expression in the text of its file.
    fn range(&self, text: &str) -> Result<Range<usize>> {
        let places = text.match_indices(&self.original).map(|(start, _)| start);
        let places: Vec<usize> = places.collect();
        let place = if self.place.is_empty() { "1 of 1" } else { &self.place };
        let numbers = place.split_once(" of ").and_then(|(number, count)| {
            Some((number.parse::<usize>().ok()?.checked_sub(1)?, count.parse::<usize>().ok()?))
        });
        match numbers {
            Some((index, count)) if count == places.len() && index < count => {
                Ok(places[index]..places[index] + self.original.len())
            }
            _ => {
                let fault =
                    format!("`{}` occurs {} times, not {place}", self.original, places.len());
                Err(Error::new(fault, "adapt the list of mutations to the source")
                    .in_file(&self.file))
            }
        }
    }
}

/// Reads a list of mutations.
pub fn read(list: &Path) -> Result<Vec<Mutation>> {
    let fault = |error: csv::Error| {
        Error::new(error.to_string(), "the columns are file,place,original,mutated").in_file(list)
    };
    let mut reader = csv::Reader::from_path(list).map_err(fault)?;
    reader.deserialize().collect::<std::result::Result<_, _>>().map_err(fault)
}

/// The files that have mutations, each with all of them behind switches. `read` gives the text of a
/// file.
pub fn switched(
    mutations: &[Mutation],
    read: impl Fn(&str) -> Result<String>,
) -> Result<BTreeMap<&str, String>> {
    let mut files: BTreeMap<&str, Vec<(usize, &Mutation)>> = BTreeMap::new();
    for (number, mutation) in (1..).zip(mutations) {
        files.entry(&mutation.file).or_default().push((number, mutation));
    }
    let files = files.into_iter().map(|(file, mutations)| {
        let mut text = read(file)?;
        let ranges = mutations.iter().map(|(_, mutation)| mutation.range(&text));
        let mut ranges: Vec<_> =
            ranges.zip(&mutations).map(|(r, m)| Ok((r?, m))).collect::<Result<_>>()?;
        // From the end of the file on, so that the ranges before stay valid.
        ranges.sort_by_key(|(range, _)| range.start);
        if ranges.windows(2).any(|two| two[0].0.end > two[1].0.start) {
            let fault = Error::new("two mutations overlap", "choose separate expressions");
            return Err(fault.in_file(file));
        }
        for (range, (number, Mutation { original, mutated, .. })) in ranges.into_iter().rev() {
            let switch =
                format!("(if crate::mutated({number}) {{ {mutated} }} else {{ {original} }})");
            text.replace_range(range, &switch);
        }
        Ok((file, text))
    });
    files.collect()
}
