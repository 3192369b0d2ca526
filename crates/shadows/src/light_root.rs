//! The root R of the covariance of a light's coefficients, E{L Lᵀ} = R Rᵀ.
//!
//! Light that turns over all rotations has a diagonal covariance C_all. Light that is only tilted has
//! not, and deviates little in most directions of its coefficients: R⁻¹ would amplify what lights of other
//! databases have there. So a share s of the lights turns freely, C = (1 - s) C_tilts + s C_all, and
//! |R⁻¹ L|² is at most 1 / s times that of a root of C_all.

use eigenshade_model::database::{Lights, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::parallel;
use eigenshade_model::rotation::Rotation;
use faer::linalg::solvers::SelfAdjointEigen;
use faer::{Mat, Side};
use std::f64::consts::{FRAC_PI_2, TAU};

/// The share s of tilted lights that turn freely. Shares of 0.1 and 0.01 gave 1.15 and 1.44 times the
/// error of two shapes under other tilted lights, and 1.5 and 2.7 times under lights that turn freely.
const FREE: f64 = 0.4;

/// Angles of tilts in an average.
const ANGLES: usize = 8;

/// How lights turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turns {
    /// All rotations are equally likely.
    All,
    /// Up to this angle in radians about any axis across the line of sight. All directions of the line
    /// of sight within the angle are equally likely.
    Tilts(f64),
}

/// A root of the covariance of lights, and its inverse.
pub struct LightRoot {
    /// R, symmetric.
    pub root: Mat<f64>,
    /// R⁻¹.
    pub inverse: Mat<f64>,
}

impl LightRoot {
    /// The root for lights that turn. Each light is scaled to the same mean radiance.
    ///
    /// # Errors
    ///
    /// If a light is dark, none has a coefficient of some degree, or a tilt is not above 0 and at most a
    /// right angle.
    pub fn new(lights: &Lights, turns: Turns) -> Result<Self> {
        let degree = lights.degree;
        let mut lights: Vec<Vec<f64>> = lights.entries.iter().map(Named::luminance).collect();
        for light in &mut lights {
            let ambient = light[0];
            if ambient <= 0.0 {
                return Err(Error::new("a light is dark", "leave it out"));
            }
            light.iter_mut().for_each(|one| *one /= ambient);
        }
        let free = freely_turned(degree, &lights)?;
        let covariance = match turns {
            Turns::All => free,
            Turns::Tilts(most) if most > 0.0 && most <= FRAC_PI_2 => {
                let tilted = tilted(degree, &lights, most);
                Mat::from_fn(free.nrows(), free.ncols(), |a, b| {
                    (1.0 - FREE) * tilted[(a, b)] + FREE * free[(a, b)]
                })
            }
            Turns::Tilts(most) => {
                let what = format!("tilts of {} degrees", most.to_degrees());
                return Err(Error::new(what, "give more than 0 and at most 90"));
            }
        };
        let found = covariance.self_adjoint_eigen(Side::Lower);
        let found =
            found.map_err(|_| Error::new("no eigenvalues of lights", "check the lights"))?;
        let power = |exponent| Self::power(&found, exponent);
        Ok(Self { root: power(0.5), inverse: power(-0.5) })
    }

    fn power(of: &SelfAdjointEigen<f64>, exponent: f64) -> Mat<f64> {
        let vectors = of.U();
        let scaled = Mat::from_fn(vectors.nrows(), vectors.ncols(), |row, k| {
            vectors[(row, k)] * of.S()[k].powf(exponent)
        });
        scaled * vectors.transpose()
    }
}

/// The diagonal covariance of lights over all rotations.
fn freely_turned(last: usize, lights: &[Vec<f64>]) -> Result<Mat<f64>> {
    let mut powers = Vec::new();
    for degree in 0..=last {
        let orders = 2 * degree + 1;
        let of_degree = |light: &Vec<f64>| -> f64 {
            light[degree * degree..][..orders].iter().map(|one| one * one).sum()
        };
        let power: f64 = lights.iter().map(of_degree).sum();
        if power <= 0.0 {
            let what = format!("no light has a coefficient of degree {degree}");
            return Err(Error::new(what, "give other lights, or a lower degree"));
        }
        powers.extend(vec![power / orders as f64; orders]);
    }
    Ok(Mat::from_fn(powers.len(), powers.len(), |a, b| if a == b { powers[a] } else { 0.0 }))
}

