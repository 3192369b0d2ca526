//! The estimated screen error of a picture, and how many sources it needs.
//!
//! The figures are looked up: those of GGX materials of the same roughness under the same light, or
//! under all shipped lights if its own are not known.

use crate::presets::{Source, largest_within};
use eigenshade_model::error::Result;
use eigenshade_model::screen::ScreenError;
use eigenshade_model::shipped;
use eigenshade_model::source::{Base, Gloss, NamedGloss, SourceError};
use eigenshade_table::highlights::MATTE;

/// The rms that a fitted gloss leaves, relative to pictures under a small source, from which on it
/// is worth a note.
const FAR: f64 = 0.15;

/// The largest roughness whose errors are known.
const ROUGHEST: f64 = 0.6;

/// A degree and an order.
type Size = (usize, usize);

/// The errors of pictures of GGX materials under a light, or under many.
pub struct Estimates {
    /// The name of the light, if the errors are its own.
    light: Option<String>,
    errors: Vec<SourceError>,
}

/// A number of sources, and the error of a picture with them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The number of sources.
    pub sources: usize,
    /// The error against direct integration under the whole light.
    pub error: ScreenError,
}

impl Estimates {
    /// The errors under a light, or under all shipped lights with maps if its own are not known.
    ///
    /// # Errors
    ///
    /// If the errors beside a light CSV cannot be read.
    pub fn under(light: &Source, name: &str) -> Result<Self> {
        let errors = light.source_errors(name)?;
        if errors.is_empty() {
            return Ok(Self { light: None, errors: shipped::source_errors()? });
        }
        Ok(Self { light: Some(name.to_owned()), errors })
    }

    /// Whether the errors are those of the light itself.
    #[must_use]
    pub fn is_of_the_light(&self) -> bool {
        self.light.is_some()
    }

    /// The error of a picture of a material with at most this many sources, at the largest measured
    /// degree and order that are not larger, or else at the least: the median over the lights. It is
    /// not known, and NaN, beyond the largest.
    #[must_use]
    pub fn of(&self, size: Size, gloss: &Gloss, sources: usize) -> Estimate {
        let sources = if gloss.needs_sources() { sources } else { 0 };
        let sizes = self.errors.iter().map(|one| one.size);
        let is_beyond = sizes.clone().all(|(degree, order)| size.0 > degree || size.1 > order);
        let size = largest_within(sizes, size).filter(|_| !is_beyond).unwrap_or_default();
        let fits = |one: &&SourceError| {
            (one.size, one.base) == (size, Base::of(gloss)) && one.sources <= sources
        };
        let mut all: Vec<&SourceError> = Vec::new();
        for one in self.errors.iter().filter(fits) {
            match all.iter_mut().find(|other| other.light == one.light) {
                Some(other) if other.sources <= one.sources => *other = one,
                Some(_) => {}
                None => all.push(one),
            }
        }
        let errors: Vec<_> = all.iter().map(|one| one.of(gloss)).collect();
        let median = |of: fn(&ScreenError) -> f64| {
            let mut values: Vec<f64> = errors.iter().map(of).collect();
            values.sort_by(f64::total_cmp);
            values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
        };
        let error = ScreenError {
            mean: median(|error| error.mean),
            p95: median(|error| error.p95),
            white: median(|error| error.white),
        };
        Estimate { sources, error }
    }

    /// The fewest sources, at most `most`, with which a picture is close, or within a share of
    /// white if one is given; or else those that leave least.
    #[must_use]
    pub fn fewest(&self, size: Size, gloss: &Gloss, within: Option<f64>, most: usize) -> Estimate {
        let mut counts: Vec<usize> = self.errors.iter().map(|one| one.sources).collect();
        counts.retain(|count| *count <= most);
        counts.sort_unstable();
        counts.dedup();
        let over = |one: &Estimate| match within {
            None => one.error.over_close(),
            Some(share) => one.error.white / share,
        };
        let mut best = self.of(size, gloss, 0);
        for count in counts {
            if over(&best) <= 1.0 {
                break;
            }
            let one = self.of(size, gloss, count);
            if over(&one) < over(&best) {
                best = one;
            }
        }
        best
    }

    /// A note if a picture is not close, or exceeds the share of white that is given.
    #[must_use]
    pub fn note(
        &self,
        material: &str,
        (degree, order): Size,
        gloss: &Gloss,
        Estimate { sources, error }: Estimate,
        within: Option<f64>,
    ) -> Option<String> {
        let ScreenError { mean, p95, white } = error;
        let least = self.errors.iter().map(|one| one.size).min().unwrap_or_default();
        let bound = match () {
            () if mean.is_nan() => return None,
            () if gloss.roughness > ROUGHEST => "at most ",
            () if degree < least.0 || order < least.1 => "at least ",
            () => "",
        };
        let (goal, is_met) = match within {
            // A rougher material than the table has is nearer by an unknown amount.
            None if gloss.roughness > ROUGHEST => return None,
            None => ("close is 2 and 5".to_owned(), error.is_close()),
            Some(share) => {
                // Without the digits of rounding to binary.
                let asked = (1e11 * share).round() / 1e9;
                (format!("{:.2} % of white, {asked} % asked for", 100.0 * white), white <= share)
            }
        };
        let light = match &self.light {
            Some(light) => format!("under `{light}`"),
            None => "under the median of 18 lights".to_owned(),
        };
        (!is_met).then(|| {
            format!(
                "note: `{material}` is sharper than degree {degree}, order {order} with {} can \
                 show: a {} of its roughness, {:.2}, {light} has an estimated screen error of \
                 {bound}{mean:.1} in the mean and {p95:.1} for 95 of 100 pixels in the worse of two \
                 views (CIEDE2000; {goal})",
                counted(sources),
                Base::of(gloss).name(),
                gloss.roughness,
            )
        })
    }
}

/// A number of sources in words.
#[must_use]
pub fn counted(sources: usize) -> String {
    match sources {
        0 => "no sources".to_owned(),
        1 => "1 source".to_owned(),
        _ => format!("{sources} sources"),
    }
}

/// A note on a material that takes no sources.
#[must_use]
pub fn matte_note(name: &str, gloss: &Gloss) -> String {
    format!(
        "note: `{name}` is as matte as a roughness of {:.2}, and sources serve a roughness below \
         {:.1}",
        gloss.roughness, MATTE
    )
}

/// A note if a material needs no sources, or its highlights are far off with them.
#[must_use]
pub fn gloss_note(NamedGloss { name, gloss, error }: &NamedGloss) -> Option<String> {
    if !gloss.needs_sources() {
        return Some(matte_note(name, gloss));
    }
    off_lobe_note(name, *error)
}

/// A note if the highlights of a fitted lobe with this error are far off.
#[must_use]
pub fn off_lobe_note(name: &str, error: f64) -> Option<String> {
    let percent = 100.0 * error;
    (error > FAR).then(|| {
        format!(
            "note: the gloss of `{name}` is not quite a GGX lobe, and its highlights are off by \
             {percent:.0} %"
        )
    })
}
