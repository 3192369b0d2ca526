//! How far pictures of sharp materials are off, without sources and with them.
//!
//! The figures are looked up: those of a material of a shipped file are its own; those of any other
//! gloss are of a GGX metal of the same roughness, under the same light if it has been measured.

use crate::presets::{Source, largest_within};
use eigenshade_model::budget::Budget;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::source::{Gloss, NamedGloss, SetError};
use eigenshade_shading::shipped::TotalError;
use eigenshade_shading::{highlights, shipped};
use std::cmp::Ordering;
use std::fmt::Write as _;

/// A total error above this share of the peak, over a picture, is worth a note.
const LARGE: f64 = 0.05;
/// And so is one of a pixel above this share: a highlight is less than 0.4 of what it should be.
const DIM: f64 = 0.6;
/// The same with sources, which are meant for highlights.
const DIM_WITH_SOURCES: f64 = 0.25;
/// The rms that a fitted gloss leaves, relative to pictures under a small source, from which on it
/// is worth a note.
const FAR: f64 = 0.15;

/// A degree and an order.
type Size = (usize, usize);

/// Whether an error measured at one size is too large or too small for pictures of another.
fn bound(measured: Size, drawn: Size) -> &'static str {
    match (measured.0.cmp(&drawn.0), measured.1.cmp(&drawn.1)) {
        (Ordering::Equal, Ordering::Equal) => "",
        (Ordering::Less | Ordering::Equal, Ordering::Less | Ordering::Equal) => "at most ",
        (Ordering::Greater | Ordering::Equal, Ordering::Greater | Ordering::Equal) => "at least ",
        _ => "about ",
    }
}

/// The errors of pictures of GGX metals under a light, or under many.
pub struct Sharpness {
    /// The name of the light, if the errors are its own.
    light: Option<String>,
    errors: Vec<SetError>,
}

impl Sharpness {
    /// Whether the errors are those of the light itself.
    #[must_use]
    pub fn is_of_the_light(&self) -> bool {
        self.light.is_some()
    }

    /// The errors under a light, or under all shipped lights with maps if its own are not known.
    /// Fails if the errors beside a light CSV cannot be read.
    pub fn under(light: &Source, name: &str, budget: Budget) -> Result<Self> {
        let errors = light.set_errors(name, budget)?;
        if errors.is_empty() {
            return Ok(Self { light: None, errors: shipped::set_errors()? });
        }
        Ok(Self { light: Some(name.to_owned()), errors })
    }

    /// For each light, the errors of its largest set of at most this many sources, at the largest
    /// measured degree and order that are not larger, or else at the least.
    fn sets(&self, size: Size, most: usize) -> Vec<&SetError> {
        let size = self.size(size);
        let mut sets: Vec<&SetError> = Vec::new();
        let fitting = self.errors.iter().filter(|one| one.size == size && one.most <= most);
        for one in fitting {
            match sets.iter_mut().find(|set| set.light == one.light) {
                Some(set) if set.most <= one.most => *set = one,
                Some(_) => {}
                None => sets.push(one),
            }
        }
        sets
    }

    fn size(&self, size: Size) -> Size {
        largest_within(self.errors.iter().map(|one| one.size), size).unwrap_or_default()
    }

    /// The errors of pictures of a metal: the root mean square, in the median over the lights and
    /// under the worst one, and the largest error of a pixel.
    fn left(&self, size: Size, most: usize, gloss: &Gloss) -> Result<[f64; 3]> {
        let gloss = highlights::gloss(gloss)?;
        let sets = self.sets(size, most);
        let errors: Vec<_> = sets.iter().map(|set| highlights::set_errors(set, &gloss)).collect();
        let mut rms: Vec<f64> = errors.iter().map(|error| error.rms).collect();
        rms.sort_by(f64::total_cmp);
        let median = rms.get(rms.len() / 2).copied().unwrap_or(0.0);
        let pixel = errors.iter().map(|error| error.worst).fold(0.0, f64::max);
        Ok([median, rms.last().copied().unwrap_or(0.0), pixel])
    }

    /// The smallest set of sources that leaves at most `tolerance` at a degree and an order, or, if
    /// all leave more, the one that leaves least. A material that needs no sources has none. Fails
    /// if the errors of the light's sets are not known.
    pub fn fewest(&self, size: Size, gloss: &Gloss, tolerance: f64) -> Result<Choice> {
        let unknown = || {
            let remedy = "find its sources again with `eigenshade light MAP --sources 8 --out \
                          FILE.csv`, which measures them, or give their number: --sources 4";
            Error::new("the errors of the light's sources are not known", remedy)
        };
        if self.light.is_none() {
            return Err(unknown());
        }
        let gloss = highlights::gloss::<f64>(gloss)?;
        let measured = self.size(size);
        let most = if gloss.needs_sources() { usize::MAX } else { 0 };
        let of_size = self.errors.iter().filter(|one| one.size == measured && one.most <= most);
        let mut all: Vec<&SetError> = of_size.collect();
        all.sort_by_key(|one| one.most);
        let error = |one| highlights::set_errors(one, &gloss).rms;
        let choices = all.iter().map(|one| Choice { most: one.most, error: error(one) });
        let choices: Vec<Choice> = choices.collect();
        let within = choices.iter().find(|choice| choice.error <= tolerance);
        let least = || choices.iter().min_by(|a, b| a.error.total_cmp(&b.error));
        within.or_else(least).copied().ok_or_else(unknown)
    }

