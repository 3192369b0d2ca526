//! Text forms of numbers and settings for the page.

use super::setting::{Format, Setting, Way};
use eigenshade_cli::messages::grouped;
use eigenshade_cli::table;
use eigenshade_table::scene;

/// An error in percent with two digits, or as a power of ten below 0.01 %.
#[must_use]
pub fn per_cent(error: f64) -> String {
    if !error.is_finite() {
        return "—".into();
    }
    if error < 1e-4 {
        return format!("{error:.1e}");
    }
    let value = 100.0 * error;
    let places = usize::try_from(1 - value.log10().floor() as i32).unwrap_or(0).min(6);
    format!("{value:.places$} %")
}

/// An exponent, without decimals if it is whole.
#[must_use]
pub fn exponent(value: f64) -> String {
    if value.fract() == 0.0 { value.to_string() } else { format!("{value:.2}") }
}

/// An error limit.
#[must_use]
pub fn limit(limit: f64) -> String {
    if limit < 0.99e-3 {
        format!("{limit:e}")
    } else {
        format!("{} %", (1e5 * limit).round() / 1e3)
    }
}

/// A cost with two digits, or a whole number from 100 on.
#[must_use]
pub fn cost(value: f64) -> String {
    match value {
        100.0.. => grouped(value.round() as usize),
        10.0.. => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// A description of a setting for users.
#[must_use]
pub fn setting(setting: &Setting, terms: usize) -> String {
    let recipe = &setting.recipe;
    let mut text = match setting.way {
        Way::NineTerms => return "the nine-term formula".into(),
        Way::Eigen => "component by component".into(),
        Way::Polynomial => format!("polynomials, {terms} terms"),
        Way::Within(share) => {
            format!("polynomials within {}, {terms} terms in the median", limit(share))
        }
        Way::Linear(knots) => format!("{knots} knots, linear"),
        Way::Cubic(knots) => format!("{knots} knots, cubic"),
        Way::Bilinear(size) => format!("baked map {size} x {size}, bilinear"),
        Way::Nearest(size) => format!("baked map {size} x {size}, nearest"),
    };
    text.push_str(&format!(
        ", `{}`; degree {}, order {}, ",
        setting.format, recipe.degree, recipe.order
    ));
    match recipe.components {
        Some(count) => text.push_str(&format!("{count} components")),
        None => text.push_str("all components"),
    }
    if let Some(modes) = recipe.modes {
        text.push_str(&format!(" of {modes} modes"));
    }
    if !recipe.effects.is_all() {
        let names = table::effect_names(recipe.effects).replace(' ', ", ");
        text.push_str(&format!(", of {names} alone"));
    }
    let cut = recipe.cuts();
    if cut != scene::Cut::default() {
        text.push_str(&format!(", {cut}"));
    }
    if setting.format == Format::Q15 && matches!(setting.way, Way::Bilinear(_)) {
        text.push_str(", texels of 16 bits");
    }
    text
}

/// A Markdown table with numbers aligned to the right.
#[must_use]
pub fn table(header: &[String], rows: &[Vec<String>]) -> String {
    let line = |fields: &[String]| format!("| {} |\n", fields.join(" | "));
    let is_number =
        |field: &String| field.starts_with(|c: char| c.is_ascii_digit()) || field == "—";
    let rule = |column: usize| {
        let right =
            column > 0 && rows.iter().all(|row| is_number(&row[column]) && row[column].len() < 20);
        if right { "---:".to_owned() } else { "---".to_owned() }
    };
    let rules: Vec<String> = (0..header.len()).map(rule).collect();
    let mut text = line(header) + &line(&rules);
    for row in rows {
        text.push_str(&line(row));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{cost, per_cent};

    #[test]
    fn numbers_are_short() {
        let texts = [0.5, 0.0123, 0.00456, 2e-4, 3.21e-5].map(per_cent);
        assert_eq!(texts, ["50 %", "1.2 %", "0.46 %", "0.020 %", "3.2e-5"]);
        assert_eq!([1.24, 99.0, 12345.6].map(cost), ["1.24", "99.0", "12,346"]);
    }
}
