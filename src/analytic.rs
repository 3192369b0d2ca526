//! Lights that a formula describes: ambient, sky and ground, discs and directions.

use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::light;
use crate::light::{Light, Window, degree};
use crate::mathematics;
use core::f32::consts::{FRAC_PI_2, PI, SQRT_2};

/// One channel of a light made of formulas, of the degree with `N` coefficients.
///
/// Directions point from the object to the light, in the camera's frame, and may have any length.
/// A window keeps small lights from ringing.
///
/// ```
/// use eigenshade::lights::{AnalyticLight, Window};
///
/// // A sky above a darker ground, and a lamp from the upper left, 20 degrees in radius.
/// let light = AnalyticLight::<100>::dark()?
///     .hemisphere([0.0, 1.0, 0.0], 1.0, 0.2)?
///     .disc([-1.0, 1.0, 1.0], 0.35, 5.0)?
///     .windowed(Window::SincFourth { width: 20.0 });
/// assert_eq!(light.light()?.degree(), 9);
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnalyticLight<const N: usize> {
    coefficients: [f32; N],
}

impl<const N: usize> AnalyticLight<N> {
    /// No light.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless `N` is (degree + 1)² for some degree.
    pub fn dark() -> Result<Self, Error> {
        degree(N)?;
        Ok(Self { coefficients: [0.0; N] })
    }

    /// Adds the same radiance from everywhere.
    #[must_use]
    pub fn ambient(mut self, radiance: f32) -> Self {
        if let Some(mean) = self.coefficients.first_mut() {
            // 1 / Y_0^0 is 2 √π.
            *mean += radiance * (PI * core::f32::consts::FRAC_2_SQRT_PI);
        }
        self
    }

    /// Adds the radiance of a sky in the half of directions around `up`, and of a ground in the
    /// other; errors as [`disc`](Self::disc).
    pub fn hemisphere(self, up: [f32; 3], sky: f32, ground: f32) -> Result<Self, Error> {
        self.ambient(ground).disc(up, FRAC_PI_2, sky - ground)
    }

    /// Adds a disc of constant radiance around a direction, with an angular radius in radians: the
    /// sun's is 0.00465.
    ///
    /// # Errors
    ///
    /// [`Error::Direction`] if the direction has no length or the radius is not above 0 and at most
    /// π.
    pub fn disc(self, direction: [f32; 3], radius: f32, radiance: f32) -> Result<Self, Error> {
        if !(radius > 0.0 && radius <= PI) {
            return Err(Error::Direction);
        }
        let (sine, cosine) = mathematics::sine_and_cosine(radius);
        // 2π times the integral of P_l from the cosine to 1: (1 - cos²) P_l'(cos) / (l (l + 1)).
        let scale = (2.0 * PI) * radiance;
        let square = sine * sine;
        let [mut before, mut now] = [1.0, cosine];
        let [mut slope_before, mut slope] = [0.0, 1.0];
        let half = mathematics::sine_and_cosine(0.5 * radius).0;
        self.along(direction, |l| {
            if l == 0 {
                // 1 - cos = 2 sin² of half the radius.
                return scale * (half * half + half * half);
            }
            let factor = scale * square * slope * ((l * (l + 1)) as f32).recip();
            let [odd, whole] = [((2 * l + 1) as f32), (l as f32)];
            let next_slope = slope_before + odd * now;
            let next = (odd * cosine * now - whole * before) * ((l + 1) as f32).recip();
            (before, now, slope_before, slope) = (now, next, slope, next_slope);
            factor
        })
    }

    /// Adds light from a single direction, which gives this irradiance on a surface that faces it.
    ///
    /// # Errors
    ///
    /// [`Error::Direction`] if the direction has no length.
    pub fn directional(self, direction: [f32; 3], irradiance: f32) -> Result<Self, Error> {
        self.along(direction, |_| irradiance)
    }

    /// Adds factor(l) Y_l^m(direction); `factor` is called for l = 0, 1, ... in this order.
    fn along(
        mut self,
        direction: [f32; 3],
        mut factor: impl FnMut(usize) -> f32,
    ) -> Result<Self, Error> {
        let [x, y, z] = direction;
        let square = x * x + y * y + z * z;
        if !(square.is_finite() && square >= 1e-37) {
            return Err(Error::Direction);
        }
        let scale = mathematics::inverse_root(square);
        let mut harmonics = [0.0; N];
        add_harmonics(&mut harmonics, [x * scale, y * scale, z * scale], 1.0)?;
        let mut pairs = self.coefficients.iter_mut().zip(&harmonics);
        for l in 0..=degree(N)? {
            let factor = factor(l);
            for (to, &harmonic) in pairs.by_ref().take(2 * l + 1) {
                *to += factor * harmonic;
            }
        }
        Ok(self)
    }

    /// Multiplies the light.
    #[must_use]
    pub fn scaled(mut self, factor: f32) -> Self {
        self.coefficients.iter_mut().for_each(|coefficient| *coefficient *= factor);
        self
    }

    /// Adds another light, of this degree or less.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if the other light has a higher degree.
    pub fn plus(mut self, other: &Light<'_>) -> Result<Self, Error> {
        let needed = other.coefficients().len();
        if needed > N {
            return Err(Error::Capacity { argument: Argument::Light, needed, capacity: N });
        }
        for (to, &from) in self.coefficients.iter_mut().zip(other.coefficients()) {
            *to += from;
        }
        Ok(self)
    }

