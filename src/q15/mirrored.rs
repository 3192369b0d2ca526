//! Shades a normal and its mirror images together, as in floats: see [`crate::shade::mirrored`].

use super::arithmetic::{self, argument, dot, halved, of_value, product};
use super::scene::{Scene, value};
use super::{Basis, Normal, Q15};
use crate::checked_slice::{part, split_row};
use crate::index::layout::MAX_DEGREE;
use crate::known_table::{KnownTable, at};

/// What a normal and its mirror images share, in all channels: the argument of the polynomials, and
/// the powers of n_x + i n_y from the first on.
#[derive(Clone, Copy, Debug)]
pub struct Mirrored {
    t: i32,
    powers: [[i32; 2]; MAX_DEGREE],
}

/// The sums of even and of odd azimuths, each of real and of imaginary parts.
type Sums = [[i32; 2]; 2];

impl Mirrored {
    /// Of one of the four normals.
    #[must_use]
    pub fn new(Normal { x, y, z }: Normal) -> Self {
        let mut next = [halved(x), halved(y)];
        let powers = [(); MAX_DEGREE].map(|()| {
            let power @ [cosine, sine] = next;
            next = [dot(cosine, x, -sine, y), dot(cosine, y, sine, x)];
            power
        });
        Self { t: argument(z), powers }
    }

    /// The polynomial of azimuth 0.
    #[inline(always)]
    fn start(&self, polynomial: &[i32]) -> Sums {
        let (last, first) = polynomial.split_last().unwrap_or((&0, &[]));
        [[product(value(first, self.t), self.t).wrapping_add(of_value(*last)), 0], [0; 2]]
    }

    /// Adds azimuth `m` > 0.
    #[inline(always)]
    fn add(&self, m: usize, plus: &[i32], minus: &[i32], mut sums: Sums) -> Sums {
        let [real, imaginary] =
            m.checked_sub(1).and_then(|m| self.powers.get(m)).unwrap_or(&[0; 2]);
        let [even, odd] = &mut sums;
        let [of_real, of_imaginary] = if m.is_multiple_of(2) { even } else { odd };
        *of_real = of_real.wrapping_add(product(value(plus, self.t), *real));
        *of_imaginary = of_imaginary.wrapping_add(product(value(minus, self.t), *imaginary));
        sums
    }

    /// The polynomial of azimuth 0 of a scene of `B`.
    #[inline(always)]
    #[must_use]
    pub fn pole<B: KnownTable<Basis<'static>>, const N: usize>(&self, terms: &[i32; N]) -> Sums {
        self.start(part(terms, ..const { B::BASIS.length(0) }))
    }

    /// Adds azimuth `M` > 0 of a scene of `B`.
    #[inline(always)]
    #[must_use]
    pub fn azimuth<B: KnownTable<Basis<'static>>, const M: usize, const N: usize>(
        &self,
        terms: &[i32; N],
        sums: Sums,
    ) -> Sums {
        let start = const { at(B::BASIS.parts.azimuths, M).start as usize };
        let length = const { B::BASIS.length(M) };
        let [plus, minus] = [start, start + length].map(|start| part(terms, start..start + length));
        self.add(M, plus, minus, sums)
    }

    /// The irradiances of the normal and its mirror images.
    #[inline(always)]
    #[must_use]
    pub fn images([[even, even_i], [odd, odd_i]]: Sums) -> [i32; 4] {
        let [all, apart] = [even.wrapping_add(odd), even.wrapping_sub(odd)];
        let [all_i, apart_i] = [even_i.wrapping_add(odd_i), even_i.wrapping_sub(odd_i)];
        [
            all.wrapping_add(all_i),
            apart.wrapping_sub(apart_i),
            all.wrapping_sub(all_i),
            apart.wrapping_add(apart_i),
        ]
        .map(arithmetic::sum)
    }
}

impl Normal {
    /// The normal (x, y, z), and its mirror images (-x, y, z), (x, -y, z) and (-x, -y, z).
    #[must_use]
    pub fn mirrored(self) -> [Self; 4] {
        let Self { x, y, z } = self;
        let [left, below] = [x, y].map(|Q15(along)| Q15(along.saturating_neg()));
        [[x, y], [left, y], [x, below], [left, below]].map(|[x, y]| Self { x, y, z })
    }
}

impl<B: AsRef<[i32]>> Scene<'_, B> {
    /// The irradiances of [`Normal::mirrored`], at little more than the cost of one normal: within six
    /// units of those of [`shade`](Self::shade), which rounds the powers of n_x + i n_y of each image.
    #[must_use]
    pub fn shade_mirrored(&self, normal: Normal) -> [i32; 4] {
        let mirrored = Mirrored::new(normal);
        let (first, lengths, mut rest) = self.constant();
        let mut sums = mirrored.start(first);
        for (&length, m) in lengths.iter().zip(1..) {
            let (plus, after) = split_row(rest, length.into());
            let (minus, after) = split_row(after, length.into());
            rest = after;
            sums = mirrored.add(m, plus, minus, sums);
        }
        Mirrored::images(sums)
    }
}

#[cfg(all(test, feature = "baked", feature = "presets"))]
mod tests {
    use crate::object::{Disc, DiscPixel};
    use crate::presets::{light::q15 as light, material::q15 as material};
    use crate::sphere::q15::{BASIS, SCENE, color};

    /// Against single normals, by the kernels of a table and by lengths.
    #[test]
    fn images_are_shaded_as_normals() {
        let (mut worst, mut count) = (0, 0);
        for light in [light::LOBBY, light::STUDIO, light::SKY, light::NIGHT] {
            for material in [material::GOLD_METALLIC_PAINT, material::CHROME, material::PINK_FELT] {
                let Ok(scene) = color::scene(light, material) else { unreachable!("one table") };
                let found = Disc::new(40).into_iter().flatten().map(DiscPixel::normal_q15);
                for normal in found {
                    let channel = &scene.r;
                    let general = BASIS.scene(channel.exponent(), channel.terms());
                    let general = general.map(|scene| scene.shade_mirrored(normal));
                    let all = scene.shade_mirrored(normal);
                    assert_eq!(general, Ok(all.map(|color| color.r)), "{SCENE}");
                    for (found, image) in all.into_iter().zip(normal.mirrored()) {
                        let exact = scene.shade(image);
                        for (a, b) in <[_; 3]>::from(found.zip(exact)) {
                            worst = worst.max(a.abs_diff(b));
                        }
                        count += 1;
                    }
                }
            }
        }
        assert!(worst <= 6 && worst > 1 && count > 60_000, "{worst} of {count}");
    }
}
