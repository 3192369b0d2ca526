//! Unit vectors in two bytes.
//!
//! A code is a point (u, v) with |u|, |v| <= 127: the normal's direction in the picture, and its
//! angle from the camera as the distance from (0, 0), 127 for 90°. In this azimuthal equidistant map
//! a step of u or v turns the normal by at most 0.71° everywhere, so rounding turns it by at most
//! 0.51°. Octahedral codes are off by up to 0.55° and paraboloid codes by up to 0.64°. Both sin θ / θ
//! and cos θ are series in θ², which is u² + v², so a short polynomial decodes each.

use crate::normal::Normal;
use crate::q15;
use crate::q15::Q15;
use core::f32::consts::FRAC_PI_2;

/// The distance of the rim from the center.
pub(crate) const RIM: f32 = 127.0;

/// The first byte of a pixel that has no normal of its own.
pub(crate) const WITHOUT: u8 = 0x80;

/// All rounded codes lie inside of this squared distance, and no code of [`WITHOUT`].
const OUTSIDE: i32 = 1 << 14;

/// sin θ / s with s = θ / (π/2), in (u² + v²) / 2^14, from the constant on: within 1.3e-6.
const SINE: [f64; 4] = [1.570_795_05, -0.656_135_98, 0.082_027_47, -0.004_576_182];

/// (1 - cos θ) / t, with t = (u² + v²) / 2^14, in t: within 2.1e-7, times t.
const COSINE: [f64; 4] = [1.253_205_19, -0.261_747_396, 0.021_835_836, -0.000_925_671_56];

/// The code of a visible normal: its point (u, v) in the map of codes, within 0.51° of the normal.
///
/// A [`Palette`](crate::screen::Palette) gives its color.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NormalCode([i8; 2]);

impl NormalCode {
    /// The nearest code. Cost: a root and an arc tangent.
    #[must_use]
    pub fn of(normal: Normal) -> Self {
        let Normal { x, y, z } = normal;
        let sine = libm::sqrtf(x * x + y * y);
        let scale = if sine > 0.0 { RIM / FRAC_PI_2 * libm::atan2f(sine, z) / sine } else { 0.0 };
        Self([x, y].map(|along| libm::roundf(along * scale).clamp(-RIM, RIM) as i8))
    }

    /// The nearest code of a normal in integers, within 0.6 in u and in v. Cost: a dozen
    /// instructions.
    #[inline]
    #[must_use]
    pub fn of_q15(normal: q15::Normal) -> Self {
        let [x, y, z] = normal.components().map(|along| i32::from(along.0));
        Self::of_sphere([x, y], z)
    }

    /// These bytes as a code, if its point is inside the rim: those of a pixel that has a normal of
    /// its own.
    #[inline(always)]
    pub(crate) const fn inside([u, v]: [u8; 2]) -> Option<Self> {
        let point = [u.cast_signed(), v.cast_signed()];
        if square(point) < OUTSIDE { Some(Self(point)) } else { None }
    }

    /// The code at a point of a sphere, from its place (x, y) and z in units of 2^-15: within 0.6.
    #[inline]
    pub(crate) const fn of_sphere([x, y]: [i32; 2], z: i32) -> Self {
        // θ / sin θ / (π/2) in z, within 6.4e-4.
        let [a, b, c, d] = [32_747, -20_117, 11_937, -3_722];
        let value = ((d * z) >> 15) + c;
        let value = ((value * z) >> 15) + b;
        let value = ((value * z) >> 15) + a;
        let (u, v) = ((x * value) >> 15, (y * value) >> 15);
        // A little less than 128 at the rim.
        Self([((u * 127 + (1 << 14)) >> 15) as i8, ((v * 127 + (1 << 14)) >> 15) as i8])
    }

    /// The column and the row of the node before the code, every eighth code from -128 on, and the
    /// way to the next ones in eighths.
    #[inline(always)]
    pub(crate) const fn cell(self) -> ([usize; 2], [u32; 2]) {
        let [u, v] = self.0;
        // Both at once.
        let biased = u16::from_le_bytes([u.cast_unsigned(), v.cast_unsigned()]) as u32 ^ 0x8080;
        let (column, row) = (biased >> 3 & 31, biased >> 11);
        ([column as usize, row as usize], [biased & 7, biased >> 8 & 7])
    }