/// The covariance of lights over tilts by up to `most`.
///
/// A coefficient of a tilted light is a trigonometric polynomial of the axis's azimuth, of degree
/// 2 `degree`, so 4 `degree` + 1 axes give exact means of products.
fn tilted(degree: usize, lights: &[Vec<f64>], most: f64) -> Mat<f64> {
    let axes = 4 * degree + 1;
    let turned = parallel::map(ANGLES * axes, &(), |k| {
        let share = ((k / axes) as f64 + 0.5) / ANGLES as f64;
        let axis = TAU * (k % axes) as f64 / axes as f64;
        let alpha = (1.0 - share * (1.0 - most.cos())).acos();
        let rotation = Rotation { alpha, beta: axis, gamma: -axis };
        lights.iter().map(|light| rotation.turn(degree, light)).collect::<Vec<_>>()
    });
    let all: Vec<Vec<f64>> = turned.into_iter().flatten().collect();
    let all = Mat::from_fn((degree + 1).pow(2), all.len(), |k, column| all[column][k]);
    let covariance = &all * all.transpose();
    covariance / faer::Scale((ANGLES * axes) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use eigenshade_model::shipped;

    const DEGREE: usize = 5;
    const COUNT: usize = 36;

    fn lights() -> Lights {
        shipped::lights().unwrap().truncated(DEGREE)
    }

    fn product(matrix: &Mat<f64>, light: &[f64]) -> Vec<f64> {
        let row = |k| (0..COUNT).map(|column| matrix[(k, column)] * light[column]).sum();
        (0..COUNT).map(row).collect()
    }

    #[test]
    fn roots_are_those_of_the_covariance() {
        let lights = lights();
        let comparable = |light: &Named| -> Vec<f64> {
            let light = light.luminance();
            light.iter().map(|one| one / light[0]).collect()
        };
        let free = LightRoot::new(&lights, Turns::All).unwrap();
        for (degree, power) in [(0, 1.0), (1, 3.0), (5, 11.0)] {
            let own = degree * degree..(degree + 1) * (degree + 1);
            let of = |light: Vec<f64>| light[own.clone()].iter().map(|x| x * x).sum::<f64>();
            let expected =
                lights.entries.iter().map(|one| of(comparable(one))).sum::<f64>() / power;
            for (a, b) in own.clone().flat_map(|a| (0..COUNT).map(move |b| (a, b))) {
                let expected = if a == b { expected.sqrt() } else { 0.0 };
                assert!((free.root[(a, b)] - expected).abs() < 1e-12, "{a} {b}");
            }
        }
        // Tilts at random, by rejection, instead of rings of axes.
        let most: f64 = 0.7;
        let tilts = LightRoot::new(&lights, Turns::Tilts(most)).unwrap();
        let mut sum = Mat::<f64>::zeros(COUNT, COUNT);
        let mut count = 0.0;
        for k in 0..4000_u32 {
            let [x, y] = [0.754_877_666, 0.569_840_296]
                .map(|step: f64| 2.0 * (0.5 + step * f64::from(k)).fract() - 1.0);
            // The cosine of the angle is linear in the square of the distance in a disc.
            let square = x * x + y * y;
            if square > 1.0 {
                continue;
            }
            let alpha = (1.0 - square * (1.0 - most.cos())).acos();
            let rotation = Rotation { alpha, beta: y.atan2(x), gamma: -y.atan2(x) };
            count += 1.0;
            for light in &lights.entries {
                let light = rotation.turn(DEGREE, &comparable(light));
                for (a, b) in (0..COUNT).flat_map(|a| (0..COUNT).map(move |b| (a, b))) {
                    sum[(a, b)] += light[a] * light[b];
                }
            }
        }
        let found = &tilts.root * &tilts.root;
        let of_free = &free.root * &free.root;
        let mut worst: f64 = 0.0;
        for (a, b) in (0..COUNT).flat_map(|a| (0..COUNT).map(move |b| (a, b))) {
            let expected = (1.0 - FREE) * sum[(a, b)] / count + FREE * of_free[(a, b)];
            let scale = (of_free[(a, a)] * of_free[(b, b)]).sqrt();
            worst = worst.max((found[(a, b)] - expected).abs() / scale);
        }
        println!("covariance: {worst:e}");
        assert!(worst < 0.01);
        let unit = &tilts.root * &tilts.inverse;
        for (a, b) in (0..COUNT).flat_map(|a| (0..COUNT).map(move |b| (a, b))) {
            assert!((unit[(a, b)] - f64::from(u8::from(a == b))).abs() < 1e-10, "{a} {b}");
        }
        // The inverse is bounded.
        for k in 0..100_u32 {
            let light: Vec<f64> =
                (0..COUNT).map(|j| f64::from(k * k + 7 * j as u32).sin()).collect();
            let [tilted, free] = [&tilts, &free].map(|one| -> f64 {
                product(&one.inverse, &light).iter().map(|one| one * one).sum()
            });
            assert!(tilted <= free / FREE * (1.0 + 1e-9), "{tilted} {free}");
        }
    }

    #[test]
    fn bad_lights_are_refused() {
        for most in [0.0, -1.0, 2.0, f64::NAN] {
            assert!(LightRoot::new(&lights(), Turns::Tilts(most)).is_err());
        }
        let mut dark = lights();
        dark.entries[2].rgb.iter_mut().for_each(|channel| channel[0] = 0.0);
        assert!(LightRoot::new(&dark, Turns::All).is_err());
        let mut flat = lights();
        flat.entries
            .iter_mut()
            .flat_map(|one| &mut one.rgb)
            .for_each(|light| light[25..].fill(0.0));
        assert!(LightRoot::new(&flat, Turns::Tilts(0.5)).is_err());
    }
}
