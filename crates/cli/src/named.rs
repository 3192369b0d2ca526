//! One entry of a file of lights or materials: `FILE` or `FILE:NAME`.

use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use std::path::{Path, PathBuf};

/// How many names an error message lists.
const LISTED: usize = 5;

/// A file and the name of one of its entries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The file.
    pub path: PathBuf,
    /// The entry's name; `None` if the file must hold exactly one entry.
    pub name: Option<String>,
}

impl Choice {
    /// Splits at the last colon, unless the whole text names an existing file.
    #[must_use]
    pub fn new(text: &str) -> Self {
        let whole = || Self { path: text.into(), name: None };
        if Path::new(text).exists() {
            return whole();
        }
        match text.rsplit_once(':') {
            Some((path, name)) if !path.is_empty() && !name.is_empty() => {
                Self { path: path.into(), name: Some(name.to_owned()) }
            }
            _ => whole(),
        }
    }

    /// The chosen entry.
    ///
    /// # Errors
    ///
    /// If the file has no entry of that name, or if no name is given and the file has several
    /// entries. The message lists a few of the available names.
    pub fn of(&self, entries: Vec<Named>) -> Result<Named> {
        let names: Vec<String> = entries.iter().map(|entry| entry.name.clone()).collect();
        let found = match &self.name {
            Some(name) => entries.into_iter().find(|entry| entry.name == *name),
            None if entries.len() == 1 => entries.into_iter().next(),
            None => None,
        };
        found.ok_or_else(|| {
            let what = match &self.name {
                Some(name) => format!("there is no `{name}` in it"),
                None => format!("it holds {} entries", names.len()),
            };
            let file = self.path.display();
            Error::new(what, format!("name one as {file}:NAME, of {}", listed(&names)))
                .in_file(&self.path)
        })
    }
}

fn listed(names: &[String]) -> String {
    let mut text = names.iter().take(LISTED).cloned().collect::<Vec<_>>().join(", ");
    if names.len() > LISTED {
        text.push_str(&format!(", ... ({} in all)", names.len()));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_follow_the_last_colon() {
        let choice = Choice::new("no/such:file.csv:felt");
        assert_eq!(choice.path, Path::new("no/such:file.csv"));
        assert_eq!(choice.name.as_deref(), Some("felt"));
        assert_eq!(Choice::new("no/such.csv").name, None);
        assert_eq!(Choice::new("no/such.csv:").name, None);
    }
}
