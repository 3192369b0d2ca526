//! Windows of a light, and clamping of what is below zero.

use crate::tolerances;
use eigenshade::lights::Window;
use eigenshade::screen::NegativePolicy;
use eigenshade::{Error, Light};
use eigenshade_model::window::Window as OfHost;

/// A factor of a window in f32: a sine, a division, two squares.
const WINDOW_F32: f64 = 5e-7;

/// How far a point of light to degree 9 goes below zero through a window of width 10, of its peak;
/// without one it is 0.13 or more.
const WINDOW_RINGING: f64 = 0.01;

/// The documented factors of degree 9 at widths 20 and 10: 24 %, "nearly nothing".
const WINDOW_STATED: [f32; 2] = [0.24, 1e-3];

/// sin(x) / x by its product over doubled angles: cos(x/2) cos(x/4) ...
fn sinc(x: f64) -> f64 {
    (1..50).map(|k| (x / 2f64.powi(k)).cos()).product()
}

#[test]
fn factors_are_fourth_powers_of_sinc() {
    for width in [0.5, 3.0, 10.0, 12.5, 20.0, 1e3] {
        for degree in 0..=20usize {
            let expected = match degree {
                0 => 1.0,
                _ if degree as f64 >= width => 0.0,
                _ => sinc(std::f64::consts::PI * degree as f64 / width).powi(4),
            };
            let of_host = OfHost::SincFourth { width }.factor(degree);
            assert!((of_host - expected).abs() <= tolerances::SPECIAL_LOW, "{degree}, {width}");
            let found = Window::SincFourth { width: width as f32 }.factor(degree);
            let apart = (f64::from(found) - expected).abs();
            assert!(apart <= WINDOW_F32, "{degree}, {width}: {apart:e}");
            assert_eq!(Window::None.factor(degree), 1.0);
        }
    }
    // As documented for degree 9.
    let last = |width: f32| Window::SincFourth { width }.factor(9);
    let [wide, nothing] = WINDOW_STATED;
    assert!(
        (last(20.0) - wide).abs() < 0.005 && last(10.0) < nothing,
        "{} {}",
        last(20.0),
        last(10.0)
    );
    for width in [0.0f32, -1.0, f32::NAN] {
        let window = Window::SincFourth { width };
        assert_eq!((window.factor(0), window.factor(1)), (1.0, 0.0));
    }
}

/// Each coefficient takes the factor of its own degree.
#[test]
fn lights_pass_windows_degree_by_degree() {
    let coefficients: Vec<f32> = (0..100u8).map(|k| 1.0 + f32::from(k)).collect();
    let light = Light::new(&coefficients).expect("100 coefficients");
    let window = Window::SincFourth { width: 11.0 };
    let windowed = light.windowed::<100>(window).expect("room");
    let places = eigenshade_table::light::indices(9);
    for ((l, _), (found, given)) in places.zip(windowed.iter().zip(&coefficients)) {
        assert_eq!(*found, given * window.factor(l));
    }
    assert_eq!(light.windowed::<100>(Window::None).expect("room").as_slice(), coefficients);
    assert!(matches!(light.windowed::<99>(window), Err(Error::Capacity { needed: 100, .. })));
}

/// A sun to degree 9 rings below zero; through a window of that degree hardly.
#[test]
fn a_window_takes_the_ringing() {
    // A sun at +z: L_l^0 = √((2l+1)/4π), all others zero.
    let mut sun = [0.0f32; 100];
    for l in 0..10usize {
        sun[l * l + l] = ((2 * l + 1) as f32 / (4.0 * std::f32::consts::PI)).sqrt();
    }
    let least = |coefficients: &[f32]| {
        let radiance = |k: i32| {
            let z = f64::from(k) / 1000.0;
            // Legendre's polynomials by Bonnet's recurrence.
            let (mut before, mut legendre, mut sum) = (0.0, 1.0, 0.0);
            for l in 0..10usize {
                let norm = ((2 * l + 1) as f64 / (4.0 * std::f64::consts::PI)).sqrt();
                sum += f64::from(coefficients[l * l + l]) * norm * legendre;
                let degree = l as f64;
                let next = ((2.0 * degree + 1.0) * z * legendre - degree * before) / (degree + 1.0);
                (before, legendre) = (legendre, next);
            }
            sum
        };
        (-1000..=1000).map(radiance).fold(f64::INFINITY, f64::min) / radiance(1000)
    };
    let light = Light::new(&sun).expect("100 coefficients");
    let windowed = light.windowed::<100>(Window::SincFourth { width: 10.0 }).expect("room");
    let (before, after) = (least(&sun), least(&windowed));
    println!("{before} {after}");
    assert!(before < -0.1 && after > -WINDOW_RINGING, "{before} {after}");
}

#[test]
fn negatives_are_kept_or_clamped_and_told() {
    let image = [0.5f32, -0.25, f32::NAN, 2.0, -0.0];
    for (negatives, second) in [(NegativePolicy::Kept, -0.25), (NegativePolicy::Clamped, 0.0)] {
        let mut changed = image;
        assert_eq!(negatives.apply(&mut changed), Some(-0.25));
        assert_eq!((changed[0], changed[1], changed[3]), (0.5, second, 2.0));
        assert!(changed[2].is_nan());
        assert_eq!(negatives.apply::<f32>(&mut []), None);
    }
    assert_eq!(NegativePolicy::default(), NegativePolicy::Kept);
}

#[test]
fn integers_are_clamped_like_floats() {
    for (negatives, expected) in
        [(NegativePolicy::Kept, [5, -3, 0]), (NegativePolicy::Clamped, [5, 0, 0])]
    {
        let mut image = [5i32, -3, 0];
        assert_eq!(negatives.apply(&mut image), Some(-3));
        assert_eq!(image, expected);
        assert_eq!(negatives.of(i32::MIN).min(0), if expected[1] < 0 { i32::MIN } else { 0 });
    }
}
