//! A page against what is counted and computed now.

use super::tolerances;

/// Compares a page with what is measured now: word by word. Errors and shares, which have an
/// exponent or a per cent sign, may differ by [`tolerances::ABLATION_PAGE`] of themselves, or
/// both be below [`tolerances::ABLATION_ROUNDING`]; times are not compared.
///
/// # Errors
///
/// The first line that differs.
pub fn compare(recorded: &str, page: &str) -> Result<(), String> {
    let (old, new): (Vec<_>, Vec<_>) = (recorded.lines().collect(), page.lines().collect());
    for (line, (old, new)) in old.iter().zip(&new).enumerate() {
        let words =
            |text: &str| -> Vec<String> { text.split_whitespace().map(Into::into).collect() };
        let (before, now) = (words(old), words(new));
        let same = before.len() == now.len() && before.iter().zip(&now).all(|(a, b)| near(a, b));
        if !same {
            return Err(format!("line {}: it says\n{old}\nwhere it is\n{new}", line + 1));
        }
    }
    if old.len() == new.len() { Ok(()) } else { Err("it has other lines".into()) }
}

fn near(old: &str, new: &str) -> bool {
    let number = |word: &str| {
        let share = word.trim_end_matches([',', '.', ';']).strip_suffix('%');
        let error = word.contains('e').then_some(word);
        share
            .map(|share| (share, 1e-2))
            .or(error.map(|error| (error, 1.0)))
            .and_then(|(text, unit)| Some(unit * text.parse::<f64>().ok()?))
    };
    match (number(old), number(new)) {
        (Some(old), Some(new)) => {
            let most = old.abs().max(new.abs());
            (old - new).abs() <= tolerances::ABLATION_PAGE * most
                || most < tolerances::ABLATION_ROUNDING
        }
        _ => old == new || old.starts_with('×') && new.starts_with('×'),
    }
}
