//! Shades a normal and its mirror images together, which have the same polynomials.
//!
//! With w = n_x + i n_y, a normal to the left has -w̄ in place of w, one below w̄, and the opposite
//! one -w. So four sums give four irradiances: those of Re w^m and of Im w^m, for even and for odd m.

use crate::basis::Basis;
use crate::checked_slice::{part, split};
use crate::color::Rgb;
use crate::float;
use crate::index::layout::MAX_DEGREE;
use crate::known_table::{KnownTable, at};
use crate::normal::Normal;
use crate::scene::Scene;
use crate::shade::{argument, doubled, values};

/// What a normal and its mirror images share, in all channels: the arguments of the polynomials, and
/// the powers of w from the first on.
#[derive(Clone, Copy, Debug)]
pub struct Mirrored {
    t: [f32; 1],
    u: [f32; 1],
    powers: [[f32; 2]; MAX_DEGREE],
}

/// The sums of even and of odd azimuths, each of real and of imaginary parts.
type Sums = [[f32; 2]; 2];

impl Mirrored {
    /// Of one of the four normals.
    #[must_use]
    pub fn new(Normal { x, y, z }: Normal) -> Self {
        let t = argument(z);
        let mut power = [1.0, 0.0];
        let powers = [(); MAX_DEGREE].map(|()| {
            let [real, imaginary] = power;
            power = [
                float::add_product(real * x, -imaginary, y),
                float::add_product(imaginary * x, real, y),
            ];
            power
        });
        Self { t: [t], u: [doubled(t)], powers }
    }

    #[inline(always)]
    fn value(&self, terms: &[f32]) -> f32 {
        let [value] = values(terms, [&self.t, &self.u]);
        value
    }

    /// Adds azimuth `m` > 0.
    #[inline(always)]
    fn add(&self, m: usize, plus: &[f32], minus: &[f32], mut sums: Sums) -> Sums {
        let [real, imaginary] =
            m.checked_sub(1).and_then(|m| self.powers.get(m)).unwrap_or(&[0.0; 2]);
        let [even, odd] = &mut sums;
        let [of_real, of_imaginary] = if m.is_multiple_of(2) { even } else { odd };
        *of_real = float::add_product(*of_real, self.value(plus), *real);
        *of_imaginary = float::add_product(*of_imaginary, self.value(minus), *imaginary);
        sums
    }

    /// The polynomial of azimuth 0 of a scene of `B`.
    #[inline(always)]
    #[must_use]
    pub fn pole<B: KnownTable<Basis<'static>>, const N: usize>(&self, terms: &[f32; N]) -> Sums {
        [[self.value(part(terms, ..const { B::BASIS.length(0) })), 0.0], [0.0; 2]]
    }

    /// Adds azimuth `M` > 0 of a scene of `B`.
    #[inline(always)]
    #[must_use]
    pub fn azimuth<B: KnownTable<Basis<'static>>, const M: usize, const N: usize>(
        &self,
        terms: &[f32; N],
        sums: Sums,
    ) -> Sums {
        let length = const { B::BASIS.length(M) };
        let start = const { at(B::BASIS.parts.azimuths, M).start as usize };
        let [plus, minus] = [start, start + length].map(|start| part(terms, start..start + length));
        self.add(M, plus, minus, sums)
    }

    /// The irradiances of the normal and its mirror images.
    #[inline(always)]
    #[must_use]
    pub fn images([[even, even_i], [odd, odd_i]]: Sums) -> [f32; 4] {
        [
            (even + odd) + (even_i + odd_i),
            (even - odd) - (even_i - odd_i),
            (even + odd) - (even_i + odd_i),
            (even - odd) + (even_i - odd_i),
        ]
    }
}

impl Normal {
    /// The normal (x, y, z), and its mirror images (-x, y, z), (x, -y, z) and (-x, -y, z).
    #[must_use]
    pub fn mirrored(self) -> [Self; 4] {
        let Self { x, y, z } = self;
        [[x, y], [-x, y], [x, -y], [-x, -y]].map(|[x, y]| Self { x, y, z })
    }
}

impl<B: AsRef<[f32]>> Scene<'_, B> {
    /// The irradiances of [`Normal::mirrored`], at little more than the cost of one normal.
    #[must_use]
    pub fn shade_mirrored(&self, normal: Normal) -> [f32; 4] {
        let mirrored = Mirrored::new(normal);
        let polynomials = self.descent();
        let mut sums = [[mirrored.value(polynomials.pole), 0.0], [0.0; 2]];
        let mut around = polynomials.around;
        for (&length, m) in polynomials.lengths.iter().zip(1..) {
            let (plus, rest) = split(around, length.into());
            let (minus, rest) = split(rest, length.into());
            around = rest;
            sums = mirrored.add(m, plus, minus, sums);
        }
        Mirrored::images(sums)
    }
}

/// The colors of the images, from the images in each channel.
#[inline]
#[must_use]
pub fn by_image<T>(Rgb { r, g, b }: Rgb<[T; 4]>) -> [Rgb<T>; 4] {
    let ([r, r_left, r_below, r_opposite], [g, g_left, g_below, g_opposite]) = (r, g);
    let [b, b_left, b_below, b_opposite] = b;
    [
        Rgb::new(r, g, b),
        Rgb::new(r_left, g_left, b_left),
        Rgb::new(r_below, g_below, b_below),
        Rgb::new(r_opposite, g_opposite, b_opposite),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_are_shaded_as_normals() {
        let mut state = 1_u32;
        let numbers: [f32; 200] = core::array::from_fn(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f32::from((state >> 16) as u16 as i16) / 32_768.0
        });
        let lengths_of: [&[u16]; 5] =
            [&[], &[3], &[9, 8], &[5, 5, 4, 0], &[13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1]];
        for lengths in lengths_of {
            let scene = Scene { lengths, buffer: numbers };
            for [x, y, z] in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.36, 0.48, 0.8], [0.6, 0.8, 0.0]]
            {
                let normal = Normal { x, y, z };
                let found = scene.shade_mirrored(normal);
                for (found, image) in found.into_iter().zip(normal.mirrored()) {
                    assert!((found - scene.shade(image)).abs() < 1e-5, "{lengths:?}");
                }
            }
        }
    }
}
