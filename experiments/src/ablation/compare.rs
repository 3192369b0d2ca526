//! The page against what is counted and computed now.

use crate::pages;

/// Figures of the page of the ablation have two digits, the last of which may be rounded either
/// way.
const ABLATION_PAGE: f64 = 0.1;

/// Errors on that page below this are roundings of f32, another number on another host.
const ABLATION_ROUNDING: f64 = 1e-6;

/// [`pages::compare`]: errors and shares may differ by [`ABLATION_PAGE`] of themselves,
/// or both be below [`ABLATION_ROUNDING`].
///
/// # Errors
///
/// The first line that differs.
pub fn compare(recorded: &str, now: &str) -> Result<(), String> {
    pages::compare(recorded, now, |old, new| {
        let most = old.abs().max(new.abs());
        (old - new).abs() <= ABLATION_PAGE * most || most < ABLATION_ROUNDING
    })
}
