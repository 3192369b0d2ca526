//! Compares SVG charts: elements and words must be equal, coordinates and colors nearly so.
//! Coordinates are whole pixels and colors are whole multiples of 1/255. Where a value lies between
//! two whole numbers, the last digit of a host's arithmetic decides how it is rounded.

use super::texts::{Pairs, shown};

/// The allowed difference of a coordinate, in pixels of the chart.
pub const PIXELS: f64 = 1.0;
/// The allowed difference of a color channel, out of 255.
pub const LEVELS: u8 = 1;
/// Attributes that are coordinates; all others except colors must be equal.
const COORDINATES: [&str; 9] = ["x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "points"];

/// Compares two charts. Returns the number of coordinates and colors, or the first line (counted
/// from 1) where they differ, with a description.
///
/// # Errors
///
/// The first difference.
pub fn compare_charts(found: &str, expected: &str) -> Result<usize, (u64, String)> {
    let mut marks = 0;
    for (line, both) in (1..).zip(Pairs(found.lines(), expected.lines())) {
        let (Some(found), Some(expected)) = both else {
            return Err((line, "one line more or less than there should be".into()));
        };
        let mut attribute = "";
        // Values are between quotation marks, and the names of attributes are before them.
        for (place, both) in Pairs(found.split('"'), expected.split('"')).enumerate() {
            let (Some(found), Some(expected)) = both else {
                return Err((line, format!("other elements than in `{}`", shown(expected))));
            };
            let is_value = place % 2 == 1;
            let near = match attribute {
                "fill" | "stroke" if is_value => colours(found, expected),
                name if is_value && COORDINATES.contains(&name) => coordinates(found, expected),
                _ => (found == expected).then_some(0),
            };
            let differs = || format!("`{}` where `{}` belongs", shown(found), shown(expected));
            marks += near.ok_or_else(|| (line, differs()))?;
            attribute = expected.trim_end_matches('=').rsplit(' ').next().unwrap_or_default();
        }
    }
    Ok(marks)
}

/// The number of coordinates, if both have the same number and all are near.
fn coordinates(found: &str, expected: &str) -> Option<usize> {
    let split = |text| str::split(text, [' ', ',']).filter(|word| !word.is_empty());
    let mut count = 0;
    for both in Pairs(split(found), split(expected)) {
        let (found, expected) = (both.0?, both.1?);
        let [a, b]: [f64; 2] = [found.parse().ok()?, expected.parse().ok()?];
        // Written so that a NaN is not near.
        let is_near = (a - b).abs() <= PIXELS;
        if !is_near {
            return None;
        }
        count += 1;
    }
    Some(count)
}

/// 1 if both are colors `#RRGGBB` that are near, 0 if they are the same word.
fn colours(found: &str, expected: &str) -> Option<usize> {
    if found == expected && !expected.starts_with('#') {
        return Some(0);
    }
    let [a, b] = [channels(found)?, channels(expected)?];
    a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= LEVELS).then_some(1)
}

fn channels(colour: &str) -> Option<[u8; 3]> {
    let digits = colour.strip_prefix('#').filter(|digits| digits.len() == 6)?;
    let value = u32::from_str_radix(digits, 16).ok()?;
    let [_, r, g, b] = value.to_be_bytes();
    Some([r, g, b])
}

#[cfg(test)]
mod tests {
    use super::compare_charts;

    const CHART: &str = "<svg width=\"720\">\n\
        <polyline fill=\"none\" opacity=\"1\" stroke=\"#005FAA\" points=\"98,52 104,53 \"/>\n\
        <rect x=\"90\" y=\"7\" fill=\"#90C4DE\"/>\n<text x=\"1\" y=\"2\">\n10 %\n</text>\n</svg>\n";

    #[test]
    fn one_pixel_and_one_level_may_differ_and_nothing_else() {
        let with = |from: &str, to: &str| compare_charts(&CHART.replace(from, to), CHART);
        assert_eq!(compare_charts(CHART, CHART), Ok(10));
        assert!(with("104,53", "105,52").is_ok() && with("#90C4DE", "#91C3DE").is_ok());
        for (from, to, line) in [
            ("104,53", "104,55", 2),
            ("104,53", "104,NaN", 2),
            ("104,53 ", "104,53 105,54 ", 2),
            ("#005FAA", "#0061AA", 2),
            ("\"none\"", "\"#000000\"", 2),
            ("opacity=\"1\"", "opacity=\"0\"", 2),
            ("polyline", "polygon", 2),
            ("y=\"7\"", "z=\"7\"", 3),
            ("10 %", "11 %", 5),
            ("720", "721", 1),
            ("</text>\n", "", 6),
        ] {
            assert_eq!(with(from, to).map_err(|(line, _)| line), Err(line), "{from} {to}");
        }
    }
}
