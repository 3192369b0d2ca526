//! Messages and progress on standard error, and the warnings and notes about inputs and results.

use eigenshade::truncation::Truncation;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::scattering;
use std::fmt::Display;
use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};

static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// Hides messages, reports and progress from now on; errors stay.
pub fn be_quiet() {
    IS_QUIET.store(true, Ordering::Relaxed);
}

/// Whether messages are hidden.
#[must_use]
pub fn is_quiet() -> bool {
    IS_QUIET.load(Ordering::Relaxed)
}

/// Writes one line to standard error, unless messages are hidden. Does nothing if that fails.
pub fn print_message(line: impl Display) {
    if !is_quiet() {
        print_line(line);
    }
}

fn print_line(line: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{}", printable(&line.to_string()));
}

/// Writes an error to standard error as a single line, whatever text it quotes.
pub fn report_error(error: impl Display) {
    let text = error.to_string();
    let line = text.split(['\n', '\r']).map(str::trim).filter(|part| !part.is_empty());
    print_line(format_args!("error: {}", line.collect::<Vec<_>>().join(" ")));
}

/// Escapes control characters, which may come from names in files, because a terminal would
/// interpret them.
#[must_use]
pub fn printable(text: &str) -> String {
    // Also escapes characters that change the writing direction or end a line.
    let is_control = |letter: char| {
        letter.is_control()
            || matches!(letter, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}')
            || matches!(letter, '\u{2066}'..='\u{2069}')
    };
    let shown = |letter: char| {
        if is_control(letter) { letter.escape_default().to_string() } else { letter.to_string() }
    };
    text.chars().map(shown).collect()
}

/// A number of bytes with its digits in groups of three.
#[must_use]
pub fn grouped(count: usize) -> String {
    match count {
        0..1000 => count.to_string(),
        _ => format!("{},{:03}", grouped(count / 1000), count % 1000),
    }
}

/// A progress bar that counts to `count`, shown only on a terminal until it is dropped.
#[cfg(feature = "generate")]
#[must_use]
pub fn progress_bar(what: &'static str, count: usize) -> indicatif::ProgressBar {
    if is_quiet() {
        return indicatif::ProgressBar::hidden();
    }
    let template = "{msg} [{bar:32}] {pos}/{len} {eta}";
    let style = indicatif::ProgressStyle::with_template(template)
        .unwrap_or_else(|_| indicatif::ProgressStyle::default_bar())
        .progress_chars("=> ");
    indicatif::ProgressBar::new(count as u64).with_style(style).with_message(what)
}

/// A spinner for work of unknown length, shown only on a terminal.
#[cfg(feature = "generate")]
#[must_use]
pub fn spinner(what: &'static str) -> indicatif::ProgressBar {
    if is_quiet() {
        return indicatif::ProgressBar::hidden();
    }
    let spinner = indicatif::ProgressBar::new_spinner().with_message(what);
    spinner.enable_steady_tick(std::time::Duration::from_millis(100));
    spinner
}

/// Shows nothing: progress bars need the feature `generate`.
#[cfg(not(feature = "generate"))]
#[must_use]
pub fn progress_bar(_: &'static str, _: usize) -> impl eigenshade_model::parallel::Progress {}

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
    let of_all = match all {
        1 => String::new(),
        _ => format!(" (albedos beyond 0 to 1: {count} of {all})"),
    };
    Some(format!(
        "warning: material `{name}` has albedo {albedo:.4}: it reflects {fault}{of_all}; check that \
         its unit is 1/sr, or scale it"
    ))
}

