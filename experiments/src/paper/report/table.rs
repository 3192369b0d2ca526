//! Tables and numbers for the page.

/// A Markdown table with numbers aligned to the right.
#[must_use]
pub fn table<const N: usize>(header: [&str; N], rows: &[[String; N]]) -> String {
    let line = |fields: &[String]| format!("| {} |\n", fields.join(" | "));
    let is_number = |field: &String| {
        field.trim_start_matches('-').starts_with(|letter: char| letter.is_ascii_digit())
    };
    let rules: Vec<String> = (0..N)
        .map(|column| {
            let right = rows.iter().all(|row| is_number(&row[column]) && row[column].len() < 20);
            if right { "---:".into() } else { "---".into() }
        })
        .collect();
    let mut text = line(&header.map(str::to_owned)) + &line(&rules);
    for row in rows {
        text.push_str(&line(row));
    }
    text
}

/// A share in percent, with three digits.
#[must_use]
pub fn percent(share: f64) -> String {
    let value = 100.0 * share;
    let magnitude = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
    let places = usize::try_from(2 - magnitude).unwrap_or(0).min(6);
    format!("{value:.places$} %")
}

/// A number of components, or a note that there are not enough.
#[must_use]
pub fn components(count: Option<usize>) -> String {
    count.map_or("more than 100".into(), |count| count.to_string())
}

/// Sorts the values in ascending order.
#[must_use]
pub fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

#[cfg(test)]
mod tests {
    use super::percent;

    #[test]
    fn shares_have_three_digits() {
        let texts = [0.0, 1e-5, 0.00744, -0.0744, 0.174, 0.9926, 1.0].map(percent);
        let expected = ["0.00 %", "0.00100 %", "0.744 %", "-7.44 %", "17.4 %", "99.3 %", "100 %"];
        assert_eq!(texts, expected);
    }
}
