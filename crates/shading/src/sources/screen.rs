//! Pictures as a display shows them, and how far one is from another.

use crate::sources::sphere::{Picture, Sphere};
use eigenshade::Rgb;
use eigenshade::screen::{Display, Exposure, Meter, Tone};
use eigenshade_model::screen::ScreenError;
use eigenshade_model::window::Window;
use palette::color_difference::Ciede2000;
use palette::{IntoColor, Lab, Srgb};

/// The number of pixels that are metered: each normal counts as many as its weight is of them.
const METERED: f64 = 10_000.0;
/// The display of `eigenshade render`.
static DISPLAY: Display = Display::new(Tone::Linear);

/// The metered exposure of a sphere's picture, as `eigenshade render` chooses it; 1 if it is black.
#[must_use]
pub fn exposure(picture: &Picture, sphere: &Sphere) -> Exposure {
    let mut meter = Meter::default();
    for (k, weight) in sphere.weights.iter().enumerate() {
        let pixel = pixel(picture, k);
        (0..(METERED * weight).round() as usize).for_each(|_| meter.add(pixel));
    }
    meter.exposure().unwrap_or_default()
}

/// The picture that `drawn` makes with the window that `eigenshade render` chooses.
///
/// # Errors
///
/// The errors of `drawn`.
pub fn windowed<E>(
    degree: usize,
    sphere: &Sphere,
    mut drawn: impl FnMut(Window) -> Result<Picture, E>,
) -> Result<Picture, E> {
    let plain = drawn(Window::None)?;
    let exposure = f64::from(exposure(&plain, sphere).factor());
    let (mut last, mut fault) = ((Window::None, plain), None);
    let window = Window::weakest(degree, |window| {
        if window != Window::None {
            match drawn(window) {
                Ok(picture) => last = (window, picture),
                Err(error) => fault = Some(error),
            }
        }
        exposure * last.1.iter().flatten().fold(f64::INFINITY, |least, &value| least.min(value))
    });
    match fault {
        Some(error) => Err(error),
        None if window == last.0 => Ok(last.1),
        None => drawn(window),
    }
}

/// The factors of a window for each degree of a light.
#[must_use]
pub fn factors(window: Window, degree: usize) -> Vec<f64> {
    (0..=degree).map(|degree| window.factor(degree)).collect()
}

/// A picture that others are compared with.
pub struct Reference {
    picture: Picture,
    exposure: Exposure,
    shown: Vec<Lab>,
}

/// The errors of a picture: of all pixels, and of the pixels that the reference shows below white
/// in every channel, since clipping hides errors of the others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Over all pixels.
    pub all: ScreenError,
    /// Over the pixels below white.
    pub below: ScreenError,
}

impl Reference {
    /// The picture at the normals of a sphere.
    #[must_use]
    pub fn new(picture: Picture, sphere: &Sphere) -> Self {
        let exposure = exposure(&picture, sphere);
        Self { shown: shown(&picture, exposure), exposure, picture }
    }

    /// The errors of a picture at the same normals, shown with the exposure of the reference.
    #[must_use]
    pub fn errors(&self, found: &Picture, sphere: &Sphere) -> Errors {
        let shown = shown(found, self.exposure);
        let apart = |k: usize| {
            let [found, expected] = [found, &self.picture].map(|one| self.clipped(one, k));
            let square = |c: usize| (found[c] - expected[c]).powi(2);
            let square = (square(0) + square(1) + square(2)) / 3.0;
            (f64::from(shown[k].difference(self.shown[k])), square, sphere.weights[k])
        };
        let is_below = |k: &usize| self.clipped(&self.picture, *k).iter().all(|&one| one < 1.0);
        let count = sphere.weights.len();
        Errors {
            all: summed((0..count).map(apart).collect()),
            below: summed((0..count).filter(is_below).map(apart).collect()),
        }
    }

    /// A pixel in linear light, exposed and clipped.
    fn clipped(&self, picture: &Picture, k: usize) -> [f64; 3] {
        let exposed = |c: usize| f64::from(self.exposure.factor()) * picture[c][k];
        // A number that is not finite stays so.
        [0, 1, 2].map(|c| if exposed(c).is_nan() { f64::NAN } else { exposed(c).clamp(0.0, 1.0) })
    }
}

/// The error of pixels, each with its difference of color, its square in linear light and its
/// weight.
fn summed(mut pixels: Vec<(f64, f64, f64)>) -> ScreenError {
    pixels.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = pixels.iter().map(|(.., weight)| weight).sum();
    if total == 0.0 {
        return ScreenError::default();
    }
    let (mut error, mut counted) = (ScreenError::default(), 0.0);
    for (difference, square, weight) in pixels {
        error.mean += weight * difference / total;
        error.white += weight * square / total;
        if counted < 0.95 * total {
            error.p95 = difference;
        }
        counted += weight;
    }
    ScreenError { white: error.white.sqrt(), ..error }
}

fn pixel(picture: &Picture, k: usize) -> Rgb<f32> {
    [0, 1, 2].map(|c: usize| picture[c][k] as f32).into()
}

/// The pixels of the display.
fn shown(picture: &Picture, exposure: Exposure) -> Vec<Lab> {
    let shown = |k: usize| {
        let Rgb { r, g, b } = DISPLAY.rgb888(exposure.of(pixel(picture, k)));
        Srgb::new(r, g, b).into_format::<f32>().into_color()
    };
    (0..picture[0].len()).map(shown).collect()
}