/// A warning if a light has a mean radiance below zero, in any channel.
#[must_use]
pub fn dark_light_warning(lights: &Lights) -> Option<String> {
    let is_dark = |light: &&Named| light.rgb.iter().any(|channel| channel[0] < 0.0);
    let light = lights.entries.iter().find(is_dark)?;
    Some(format!(
        "warning: the mean radiance of light `{}` is below zero; check the sign of its first \
         coefficient",
        light.name
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
        let (least, largest) = (plain(*least), plain(*largest));
        let subject = match images {
            1 => format!("the image of {name} falls far below zero"),
            _ => format!("{found} of {images} images fall far below zero, like that of {name}"),
        };
        Some(format!(
            "note: {subject}, from {least} to {largest}: this is ringing, as a series that ends at \
             a degree swings about zero where little light arrives, for example because the light \
             is behind the object; a window damps it, as `render --window auto` chooses it or \
             --window 12"
        ))
    }
}

/// Describes the truncations that a tolerance chose: what they keep of `components`, and their
/// error, for one image in one channel or for many images, each with its exposure. `rounding` is the
/// error of the number format as a share of the peak.
#[must_use]
pub fn truncation_lines(
    chosen: &[(Truncation, f64)],
    components: usize,
    rounding: f64,
) -> Vec<String> {
    let span = |of: fn(&Truncation) -> usize| {
        let values = chosen.iter().map(|(one, _)| of(one));
        match (values.clone().min(), values.max()) {
            (Some(least), Some(most)) if least == most => least.to_string(),
            (Some(least), Some(most)) => format!("{least} to {most}"),
            _ => "none".to_owned(),
        }
    };
    let share = |(one, exposure): &(Truncation, f64)| {
        let of = |part: f32| exposure * f64::from(part);
        let parts = [one.bound, one.left_out_by_components, one.left_out_by_terms, one.floor];
        (parts.map(of), rounding * of(one.peak))
    };
    let floor = chosen.iter().map(|one| share(one).0[3]).fold(0.0, f64::max);
    let total = |(parts, rounding): &([f64; 4], f64)| parts[0] + rounding;
    let worst = chosen.iter().map(share).max_by(|a, b| total(a).total_cmp(&total(b)));
    let worst = worst.unwrap_or_default();
    let ([_, by_components, by_terms, _], rounding) = worst;
    let worst = rounded_up(total(&worst));
    vec![
        format!(
            "kept: {} of {components} components, {} azimuths, {} polynomial terms",
            span(|one| one.components),
            span(|one| one.azimuths),
            span(|one| one.terms),
        ),
        format!(
            "left out of the image of {components} components, rms over a picture of a sphere: \
             at most {worst:.1e} of white, {by_components:.1e} by components, {by_terms:.1e} by \
             terms and {rounding:.1e} by rounding"
        ),
        format!(
            "estimated beyond these components, rms over a picture of a sphere: {floor:.1e} of \
             white"
        ),
    ]
}

/// A number with three digits, without an exponent if it is short without.
fn plain(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size @ 1e-3..1e4 => {
            let decimals = (2.0 - size.log10().floor()).max(0.0) as usize;
            format!("{value:.decimals$}")
        }
        _ => format!("{value:.2e}"),
    }
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
    use super::{Ringing, grouped, printable, rounded_up};

    #[test]
    fn control_characters_are_escaped() {
        let text = "na\u{1b}[31mme\u{7}\u{9b}2J\t\u{202e}\r\n";
        assert_eq!(printable(text), r"na\u{1b}[31mme\u{7}\u{9b}2J\t\u{202e}\r\n");
        assert_eq!(printable("Größe `π` \"a\\b\" e\u{301} 面"), "Größe `π` \"a\\b\" e\u{301} 面");
    }

    #[test]
    fn digits_are_grouped() {
        let texts = [0, 999, 1000, 1_234_567].map(grouped);
        assert_eq!(texts, ["0", "999", "1,000", "1,234,567"]);
    }

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
        assert!(note.starts_with("note: 2 of 5 images"), "{note}");
        assert!(note.contains("of b, from -1.00 to -0.500:"), "{note}");
        let mut image = Ringing::default();
        image.record(|| "a".into(), -4e-5, 0.0);
        let note = image.note().unwrap();
        assert!(note.contains("the image of a falls far below zero, from -4.00e-5 to 0:"));
    }
}
