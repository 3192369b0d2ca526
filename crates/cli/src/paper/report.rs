//! The page.

use super::bound::Bounds;
use super::error::Errors;
use super::selected::Selected;
use super::study::Study;
use super::variance::Variance;

/// What the page tells of.
pub struct Report<'a> {
    /// Lights, materials and bases.
    pub study: &'a Study,
    /// Fig. 2.
    pub variance: &'a Variance,
    /// Fig. 5 and 6.
    pub errors: &'a Errors,
    /// Section 4.4.
    pub bounds: &'a Bounds,
    /// The paper's truncation.
    pub selected: &'a Selected,
}

impl Report<'_> {
    /// The page, in Markdown.
    #[must_use]
    pub fn page(&self) -> String {
        String::new()
    }
}
