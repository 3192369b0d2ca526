//! Generated parts of handwritten pages.
//!
//! A part is enclosed by `<!-- NAME -->` and `<!-- end of NAME -->`, each on its own line.

/// A part's name and its text, which consists of whole lines.
pub type Part = (&'static str, String);

/// Returns the page with the text of each part replaced.
///
/// # Errors
///
/// If the page lacks the markers of a part.
pub fn with_parts(page: &str, parts: &[Part]) -> Result<String, String> {
    let mut page = page.to_owned();
    for (name, text) in parts {
        let (begin, end) = (format!("<!-- {name} -->\n"), format!("<!-- end of {name} -->\n"));
        let places = page.find(&begin).map(|at| at + begin.len()).zip(page.find(&end));
        let (start, stop) = places.filter(|(start, stop)| start <= stop).ok_or_else(|| {
            format!("the lines `{}` and `{}` are missing", begin.trim(), end.trim())
        })?;
        page.replace_range(start..stop, text);
    }
    Ok(page)
}

/// Compares a page with its current version, word by word. Words with an exponent or a percent sign
/// are numbers and must be `near` each other (recorded, now). Words that begin with × are ratios of
/// times and are not compared. All other words must be equal.
///
/// # Errors
///
/// The first line that differs.
pub fn compare(recorded: &str, now: &str, near: impl Fn(f64, f64) -> bool) -> Result<(), String> {
    let same = |old: &str, new: &str| match (number(old), number(new)) {
        (Some(old), Some(new)) => near(old, new),
        _ => old == new || old.starts_with('×') && new.starts_with('×'),
    };
    let (old, new): (Vec<_>, Vec<_>) = (recorded.lines().collect(), now.lines().collect());
    for (line, (old, new)) in old.iter().zip(&new).enumerate() {
        let [before, after] = [old, new].map(|line| line.split_whitespace().collect::<Vec<_>>());
        let alike = before.len() == after.len()
            && before.iter().zip(&after).all(|(old, new)| same(old, new));
        if !alike {
            return Err(format!("line {}: it says `{old}` where it is `{new}`", line + 1));
        }
    }
    if old.len() == new.len() { Ok(()) } else { Err("it has another number of lines".into()) }
}

fn number(word: &str) -> Option<f64> {
    if let Some(share) = word.trim_end_matches([',', '.', ';']).strip_suffix('%') {
        return share.parse::<f64>().ok().map(|share| 1e-2 * share);
    }
    if word.contains('e') { word.parse().ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_replaced_between_their_markers() {
        let page = "a\n<!-- t -->\nold\n<!-- end of t -->\nb\n";
        let made = with_parts(page, &[("t", "new\nlines\n".into())]);
        assert_eq!(made.as_deref(), Ok("a\n<!-- t -->\nnew\nlines\n<!-- end of t -->\nb\n"));
        assert!(with_parts(page, &[("u", String::new())]).is_err());
    }

    #[test]
    fn words_are_equal_and_numbers_near() {
        let near = |old: f64, new: f64| (old - new).abs() <= 0.1 * old;
        for (old, new) in [("1.0e-3 a", "1.05e-3 a"), ("10 %", "10 %"), ("10%;", "10.5%;")] {
            assert_eq!(compare(old, new, near), Ok(()), "{old}");
        }
        assert_eq!(compare("×1.2 b", "×7 b", near), Ok(()));
        for (old, new) in [("1e-3", "2e-3"), ("a", "b"), ("1", "2"), ("a", "a\nb"), ("1e-3", "x")] {
            assert!(compare(old, new, near).is_err(), "{old}");
        }
    }
}
