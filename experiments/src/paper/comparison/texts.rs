//! Compares the page and the CSV files: words must be equal, numbers nearly so, because hosts
//! differ in the last digits.

/// The allowed difference of two numbers of a CSV, relative to the larger one: two units of the six
/// digits.
pub const ALLOWED: f64 = 2e-5;
/// The difference that is always allowed, relative to the largest number of the file: rounding.
pub const FLOOR: f64 = 1e-13;

/// Compares two texts. Returns the number of numbers, or the first line (counted from 1) where they
/// differ, with a description.
///
/// # Errors
///
/// The first difference.
pub fn compare_texts(found: &str, expected: &str) -> Result<usize, (u64, String)> {
    let largest = expected
        .split(separates)
        .filter_map(|word| number(word).map(|(value, _)| value.abs()))
        .fold(0.0, f64::max);
    let mut numbers = 0;
    for (line, both) in (1..).zip(Pairs(found.lines(), expected.lines())) {
        let (Some(found), Some(expected)) = both else {
            return Err((line, "one line more or less than there should be".into()));
        };
        for both in Pairs(found.split(separates), expected.split(separates)) {
            let (Some(found), Some(expected)) = both else {
                return Err((line, format!("other words than in `{}`", shown(expected))));
            };
            match (number(found), number(expected)) {
                (Some((a, _)), Some((b, unit))) => {
                    let allowed = (ALLOWED * a.abs().max(b.abs())).max(FLOOR * largest).max(unit);
                    let is_near = (a - b).abs() <= allowed;
                    if !is_near {
                        return Err((line, format!("{found} where {expected} belongs")));
                    }
                    numbers += 1;
                }
                _ if found == expected => {}
                _ => return Err((line, format!("`{found}` where `{expected}` belongs"))),
            }
        }
    }
    Ok(numbers)
}

/// Two sequences side by side, to the end of the longer one.
pub struct Pairs<A, B>(pub A, pub B);

impl<A: Iterator, B: Iterator> Iterator for Pairs<A, B> {
    type Item = (Option<A::Item>, Option<B::Item>);

    fn next(&mut self) -> Option<Self::Item> {
        match (self.0.next(), self.1.next()) {
            (None, None) => None,
            both => Some(both),
        }
    }
}

fn separates(letter: char) -> bool {
    letter.is_whitespace() || matches!(letter, ',' | '|' | '(' | ')' | ';' | ':')
}

/// A number, and one unit of its last digit if it has a decimal point, because a number with fewer
/// digits may be rounded either way. Whole numbers are counts and must be equal.
fn number(word: &str) -> Option<(f64, f64)> {
    let word = word.trim_end_matches('.');
    let value: f64 = word.parse().ok().filter(|value: &f64| value.is_finite())?;
    let (digits, power) = word.split_once('e').unwrap_or((word, "0"));
    let places = digits.split_once('.').map(|(_, places)| places.len());
    let power: i32 = power.parse().ok()?;
    let unit = places.map_or(0.0, |places| 10f64.powi(power - places as i32));
    Some((value, 1.000_001 * unit))
}

/// The beginning of a line, for a message.
pub fn shown(line: &str) -> &str {
    let end = line.char_indices().nth(60).map_or(line.len(), |(end, _)| end);
    &line[..end]
}

#[cfg(test)]
mod tests {
    use super::compare_texts;

    #[test]
    fn last_digits_may_differ_and_nothing_else() {
        let same = |a: &str, b: &str| compare_texts(a, b).is_ok();
        assert!(same("a,1.00001e-3,7\n", "a,1.00002e-3,7\n"));
        assert!(same("about 0.7 % of it.", "about 0.8 % of it."));
        assert!(!same("about 0.7 % of it.", "about 0.9 % of it."));
        assert!(!same("a,1.00001e-3,7", "a,1.0005e-3,7"));
        assert!(!same("a,7", "a,8"));
        assert!(!same("a,7", "b,7"));
        assert!(!same("a,7", "a"));
        assert!(!same("a\nb", "a"));
        assert!(!same("a,NaN", "a,1"));
        // Rounding, compared with the largest number of the file.
        assert!(same("1\n3e-20", "1\n5e-20"));
        assert_eq!(compare_texts("x 1,2\n3", "x 1,2\n3"), Ok(3));
        assert_eq!(compare_texts("1\n2", "1\n3").unwrap_err().0, 2);
    }
}
