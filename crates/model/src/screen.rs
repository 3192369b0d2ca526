//! The error of a picture as a display shows it.

/// How far a picture is from a reference on a screen: both exposed for the reference, clipped at
/// white and encoded in sRGB with 8 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ScreenError {
    /// CIEDE2000, the mean over the covered pixels.
    pub mean: f64,
    /// CIEDE2000, which 95 of 100 pixels do not exceed.
    pub p95: f64,
    /// The root mean square over pixels and channels in linear light, clipped, as a share of white.
    pub white: f64,
}

impl ScreenError {
    /// Whether the difference is not visible: a mean of at most 1 and 95 of 100 pixels within 2.
    #[must_use]
    pub fn is_invisible(&self) -> bool {
        self.mean <= 1.0 && self.p95 <= 2.0
    }

    /// Whether the pictures are close: a mean of at most 2 and 95 of 100 pixels within 5.
    #[must_use]
    pub fn is_close(&self) -> bool {
        self.mean <= 2.0 && self.p95 <= 5.0
    }

    /// `not visible`, `close` or `visible`.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match (self.is_invisible(), self.is_close()) {
            (true, _) => "not visible",
            (_, true) => "close",
            _ => "visible",
        }
    }

    /// The larger of each measure.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self {
            mean: self.mean.max(other.mean),
            p95: self.p95.max(other.p95),
            white: self.white.max(other.white),
        }
    }

    /// How many times an error at the limit of [close](Self::is_close) this is; at most 1 if it is
    /// close.
    #[must_use]
    pub fn over_close(&self) -> f64 {
        (self.mean / 2.0).max(self.p95 / 5.0)
    }
}

#[cfg(test)]
mod tests {
    use super::ScreenError;

    #[test]
    fn words_follow_both_measures() {
        for (mean, p95, word) in [
            (1.0, 2.0, "not visible"),
            (1.1, 2.0, "close"),
            (0.5, 5.0, "close"),
            (2.0, 5.1, "visible"),
            (2.1, 2.0, "visible"),
            (f64::NAN, 1.0, "visible"),
        ] {
            let error = ScreenError { mean, p95, white: 0.0 };
            assert_eq!(error.word(), word, "{error:?}");
        }
    }
}
