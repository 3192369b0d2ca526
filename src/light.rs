//! Light as spherical harmonic coefficients L_l^m of (4), and windows over its degrees, which
//! reduce the ringing of a truncated light.

use crate::buffer::{Buffer, copied};
use crate::checked_slice::split_mut;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::light;
use crate::mathematics;

/// One channel of distant light: (degree + 1)² coefficients in units of radiance, in the order of
/// [`eigenshade_table::light`].
///
/// The harmonics include the Condon-Shortley phase. z points to the camera, x to the right, y up.
/// [`from_graphics`](Self::from_graphics) converts coefficients of three.js, Filament and cmgen.
///
/// An image is linear in its light. In `f32`, keep coefficients near 1 and scale the image when it
/// is displayed. With a light at 1e-30, the coefficients and pixels of the shipped table are just
/// as exact, but products of its pixels, and components weaker than 1e-8 of the strongest, are
/// subnormal, which is slow on many processors. Scaling by a power of two changes no bit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Light<'a> {
    degree: usize,
    coefficients: &'a [f32],
}

impl<'a> Light<'a> {
    /// Creates a light from its coefficients, which must be finite. The number of coefficients
    /// determines the degree.
    ///
    /// Constants, and lights that a small machine makes for each frame, can be created by
    /// [`from_finite`](Self::from_finite).
    ///
    /// ```
    /// use eigenshade::{Argument, Error, Light};
    ///
    /// // The same from everywhere, and more from the camera.
    /// assert_eq!(Light::new(&[3.5, 0.0, 1.0, 0.0])?.degree(), 1);
    /// let refused = Error::Count { argument: Argument::Light, found: 3 };
    /// assert_eq!(Light::new(&[3.5, 0.0, 1.0]), Err(refused));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are (degree + 1)² coefficients for some degree;
    /// [`Error::NotFinite`] with the index of the first coefficient that is infinite or NaN.
    pub fn new(coefficients: &'a [f32]) -> Result<Self, Error> {
        let light = Self::from_finite(coefficients)?;
        Error::check_finite(Argument::Light, coefficients)?;
        Ok(light)
    }

    /// [`new`](Self::new) in a constant, or without a pass over the coefficients: the caller
    /// promises finite coefficients. An infinite or NaN coefficient spoils more of an image than
    /// its own mode.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] as for `new`.
    #[inline]
    pub const fn from_finite(coefficients: &'a [f32]) -> Result<Self, Error> {
        match degree(coefficients.len()) {
            Ok(degree) => Ok(Self { degree, coefficients }),
            Err(error) => Err(error),
        }
    }

    /// This light without the degrees above `degree`. A light of that degree or less stays as it
    /// is.
    #[must_use]
    pub fn truncated(self, degree: usize) -> Self {
        match self.coefficients.get(..light::count(degree)) {
            Some(coefficients) if degree < self.degree => Self { degree, coefficients },
            _ => self,
        }
    }

    /// Largest degree l.
    #[must_use]
    pub const fn degree(&self) -> usize {
        self.degree
    }

    /// All coefficients.
    #[must_use]
    pub const fn coefficients(&self) -> &'a [f32] {
        self.coefficients
    }
}

/// The degree of a light with this number of coefficients. Inlined, so that the loop is evaluated
/// at compile time where the length is a constant. Elsewhere the lights of the shipped tables need
/// no loop, which would add a tenth to a new light.
#[inline]
pub(crate) const fn degree(found: usize) -> Result<usize, Error> {
    match found {
        100 => return Ok(9),
        169 => return Ok(12),
        _ => {}
    }
    let (mut degree, mut count) = (0, 1);
    while count < found {
        degree += 1;
        count += 2 * degree + 1;
    }
    if count == found { Ok(degree) } else { Err(Error::Count { argument: Argument::Light, found }) }
}

/// Factors that attenuate a light's coefficients, degree by degree.
///
/// A light truncated at some degree rings around its brightest parts and becomes negative, and so
/// does the irradiance of a glossy material. A window blurs the light instead.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Window {
    /// No window: every degree is kept as it is.
    #[default]
    None,
    /// (sin x / x)⁴ with x = π l / width, and 0 from l = width on: the fourth power of the Lanczos
    /// window of P.-P. Sloan, "Stupid Spherical Harmonics (SH) Tricks", 2008.
    ///
    /// A wider window attenuates less: with the width 2 (degree + 1) the last degree of a light of
    /// degree 9 keeps 24 %, with degree + 1 nearly nothing.
    SincFourth {
        /// The degree from which on the factor is 0; above 0, not necessarily an integer.
        width: f32,
    },
}

