//! Noise that is the same on every host and run.
//!
//! Uniform numbers are SplitMix64's (Steele, Lea and Flood, "Fast splittable
//! pseudorandom number generators", OOPSLA 2014), normal ones made of pairs of them
//! by Box and Muller (1958).

use std::f64::consts::TAU;

/// A stream of normal numbers.
#[derive(Clone, Debug)]
pub struct Noise(u64);

impl Noise {
    /// The stream of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number of a normal distribution of mean 0 and variance 1.
    pub fn normal(&mut self) -> f64 {
        let (radius, turn) = (self.uniform(), self.uniform());
        // 1 - radius is above zero.
        (-2.0 * (-radius).ln_1p()).sqrt() * (TAU * turn).cos()
    }

    /// The next number in \[0, 1).
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        word ^= word >> 31;
        (word >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::Noise;

    #[test]
    fn moments_are_those_of_the_normal_distribution() {
        let mut noise = Noise::new(1);
        let count = 100_000;
        let mut moments = [0.0; 5];
        for _ in 0..count {
            let x = noise.normal();
            moments.iter_mut().enumerate().for_each(|(k, sum)| *sum += x.powi(k as i32));
        }
        // Five standard errors of each.
        for (moment, (expected, variance)) in
            moments.into_iter().zip([(1.0, 0.0), (0.0, 1.0), (1.0, 2.0), (0.0, 15.0), (3.0, 96.0)])
        {
            let error = (moment / f64::from(count) - expected).abs();
            assert!(error <= 5.0 * f64::sqrt(variance / f64::from(count)), "{error}");
        }
    }
}
