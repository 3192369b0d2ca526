//! Compares the page with freshly counted and computed figures.

use crate::pages;

/// Allowed relative difference of the figures on the ablation page: they have two digits, and the
/// last may be rounded either way.
const ABLATION_PAGE: f64 = 0.1;

/// Errors on that page below this are f32 rounding and differ between hosts.
const ABLATION_ROUNDING: f64 = 1e-6;

/// Applies [`pages::compare`]: errors and shares may differ by a relative [`ABLATION_PAGE`], or
/// both may be below [`ABLATION_ROUNDING`].
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