/// The darkest channel of a picture that [`Window::weakest`] allows, as a share of white.
const DARKEST: f32 = -0.02;
/// The windows that it tries, from weak to strong: their widths, in degrees of the light plus one.
const WIDTHS: [f32; 11] = [4.5, 3.6, 3.0, 2.6, 2.3, 2.0, 1.8, 1.6, 1.4, 1.2, 1.0];

impl Window {
    /// The weakest window that keeps a picture from dark rings: no window if there are none.
    ///
    /// `darkest` draws the picture of the light of this degree under a window, and returns its
    /// smallest channel, exposed, as a share of white. `darkest` is called for no window, then for
    /// stronger windows until it returns at least -0.02, which a display clips to black. If no
    /// window suffices, the window with the largest result is taken. Sloan and Filament search for
    /// a window of a light in this way; a picture needs a weaker one, since its material blurs it.
    ///
    /// ```
    /// use eigenshade::lights::Window;
    ///
    /// // A picture that is dark by a tenth of the second degree's factor.
    /// let window = Window::weakest(2, |window: Window| -0.1 * window.factor(2));
    /// assert!(window.factor(2) <= 0.2 && window.factor(2) > 0.1);
    /// assert_eq!(Window::weakest(2, |_| 0.0), Window::None);
    /// ```
    pub fn weakest(degree: usize, mut darkest: impl FnMut(Self) -> f32) -> Self {
        let unit = (degree + 1) as f32;
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

    /// The factor of a degree, from 0 to 1; 1 for degree 0, which preserves the mean light.
    ///
    /// A width that is not above 0 keeps degree 0 only.
    #[must_use]
    pub fn factor(self, degree: usize) -> f32 {
        let Self::SincFourth { width } = self else { return 1.0 };
        let degree = degree as f32;
        if degree == 0.0 {
            return 1.0;
        }
        let inside = degree < width;
        if !inside {
            return 0.0;
        }
        let x = core::f32::consts::PI * degree * width.recip();
        let (sine, _) = mathematics::sine_and_cosine(x);
        let ratio = sine * x.recip();
        let square = ratio * ratio;
        square * square
    }

    /// Attenuates the coefficients of a light in place, in the order of
    /// [`eigenshade_table::light`].
    ///
    /// Cost: a sine for each degree and a product for each coefficient.
    pub fn apply(self, coefficients: &mut [f32]) {
        let (mut rest, mut degree) = (coefficients, 0);
        while !rest.is_empty() {
            let orders = (2 * degree + 1).min(rest.len());
            let (of_degree, higher) = split_mut(rest, orders);
            let factor = self.factor(degree);
            of_degree.iter_mut().for_each(|coefficient| *coefficient *= factor);
            (rest, degree) = (higher, degree + 1);
        }
    }
}

impl Light<'_> {
    /// The coefficients of this light after a window. `N` must be at least (degree + 1)². Cost: a
    /// sine for each degree.
    ///
    /// ```
    /// use eigenshade::lights::Window;
    /// use eigenshade::Light;
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
    /// let window = Window::SincFourth { width: 4.0 };
    /// let windowed = light.windowed::<4>(window)?;
    /// assert!(windowed[0] == 3.5 && windowed[2] < 1.0);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small.
    pub fn windowed<const N: usize>(&self, window: Window) -> Result<Buffer<f32, N>, Error> {
        let mut windowed = copied(Argument::Light, self.coefficients().iter().copied())?;
        window.apply(&mut windowed);
        Ok(windowed)
    }
}

impl<'a> From<Light<'a>> for Rgb<Light<'a>> {
    #[inline]
    fn from(gray: Light<'a>) -> Self {
        Self::gray(gray)
    }
}

impl Rgb<Light<'_>> {
    /// [`Light::truncated`] in each channel.
    #[must_use]
    pub fn truncated(self, degree: usize) -> Self {
        self.map(|light| light.truncated(degree))
    }

    /// [`Light::windowed`] in each channel; the same errors.
    pub fn windowed<const N: usize>(&self, window: Window) -> Result<Rgb<Buffer<f32, N>>, Error> {
        self.each_ref().try_map(|light| light.windowed::<N>(window))
    }
}

impl<const N: usize> Rgb<Buffer<f32, N>> {
    /// The lights in these buffers; errors as [`Light::from_finite`].
    pub fn lights(&self) -> Result<Rgb<Light<'_>>, Error> {
        self.each_ref().try_map(|channel| Light::from_finite(channel))
    }
}
