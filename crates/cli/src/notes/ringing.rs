//! Detects images that show only the ringing of a light truncated at its degree.

/// The threshold on how far an image falls below zero, as a share of its largest value.
const SHARE: f64 = 1.0 / 3.0;

/// The images seen so far. No light and no material makes irradiance negative, but truncated series
/// oscillate about the values that they approximate. The series of a highlight falls below zero by
/// 0.13 of the highlight's height, which is the first swing of a point light. If an image falls
/// below zero by a third of its peak, then its peak is not much larger than such a swing. This
/// happens when all light is behind the object.
#[derive(Clone, Debug, Default)]
pub struct Ringing {
    images: usize,
    found: usize,
    /// The name, least value and largest value of the most negative image.
    worst: Option<(String, f64, f64)>,
}

impl Ringing {
    /// Records the least and the largest irradiance of one image.
    pub fn see(&mut self, name: impl FnOnce() -> String, least: f64, largest: f64) {
        self.images += 1;
        if least < 0.0 && -least > SHARE * largest {
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
        Some(format!(
            "note: {found} of {images} images fall far below zero, like that of {name}, from \
             {least:.2e} to {largest:.2e}: their peak is the ringing of a cut series, as where all \
             light is behind the object; do not take it for light"
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::Ringing;

    #[test]
    fn images_about_zero_are_noted() {
        let mut images = Ringing::default();
        for (least, largest) in [(0.0, 1.0), (-0.3, 1.0), (0.0, 0.0)] {
            images.see(|| unreachable!(), least, largest);
        }
        assert_eq!(images.note(), None);
        images.see(|| "a".into(), -0.4, 1.0);
        images.see(|| "b".into(), -1.0, -0.5);
        let note = images.note().unwrap();
        assert!(note.starts_with("note: 2 of 5 images") && note.contains("of b, from -1.00e0"));
    }
}
