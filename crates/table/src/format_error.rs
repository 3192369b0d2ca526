//! Why a table is not one of the runtime.

use crate::layout::{MAX_DEGREE, MAX_ORDER, MAX_WEIGHTS};
use std::fmt;

/// The maximum number of profiles in `eigenshade::q15::Basis`.
pub(crate) const MAX_PROFILES: usize = MAX_WEIGHTS / 2;

/// Why a table cannot be converted into a format of the runtime.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FormatError {
    /// The degree exceeds [`MAX_DEGREE`] or the order [`MAX_ORDER`].
    High {
        /// The degree.
        degree: usize,
        /// The order.
        order: usize,
    },
    /// The criterion subtracts a mean image.
    Mean,
    /// The table has a selection of modes.
    Selection,
    /// The table stores only transfers.
    TransfersOnly,
    /// A polynomial has more terms than the format allows.
    Long {
        /// |m| of the polynomial.
        azimuth: usize,
        /// Number of terms of the polynomial.
        terms: usize,
        /// Number of terms that the format allows.
        most: usize,
    },
    /// The table has more profiles than the runtime's sums allow.
    Many,
    /// A profile, a term of its polynomial or an intermediate sum exceeds 4,095.
    Large {
        /// The first component of such a profile, from 0.
        component: usize,
    },
    /// The wire file would be longer than 32 bits can express.
    File,
}

impl fmt::Display for FormatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::High { degree, order } => write!(
                f,
                "it has degree {degree} and order {order}, the runtime goes to {MAX_DEGREE} and \
                 {MAX_ORDER}; make the table so, and give what is sharper as sources"
            ),
            Self::Mean => f.write_str(
                "it subtracts a mean image, which only f64 draws; make the table with criterion = \
                 \"image-centered\"",
            ),
            Self::Selection => f.write_str(
                "it has a selection of modes, which only f64 draws; make the table with modes = 0",
            ),
            Self::TransfersOnly => {
                f.write_str("the table stores only transfers; make it with store = \"projection\"")
            }
            Self::Long { azimuth, terms, most } => write!(
                f,
                "a polynomial of |m| = {azimuth} has {terms} terms, the format allows at most {most}; \
                 make the table with a larger profile_tolerance or a lower degree"
            ),
            Self::Many => write!(
                f,
                "integer formats allow at most {MAX_PROFILES} profiles; make the table with fewer \
                 components"
            ),
            Self::Large { component } => {
                write!(f, "component {component} (counted from 0) has a profile above 4095; ")?;
                if *component > 0 {
                    write!(
                        f,
                        "keep {component} components or fewer (`pack --components {component}`), or "
                    )?;
                }
                f.write_str("make the table of a lower degree")
            }
            Self::File => {
                f.write_str("the wire file would exceed 4 GB; make the table with fewer components")
            }
        }
    }
}

impl std::error::Error for FormatError {}
