//! Compares PNG pictures pixel by pixel. Their channels have 255 levels. Where a value lies between
//! two levels, the last digit of a host's arithmetic decides how it is rounded; this affects one
//! pixel in millions.

use eigenshade_cli::picture::canvas::Canvas;
use eigenshade_generator::picture::png_samples::PngSamples;

/// The allowed difference of a channel of any pixel, out of 255.
pub const LEVELS: u16 = 1;
/// The share of the pixels that may differ at all.
pub const SHARE: f64 = 1e-3;

/// Compares two pictures. Returns the number of pixels, or a description of the difference.
///
/// # Errors
///
/// If the size or format differs; if a channel of a pixel is off by more than one of 255 levels,
/// with the column and row of the pixel; if more than a thousandth of the pixels are off at all.
pub fn compare_pictures(found: &PngSamples, expected: &Canvas) -> Result<usize, String> {
    let (width, height) = (expected.width, expected.height);
    if (found.width, found.height) != (width, height) {
        let size = format!("it has {} x {} pixels", found.width, found.height);
        return Err(format!("{size} where {width} x {height} belong"));
    }
    if found.full != u16::from(u8::MAX) || found.opacities.iter().any(|one| *one != found.full) {
        return Err("it is not opaque with 8 bits a channel".into());
    }
    let mut off = 0;
    let (pixels, _) = expected.bytes.as_chunks::<3>();
    for (place, (found, expected)) in found.colours.iter().zip(pixels).enumerate() {
        let expected = expected.map(u16::from);
        let apart = found.iter().zip(expected).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0);
        if apart > LEVELS {
            let (column, row) = (place % width, place / width);
            return Err(format!(
                "pixel ({column}, {row}) has {found:?} where {expected:?} belongs"
            ));
        }
        off += usize::from(apart > 0);
    }
    let most = (SHARE * pixels.len() as f64) as usize;
    if off > most {
        return Err(format!("{off} of its pixels are off by a level where {most} may be"));
    }
    Ok(pixels.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use eigenshade_generator::picture::png_curve::Curve;

    #[test]
    fn a_level_here_and_there_may_differ_and_nothing_else() {
        let canvas = Canvas::new(50, 40, [10, 20, 30]);
        let same = PngSamples {
            width: 50,
            height: 40,
            full: 255,
            curve: Curve::Srgb,
            colours: vec![[10, 20, 30]; 2000],
            opacities: vec![255; 2000],
        };
        type Change<'a> = &'a dyn Fn(&mut PngSamples);
        let with = |change: Change<'_>| {
            let mut changed = same.clone();
            change(&mut changed);
            compare_pictures(&changed, &canvas)
        };
        assert_eq!(with(&|_| ()), Ok(2000));
        assert_eq!(with(&|one| one.colours[..2].fill([11, 19, 30])), Ok(2000));
        let wrong: [(Change<'_>, &str); 5] = [
            (&|one| one.colours[..3].fill([11, 19, 30]), "3 of its pixels"),
            (&|one| one.colours[52][2] = 32, "pixel (2, 1)"),
            (&|one| one.opacities[7] = 254, "opaque"),
            (&|one| one.full = u16::MAX, "8 bits"),
            (&|one| (one.width, one.height) = (40, 50), "40 x 50"),
        ];
        for (change, word) in wrong {
            assert!(with(change).is_err_and(|what| what.contains(word)), "{word}");
        }
    }
}
