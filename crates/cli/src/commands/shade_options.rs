//! Parsers of options of `eigenshade shade`.

use eigenshade::{Effect, Tolerance};
use eigenshade_model::rotation::Rotation;

/// An effect by name.
pub fn effect(text: &str) -> std::result::Result<Effect, String> {
    let found = Effect::ALL.into_iter().find(|effect| effect.name() == text.trim());
    found.ok_or_else(|| "ambient, diffuse, broad and gloss are the effects".to_owned())
}

/// A share of the peak, or decibels below it.
pub fn tolerance(text: &str) -> std::result::Result<Tolerance<f64>, String> {
    let decibels = text.strip_suffix("dB").map(|number| number.trim().parse::<u8>());
    match (decibels, text.parse::<f64>()) {
        (Some(Ok(decibels @ 1..)), _) => Ok(Tolerance::Decibels(decibels)),
        (None, Ok(share)) if (1e-30..1.0).contains(&share) => Ok(Tolerance::OfPeak(share)),
        _ => {
            Err("a share from 1e-30 to less than 1, or 1 to 255 whole decibels are wanted, as in \
                 1e-3 or 60dB"
                .to_owned())
        }
    }
}

/// A width in degrees.
pub fn width(text: &str) -> std::result::Result<f64, String> {
    match text.parse() {
        Ok(width) if width > 0.0 && f64::is_finite(width) => Ok(width),
        _ => Err("a width in degrees above 0 is wanted, as in 12".to_owned()),
    }
}

/// Three angles A,B,C of Rz(A) Ry(B) Rz(C).
pub fn angles(text: &str) -> std::result::Result<Rotation, String> {
    let numbers: Option<Vec<f64>> = text
        .split(',')
        .map(|part| part.trim().parse().ok().filter(|x: &f64| x.is_finite()))
        .collect();
    match numbers.as_deref() {
        // R = Rz(A) Ry(B) Rz(C).
        Some(&[a, b, c]) => Ok(Rotation { alpha: b, beta: a, gamma: c }),
        _ => Err("three angles in radians are wanted, as in 0.5,1.2,-0.3".to_owned()),
    }
}
