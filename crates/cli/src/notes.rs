//! Warnings and notes about inputs and results.

use eigenshade::{Scalar, Truncation};
use eigenshade_model::database::Materials;
use eigenshade_model::scattering;

/// How far an albedo may be beyond 0 to 1: the error of truncated coefficients.
const ALBEDO_SLACK: f64 = 1e-3;

/// How far an image may fall below zero without a note, as a share of its largest value.
const RINGING_SHARE: f64 = 1.0 / 3.0;

/// A warning if there are materials that reflect more light than they receive, or a negative
/// amount. It gives the albedo of the worst one under uniform light.
#[must_use]
pub fn albedo_warning(materials: &Materials) -> Option<String> {
    let beyond = |albedo: f64| (albedo - 1.0).max(-albedo);
    let of = |rgb: &[Vec<f64>; 3]| {
        let albedos = rgb.iter().map(|channel| scattering::albedo(channel));
        albedos.max_by(|a, b| beyond(*a).total_cmp(&beyond(*b))).unwrap_or(0.0)
    };
    let found: Vec<(&str, f64)> = materials
        .entries
        .iter()
        .map(|entry| (entry.name.as_str(), of(&entry.rgb)))
        .filter(|(_, albedo)| beyond(*albedo) > ALBEDO_SLACK)
        .collect();
    let (name, albedo) = found.iter().max_by(|a, b| beyond(a.1).total_cmp(&beyond(b.1)))?;
    let (count, all) = (found.len(), materials.entries.len());
    let fault = if *albedo > 1.0 { "more light than it receives" } else { "a negative amount" };
    Some(format!(
        "warning: material `{name}` has albedo {albedo:.4}: it reflects {fault} (of {all} \
         materials, {count} are beyond 0 to 1); check that its unit is 1/sr, or scale it"
    ))
}

/// Records which images show only the ringing of a light that was truncated at its degree.
///
/// No light and no material makes irradiance negative, but truncated series oscillate about the
/// values that they approximate. The series of a highlight falls below zero by 0.13 of the
/// highlight's height, which is the first swing of a point light. If an image falls below zero by a
/// third of its peak, then its peak is not much larger than such a swing. This happens when all
/// light is behind the object.
#[derive(Clone, Debug, Default)]
pub struct Ringing {
    images: usize,
    found: usize,
    /// The name, least value and largest value of the most negative image.
    worst: Option<(String, f64, f64)>,
}

impl Ringing {
    /// Records the least and the largest irradiance of one image.
    pub fn record(&mut self, name: impl FnOnce() -> String, least: f64, largest: f64) {
        self.images += 1;
        if least < 0.0 && -least > RINGING_SHARE * largest {
            self.found += 1;
            if self.worst.as_ref().is_none_or(|(_, lowest, _)| least < *lowest) {
                self.worst = Some((name(), least, largest));
            }
        }
    }

    /// One line about these images, if there are any.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        let (name, least, largest) = self.worst.as_ref()?;
        let (found, images) = (self.found, self.images);
        Some(format!(
            "note: {found} of {images} images fall far below zero, like that of {name}, from \
             {least:.2e} to {largest:.2e}: their peak is only the ringing of a truncated series, \
             as when all light is behind the object"
        ))
    }
}

/// Describes the truncations that a tolerance chose: what they keep of `components`, and their
/// error, for one image in one channel or for many images. `rounding` is the error of the number
/// format as a share of the peak.
#[must_use]
pub fn truncation_lines<S: Scalar + Into<f64>>(
    chosen: &[Truncation<S>],
    components: usize,
    rounding: f64,
) -> Vec<String> {
    let span = |of: fn(&Truncation<S>) -> usize| {
        let values = chosen.iter().map(of);
        match (values.clone().min(), values.max()) {
            (Some(least), Some(most)) if least == most => least.to_string(),
            (Some(least), Some(most)) => format!("{least} to {most}"),
            _ => "none".to_owned(),
        }
    };
    let share = |one: &Truncation<S>| {
        let peak: f64 = one.peak.into();
        let of = |part: S| if peak > 0.0 { part.into() / peak } else { 0.0 };
        [one.bound, one.left_out_by_components, one.left_out_by_terms, one.floor].map(of)
    };
    let floor = chosen.iter().map(|one| share(one)[3]).fold(0.0, f64::max);
    let worst = chosen.iter().map(share).max_by(|a, b| a[0].total_cmp(&b[0]));
    let [worst, by_components, by_terms, _] = worst.unwrap_or_default();
    let worst = rounded_up(worst + rounding);
    vec![
        format!(
            "kept: {} of {components} components, {} azimuths, {} polynomial terms",
            span(|one| one.components),
            span(|one| one.azimuths),
            span(|one| one.terms),
        ),
        format!(
            "left out of the image of {components} components, rms over a picture of a sphere: \
             at most {worst:.1e} of the brightest channel's peak, {by_components:.1e} by \
             components, {by_terms:.1e} by terms and {rounding:.1e} by rounding"
        ),
        format!(
            "estimated beyond these components, rms over a picture of a sphere: {floor:.1e} of \
             that peak"
        ),
    ]
}

/// Rounds up to two digits, so that a printed bound remains a bound.
fn rounded_up(value: f64) -> f64 {
    if value <= 0.0 {
        return 0.0;
    }
    let unit = 10f64.powf(value.log10().floor() - 1.0);
    (value / unit).ceil() * unit
}

#[cfg(test)]
mod tests {
    use super::{Ringing, rounded_up};

    #[test]
    fn a_printed_bound_is_no_smaller() {
        for value in [0.0, 1.0, 0.0101, 9.91e-3, 9.99e-7, 1.234e-5, 3e-2] {
            let printed: f64 = format!("{:.1e}", rounded_up(value)).parse().expect("a number");
            assert!(printed >= value && printed <= 1.1 * value, "{printed} of {value}");
        }
    }

    #[test]
    fn images_about_zero_are_noted() {
        let mut images = Ringing::default();
        for (least, largest) in [(0.0, 1.0), (-0.3, 1.0), (0.0, 0.0)] {
            images.record(|| unreachable!(), least, largest);
        }
        assert_eq!(images.note(), None);
        images.record(|| "a".into(), -0.4, 1.0);
        images.record(|| "b".into(), -1.0, -0.5);
        let note = images.note().unwrap();
        assert!(note.starts_with("note: 2 of 5 images") && note.contains("of b, from -1.00e0"));
    }
}