    /// A note if pictures of a material are far off, at this degree and order with at most this
    /// many sources. Fails if a parameter of the gloss is not from 0 to 1.
    pub fn note(
        &self,
        NamedGloss { name, gloss, error }: &NamedGloss,
        size: Size,
        sources: usize,
    ) -> Result<Option<String>> {
        let (degree, order) = size;
        let with = if sources > 0 { format!(" and {}", counted(sources)) } else { String::new() };
        let mut text = format!("note: `{name}` is sharper than order {order}{with} can show");
        let [median, worst, pixel] = self.left(size, sources, gloss)?;
        let dim = if sources > 0 { DIM_WITH_SOURCES } else { DIM };
        let is_blurred = worst > LARGE || pixel > dim;
        let is_other = sources > 0 && *error > FAR;
        if is_blurred {
            let _ = write!(
                text,
                ": at degree {degree}, pictures of a metal of its roughness, {:.2}, are off by \
                 {}{:.1} % of their peak",
                gloss.roughness,
                bound(self.size(size), size),
                100.0 * median
            );
            let _ = match &self.light {
                Some(light) => write!(text, " under `{light}`"),
                None => write!(text, " in the median, under some lights by {:.0} %", 100.0 * worst),
            };
            let _ = write!(
                text,
                ", and blurred highlights by up to {:.0} %, in the worse of two views",
                100.0 * pixel
            );
        }
        if is_other {
            let joint = if is_blurred { "; moreover" } else { ":" };
            let _ = write!(text, "{joint} its gloss {}", off_lobe(*error));
        }
        Ok((is_blurred || is_other).then_some(text))
    }
}

/// A set of sources that was chosen.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice {
    /// The most sources of the set; 0 for none.
    pub most: usize,
    /// The error of pictures with it: root mean square, relative to the peak.
    pub error: f64,
}

impl Choice {
    /// What was chosen, and what it leaves.
    #[must_use]
    pub fn report(&self, (degree, order): Size, tolerance: f64) -> String {
        let [error, asked] = [self.error, tolerance].map(|share| 100.0 * share);
        let sources = match self.most {
            0 => "no sources".to_owned(),
            most => counted(most),
        };
        let leave = if self.most == 1 { "leaves" } else { "leave" };
        // Without the digits of rounding to binary.
        let asked = (1e9 * asked).round() / 1e9;
        let (note, more) = if error > asked { ("note: ", "more than the ") } else { ("", "") };
        format!(
            "{note}{sources} at degree {degree}, order {order} {leave} {error:.2} % of the peak of \
             a metal of this roughness, {more}{asked} % asked for"
        )
    }
}

/// A number of sources in words.
#[must_use]
pub fn counted(sources: usize) -> String {
    format!("{sources} source{}", if sources == 1 { "" } else { "s" })
}

/// A note on a material that takes no sources.
#[must_use]
pub fn matte_note(name: &str, gloss: &Gloss) -> String {
    format!(
        "note: `{name}` is as matte as a roughness of {:.2}, and sources serve a roughness below \
         {:.1}",
        gloss.roughness,
        eigenshade::Gloss::MATTE
    )
}

/// A note if a material needs no sources, or its highlights are far off with them. Fails if a
/// parameter of the gloss is not from 0 to 1.
pub fn gloss_note(NamedGloss { name, gloss, error }: &NamedGloss) -> Result<Option<String>> {
    if !highlights::gloss::<f64>(gloss)?.needs_sources() {
        return Ok(Some(matte_note(name, gloss)));
    }
    Ok((*error > FAR).then(|| format!("note: the gloss of `{name}` {}", off_lobe(*error))))
}

/// How far the highlights of a lobe with this error are off, for messages.
fn off_lobe(error: f64) -> String {
    let percent = 100.0 * error;
    format!("is not quite a GGX lobe, and its highlights are off by {percent:.0} %")
}

/// A note if the pictures of a shipped material that were measured at a degree and order, without
/// sources, are far from those of its BRDF. `drawn` are the degree and order of the picture.
#[must_use]
pub fn shipped_note(name: &str, measured: Size, drawn: Size, error: TotalError) -> Option<String> {
    let TotalError { median, worst, pixel } = error;
    let ((degree, order), bound) = (drawn, bound(measured, drawn));
    (worst > LARGE || pixel > DIM).then(|| {
        format!(
            "note: `{name}` is sharper than order {order} can show: at degree {degree}, pictures \
             are off by {bound}{:.1} % of their peak in the median, under some lights by {:.0} %, \
             and blurred highlights by up to {:.0} %",
            100.0 * median,
            100.0 * worst,
            100.0 * pixel
        )
    })
}