    pub(crate) const fn point(self) -> [i8; 2] {
        self.0
    }

    /// The two bytes of a pixel of a [`NormalMap`](crate::object::NormalMap).
    #[must_use]
    pub const fn bytes(self) -> [u8; 2] {
        let [u, v] = self.0;
        [u.cast_unsigned(), v.cast_unsigned()]
    }

    #[inline]
    pub(crate) fn normal(self) -> Normal {
        normal_at::<0>(self.0.map(i32::from))
    }

    #[inline]
    pub(crate) fn normal_q15(self) -> q15::Normal {
        normal_q15_at::<0>(self.0.map(i32::from))
    }
}

/// The normal at a point of the map of codes, in units of 2^-`POINT`.
#[inline]
pub(crate) fn normal_at<const POINT: u32>(point: [i32; 2]) -> Normal {
    const SINE_32: [f32; 4] = rounded(SINE, 1.0 / 127.0);
    const COSINE_32: [f32; 4] = rounded(COSINE, 1.0);
    let (unit, square_unit) =
        const { (1.0 / (1 << POINT) as f32, 1.0 / (1_i64 << (14 + 2 * POINT)) as f32) };
    let [u, v] = point;
    let t = (u * u + v * v) as f32 * square_unit;
    let value = |[a, b, c, d]: [f32; 4]| ((d * t + c) * t + b) * t + a;
    let scale = value(SINE_32) * unit;
    let [x, y] = point.map(|along| along as f32 * scale);
    Normal { x, y, z: (1.0 - t * value(COSINE_32)).max(0.0) }
}

/// [`normal_at`] in integers.
#[inline]
pub(crate) fn normal_q15_at<const POINT: u32>(point: [i32; 2]) -> q15::Normal {
    const SINE_15: [i32; 4] = whole(SINE, 32_767.0 * 128.0 / 127.0);
    const COSINE_15: [i32; 4] = whole(COSINE, 32_767.0);
    let [u, v] = point;
    let t = (u * u + v * v) >> (2 * POINT);
    let value = |[a, b, c, d]: [i32; 4]| {
        let sum = ((d * t) >> 14) + c;
        let sum = ((sum * t) >> 14) + b;
        ((sum * t) >> 14) + a
    };
    let scale = value(SINE_15);
    let [x, y] = point.map(|along| {
        // At most 2^15 before.
        Q15(((along * scale + (64 << POINT)) >> (7 + POINT)).min(32_767) as i16)
    });
    let z = 32_767 - ((value(COSINE_15) * t + (1 << 13)) >> 14);
    q15::Normal { x, y, z: Q15(z.max(0) as i16) }
}

const fn rounded([a, b, c, d]: [f64; 4], scale: f64) -> [f32; 4] {
    [(a * scale) as f32, (b * scale) as f32, (c * scale) as f32, (d * scale) as f32]
}

/// Rounds up what is added to a step of Horner's rule, which rounds down, and the first coefficient
/// to the nearest integer. The signs alternate.
const fn whole([a, b, c, d]: [f64; 4], scale: f64) -> [i32; 4] {
    let [a, b, c, d] = [a * scale, b * scale, c * scale, d * scale - 0.5];
    [a as i32 + 1, b as i32, c as i32 + 1, d as i32]
}

