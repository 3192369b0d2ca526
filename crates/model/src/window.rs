//! Windows over the degrees of a light, which reduce the ringing of a truncated light: see the
//! runtime's `Window`.

use std::f64::consts::PI;

/// Factors that attenuate a light's coefficients, degree by degree.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Window {
    /// Every degree is kept as it is.
    #[default]
    None,
    /// (sin x / x)⁴ with x = π l / width, and 0 from l = width on.
    SincFourth {
        /// The degree from which on the factor is 0; above 0, not necessarily an integer.
        width: f64,
    },
}

/// The darkest channel of a picture that [`Window::weakest`] allows, as a share of white.
const DARKEST: f64 = -0.02;
/// The windows that it tries, from weak to strong: their widths, in degrees of the light plus one.
const WIDTHS: [f64; 11] = [4.5, 3.6, 3.0, 2.6, 2.3, 2.0, 1.8, 1.6, 1.4, 1.2, 1.0];

impl Window {
    /// The weakest window that keeps a picture from dark rings.
    ///
    /// `darkest` draws the picture of the light of this degree under a window, and returns its
    /// smallest channel, exposed, as a share of white. `darkest` is called for no window, then for
    /// stronger windows until it returns at least -0.02. If no window suffices, the window with the
    /// largest result is taken.
    pub fn weakest(degree: usize, mut darkest: impl FnMut(Self) -> f64) -> Self {
        let unit = (degree + 1) as f64;
        let mut best = (Self::None, darkest(Self::None));
        for width in WIDTHS {
            if best.1 >= DARKEST {
                break;
            }
            let window = Self::SincFourth { width: width * unit };
            let found = darkest(window);
            if found > best.1 {
                best = (window, found);
            }
        }
        best.0
    }

    /// The factor of a degree, from 0 to 1; 1 for degree 0.
    #[must_use]
    pub fn factor(self, degree: usize) -> f64 {
        let degree = degree as f64;
        match self {
            Self::SincFourth { width } if degree > 0.0 => {
                let x = PI * degree / width;
                if degree < width { (x.sin() / x).powi(4) } else { 0.0 }
            }
            _ => 1.0,
        }
    }

    /// Attenuates the coefficients of a light, in the order of [`eigenshade_table::light`].
    pub fn apply(self, light: &mut [f64]) {
        let degrees = (0..).flat_map(|l| std::iter::repeat_n(l, 2 * l + 1));
        light.iter_mut().zip(degrees).for_each(|(value, l)| *value *= self.factor(l));
    }
}
