//! The page against what is counted and computed now.

use crate::{pages, tolerances};

/// [`pages::compare`]: errors and shares may differ by [`tolerances::ABLATION_PAGE`] of themselves,
/// or both be below [`tolerances::ABLATION_ROUNDING`].
///
/// # Errors
///
/// The first line that differs.
pub fn compare(recorded: &str, now: &str) -> Result<(), String> {
    pages::compare(recorded, now, |old, new| {
        let most = old.abs().max(new.abs());
        (old - new).abs() <= tolerances::ABLATION_PAGE * most
            || most < tolerances::ABLATION_ROUNDING
    })
}