#[inline(always)]
const fn square([u, v]: [i8; 2]) -> i32 {
    let [u, v] = [u as i32, v as i32];
    u * u + v * v
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::FRAC_PI_2;

    /// The normal of a code, by the definition of the map.
    fn exact([u, v]: [i8; 2]) -> [f64; 3] {
        let [u, v] = [u, v].map(f64::from);
        let distance = libm::sqrt(u * u + v * v);
        let angle = (distance / 127.0 * FRAC_PI_2).min(FRAC_PI_2);
        let scale = if distance > 0.0 { libm::sin(angle) / distance } else { 0.0 };
        [u * scale, v * scale, libm::cos(angle)]
    }

    /// The angle between two unit vectors in degrees, precise for small ones.
    fn degrees(a: [f64; 3], b: [f64; 3]) -> f64 {
        let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
        (2.0 * libm::asin(0.5 * libm::sqrt(square))).to_degrees()
    }

    /// Calls a function with unit vectors, spread evenly over the visible hemisphere.
    fn spread(mut with: impl FnMut([f64; 3])) {
        const COUNT: usize = 200_000;
        for k in 0..COUNT {
            let z = k as f64 / (COUNT - 1) as f64;
            let (sine, turn) = (libm::sqrt(1.0 - z * z), k as f64 * 2.399_963_229_728_653);
            with([sine * libm::cos(turn), sine * libm::sin(turn), z]);
        }
    }

    #[test]
    fn every_code_is_decoded_in_floats_and_integers() {
        // Codes just beyond the rim have its normals, which are too short by 7e-5.
        const AT_THE_RIM: f64 = 8e-5;
        for code in 0..=u16::MAX {
            let code = code.to_le_bytes();
            let point = code.map(u8::cast_signed);
            let Some(pixel) = NormalCode::inside(code) else {
                assert!(square(point) >= OUTSIDE);
                continue;
            };
            assert_eq!(pixel.bytes(), code);
            let exact = exact(point);
            let beyond = square(point) > 127 * 127;
            let found = pixel.normal().components().map(f64::from);
            let integers = pixel.normal_q15().components();
            for ((found, integer), exact) in found.into_iter().zip(integers).zip(exact) {
                let more = if beyond { AT_THE_RIM } else { 0.0 };
                assert!((found - exact).abs() < 2e-6 + more, "{point:?}: {found} {exact}");
                let off = (f64::from(integer.0) - 32_768.0 * exact).abs();
                assert!(off < 2.5 + 32_768.0 * more, "{point:?}: {integer:?} {exact}");
            }
            assert!(found[2] >= 0.0 && found[2] <= 1.0 && integers[2].0 >= 0);
        }
    }

    #[test]
    fn rounding_turns_normals_by_half_a_degree_at_most() {
        let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
        spread(|[x, y, z]| {
            let code = NormalCode::of(Normal { x: x as f32, y: y as f32, z: z as f32 });
            let found = code.normal().components().map(f64::from);
            let off = degrees(found, [x, y, z]);
            worst = worst.max(off);
            // By the projected area.
            (sum, count) = (sum + z * off * off, count + z);
        });
        let rms = libm::sqrt(sum / count);
        assert!(worst < 0.51 && rms < 0.28, "{worst} {rms}");
    }

    /// The two other maps that need no trigonometry, rounded to the same number of steps.
    #[test]
    fn other_maps_are_less_exact() {
        let round = |x: f64| libm::round(x * 127.0) / 127.0;
        let unit = |[x, y, z]: [f64; 3]| {
            let length = libm::sqrt(x * x + y * y + z * z);
            [x / length, y / length, z / length]
        };
        let (mut paraboloid, mut octahedral) = (0.0_f64, 0.0_f64);
        spread(|[x, y, z]| {
            let [u, v] = [x, y].map(|along| round(along / (1.0 + z)));
            let found = unit([2.0 * u, 2.0 * v, 1.0 - u * u - v * v]);
            paraboloid = paraboloid.max(degrees(found, [x, y, z]));
            // The hemisphere fills the square turned by 45 degrees.
            let sum = x.abs() + y.abs() + z;
            let [u, v] = [(x + y) / sum, (x - y) / sum].map(round);
            let [p, q] = [(u + v) / 2.0, (u - v) / 2.0];
            let found = unit([p, q, 1.0 - p.abs() - q.abs()]);
            octahedral = octahedral.max(degrees(found, [x, y, z]));
        });
        assert!((paraboloid - 0.64).abs() < 0.01, "{paraboloid}");
        assert!((octahedral - 0.55).abs() < 0.01, "{octahedral}");
    }
}