    /// Applies a window.
    #[must_use]
    pub fn windowed(mut self, window: Window) -> Self {
        window.apply(&mut self.coefficients);
        self
    }

    /// The light.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`] if a coefficient is infinite or NaN.
    pub fn light(&self) -> Result<Light<'_>, Error> {
        Light::new(&self.coefficients)
    }
}

/// The same in color. Radiances and irradiances have three channels.
///
/// ```
/// use eigenshade::lights::AnalyticLight;
/// use eigenshade::Rgb;
///
/// let light = Rgb::<AnalyticLight<100>>::dark()?
///     .hemisphere([0.0, 1.0, 0.0], [0.3, 0.5, 1.0], [0.2, 0.2, 0.1])?
///     .disc([1.0, 1.0, 1.0], 0.2, [9.0, 8.0, 6.0])?;
/// assert!(light.lights()?.r.coefficients()[0] > 0.0);
/// # Ok::<(), eigenshade::Error>(())
/// ```
impl<const N: usize> Rgb<AnalyticLight<N>> {
    /// [`AnalyticLight::dark`]; the same errors.
    pub fn dark() -> Result<Self, Error> {
        AnalyticLight::dark().map(Self::gray)
    }

    /// [`AnalyticLight::ambient`].
    #[must_use]
    pub fn ambient(self, radiance: [f32; 3]) -> Self {
        self.zip(radiance.into()).map(|(light, radiance)| light.ambient(radiance))
    }

    /// [`AnalyticLight::hemisphere`]; the same errors.
    pub fn hemisphere(self, up: [f32; 3], sky: [f32; 3], ground: [f32; 3]) -> Result<Self, Error> {
        let radiances = Rgb::from(sky).zip(ground.into());
        self.zip(radiances).try_map(|(light, (sky, ground))| light.hemisphere(up, sky, ground))
    }

    /// [`AnalyticLight::disc`]; the same errors.
    pub fn disc(self, direction: [f32; 3], radius: f32, radiance: [f32; 3]) -> Result<Self, Error> {
        let channels = self.zip(radiance.into());
        channels.try_map(|(light, radiance)| light.disc(direction, radius, radiance))
    }

    /// [`AnalyticLight::directional`]; the same errors.
    pub fn directional(self, direction: [f32; 3], irradiance: [f32; 3]) -> Result<Self, Error> {
        let channels = self.zip(irradiance.into());
        channels.try_map(|(light, irradiance)| light.directional(direction, irradiance))
    }

    /// [`AnalyticLight::scaled`].
    #[must_use]
    pub fn scaled(self, factor: f32) -> Self {
        self.map(|light| light.scaled(factor))
    }

    /// [`AnalyticLight::plus`]; the same errors.
    pub fn plus<'l>(self, other: impl Into<Rgb<Light<'l>>>) -> Result<Self, Error> {
        self.zip(other.into()).try_map(|(light, other)| light.plus(&other))
    }

    /// [`AnalyticLight::windowed`].
    #[must_use]
    pub fn windowed(self, window: Window) -> Self {
        self.map(|light| light.windowed(window))
    }

    /// [`AnalyticLight::light`] in each channel; the same errors.
    pub fn lights(&self) -> Result<Rgb<Light<'_>>, Error> {
        self.each_ref().try_map(AnalyticLight::light)
    }
}

/// Adds weight Y_l^m(direction) to each coefficient of a light. The direction is a unit vector.
/// N_l^m P_l^m(z) / (-sin θ)^m is a polynomial in z, by the three-term recurrence of the normalized
/// functions. Cost: two roots for each degree and order.
pub(crate) fn add_harmonics(
    coefficients: &mut [f32],
    [x, y, z]: [f32; 3],
    weight: f32,
) -> Result<(), Error> {
    let degree = degree(coefficients.len())?;
    let ratio = |numerator: usize, denominator: usize| {
        mathematics::square_root((numerator as f32) * (denominator as f32).recip())
    };
    let mut add = |l: usize, order: isize, amount: f32| {
        if let Some(to) = coefficients.get_mut(light::position(l, order)) {
            *to += amount;
        }
    };
    // N_m^m: the product of √((2k + 1) / 2k), over √(4π).
    let mut square = 0.25 / PI;
    // Re and -Im of (x + iy)^m, with the phase (-1)^m in the cosine.
    let [mut cosine, mut sine] = [weight, 0.0];
    for m in 0..=degree {
        let root = if m == 0 { 1.0 } else { SQRT_2 };
        let plus = root * if m % 2 == 0 { cosine } else { -cosine };
        let minus = -root * sine;
        let (mut before, mut now) = (0.0, mathematics::square_root(square));
        for l in m..=degree {
            if l > m {
                let (product, last) = (l * l - m * m, l - 1);
                let factor = ratio(4 * l * l - 1, product);
                let share = ratio(last * last - m * m, (4 * last * last).max(2) - 1);
                (before, now) = (now, factor * (z * now - share * before));
            }
            add(l, m.cast_signed(), now * plus);
            if m > 0 {
                add(l, -m.cast_signed(), now * minus);
            }
        }
        [cosine, sine] = [cosine * x - sine * y, cosine * y + sine * x];
        square = square * ((2 * m + 3) as f32) * ((2 * m + 2) as f32).recip();
    }
    Ok(())
}
